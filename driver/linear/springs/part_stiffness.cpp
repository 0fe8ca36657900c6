#include "part_stiffness.hpp"

namespace pd {

PartStiffness::PartStiffness(const SpringOperator& stiffness, const std::vector<int>& points)
    : stiffness_(stiffness),
      dimension_(stiffness.network().dimension()),
      points_(points),
      placeOf_(static_cast<std::size_t>(stiffness.network().points().nOwned), -1) {
  for (std::size_t p = 0; p < points_.size(); ++p) placeOf_[static_cast<std::size_t>(points_[p])] = static_cast<int>(p);
  for (const int i : points_)
    for (int c = 0; c < dimension_; ++c) unknown_.push_back(stiffness.isHeld(i, c) ? 0 : ++entries_.size);
  diagonal_.assign(unknown_.size() * static_cast<std::size_t>(dimension_), 0.0);
}

int PartStiffness::unknown(int point, int component) const {
  return unknown_[static_cast<std::size_t>(placeOf_[static_cast<std::size_t>(point)]) *
                      static_cast<std::size_t>(dimension_) +
                  static_cast<std::size_t>(component)];
}

std::vector<int> PartStiffness::unknownsOf(const std::vector<int>& points) const {
  std::vector<int> unknowns;
  for (const int i : points)
    for (int c = 0; c < dimension_; ++c)
      if (unknown(i, c) > 0) unknowns.push_back(unknown(i, c));
  return unknowns;
}

double& PartStiffness::ofPoint(int point, int c, int d) {
  const auto n = static_cast<std::size_t>(dimension_);
  return diagonal_[(static_cast<std::size_t>(placeOf_[static_cast<std::size_t>(point)]) * n +
                    static_cast<std::size_t>(c)) *
                       n +
                   static_cast<std::size_t>(d)];
}

void PartStiffness::addEntry(int i, int c, int j, int d, double value) {
  const int row = unknown(i, c), column = unknown(j, d);
  if (row > 0 && column > 0) entries_.add(row, column, value);
}

void PartStiffness::addSpring(int i, int j, const double* xi, double radial) {
  for (int c = 0; c < dimension_; ++c)
    for (int d = 0; d < dimension_; ++d) {
      const double value = radial * xi[c] * xi[d];
      addEntry(i, c, j, d, -value);
      ofPoint(i, c, d) += value;
      ofPoint(j, c, d) += value;
    }
}

void PartStiffness::add(const std::vector<int>& points, const std::vector<double>& values) {
  const std::vector<int> unknowns = unknownsOf(points);
  for (std::size_t r = 0; r < unknowns.size(); ++r)
    for (std::size_t c = 0; c <= r; ++c) entries_.add(unknowns[r], unknowns[c], values[r * unknowns.size() + c]);
}

void PartStiffness::addDiagonal() {
  for (const int i : points_)
    for (int c = 0; c < dimension_; ++c)
      for (int d = 0; d <= c; ++d) addEntry(i, c, i, d, ofPoint(i, c, d));
}

SchurComplement PartStiffness::condenseOnto(const std::vector<int>& kept, const std::vector<int>& eliminated) {
  addDiagonal();
  std::vector<int> keptUnknowns = unknownsOf(kept), order = unknownsOf(eliminated);
  order.insert(order.end(), keptUnknowns.begin(), keptUnknowns.end());
  return schurComplement(entries_, keptUnknowns, order);
}

InverseColumns PartStiffness::inverse(const std::vector<int>& rows, const std::vector<int>& columns,
                                      const std::vector<int>& order) {
  addDiagonal();
  return columnsOfInverse(entries_, unknownsOf(rows), unknownsOf(columns), unknownsOf(order));
}

}  // namespace pd
