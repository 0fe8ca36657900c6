// Parts of a body that unbroken bonds hold together.
#ifndef PD_CONNECTED_PARTS_HPP
#define PD_CONNECTED_PARTS_HPP

#include <functional>
#include <vector>

#include "../model/model.hpp"

namespace pd {

/// A part is known by the smallest global id of its points. Beside planes of symmetry a part is one of the whole body,
/// seen through the points of the mesh whose images it holds: a bond to an image goes to a copy of the body.
struct ConnectedParts {
  std::vector<long long> names;  ///< of the parts of all ranks, ascending
  std::vector<long long> sizes;  ///< points of the mesh in each part
  std::vector<unsigned>
      mirrors;  ///< by part: bit c is set where it holds, of one of its points, the image in copy c, too
  std::vector<int> partOfPoint;  ///< [nOwned] index into names
  std::vector<int> copyOfPoint;  ///< [nOwned] the copy in which the point belongs to the part; 0 without planes

  /// Without a bond to anything.
  bool isSingle(std::size_t part) const { return sizes[part] == 1 && mirrors[part] == 0; }
};

/// Bonds whose Bond_Damage is below 1 connect, whichever end lists them. Collective.
ConnectedParts findConnectedParts(Model& model);

/// visit(owned point, neighbour, bond damage) for each directed bond of this rank; damage is zero where a block has no
/// Bond_Damage.
void forEachBond(Model& model, const std::function<void(int, int, double)>& visit);

}  // namespace pd

#endif
