// pdrun: runs a YAML deck. See `pdrun --help`.
#include "command_line/command_line.hpp"
#include "parallel/session.hpp"

int main(int argc, char** argv) {
  const pd::ParallelSession session(argc, argv);
  const pd::Communicator world(MPI_COMM_WORLD);
  return pd::runCommandLine(argc, argv, world);
}
