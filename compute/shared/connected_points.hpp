// Points of all ranks that hang together.
#ifndef PD_CONNECTED_POINTS_HPP
#define PD_CONNECTED_POINTS_HPP

#include <vector>

#include "compute_support.hpp"

namespace pd {

struct ConnectedPoint {
  int globalId;
  std::vector<int> neighbors;  ///< global ids; those that are in nobody's list are passed over
};

/// Marks the points that hang together with marked ones. `points`: of this rank, each in the list of one rank alone;
/// `isMarked`: one a point. Collective.
void spread(const std::vector<ConnectedPoint>& points, std::vector<char>& isMarked, const Epetra_Comm& comm);

}  // namespace pd

#endif
