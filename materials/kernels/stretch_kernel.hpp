// The test of bonds against their critical stretch.
#ifndef PD_STRETCH_KERNEL_HPP
#define PD_STRETCH_KERNEL_HPP

#include <array>
#include <functional>
#include <limits>
#include <vector>

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
  /// Bound of |d s_c / d psi| over [0, 1]; infinite where a square root meets zero.
  double steepest() const;
};

/// What the stretch of bonds is computed from. `reference2`: width 1, |xi|^2, only in chunks where it is uniform.
/// `coverage`: component 0 is psi, already in [0, 1]; or null.
struct StretchFields {
  int dimension;
  const BondConstants& reference2;
  const PointArrays& reference;
  const PointArrays& current;
  const PointArrays* coverage;
};

/// Calls onBreak(chunk, k, lanes) wherever unbroken bonds of the chunks `only` (all where it is null) exceed the law's
/// stretch, with a bit for each lane that does. The test compares squared lengths, and decides the same from both ends
/// of a bond. `slack`, where given, becomes for each tested chunk a length (m) by which any of its other bonds must
/// grow (or shrink, where compression breaks) at least before it breaks.
void findOverstretchedBonds(const ChunkedNeighborhood& neighborhood, const AliveBonds& alive,
                            const StretchFields& fields, const CriticalStretchLaw& law,
                            const std::function<void(const Chunk&, int, unsigned char)>& onBreak,
                            const std::vector<std::size_t>* only, std::vector<double>* slack);

}  // namespace pd::kernels

#endif
