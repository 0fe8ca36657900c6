// Whether volumes, spacing and horizon fit each other, seen before any long search.
#ifndef PD_RESOLUTION_CHECK_HPP
#define PD_RESOLUTION_CHECK_HPP

#include <vector>

#include "../deck/deck.hpp"
#include "mesh_points.hpp"
#include "neighbor_search.hpp"

namespace pd {

/// Looks at a sample of the points. Adds a mistake where volumes do not belong to the distances between points (the
/// wrong thickness, millimetres mixed with metres), and where the neighbourhoods would hold more bonds than lists on
/// `nRanks` ranks can, of one of the `nCopies` copies that `points` are of. `spacing`: from the volumes, empty where
/// nothing depends on it. Warns where horizons are hardly larger than spacings.
void checkResolution(const Deck& deck, const MeshPoints& points, const std::vector<double>& spacing, int dimension,
                     const NeighborRule& rule, int nRanks, int nCopies);

}  // namespace pd

#endif
