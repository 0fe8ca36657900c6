// An order of elimination for the points of a spring network.
#ifndef PD_DISSECTION_HPP
#define PD_DISSECTION_HPP

#include <cstddef>
#include <vector>

#include "spring_network.hpp"

namespace pd {

/// Points as they are to be eliminated, group by group.
struct Dissection {
  std::vector<int> points;
  std::vector<std::size_t> ends;  ///< of the groups, in points

  void addGroup(const std::vector<int>& group);
};

/// These owned points. Nested dissection (A. George, SIAM J. Numer. Anal. 10 (1973) 345): the points are cut in two
/// across the side that leaves fewer points with springs to the other half; those come after both halves, as a group;
/// so do the halves in turn.
Dissection dissect(const SpringNetwork& network, std::vector<int> points);

}  // namespace pd

#endif
