#include "part_stiffness.hpp"

#include <utility>

namespace pd {

PartStiffness::PartStiffness(const SpringOperator& stiffness, std::vector<int> points)
    : stiffness_(stiffness),
      width_(static_cast<std::size_t>(stiffness.network().dimension())),
      points_(std::move(points)),
      placeOf_(static_cast<std::size_t>(stiffness.network().points().nOwned), -1),
      firstUnknown_{0},
      diagonal_(points_.size() * width_ * width_, 0.0) {
  for (std::size_t p = 0; p < points_.size(); ++p) {
    placeOf_[static_cast<std::size_t>(points_[p])] = static_cast<int>(p);
    int count = 0;
    for (std::size_t c = 0; c < width_; ++c) count += isHeld(static_cast<int>(p), static_cast<int>(c)) ? 0 : 1;
    firstUnknown_.push_back(firstUnknown_.back() + count);
  }
}

void PartStiffness::addSpring(int i, int j, const double* xi, double radial) {
  const int from = placeOf(i), to = placeOf(j), width = static_cast<int>(width_);
  springs_.push_back(from < to ? Spring{from, to, radial} : Spring{to, from, radial});
  for (int c = 0; c < width; ++c)
    for (int d = 0; d < width; ++d) {
      const double value = radial * xi[c] * xi[d];
      ofPoint(from, c, d) += value;
      ofPoint(to, c, d) += value;
    }
}

std::vector<int> PartStiffness::unknownsOf(const std::vector<int>& points) const {
  std::vector<int> unknowns;
  for (const int i : points) {
    const auto place = static_cast<std::size_t>(placeOf(i));
    for (int unknown = firstUnknown(place); unknown < firstUnknown(place + 1); ++unknown) unknowns.push_back(unknown);
  }
  return unknowns;
}

void PartStiffness::add(const std::vector<int>& points, const std::vector<double>& values) {
  for (const int i : points) densePlaces_.push_back(placeOf(i));
  denseUnknowns_ = unknownsOf(points);
  denseValues_ = &values;
}

}  // namespace pd
