// This program on several ranks, started by itself.
#ifndef PD_LAUNCH_HPP
#define PD_LAUNCH_HPP

#include <string>
#include <vector>

namespace pd {

/// The file of the running program; empty where the system does not tell.
std::string ownProgram();

/// Has mpirun, or another launcher of MPI, started this process?
bool isWithinJob();

/// Runs this program with these `arguments` under mpirun on so many ranks and waits for its end; returns the exit code.
/// It works for root and with more ranks than cores, whose choice is left to the system. Ctrl-C and signals that ask
/// for an end reach the ranks, after which this process ends by the same signal; where it is killed, the ranks end too.
/// Throws DeckError where there is no mpirun. Before MPI starts only.
int runOnRanks(int nRanks, const std::vector<std::string>& arguments);

}  // namespace pd

#endif
