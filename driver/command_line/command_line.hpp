// The command line of pdrun.
#ifndef PD_COMMAND_LINE_HPP
#define PD_COMMAND_LINE_HPP

#include <string>

#include "../model/simulation.hpp"
#include "../parallel/communicator.hpp"

namespace pd {

struct CommandLine {
  enum class Action { Run, Check, Study, CheckStudy, Print, WriteReference };
  Action action = Action::Run;
  RunOptions options;
  std::string studyFile;        ///< of Study and CheckStudy
  std::string text;             ///< of Print: help, version, list or explanation
  std::string referenceFolder;  ///< of WriteReference
};

/// Throws DeckError, with the remedy, for arguments that make no sense.
CommandLine parseCommandLine(int argc, const char* const* argv);

/// Does what the arguments ask for; the root rank prints. Returns the exit code, the same on all ranks: 0; 2 for
/// mistakes in deck, mesh or arguments; 3 for a run that could not go on; 4 for a fault of pdrun itself. Where ranks
/// wait for one that has failed, the whole job is aborted with that code. Collective.
int runCommandLine(int argc, const char* const* argv, const Communicator& comm);

}  // namespace pd

#endif
