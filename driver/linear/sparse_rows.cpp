#include "sparse_rows.hpp"

#include <algorithm>

namespace pd {

void SparseRows::addRow(std::vector<std::pair<long long, double>>& entries) {
  std::sort(entries.begin(), entries.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  for (std::size_t k = 0; k < entries.size(); ++k) {
    if (k > 0 && entries[k].first == entries[k - 1].first) {
      values.back() += entries[k].second;
    } else {
      columns.push_back(entries[k].first);
      values.push_back(entries[k].second);
    }
  }
  start.push_back(columns.size());
}

}  // namespace pd
