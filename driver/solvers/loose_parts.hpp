// Parts of a body that nothing holds, and how a static solution holds them.
#ifndef PD_LOOSE_PARTS_HPP
#define PD_LOOSE_PARTS_HPP

#include <numeric>
#include <string>
#include <vector>

#include "../model/model.hpp"
#include "rigid_motions.hpp"

namespace pd {

/// Degrees of freedom that a static solution does not move, so that it is unique.
struct HeldInPlace {
  std::vector<char> isHeld;           ///< [3 nOwned] prescribed, outside the dimension, or held by what follows
  long long nPointsWithoutBonds = 0;  ///< and not fully prescribed: held where they are (all ranks)

  /// A part of two points or more that could move as a rigid body.
  struct Part {
    RigidMotions motions;
    long long nPoints = 0;
    std::vector<RigidMotions::Mode> free;  ///< which of them nothing but what follows holds: orthonormal
  };
  std::vector<Part> parts;  ///< of all ranks
  static constexpr int isSupported = -1, isAlone = -2;
  std::vector<int> partOfPoint;  ///< [nOwned] index into parts; isSupported; isAlone: without bonds
  std::vector<int> copyOfPoint;  ///< [nOwned] copy of the body in which the point belongs to its part

  bool hasAny() const { return nPointsWithoutBonds > 0 || !parts.empty(); }
  long long nPointsOfParts() const {
    return std::accumulate(parts.begin(), parts.end(), 0LL,
                           [](long long sum, const Part& part) { return sum + part.nPoints; });
  }
  bool sameCounts(const HeldInPlace& other) const {
    return nPointsWithoutBonds == other.nPointsWithoutBonds && parts.size() == other.parts.size() &&
           nPointsOfParts() == other.nPointsOfParts();
  }
};

/// Parts whose prescribed displacements, and planes of symmetry that their bonds go through, leave a rigid-body motion
/// free get as many further degrees of freedom held as there are free motions: they are then statically determinate, so
/// that holding them adds no stress. The choice depends on geometry and global ids alone, not on ranks.
/// `isPrescribed` [3 nOwned], with the components outside the dimension of the mesh set. Reads Bond_Damage: a bond
/// below 1 carries force. Collective.
HeldInPlace findLooseParts(Model& model, const std::vector<char>& isPrescribed);

/// Loads that push parts along motions which nothing but findLooseParts() holds, as what is wrong with them: the force
/// and the moment on the part that carries most, where all such loads together are more than 1e-3 of all loads, or of
/// `scale` (N, of the run so far) where that is more. Empty where they are not. `isPrescribed` as there, `forceDensity`
/// [3 nOwned], N/m3. Collective.
std::string loadsThatNothingHolds(Model& model, const HeldInPlace& held, const std::vector<char>& isPrescribed,
                                  const std::vector<double>& forceDensity, double scale);
/// What can be done where a run begins with such.
constexpr const char* remedyOfLoadsNothingHolds = "prescribe displacements there, or take the load away";

}  // namespace pd

#endif
