#include "rectangle_cover.hpp"

#include <algorithm>
#include <cmath>

#include "compute_support.hpp"

namespace pd {

namespace {

constexpr double reachesInACell = 1.5;  ///< enough points for a cell of a turned or jittered lattice to be nearly full
/// Of a row of cells along the crack: below the first it is beyond a side of the body, where nothing is to be. A cell
/// is open below the second part of what its row has, which such a side may cut.
constexpr double leastOfARow = 0.4, leastOfACell = 0.5;

}  // namespace

RectangleCover::RectangleCover(double ahead, double behind, double above, double below, double reach)
    : low_{-behind, -below} {
  const std::array<double, 2> length{ahead + behind, above + below};
  for (std::size_t d = 0; d < 2; ++d) {
    n_[d] = std::max<std::size_t>(1, static_cast<std::size_t>(length[d] / (reachesInACell * reach)));
    size_[d] = length[d] / static_cast<double>(n_[d]);
  }
  area_.assign(n_[0] * n_[1], 0.0);
}

void RectangleCover::add(double ahead, double above, double area) {
  const double place[2] = {(ahead - low_[0]) / size_[0], (above - low_[1]) / size_[1]};
  for (std::size_t d = 0; d < 2; ++d)
    if (!(place[d] >= 0.0 && place[d] < static_cast<double>(n_[d]))) return;
  area_[static_cast<std::size_t>(place[1]) * n_[0] + static_cast<std::size_t>(place[0])] +=
      area / (size_[0] * size_[1]);
}

std::optional<std::array<double, 2>> RectangleCover::gap(const Epetra_Comm& comm) const {
  const std::vector<double> covered = sumOverRanks(comm, area_);
  const auto isOpen = [&](std::size_t column, std::size_t row) {
    const auto begin = covered.begin() + static_cast<std::ptrdiff_t>(row * n_[0]);
    const double most = std::min(1.0, *std::max_element(begin, begin + static_cast<std::ptrdiff_t>(n_[0])));
    return most < leastOfARow || covered[row * n_[0] + column] < leastOfACell * most;
  };
  const auto centre = [&](std::size_t column, std::size_t row) {
    return std::array<double, 2>{low_[0] + (static_cast<double>(column) + 0.5) * size_[0],
                                 low_[1] + (static_cast<double>(row) + 0.5) * size_[1]};
  };
  std::vector<std::size_t> first;  // column of each row, from behind, at which the body begins
  for (std::size_t row = 0; row < n_[1]; ++row) {
    std::size_t column = 0;
    while (column < n_[0] && isOpen(column, row)) ++column;
    first.push_back(column);
    for (; column < n_[0]; ++column)
      if (isOpen(column, row)) return centre(column, row);
  }
  const auto isWhole = [](std::size_t column) { return column == 0; };
  for (std::size_t row = 0; row < n_[1]; ++row) {
    if (first[row] == 0 || first[row] == n_[0]) continue;
    const auto own = first.begin() + static_cast<std::ptrdiff_t>(row);
    const bool isNotch = std::any_of(first.begin(), own, isWhole) && std::any_of(own, first.end(), isWhole);
    if (!isNotch) return centre(first[row] - 1, row);
  }
  return std::nullopt;
}

}  // namespace pd
