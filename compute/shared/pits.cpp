#include "pits.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

namespace pd {

namespace {

using Column = SurfaceColumns::Column;

/// Sets of columns that are made of smaller ones by joining them.
class ConnectedColumns {
 public:
  explicit ConnectedColumns(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), std::size_t{0}); }
  std::size_t rootOf(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::size_t a, std::size_t b) { parent_[rootOf(a)] = rootOf(b); }

 private:
  std::vector<std::size_t> parent_;
};

/// Calls visit(i, j, distance) for pairs of columns, sorted by their first coordinate, nearer than `reach`, which may
/// shrink on the way.
template <class Visit>
void forEachPair(const std::vector<Column>& columns, const double& reach, Visit&& visit) {
  for (std::size_t i = 0; i < columns.size(); ++i)
    for (std::size_t j = i + 1; j < columns.size() && columns[j].across[0] - columns[i].across[0] <= reach; ++j) {
      const double distance =
          std::hypot(columns[j].across[0] - columns[i].across[0], columns[j].across[1] - columns[i].across[1]);
      if (distance <= reach) visit(i, j, distance);
    }
}

/// Edge of the square columns of a solid, m.
double edgeOf(const std::vector<Column>& columns) {
  double area = 0.0;
  for (const Column& column : columns) area += column.area;
  const double edge = std::sqrt(area / static_cast<double>(columns.size()));
  double nearest = 2.0 * edge;
  forEachPair(columns, nearest, [&](std::size_t, std::size_t, double distance) { nearest = distance; });
  if (nearest < 0.7 * edge || nearest > 1.2 * edge)
    throw std::runtime_error(
        "pits cannot be told apart where the columns of the surface are no squares or stand in no rows; give Column "
        "Width, one to three spacings");
  return edge;
}

bool isDeeper(const Column& column, double level) { return column.isMetal() && column.depth > level; }

std::vector<double> pitsOfRow(std::vector<Column> row, std::size_t axis, double level) {
  std::sort(row.begin(), row.end(), [&](const Column& a, const Column& b) { return a.across[axis] < b.across[axis]; });
  std::vector<double> depths;
  bool isWithin = false;
  for (const Column& column : row) {
    const bool wasWithin = isWithin;
    isWithin = isDeeper(column, level);
    if (!isWithin) continue;
    if (!wasWithin) depths.push_back(0.0);
    depths.back() = std::max(depths.back(), column.depth);
  }
  return depths;
}

std::vector<double> pitsOfArea(std::vector<Column> columns, double level) {
  const auto leave = [&](const auto& isLeft) {
    columns.erase(std::remove_if(columns.begin(), columns.end(), [&](const Column& c) { return !isLeft(c); }),
                  columns.end());
  };
  leave([](const Column& column) { return column.isMetal(); });
  std::sort(columns.begin(), columns.end(), [](const Column& a, const Column& b) { return a.across[0] < b.across[0]; });
  const double reach = 1.5 * edgeOf(columns);  // the diagonal of a square, and no further
  leave([&](const Column& column) { return isDeeper(column, level); });
  ConnectedColumns connected(columns.size());
  forEachPair(columns, reach, [&](std::size_t i, std::size_t j, double) { connected.join(i, j); });
  std::vector<double> deepest(columns.size(), 0.0), depths;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    double& ofPit = deepest[connected.rootOf(i)];
    ofPit = std::max(ofPit, columns[i].depth);
  }
  std::copy_if(deepest.begin(), deepest.end(), std::back_inserter(depths), [](double depth) { return depth > 0.0; });
  return depths;
}

}  // namespace

void PitCompute::declareParameters(ParameterDeclarations& declarations, const char* defaultLabel) {
  SurfaceCompute::declareParameters(declarations, defaultLabel);
  declarations
      .real(
          "Deeper Than", "m",
          "Depth below the original surface from which on a column belongs to a pit; half a spacing or more, and more "
          "than what is lost everywhere.")
      .positive()
      .required();
}

std::vector<double> PitCompute::pits(const Blocks& blocks) const {
  const SurfaceColumns::Profile columns = profile(blocks);
  const double level = parameters_.get<double>("Deeper Than");
  const SurfaceColumns::Extent extent = columns_.extent();
  return extent.isLine ? pitsOfRow(columns, extent.longer, level) : pitsOfArea(columns, level);
}

}  // namespace pd
