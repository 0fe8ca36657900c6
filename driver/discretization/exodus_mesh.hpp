// Finite-element meshes in Exodus files: one point an element, as Peridigm makes them.
#ifndef PD_EXODUS_MESH_HPP
#define PD_EXODUS_MESH_HPP

#include <string>

#include "../deck/deck.hpp"
#include "../parallel/communicator.hpp"
#include "mesh_points.hpp"

namespace pd {

/// A point at the centroid of every tetrahedron and hexahedron (nodes on edges and faces are passed over, with a
/// warning), with its volume; spheres are points as they are, their second attribute is the volume. Points are
/// numbered as the element number map says, or in the order of the file where that is no numbering from 1 to n. A node
/// set holds the points of all elements that have a node in it. Blocks and node sets without a name are block_<id> and
/// nodelist_<id>. The file is read by the root rank, whole: it need not be cut for runs on several ranks.
///
/// Mistakes (at `place` of the deck, or naming the element) and warnings are the same on all ranks. Collective.
MeshPoints readExodusMesh(const std::string& fileName, const std::string& place, const Communicator& comm,
                          Mistakes& mistakes, Mistakes& warnings);

}  // namespace pd

#endif
