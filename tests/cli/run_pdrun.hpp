// pdrun on the files of a scene, within the process of the test.
#ifndef PD_TESTS_RUN_PDRUN_HPP
#define PD_TESTS_RUN_PDRUN_HPP

#include <gtest/gtest.h>
#include <mpi.h>

#include <string>
#include <vector>

#include "../support/scene_files.hpp"
#include "driver/command_line/command_line.hpp"

namespace pd_test {

struct Outcome {
  int exitCode = 0;
  std::string errors;  ///< names of files have lost their folder
};

/// Runs `pdrun DECK --quiet` and further `arguments`, with results in the folder of the scene.
inline Outcome runPdrun(const SceneFiles& scene, const std::string& deckPath, std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), {"pdrun", deckPath, "--quiet", "--output-folder", scene.path("")});
  std::vector<const char*> argv;
  for (const std::string& argument : arguments) argv.push_back(argument.c_str());
  Outcome outcome;
  testing::internal::CaptureStderr();
  testing::internal::CaptureStdout();
  outcome.exitCode = pd::runCommandLine(static_cast<int>(argv.size()), argv.data(), pd::Communicator(MPI_COMM_WORLD));
  testing::internal::GetCapturedStdout();
  outcome.errors = testing::internal::GetCapturedStderr();
  const std::string folder = scene.path("");
  for (std::size_t at = outcome.errors.find(folder); at != std::string::npos; at = outcome.errors.find(folder, at))
    outcome.errors.erase(at, folder.size());
  return outcome;
}

}  // namespace pd_test

#endif
