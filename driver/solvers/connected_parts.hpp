// Parts of a body that unbroken bonds hold together.
#ifndef PD_CONNECTED_PARTS_HPP
#define PD_CONNECTED_PARTS_HPP

#include <functional>
#include <vector>

#include "../model/model.hpp"
#include "../parallel/ghost_exchange.hpp"

namespace pd {

/// A part is known by the smallest global id of its points.
struct ConnectedParts {
  std::vector<long long> names;  ///< of the parts of all ranks, ascending
  std::vector<long long> sizes;  ///< points of each part
  std::vector<int> partOfPoint;  ///< [nOwned] index into names
};

/// Bonds whose Bond_Damage is below 1 connect, whichever end lists them. Collective.
ConnectedParts findConnectedParts(Model& model, const GhostExchange& ghosts);

/// visit(owned point, neighbour, bond damage) for each directed bond of this rank; damage is zero where a block has no
/// Bond_Damage.
void forEachBond(Model& model, const std::function<void(int, int, double)>& visit);

}  // namespace pd

#endif
