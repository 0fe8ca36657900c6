// The neighbourhoods of a rank's points, and the ghosts that they need.
#ifndef PD_NEIGHBORHOODS_HPP
#define PD_NEIGHBORHOODS_HPP

#include <vector>

#include "bond_filters.hpp"
#include "discretization.hpp"
#include "mesh_points.hpp"
#include "neighbor_search.hpp"

namespace pd {

/// Fills nOwned, nPoints, globalIds, imageSource, imageCopy, neighborhoodList, neighborhoodStart, bondIsCut and
/// shortestBond (of this rank). `points`: of the whole body, of which `discretization.symmetry` makes copies
/// (wholeBody()). `order`: all of them in the order that local numbers follow; `owner`: rank of each point of the mesh.
/// Ghosts are the points of other ranks that are neighbours of owned points before bond filters remove any, or whose
/// images are.
void buildNeighborhoods(const MeshPoints& points, const NeighborRule& rule, BondFilters& filters,
                        const std::vector<int>& order, const std::vector<int>& owner, int rank,
                        Discretization& discretization);

}  // namespace pd

#endif
