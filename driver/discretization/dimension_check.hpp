// Whether materials are made for bars, planes or solids as their mesh is.
#ifndef PD_DIMENSION_CHECK_HPP
#define PD_DIMENSION_CHECK_HPP

#include <map>
#include <string>

#include "../deck/deck.hpp"

namespace pd {

/// Adds a mistake for each material whose constants are those of another dimension than the mesh has: of those that say
/// by "Plane Stress", "Plane Strain" or "One Dimensional" which they are of. In decks of Peridigm a warning, since
/// there it is no mistake. `entries`: of Blocks, by number of the block; `mesh`: its file.
void checkDimensions(const Deck& deck, const std::map<int, DeckNode>& entries, int dimension, const std::string& mesh);

}  // namespace pd

#endif
