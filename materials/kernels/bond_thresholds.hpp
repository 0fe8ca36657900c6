// Random numbers that belong to bonds.
#ifndef PD_BOND_THRESHOLDS_HPP
#define PD_BOND_THRESHOLDS_HPP

#include <cstdint>

namespace pd::kernels {

/// One number for each end of a bond.
struct BondThresholds {
  double ofFirst, ofSecond;
};

/// Independent uniform random numbers in (0, 1), multiples of 2^-33. They depend on the seed and on the two ids alone:
/// thresholds(s, a, b) are thresholds(s, b, a) with first and second exchanged. Philox 2x32 of Salmon, Moraes, Dror &
/// Shaw, "Parallel random numbers: as easy as 1, 2, 3", SC11 (2011): counter = the ids, key = the seed.
/// `shift`: of an image, whose mirrored bond has the same numbers (bond_name.hpp).
BondThresholds bondThresholds(std::uint32_t seed, int firstId, int secondId, int shift = 0);

}  // namespace pd::kernels

#endif
