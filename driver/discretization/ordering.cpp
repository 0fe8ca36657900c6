#include "ordering.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>

namespace pd {

namespace {

/// Groups the points by one coordinate; a group starts where a value is more than `width` above the first of the
/// last one. Returns the number of each point's group.
std::vector<std::uint32_t> groups(const std::vector<double>& x, std::size_t axis, double width) {
  const std::size_t n = x.size() / 3;
  std::vector<double> sorted(n);
  for (std::size_t i = 0; i < n; ++i) sorted[i] = x[3 * i + axis];
  std::sort(sorted.begin(), sorted.end());
  std::vector<double> starts;
  for (const double value : sorted)
    if (starts.empty() || value > starts.back() + width) starts.push_back(value);
  std::vector<std::uint32_t> result(n);
  for (std::size_t i = 0; i < n; ++i)
    result[i] =
        static_cast<std::uint32_t>(std::upper_bound(starts.begin(), starts.end(), x[3 * i + axis]) - starts.begin());
  return result;
}

/// Axes from the longest extent to the shortest; of equal ones x comes before y before z.
std::array<std::size_t, 3> axesByExtent(const std::vector<double>& x) {
  std::array<double, 3> low{x[0], x[1], x[2]}, high = low;
  for (std::size_t i = 0; i < x.size(); ++i) {
    low[i % 3] = std::min(low[i % 3], x[i]);
    high[i % 3] = std::max(high[i % 3], x[i]);
  }
  std::array<std::size_t, 3> axes{0, 1, 2};
  std::stable_sort(axes.begin(), axes.end(),
                   [&](std::size_t a, std::size_t b) { return high[a] - low[a] > high[b] - low[b]; });
  return axes;
}

}  // namespace

std::vector<int> lineOrder(const std::vector<double>& x, double spacing, const std::vector<double>& body) {
  if (x.empty()) return {};
  struct Item {
    std::uint64_t line;
    double along;
    int point;
  };
  const std::size_t n = x.size() / 3;
  const auto [along, slow, middle] = axesByExtent(body);
  const double width = 0.75 * spacing;
  // Lines that follow each other are neighbours in the shortest direction: the planes that a neighbourhood reaches
  // over are then as small as can be, and stay in the cache.
  const std::vector<std::uint32_t> slowGroup = groups(x, slow, width), middleGroup = groups(x, middle, width);
  std::vector<Item> items(n);
  for (std::size_t i = 0; i < n; ++i)
    items[i] = {static_cast<std::uint64_t>(slowGroup[i]) << 32 | middleGroup[i], x[3 * i + along], static_cast<int>(i)};
  std::sort(items.begin(), items.end(), [](const Item& a, const Item& b) {
    if (a.line != b.line) return a.line < b.line;
    return a.along != b.along ? a.along < b.along : a.point < b.point;
  });
  std::vector<int> order(n);
  std::transform(items.begin(), items.end(), order.begin(), [](const Item& item) { return item.point; });
  return order;
}

}  // namespace pd
