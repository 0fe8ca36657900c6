// Forces of the two-parameter bond model.
//
// A bond xi that has become Y = xi + eta carries the force density (per volume of the neighbour)
//   objective   f = (k_n - k_t) s n + k_t (Y - (R_i + R_j)/2 xi) / |xi|,   s = (|Y| - |xi|)/|xi|,  n = Y/|Y|
//   linear      f = (k_n - k_t) (eta.m) m / |xi| + k_t eta / |xi|,         m = xi/|xi|   (as printed in the seed)
// times the influence function, the share of the neighbour's volume and the surface factor (together g).
// R_i is the rotation of the whole neighbourhood of i (rotation.hpp). Since R_i makes the energy
//   W_i = 1/2 sum_j g |xi|/2 [ (k_n - k_t) s^2 + k_t |Y - R_i xi|^2/|xi|^2 ] V_j
// stationary, f is exactly -dW/du: the force is objective and conserves linear and angular momentum. For small
// rotations and R = I both forms are the two-parameter model of the literature; for k_t = 0 the objective form is
// bond-based PD.
#ifndef PD_TWO_PARAMETER_BOND_HPP
#define PD_TWO_PARAMETER_BOND_HPP

#include <functional>

#include "alive_bonds.hpp"
#include "bond_constants.hpp"
#include "chunked_neighborhood.hpp"
#include "point_arrays.hpp"

namespace pd::kernels {

enum class TangentialForm { Objective, Linear };

/// What the force loop needs that does not change while the neighbourhood stays.
struct BondForceData {
  int dimension = 3;
  TangentialForm form = TangentialForm::Objective;
  ElasticConstants constants;  ///< k_n, k_t
  BondConstants strength;      ///< width 1: g
  BondConstants coefficients;  ///< what bondCoefficients() makes; only in chunks where it is uniform
};

/// All constants of bonds of uniform chunks, from `geometry(point, neighbor, bond, values)`, which writes xi
/// (`dimension` components), g and the volume of the neighbour. The latter three are taken from `data`.
BondConstants bondCoefficients(const ChunkedNeighborhood& neighborhood, const BondForceData& data,
                               const std::function<void(int, int, std::size_t, double*)>& geometry);

/// Adds the force densities (N/m3) of all unbroken bonds to `force`: complete sums at the points of the neighbourhood
/// in the linear form and for k_t = 0. In the objective form the part -k_t g R_j xi/(2 |xi|) V_j of a bond is added by
/// its neighbour's call instead, so that the sum over all points' calls is complete. `reference`, `displacement`,
/// `volume`, `force` by local id.
void addTwoParameterForce(const ChunkedNeighborhood& neighborhood, const BondForceData& data, const AliveBonds& alive,
                          const PointArrays& reference, const PointArrays& displacement, const double* volume,
                          PointArrays& force);

}  // namespace pd::kernels

#endif
