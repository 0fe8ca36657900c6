// The test of bonds against their critical stretch.
#ifndef PD_STRETCH_KERNEL_HPP
#define PD_STRETCH_KERNEL_HPP

#include <array>
#include <functional>
#include <limits>

#include "alive_bonds.hpp"
#include "chunked_neighborhood.hpp"
#include "point_arrays.hpp"

namespace pd::kernels {

/// s_c of a bond as a function of the mean psi in [0, 1] of its ends: s0 times a polynomial of the coverage, or the
/// square root of one (where the polynomial scales the fracture energy, s_c being proportional to its root).
struct CriticalStretchLaw {
  double stretch = 0.0;                                     ///< s_c without hydrogen
  std::array<double, 4> polynomial = {1.0, 0.0, 0.0, 0.0};  ///< in psi
  bool scalesEnergy = false;
  /// Bonds shorter than (1 - this) times their length break too; infinite: they do not.
  double compressiveStretch = std::numeric_limits<double>::infinity();

  double at(double psi) const;
};

/// Calls onBreak(chunk, k, lane) for every unbroken bond whose stretch exceeds the law's. `coverage`: psi by local id,
/// already in [0, 1], or null. The test compares squared lengths, and decides the same from both ends of a bond.
void findOverstretchedBonds(const ChunkedNeighborhood& neighborhood, const AliveBonds& alive, int dimension,
                            const PointArrays& reference, const PointArrays& current, const double* coverage,
                            const CriticalStretchLaw& law, const std::function<void(const Chunk&, int, int)>& onBreak);

}  // namespace pd::kernels

#endif
