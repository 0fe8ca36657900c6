// Which entry of "Blocks" a block of the mesh belongs to, and the horizon that it gives to its points.
#ifndef PD_BLOCK_HORIZONS_HPP
#define PD_BLOCK_HORIZONS_HPP

#include <map>
#include <vector>

#include "../deck/deck.hpp"
#include "horizon_shape.hpp"
#include "mesh_points.hpp"

namespace pd {

/// Sorted numbers of the blocks that the points belong to.
std::vector<int> blockNumbersOf(const MeshPoints& points);

/// The deck's entry of each block of the mesh. `Block Names` lists blocks as "block_1 block_2", or by the names that
/// the mesh gives them; "default" stands for all that no entry names. Blocks without an entry, entries without a block
/// and blocks with two entries are added to deck.mistakes().
std::map<int, DeckNode> entriesOfBlocks(const Deck& deck, const std::vector<int>& blockNumbers,
                                        const MeshPoints& points);

/// [n] Horizon of every point, m: the number or function of x, y, z in its block's entry. Values that are not positive
/// and finite are added to `mistakes`.
std::vector<double> pointHorizons(const MeshPoints& points, const std::map<int, DeckNode>& entries, Mistakes& mistakes);

/// The shape that the materials of these entries give to the horizon (keys Horizon Axes, Horizon Rotation, Horizon
/// Shape). Shapes that differ are added to deck.mistakes(): the neighbourhoods of all points are of one kind.
kernels::HorizonShape horizonShape(const Deck& deck, const std::map<int, DeckNode>& entries);

}  // namespace pd

#endif
