// The order of points in memory.
#ifndef PD_ORDERING_HPP
#define PD_ORDERING_HPP

#include <vector>

namespace pd {

/// A permutation of the n points x[3 n] that follows lines of the mesh: along the longest extent of `body` first, line
/// after line. `body`: places of these points, or of some that matter most, of which x
/// may be a map that stretches (mapping makes thin bodies thick).
/// A line holds the points that lie within 3/4 `spacing` of each other in the two other directions, so that a lattice
/// is followed exactly and any other mesh in strips.
std::vector<int> lineOrder(const std::vector<double>& x, double spacing, const std::vector<double>& body);

}  // namespace pd

#endif
