// One name for a bond, whichever of its ends looks, and for its mirror image.
#ifndef PD_BOND_NAME_HPP
#define PD_BOND_NAME_HPP

#include <algorithm>

namespace pd::kernels {

struct BondName {
  int low, high;  ///< ids of its ends
  bool isLowTheFirst;
};

/// `secondId` of an image is `shift` more than that of the point which it mirrors (0: it is no image). The bond from
/// that point to the image of the first one is the mirror image of this bond, and has the same name.
inline BondName bondName(int firstId, int secondId, int shift = 0) {
  const int mirrored = secondId - shift;
  if (shift == 0 || firstId <= mirrored)
    return {std::min(firstId, secondId), std::max(firstId, secondId), firstId <= secondId};
  const BondName image = bondName(mirrored, firstId + shift);
  return {image.low, image.high, !image.isLowTheFirst};
}

}  // namespace pd::kernels

#endif
