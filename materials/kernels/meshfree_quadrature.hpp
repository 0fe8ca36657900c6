// Weights of neighbours that integrate quadratic fields exactly, however the points lie.
#ifndef PD_MESHFREE_QUADRATURE_HPP
#define PD_MESHFREE_QUADRATURE_HPP

#include <vector>

#include "bond_constants.hpp"

namespace pd::kernels {

/// The weights w_j, m3, of least norm for which sum_j kernel(|xi_j|) p(xi_j) w_j is the integral of kernel p over the
/// ball of radius `horizon`, for all p of first and second order in the components of xi. Neighbours that are missing
/// (at a face of the body) are made up for by the others. `xi`: [3 n] m, of bonds in three dimensions. Empty where n
/// neighbours cannot do it: there are fewer than 9, or they lie in a plane.
/// Trask, You, Yu & Parks, CMAME 343 (2019) 151.
std::vector<double> meshfreeWeights(const std::vector<double>& xi, double horizon, DiffusionKernel kernel);

}  // namespace pd::kernels

#endif
