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
BondThresholds bondThresholds(std::uint32_t seed, int firstId, int secondId);

/// Of a bond to an image, whose id is `shift` more than that of the point that it mirrors (0: it is no image). The bond
/// from that point to the image of the first one is the mirror image of this bond, and has the same numbers.
BondThresholds bondThresholds(std::uint32_t seed, int firstId, int imageId, int shift);

}  // namespace pd::kernels

#endif
