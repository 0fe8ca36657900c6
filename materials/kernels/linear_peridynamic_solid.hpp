// Forces of the linear peridynamic solid (Silling et al., J. Elasticity 88 (2007) 151), ordinary and state-based.
//
// With e = |Y| - |xi|, influence function w and the weighted volume m_i = sum_j w |xi|^2 V_j, a point has the
// dilatation
//   theta_i = 3/m_i sum_j w |xi| e V_j
// and its bonds have the force state t_ij = w [ (3 K - 5 G) theta_i |xi| + 15 G e ] / m_i along Y: the force density at
// i is
//   sum_j (t_ij + t_ji) Y/|Y| V_j.
// Each point's call adds t_ij at i and -t_ij at j.
#ifndef PD_LINEAR_PERIDYNAMIC_SOLID_HPP
#define PD_LINEAR_PERIDYNAMIC_SOLID_HPP

#include <functional>

#include "chunk_bonds.hpp"

namespace pd::kernels {

/// What the force loop needs that does not change while the neighbourhood stays.
struct SolidBondData {
  double bulkModulus = 0.0, shearModulus = 0.0;  ///< K, G
  BondConstants influence;                       ///< width 1: w
  BondConstants coefficients;                    ///< what solidCoefficients() makes; only in chunks where it is uniform
};

/// All constants of bonds of uniform chunks, from `geometry(point, neighbor, bond, values)`, which writes xi (3
/// components), w and the volume of the neighbour.
BondConstants solidCoefficients(const ChunkedNeighborhood& neighborhood,
                                const std::function<void(int, int, std::size_t, double*)>& geometry);

/// Adds the force densities (N/m3) of all unbroken bonds at their points and neighbours to `force`, and writes the
/// dilatation of the points. `points`, `weightedVolume` (m5), `dilatation`, `force` by local id.
void addSolidForce(const ChunkedNeighborhood& neighborhood, const SolidBondData& data, const AliveBonds& alive,
                   const BondPoints& points, const double* weightedVolume, double* dilatation, PointArrays& force);

}  // namespace pd::kernels

#endif
