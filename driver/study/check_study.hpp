// The checks of a study that need its deck.
#ifndef PD_CHECK_STUDY_HPP
#define PD_CHECK_STUDY_HPP

#include "../parallel/communicator.hpp"
#include "study_file.hpp"

namespace pd {

/// Checks the deck of every run, whether it gives what the study asks for, and, where `withMeshes`, reads its mesh and
/// node sets (each that differs once). Finds the columns of the histories. Adds all mistakes: those of
/// values that the study overrides by their place in it, those of the deck by theirs; each said once, with the first
/// series that has it.
void checkStudy(Study& study, const Communicator& comm, bool withMeshes, Mistakes& mistakes);

}  // namespace pd

#endif
