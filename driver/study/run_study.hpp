// Runs all decks of a study; its table, and pictures of error against work and of histories.
#ifndef PD_RUN_STUDY_HPP
#define PD_RUN_STUDY_HPP

#include "study_file.hpp"

namespace pd {

/// Each run is a process of its own, on one rank, one after the other. Prints the table as it grows (unless quiet),
/// writes it as <name>.study.csv, and has pdstudy draw <name>.study.png (errors) and <name>.histories.png where that
/// tool is found beside the program or on the PATH. A run that cannot go on leaves its results empty. The study has
/// been checked. Throws RunError at the end where there was one, and at once where the study cannot go on; DeckError
/// where Error names no single error norm.
void runStudy(const Study& study, bool isQuiet);

}  // namespace pd

#endif
