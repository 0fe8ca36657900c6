#include "connected_points.hpp"

#include <unordered_map>
#include <unordered_set>

namespace pd {

void spread(const std::vector<ConnectedPoint>& points, std::vector<char>& isMarked, const Epetra_Comm& comm) {
  std::unordered_map<int, std::size_t> positions;
  for (std::size_t k = 0; k < points.size(); ++k) positions.emplace(points[k].globalId, k);
  std::vector<std::size_t> toVisit;
  for (std::size_t k = 0; k < points.size(); ++k)
    if (isMarked[k] != 0) toVisit.push_back(k);
  const auto mark = [&](std::size_t k) {
    if (isMarked[k] != 0) return;
    isMarked[k] = 1;
    toVisit.push_back(k);
  };

  std::unordered_set<int> told;
  for (;;) {
    std::vector<double> elsewhere;
    while (!toVisit.empty()) {
      const std::size_t k = toVisit.back();
      toVisit.pop_back();
      for (const int id : points[k].neighbors) {
        const auto found = positions.find(id);
        if (found != positions.end())
          mark(found->second);
        else if (told.insert(id).second)
          elsewhere.push_back(id);
      }
    }
    const std::vector<double> reached = gatherFromRanks(comm, elsewhere);
    if (reached.empty()) return;
    for (const double id : reached)
      if (const auto found = positions.find(static_cast<int>(id)); found != positions.end()) mark(found->second);
  }
}

}  // namespace pd
