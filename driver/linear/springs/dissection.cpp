#include "dissection.hpp"

#include <algorithm>
#include <utility>

namespace pd {

namespace {

// Fewer points are a group.
constexpr std::ptrdiff_t fewest = 48;

class Dissector {
 public:
  using Place = std::vector<int>::iterator;
  Dissector(const SpringNetwork& network, Dissection& dissection)
      : network_(network), dissection_(dissection), half_(static_cast<std::size_t>(network.points().nPoints), 0) {}

  /// Orders [begin, end).
  void order(Place begin, Place end) {
    if (end - begin < fewest) return endGroup(begin, end);
    Place border, middle;
    std::ptrdiff_t least = end - begin + 1;
    int best = 0;
    for (int axis = 0; axis < network_.dimension(); ++axis) {
      std::tie(border, middle) = cut(begin, end, axis);
      if (middle - border >= least) continue;
      least = middle - border;
      best = axis;
    }
    if (best + 1 < network_.dimension()) std::tie(border, middle) = cut(begin, end, best);
    // The border moves behind the other half.
    const Place behind = std::rotate(border, middle, end);
    order(begin, border);
    order(border, behind);
    endGroup(behind, end);
  }

 private:
  void endGroup(Place begin, Place end) {
    if (begin != end) dissection_.ends.push_back(static_cast<std::size_t>(end - dissection_.points.begin()));
  }

  /// Where the second half begins, and before it the points of the first with springs to it.
  std::pair<Place, Place> cut(Place begin, Place end, int axis) {
    const double* x = network_.places<double>()[axis];
    const Place middle = begin + (end - begin) / 2;
    std::nth_element(begin, middle, end, [x](int i, int j) { return x[i] < x[j] || (x[i] == x[j] && i < j); });
    ++nCuts_;
    for (Place point = middle; point != end; ++point) half_[static_cast<std::size_t>(*point)] = nCuts_;
    const auto reaches = [&](int i) {
      for (int k = 0; k < network_.nNeighbors(i); ++k)
        if (half_[static_cast<std::size_t>(network_.neighbors(i)[k])] == nCuts_ && network_.alive(i, k) > 0.0F)
          return true;
      return false;
    };
    return {std::stable_partition(begin, middle, [&](int i) { return !reaches(i); }), middle};
  }

  const SpringNetwork& network_;
  Dissection& dissection_;
  std::vector<int> half_;  ///< the last cut of which a point was in the second half
  int nCuts_ = 0;
};

}  // namespace

void Dissection::addGroup(const std::vector<int>& group) {
  if (group.empty()) return;
  points.insert(points.end(), group.begin(), group.end());
  ends.push_back(points.size());
}

Dissection dissect(const SpringNetwork& network, std::vector<int> points) {
  Dissection dissection;
  dissection.points = std::move(points);
  Dissector(network, dissection).order(dissection.points.begin(), dissection.points.end());
  return dissection;
}

}  // namespace pd
