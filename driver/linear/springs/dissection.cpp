#include "dissection.hpp"

#include <algorithm>

namespace pd {

namespace {

// Fewer points are eliminated as they come.
constexpr std::ptrdiff_t fewest = 60;

class Dissection {
 public:
  explicit Dissection(const SpringNetwork& network)
      : network_(network), half_(static_cast<std::size_t>(network.points().nPoints), 0) {}

  /// Orders [begin, end).
  void order(std::vector<int>::iterator begin, std::vector<int>::iterator end) {
    if (end - begin < fewest) return;
    const int axis = longerSide(begin, end);
    const double* x = network_.places<double>()[axis];
    const auto middle = begin + (end - begin) / 2;
    std::nth_element(begin, middle, end, [x](int i, int j) { return x[i] < x[j] || (x[i] == x[j] && i < j); });
    ++nCuts_;
    for (auto point = middle; point != end; ++point) half_[static_cast<std::size_t>(*point)] = nCuts_;
    const auto reaches = [&](int i) {
      for (int k = 0; k < network_.nNeighbors(i); ++k)
        if (half_[static_cast<std::size_t>(network_.neighbors(i)[k])] == nCuts_ && network_.alive(i, k) > 0.0F)
          return true;
      return false;
    };
    const auto border = std::stable_partition(begin, middle, [&](int i) { return !reaches(i); });
    // The border moves behind the other half.
    const auto behind = std::rotate(border, middle, end);
    order(begin, border);
    order(border, behind);
  }

 private:
  int longerSide(std::vector<int>::iterator begin, std::vector<int>::iterator end) const {
    int longest = 0;
    double length = -1.0;
    for (int c = 0; c < network_.dimension(); ++c) {
      const double* x = network_.places<double>()[c];
      const auto [low, high] = std::minmax_element(begin, end, [x](int i, int j) { return x[i] < x[j]; });
      if (x[*high] - x[*low] <= length) continue;
      length = x[*high] - x[*low];
      longest = c;
    }
    return longest;
  }

  const SpringNetwork& network_;
  std::vector<int> half_;  ///< the last cut of which a point was in the second half
  int nCuts_ = 0;
};

}  // namespace

std::vector<int> dissectionOrder(const SpringNetwork& network, std::vector<int> points) {
  Dissection(network).order(points.begin(), points.end());
  return points;
}

}  // namespace pd
