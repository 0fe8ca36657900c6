// Node sets of a deck: numbers of points in files or in the deck itself, boxes, and expressions.
#ifndef PD_NODE_SETS_HPP
#define PD_NODE_SETS_HPP

#include <map>
#include <string>
#include <vector>

#include "../deck/deck.hpp"
#include "../parallel/communicator.hpp"
#include "mesh_points.hpp"

namespace pd {

/// Ids of points by name of the set as the deck writes it, sorted.
using NodeSets = std::map<std::string, std::vector<int>>;

/// Reads every node set of "Boundary Conditions": the entries whose name contains "Node Set" and that are no boundary
/// condition themselves. A value is
///   * a file of node numbers, or node numbers ("1 5 7", [1, 5, 7]); they count from 1 in the order of the mesh file;
///   * {Box: [[xlow, ylow, zlow], [xhigh, yhigh, zhigh]]}, faces included;
///   * {Expression: "x < 0.1 && y > 0"} of the reference coordinates.
/// Returns 0-based ids. Mistakes (unreadable files, numbers outside the mesh, sets without a point, two sets of one
/// name) are added to deck.mistakes(). Collective.
NodeSets readNodeSets(const Deck& deck, const Communicator& comm, const MeshPoints& points);

/// The form in which names of node sets are compared (Peridigm's rule): upper case, '_' for blanks.
std::string nodeSetKey(const std::string& name);

/// Null where no set has this name, compared by nodeSetKey().
const std::vector<int>* findNodeSet(const NodeSets& nodeSets, const std::string& name);

}  // namespace pd

#endif
