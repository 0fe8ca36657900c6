// The mesh that a deck names or describes.
#ifndef PD_MESH_READER_HPP
#define PD_MESH_READER_HPP

#include "../deck/deck.hpp"
#include "../parallel/communicator.hpp"
#include "mesh_points.hpp"
#include "node_sets.hpp"

namespace pd {

/// As `Type` of the section Discretization says: "Text File", "Exodus" or "PdQuickGrid". Mistakes of single points are
/// added to deck.mistakes(); throws DeckError where there is no mesh to go on with. Collective.
MeshPoints readMesh(const Deck& deck, const Communicator& comm);

/// The node sets of the deck and those of the mesh. Where the mesh has some, the names that conditions, bond filters,
/// computes and exact solutions use are checked here: before the mesh was read, nobody could know them. Mistakes are
/// added to deck.mistakes(). Collective.
NodeSets allNodeSets(const Deck& deck, const Communicator& comm, const MeshPoints& points);

}  // namespace pd

#endif
