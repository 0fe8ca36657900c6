#include "column_layout.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pd {

namespace {

/// Gives values (of component k, in ascending order) within `tolerance` of the first of a group its value.
void snap(std::vector<Place2>& places, std::size_t begin, std::size_t end, std::size_t k, double tolerance) {
  double value = places[begin][k];
  for (std::size_t i = begin; i < end; ++i) {
    if (places[i][k] > value + tolerance) value = places[i][k];
    places[i][k] = value;
  }
}

}  // namespace

ColumnLayout::ColumnLayout(std::vector<Place2> places, double tolerance)
    : places_(std::move(places)), tolerance_(tolerance) {
  std::sort(places_.begin(), places_.end());
  snap(places_, 0, places_.size(), 0, tolerance);
  std::sort(places_.begin(), places_.end());
  for (std::size_t begin = 0, end = 0; begin < places_.size(); begin = end) {
    while (end < places_.size() && places_[end][0] == places_[begin][0]) ++end;
    snap(places_, begin, end, 1, tolerance);
  }
  places_.erase(std::unique(places_.begin(), places_.end()), places_.end());

  constexpr double share = 0.75;  // over 1/sqrt(2), half the diagonal of a square of points
  reach_.assign(places_.size(), 0.0);
  for (int column = 0; column < count(); ++column) {
    double distance = std::numeric_limits<double>::infinity();
    if (nearest(place(column), column, distance) >= 0) reach_[static_cast<std::size_t>(column)] = share * distance;
  }
  for (const double reach : reach_) longestReach_ = std::max(longestReach_, reach);
}

ColumnLayout ColumnLayout::bins(const std::vector<Place2>& places, double width) {
  ColumnLayout result;
  result.width_ = width;
  result.origin_ = {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  for (const Place2& place : places)
    for (std::size_t k = 0; k < 2; ++k) result.origin_[k] = std::min(result.origin_[k], place[k]);
  for (const Place2& place : places) result.bins_.push_back(result.binOf(place));
  std::sort(result.bins_.begin(), result.bins_.end());
  result.bins_.erase(std::unique(result.bins_.begin(), result.bins_.end()), result.bins_.end());
  for (const Bin& bin : result.bins_)
    result.places_.push_back({result.origin_[0] + width * static_cast<double>(bin[0]),
                              result.origin_[1] + width * static_cast<double>(bin[1])});
  return result;
}

ColumnLayout::Bin ColumnLayout::binOf(const Place2& place) const {
  // Edges a little off the middle between two points of a lattice, lest rounding sort them.
  constexpr double half = 0.5 - 1e-6;
  Bin bin;
  for (std::size_t k = 0; k < 2; ++k)
    bin[k] = static_cast<long long>(std::floor((place[k] - origin_[k]) / width_ + half));
  return bin;
}

int ColumnLayout::nearest(const Place2& place, int except, double& distance) const {
  const auto start = static_cast<int>(std::lower_bound(places_.begin(), places_.end(), place) - places_.begin());
  int found = -1;
  const auto tryOne = [&](int column) {
    const Place2& other = this->place(column);
    const double length = std::hypot(other[0] - place[0], other[1] - place[1]);
    if (column == except || length > distance) return;
    distance = length;
    found = column;
  };
  // Places are in the order of their first coordinates.
  for (int up = start; up < count() && this->place(up)[0] - place[0] <= distance; ++up) tryOne(up);
  for (int down = start - 1; down >= 0 && place[0] - this->place(down)[0] <= distance; --down) tryOne(down);
  return found;
}

int ColumnLayout::columnOf(const Place2& place) const {
  if (width_ > 0.0) {
    const auto bin = std::lower_bound(bins_.begin(), bins_.end(), binOf(place));
    return bin != bins_.end() && *bin == binOf(place) ? static_cast<int>(bin - bins_.begin()) : -1;
  }
  double distance = longestReach_ + 2.0 * tolerance_;
  const int column = nearest(place, -1, distance);
  return column >= 0 && distance <= reach_[static_cast<std::size_t>(column)] + 2.0 * tolerance_ ? column : -1;
}

}  // namespace pd
