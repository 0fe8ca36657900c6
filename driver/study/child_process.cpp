#include "child_process.hpp"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>

#include "../output/atomic_file.hpp"

namespace pd {

namespace {

/// Variables by which the runtime of Open MPI tells a process that it is part of a job.
bool belongsToThisJob(const char* variable) {
  for (const char* prefix : {"PMIX_", "OMPI_COMM_WORLD_", "OMPI_UNIVERSE_", "OMPI_APP_", "OMPI_MCA_orte_",
                             "OMPI_MCA_ess", "OMPI_MCA_pmix", "ORTE_", "PRTE_"})
    if (std::strncmp(variable, prefix, std::strlen(prefix)) == 0) return true;
  return false;
}

}  // namespace

std::string toolBeside(const std::string& program, const std::string& name) {
  const std::filesystem::path neighbor = std::filesystem::path(program).parent_path() / name;
  return std::filesystem::exists(neighbor) ? neighbor.string() : name;
}

int runProgram(const std::vector<std::string>& arguments) {
  std::vector<char*> argumentPointers, environment;
  for (const std::string& argument : arguments) argumentPointers.push_back(const_cast<char*>(argument.c_str()));
  argumentPointers.push_back(nullptr);
  for (char** variable = environ; *variable != nullptr; ++variable)
    if (!belongsToThisJob(*variable)) environment.push_back(*variable);
  environment.push_back(nullptr);
  pid_t child = 0;
  const int error =
      posix_spawnp(&child, argumentPointers[0], nullptr, nullptr, argumentPointers.data(), environment.data());
  if (error != 0) throwFileError("start", arguments.front(), error);
  int status = 0;
  while (waitpid(child, &status, 0) < 0)
    if (errno != EINTR) throwFileError("wait for", arguments.front(), errno);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace pd
