// pdrun: runs a YAML deck. See `pdrun --help`.
#include <optional>

#include "command_line/command_line.hpp"
#include "parallel/session.hpp"

int main(int argc, char** argv) {
  if (const std::optional<int> code = pd::runWithoutMpi(argc, argv)) return *code;
  // Kokkos would answer --help itself, so it sees no arguments.
  int noArguments = 1;
  char** name = argv;
  const pd::ParallelSession session(noArguments, name);
  const pd::Communicator world(MPI_COMM_WORLD);
  return pd::runCommandLine(argc, argv, world);
}
