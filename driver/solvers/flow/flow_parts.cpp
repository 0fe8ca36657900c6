#include "flow_parts.hpp"

namespace pd {

FlowParts numberFlowParts(const Model& model, const std::vector<int>& points, const std::vector<double>& names) {
  const std::vector<int>& globalIds = model.discretization().globalIds;
  FlowParts found;
  std::vector<double> own;
  for (const int point : points) {
    const auto p = static_cast<std::size_t>(point);
    found.isFirst.push_back(names[p] == static_cast<double>(globalIds[p]) ? 1 : 0);
    if (found.isFirst.back() != 0) own.push_back(names[p]);
  }
  std::vector<double> all = model.comm().gather(own);
  std::sort(all.begin(), all.end());
  found.nParts = all.size();
  for (const int point : points)
    found.partOf.push_back(static_cast<std::size_t>(
        std::lower_bound(all.begin(), all.end(), names[static_cast<std::size_t>(point)]) - all.begin()));
  return found;
}

}  // namespace pd
