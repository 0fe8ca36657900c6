// The conditions of a deck on the points of a mesh. Private to this folder.
#ifndef PD_CONDITION_SET_HPP
#define PD_CONDITION_SET_HPP

#include <functional>

#include "condition.hpp"

namespace pd {

using ConditionSet = std::vector<Teuchos::RCP<Condition>>;

/// The conditions of the deck in its order, with their points found and measured. `use`, which must not communicate,
/// may throw DeckError for each. Throws DeckError with all mistakes. Collective.
ConditionSet readConditions(const Deck& deck, const Discretization& mesh, const Communicator& comm,
                            const std::function<void(const Condition&)>& use);

}  // namespace pd

#endif
