#include "ring_cover.hpp"

#include <algorithm>
#include <cmath>

#include "compute_support.hpp"

namespace pd {

namespace {

constexpr double spacingsInARow = 4.0;  ///< for rows of turned and jittered lattices to be nearly full
constexpr std::size_t mostRows = 8;
/// Of what a whole half row has: below the first it is beyond a side of the body, where nothing is to be. A half is
/// open below the second part of what the other one has, which such a side may cut as well.
constexpr double leastOfHalves = 0.4, leastOfAHalf = 0.5;
constexpr double leastBesideANotch = 0.75;  ///< of a half row, for the body to be whole there
constexpr double leastOfQ = 0.5;            ///< rows in which q is less are too short to be judged
constexpr double leastFilled = 0.2;         ///< of a row that is beyond no side

}  // namespace

RingCover::RingCover(double inner, double outer, double spacing) : inner_(inner), outer_(outer) {
  const auto fitting = static_cast<std::size_t>(2.0 * outer / (spacingsInARow * spacing));
  const std::size_t n = std::clamp<std::size_t>(fitting, 1, mostRows);
  width_ = 2.0 * outer / static_cast<double>(n);
  whole_.assign(n, 0.0);
  fallen_.assign(2 * n, 0.0);
  area_.assign(n, 0.0);
  constexpr int nParts = 64;
  for (std::size_t row = 0; row < n; ++row)
    for (int k = 0; k < nParts; ++k) {
      const double above = (static_cast<double>(row) + (k + 0.5) / nParts) * width_ - outer;
      whole_[row] += std::clamp((outer - std::abs(above)) / (outer - inner), 0.0, 1.0) * width_ / nParts;
    }
}

void RingCover::add(double ahead, double above, double area) {
  const double radius = std::hypot(ahead, above);
  if (!(radius < outer_)) return;
  const std::size_t row = std::min(nRows() - 1, static_cast<std::size_t>((above + outer_) / width_));
  area_[row] += area;
  if (radius > inner_)
    fallen_[2 * row + (ahead > 0.0 ? 1 : 0)] += area * std::abs(ahead) / (radius * (outer_ - inner_));
}

std::optional<std::array<double, 2>> RingCover::gap(const Epetra_Comm& comm) const {
  const std::vector<double> fallen = sumOverRanks(comm, fallen_), area = sumOverRanks(comm, area_);
  const double middle = 0.5 * (inner_ + outer_);
  std::vector<char> isWholeBehind(nRows(), 0), isOpenBehind(nRows(), 0);
  const auto placeIn = [&](std::size_t row, double side) {
    const double above = (static_cast<double>(row) + 0.5) * width_ - outer_;
    return std::array<double, 2>{side * std::sqrt(std::max(middle * middle - above * above, 0.0)), above};
  };
  for (std::size_t row = 0; row < nRows(); ++row) {
    if (whole_[row] < leastOfQ * width_) continue;
    const double behind = fallen[2 * row] / whole_[row], ahead = fallen[2 * row + 1] / whole_[row];
    const double most = std::min(1.0, std::max(behind, ahead));
    if (most < leastOfHalves) {
      if (area[row] > leastFilled * 2.0 * inner_ * width_) return placeIn(row, 1.0);
      continue;
    }
    if (ahead < leastOfAHalf * most) return placeIn(row, 1.0);
    isOpenBehind[row] = behind < leastOfAHalf * most ? 1 : 0;
    isWholeBehind[row] = behind >= leastBesideANotch * most ? 1 : 0;
  }
  const auto isSet = [](char flag) { return flag != 0; };
  for (std::size_t row = 0; row < nRows(); ++row) {
    if (isOpenBehind[row] == 0) continue;
    const auto own = isWholeBehind.begin() + static_cast<std::ptrdiff_t>(row);
    const bool isNotch = std::any_of(isWholeBehind.begin(), own, isSet) && std::any_of(own, isWholeBehind.end(), isSet);
    if (!isNotch) return placeIn(row, -1.0);
  }
  return std::nullopt;
}

}  // namespace pd
