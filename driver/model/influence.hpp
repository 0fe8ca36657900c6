// The influence function of a run.
#ifndef PD_INFLUENCE_HPP
#define PD_INFLUENCE_HPP

#include "../deck/deck.hpp"

namespace pd {

/// Sets PeridigmNS::InfluenceFunction from the Discretization key "Influence Function": One (default), Parabolic
/// Decay, Gaussian, or an expression in `zeta` and `horizon`. Throws DeckError.
void setInfluenceFunction(const Deck& deck);

}  // namespace pd

#endif
