// The deck of a run of a study or a fit, as far as its checks ask. Private to this folder.
#ifndef PD_DECK_OF_RUN_HPP
#define PD_DECK_OF_RUN_HPP

#include <string>
#include <vector>

#include "../deck/deck.hpp"
#include "../parallel/communicator.hpp"
#include "study_file.hpp"

namespace pd {

std::vector<std::string> textsOf(const std::vector<StudyOverride>& overrides);

/// The lines of `error`, each with the place in the study or fit in place of the override that the deck's reader names.
std::vector<std::string> placedLines(const DeckError& error, const std::vector<StudyOverride>& overrides);

/// Adds a mistake where the first section for output, which the runs are named by, has another name than Output.
void requireOutput(const Deck& deck);
/// Adds a mistake where the deck writes no histories.
void requireHistories(const Deck& deck);

/// A field for the whole body with its columns of the CSV file.
struct WrittenHistory {
  std::string label;
  std::vector<std::string> columns;
};

/// What a run of the deck writes into the CSV file of its first section: what that names, and of the computes what no
/// other section names. The deck has been checked.
std::vector<WrittenHistory> historiesOf(const Deck& deck, const Communicator& comm);
/// "no run writes "A" (did you mean "B"?); there are: ...".
std::string missingHistory(const std::string& name, const std::vector<WrittenHistory>& known);

/// Of all that a discretization may depend on: runs that agree in it have one mesh.
std::string textOfMesh(const Deck& deck);

}  // namespace pd

#endif
