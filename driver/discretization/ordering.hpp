// The order of points in memory.
#ifndef PD_ORDERING_HPP
#define PD_ORDERING_HPP

#include <vector>

namespace pd {

/// A permutation of the n points x[3 n] that follows lines of the mesh: along the longest extent first, line after
/// line. A line holds the points that lie within 3/4 `spacing` of each other in the two other directions, so that a
/// lattice is followed exactly and any other mesh in strips. Depends on the coordinates alone, not on ranks.
std::vector<int> lineOrder(const std::vector<double>& x, double spacing);

}  // namespace pd

#endif
