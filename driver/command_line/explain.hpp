// What `pdrun --list` and `pdrun --explain` say, made from the declarations of plug-ins and deck sections.
#ifndef PD_EXPLAIN_HPP
#define PD_EXPLAIN_HPP

#include <string>

namespace pd {

/// All plug-ins by kind, each with its one sentence, and the sections of a deck.
std::string listEverything();

/// The parameters of a plug-in, bond filter, boundary condition or deck section. Throws DeckError where nothing has
/// this name.
std::string explain(const std::string& name);

}  // namespace pd

#endif
