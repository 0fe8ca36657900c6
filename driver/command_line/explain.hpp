// What `pdrun --list` and `pdrun --explain` say on a terminal.
#ifndef PD_EXPLAIN_HPP
#define PD_EXPLAIN_HPP

#include <string>
#include <vector>

#include "reference.hpp"

namespace pd {

/// All plug-ins by kind, each with its one sentence, and the sections of a deck.
std::string listEverything();

/// How numbers of a deck may be written, a sentence.
extern const char* const numbersOfDecks;

/// The keys of a plug-in, of a type of mesh, bond filter or condition, or of a section of a deck or study; for a
/// section also what may stand in it. Throws DeckError where nothing has this name.
std::string explain(const std::string& name);
/// All of them.
std::string explainEverything();

/// The chapters of the reference cut down to the sections and topics of this name. Throws DeckError where there are
/// none.
std::vector<ReferenceChapter> chaptersAbout(const std::string& name);

}  // namespace pd

#endif
