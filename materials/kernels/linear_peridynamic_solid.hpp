// Forces of the linear peridynamic solid (Silling et al., J. Elasticity 88 (2007) 151), ordinary and state-based.
//
// With e = |Y| - |xi|, influence function w and the weighted volume m_i = sum_j w |xi|^2 V_j, a point has the
// dilatation
//   theta_i = 3/m_i sum_j w |xi| e V_j
// and its bonds have the force state t_ij = w [ (3 K - 5 G) theta_i |xi| + 15 G e ] / m_i along Y: the force density at
// i is
//   sum_j (t_ij + t_ji) Y/|Y| V_j.
// In a plane, where neighbourhoods are discs, the same strain energy asks for other constants (SolidConstants).
// Each point's call adds t_ij at i and -t_ij at j.
#ifndef PD_LINEAR_PERIDYNAMIC_SOLID_HPP
#define PD_LINEAR_PERIDYNAMIC_SOLID_HPP

#include <functional>

#include "bond_constants.hpp"
#include "chunk_bonds.hpp"

namespace pd::kernels {

/// In D dimensions theta_i = D/m_i sum_j w |xi| e V_j is the dilatation, in a plane the relative change of area, and
///   W = bulk/2 theta^2 + deviatoric/(2 m) sum_j w (e - theta |xi|/D)^2 V_j,
/// hence t = w (volumetric theta |xi| + deviatoric e)/m with volumetric = D bulk - deviatoric/D. W is that of the
/// elastic solid for
///   solid         bulk = K,                   deviatoric = 15 G
///   plane strain  bulk = K + G/3,             deviatoric = 8 G
///   plane stress  bulk = 9 K G/(3 K + 4 G),   deviatoric = 8 G
/// where bulk is the stiffness against a change of area, and 8 G follows from the mean of (n D n)^2 over the directions
/// n of a plane, |D|^2/4 of a deviatoric strain D (2/15 |D|^2 in space). The plane solids are those of Le, Chan &
/// Schwartz, Int. J. Numer. Meth. Engng 98 (2014) 547.
struct SolidConstants {
  double dimension = 3.0, bulk = 0.0, volumetric = 0.0, deviatoric = 0.0;
};
SolidConstants solidConstants(Geometry geometry, double bulkModulus, double shearModulus);

/// What the force loop needs that does not change while the neighbourhood stays.
struct SolidBondData {
  SolidConstants constants;
  BondConstants influence;     ///< width 1: w
  BondConstants coefficients;  ///< what solidCoefficients() makes; only in chunks where it is uniform
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
