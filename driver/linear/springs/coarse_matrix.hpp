// The stiffness of a spring network among the modes of a coarse space.
#ifndef PD_COARSE_MATRIX_HPP
#define PD_COARSE_MATRIX_HPP

#include <vector>

#include "coarse_space.hpp"

namespace pd {

/// Rows and columns of all ranks' unknowns, compressed by rows; the same on all ranks.
struct CoarseMatrix {
  std::vector<std::size_t> rowStart;
  std::vector<int> columns;
  std::vector<double> values;
};

/// P^T (K + additions) P, its diagonal raised by a little, so that parts of the body that can move without force do not
/// make it singular. `space` has exchanged. Collective.
CoarseMatrix makeCoarseMatrix(const Communicator& comm, const SpringOperator& stiffness, const CoarseSpace& space);

}  // namespace pd

#endif
