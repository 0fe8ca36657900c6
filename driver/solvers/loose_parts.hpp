// Parts of a body that nothing holds, and how a static solution holds them.
#ifndef PD_LOOSE_PARTS_HPP
#define PD_LOOSE_PARTS_HPP

#include <vector>

#include "../model/model.hpp"

namespace pd {

/// Degrees of freedom that a static solution does not move, so that it is unique.
struct HeldInPlace {
  std::vector<char> isHeld;           ///< [3 nOwned] prescribed, outside the dimension, or held by what follows
  long long nPointsWithoutBonds = 0;  ///< and not fully prescribed: held where they are (all ranks)
  long long nLooseParts = 0;          ///< parts of two points or more that could move as a rigid body (all ranks)
  long long nPointsOfLooseParts = 0;

  bool sameCounts(const HeldInPlace& other) const {
    return nPointsWithoutBonds == other.nPointsWithoutBonds && nLooseParts == other.nLooseParts &&
           nPointsOfLooseParts == other.nPointsOfLooseParts;
  }
};

/// Parts whose prescribed displacements, and planes of symmetry that their bonds go through, leave a rigid-body motion
/// free get as many further degrees of freedom held as there are free motions: they are then statically determinate, so
/// that holding them adds no stress. The choice depends on geometry and global ids alone, not on ranks.
/// `isPrescribed` [3 nOwned], with the components outside the dimension of the mesh set. Reads Bond_Damage: a bond
/// below 1 carries force. Collective.
HeldInPlace findLooseParts(Model& model, const std::vector<char>& isPrescribed);

}  // namespace pd

#endif
