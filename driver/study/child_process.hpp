// Programs that a study starts. Private to this folder.
#ifndef PD_CHILD_PROCESS_HPP
#define PD_CHILD_PROCESS_HPP

#include <string>
#include <vector>

namespace pd {

/// Runs arguments[0] and waits for its end; returns its exit code, or 128 + the signal that ended it. Its environment
/// holds nothing of this process's MPI, so that the child may start an MPI of its own. Throws RunError where the
/// program cannot be started.
int runProgram(const std::vector<std::string>& arguments);

/// The tool of this name that stands beside `program`; the name alone, for the PATH, where none does.
std::string toolBeside(const std::string& program, const std::string& name);

}  // namespace pd

#endif
