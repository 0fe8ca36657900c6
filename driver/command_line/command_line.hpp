// The command line of pdrun.
#ifndef PD_COMMAND_LINE_HPP
#define PD_COMMAND_LINE_HPP

#include <optional>
#include <string>

#include "../model/simulation.hpp"
#include "../parallel/communicator.hpp"

namespace pd {

struct CommandLine {
  enum class Action { Run, Check, Study, CheckStudy, Fit, CheckFit, Print, WriteReference };
  Action action = Action::Run;
  RunOptions options;
  int nRanks = 0;               ///< of a run or check that starts itself under mpirun; 0: as it was started
  std::string studyFile;        ///< of Study and CheckStudy
  std::string fitFile;          ///< of Fit and CheckFit
  std::string text;             ///< of Print: help, version, list or explanation
  std::string referenceFolder;  ///< of WriteReference
};

/// Throws DeckError, with the remedy, for arguments that make no sense.
CommandLine parseCommandLine(int argc, const char* const* argv);

/// Does what needs no MPI in this process, outside of a job of MPI: prints help, lists and explanations, tells mistakes
/// of the arguments, hands a run on several ranks to mpirun. Returns the exit code, nothing where runCommandLine() has
/// to follow.
std::optional<int> runWithoutMpi(int argc, const char* const* argv);

/// Does what the arguments ask for; the root rank prints. Returns the exit code, the same on all ranks: 0; 2 for
/// mistakes in deck, mesh or arguments; 3 for a run that could not go on; 4 for a fault of pdrun itself. Where ranks
/// wait for one that has failed, the whole job is aborted with that code. Collective.
int runCommandLine(int argc, const char* const* argv, const Communicator& comm);

}  // namespace pd

#endif
