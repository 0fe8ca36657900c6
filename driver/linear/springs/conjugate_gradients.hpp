// Conjugate gradients on displacements of points, for any product and preconditioner.
#ifndef PD_CONJUGATE_GRADIENTS_HPP
#define PD_CONJUGATE_GRADIENTS_HPP

#include <functional>

#include "../../parallel/communicator.hpp"
#include "point_vector.hpp"

namespace pd {

struct ConjugateGradientsResult {
  int iterations = 0;
  double relativeResidual = 1.0;  ///< |b - A x| / |b|, below 1e-6 from a product with the last x
  bool hasBrokenDown = false;     ///< A or the preconditioner is not positive definite, or something is not finite
};

/// Writes the second from the first; may change ghosts and images of the first.
using PointMap = std::function<void(PointVector<double>&, PointVector<double>&)>;

/// Solves A x = b over the first nOwned points of every rank, from x = 0. Flexible (the preconditioner need be
/// symmetric and constant only nearly: Y. Notay, SIAM J. Sci. Comput. 22 (2000) 1444). Collective.
ConjugateGradientsResult conjugateGradients(const Communicator& comm, int nOwned, const PointMap& product,
                                            const PointMap& precondition, const PointVector<double>& b,
                                            PointVector<double>& x, double tolerance, int maximumIterations);

}  // namespace pd

#endif
