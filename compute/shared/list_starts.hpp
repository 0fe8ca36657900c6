// Where the neighbours of each point of a block are in its list.
#ifndef PD_LIST_STARTS_HPP
#define PD_LIST_STARTS_HPP

#include <cstddef>
#include <vector>

#include "Peridigm_NeighborhoodData.hpp"

namespace pd {

/// [points] in the order of OwnedIDs: of the count that the neighbours follow. A compute that looks at few points need
/// not go through the list of all of them; the bonds of point p start at starts[p] - p.
inline std::vector<std::size_t> listStarts(const PeridigmNS::NeighborhoodData& points) {
  std::vector<std::size_t> starts;
  std::size_t at = 0;
  for (int p = 0; p < points.NumOwnedPoints(); ++p) {
    starts.push_back(at);
    at += static_cast<std::size_t>(points.NeighborhoodList()[at]) + 1;
  }
  return starts;
}

}  // namespace pd

#endif
