// Runs all decks of a study; its table, and pictures of error against work and of histories.
#ifndef PD_RUN_STUDY_HPP
#define PD_RUN_STUDY_HPP

#include <string>

#include "study_file.hpp"

namespace pd {

/// Throws DeckError where the results of the study cannot be written below `folder`: for links that lead elsewhere,
/// files of others that are in the way. Looks only.
void checkStudyResults(const Study& study, const std::string& folder);

/// Each run is a process of its own, on one rank, one after the other. Prints the table as it grows (unless quiet),
/// writes it as <name>.study.csv, and has pdstudy draw <name>.study.png (errors) and <name>.histories.png where that
/// tool is found beside the program or on the PATH. A run that cannot go on leaves its results empty. The study has
/// been checked. Results go below `folder` (empty: the working folder); those of an earlier study of this name are
/// removed first. Throws RunError where another run writes the same, RunError at the end where there was one, and at
/// once where the study cannot go on; DeckError where Error names no single error norm.
void runStudy(const Study& study, const std::string& folder, bool isQuiet);

}  // namespace pd

#endif
