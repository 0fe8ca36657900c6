// Whole runs of small decks: conditions, stages, error norms, resolved deck, restart, mistakes.
#include <gtest/gtest.h>
#include <mpi.h>
#include <yaml-cpp/yaml.h>

#include <cmath>
#include <fstream>
#include <sstream>

#include "../model_plugins.hpp"
#include "../support/scene_files.hpp"
#include "driver/model/simulation.hpp"

namespace pd::test {
namespace {

/// A row of nine points. The mode sin(pi x/8) decays under forward Euler with step 0.1 by the factor
/// 1 - 0.1 * 2 (1 - cos(pi/8)) a step, exactly. `solvers`: the sections Solver.
std::string rowDeck(const std::string& solvers) {
  return "Discretization: {Type: Text File, Input Mesh File: mesh.txt, Cross Section Area: 1.0}\n"
         "Materials: {Springs: {Material Model: Test Springs, Stiffness: 1.0, Mechanics: false}}\n"
         "Blocks: {Row: {Block Names: block_1, Material: Springs, Horizon: 1.2}}\n"
         "Boundary Conditions:\n"
         "  Ends Node Set: {Expression: \"x < 0.5 || x > 7.5\"}\n"
         "  All Node Set: {Expression: \"x > -1\"}\n"
         "  Start: {Type: Initial Concentration, Node Set: All Node Set, Value: \"sin(_pi*x/8)\"}\n"
         "  Ends: {Type: Prescribed Concentration, Node Set: Ends Node Set, Value: \"0*t\"}\n" +
         solvers +
         "Compute Class Parameters:\n"
         "  Middle: {Compute Class: Nearest_Point_Data, X: 4.0, Y: 0.0, Z: 0.0, Variable: Concentration, "
         "Output Label: Middle}\n"
         "Output:\n"
         "  Output Filename: FOLDER/row\n"
         "  Output Frequency: 10\n"
         "  Output Variables: [Concentration, Middle]\n"
         "  Checkpoint Frequency: 5\n"
         "Exact Solution:\n"
         "  Mode: {Field: Concentration, Value: \"sin(_pi*x/8)*(1 - 0.2*(1 - cos(pi/8)))^(t/0.1)\"}\n";
}

std::string solver(const std::string& name, double start, double end) {
  std::ostringstream text;
  text << name << ":\n  Initial Time: " << start << "\n  Final Time: " << end
       << "\n  Diffusion: {Method: Euler, Load Steps: " << 10 * (end - start) << ", Sub Steps: 1}\n";
  return text.str();
}

class RunDeckTest : public ::testing::Test {
 protected:
  Communicator comm{MPI_COMM_WORLD};

  pd_test::SceneFiles scene(const std::string& name, const std::string& deck) const {
    pd_test::SceneFiles files("run_" + name + "_" + std::to_string(comm.size()), MPI_COMM_WORLD);
    files.write("mesh.txt", pd_test::latticeMesh(9, 1, 1));
    std::string text = deck;
    const auto at = text.find("FOLDER");
    if (at != std::string::npos) text.replace(at, 6, files.path("."));
    files.write("deck.yaml", text);
    return files;
  }
  void run(const pd_test::SceneFiles& files, const std::vector<std::string>& overrides = {},
           const std::string& restartFile = "") const {
    RunOptions options;
    options.deckFile = files.path("deck.yaml");
    options.overrides = overrides;
    options.restartFile = restartFile;
    options.isQuiet = true;
    runDeck(options, comm);
    comm.barrier();
  }
  static std::string content(const pd_test::SceneFiles& files, const std::string& name) {
    std::ifstream file(files.path(name));
    EXPECT_TRUE(file) << files.path(name);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
  }
  static double errorNorm(const pd_test::SceneFiles& files, const std::string& name) {
    return YAML::Load(content(files, "row.report.json"))["error_norms"][name].as<double>();
  }
  std::string errorOf(const pd_test::SceneFiles& files) const {
    try {
      run(files);
    } catch (const DeckError& error) {
      return error.what();
    }
    return "no error";
  }
};

TEST_F(RunDeckTest, ReachesTheExactSolutionAndReportsItsError) {
  const auto files = scene("exact", rowDeck(solver("Solver", 0.0, 2.0)));
  run(files);
  // 20 steps of round-off.
  EXPECT_LT(errorNorm(files, "Mode relative L2 error"), 1e-14);
  EXPECT_LT(errorNorm(files, "Mode relative maximum error"), 1e-14);
  // The middle at t = 2 from the decay factor.
  std::istringstream history(content(files, "row.csv"));
  std::string line, last;
  while (std::getline(history, line)) last = line;
  const double expected = std::pow(1.0 - 0.2 * (1.0 - std::cos(M_PI / 8.0)), 20);
  EXPECT_EQ(last.substr(0, 5), "20,2,");
  EXPECT_NEAR(std::stod(last.substr(5)), expected, 1e-14);
}

TEST_F(RunDeckTest, TheResolvedDeckRunsAlike) {
  const auto files = scene("resolved", rowDeck(solver("Solver", 0.0, 2.0)));
  run(files);
  const std::string history = content(files, "row.csv");
  const std::string resolved = content(files, "row.resolved.yaml");
  comm.barrier();
  files.write("deck.yaml", resolved);
  run(files);
  EXPECT_EQ(content(files, "row.csv"), history);
}

TEST_F(RunDeckTest, SolversRunOneAfterAnother) {
  const auto whole = scene("one", rowDeck(solver("Solver", 0.0, 2.0)));
  const auto parts = scene("two", rowDeck(solver("Solver1", 0.0, 0.8) + solver("Solver2", 0.8, 2.0)));
  run(whole);
  run(parts);
  EXPECT_LT(errorNorm(parts, "Mode relative L2 error"), 1e-14);
  // Steps are counted through.
  std::istringstream history(content(parts, "row.csv"));
  int nLines = 0;
  for (std::string line; std::getline(history, line); ++nLines)
    if (nLines > 0) {
      EXPECT_EQ(std::stoi(line), nLines - 1);
    }
  EXPECT_EQ(nLines, 22);
}

TEST_F(RunDeckTest, ARunGoesOnFromACheckpointBeforeItsEnd) {
  const std::string deck = rowDeck(solver("Solver1", 0.0, 0.8) + solver("Solver2", 0.8, 2.0));
  const auto whole = scene("whole", deck), cut = scene("cut", deck);
  run(whole);
  // The last checkpoint is that of step 15, in the second solver; the rows of two more steps are made again.
  run(cut, {"Solver2/Final Time=1.7", "Solver2/Diffusion/Load Steps=9"});
  run(cut, {}, cut.path("row.checkpoint.h5"));
  EXPECT_EQ(content(cut, "row.csv"), content(whole, "row.csv"));
  EXPECT_EQ(errorNorm(cut, "Mode relative L2 error"), errorNorm(whole, "Mode relative L2 error"));
}

TEST_F(RunDeckTest, MistakesAreThrownOnAllRanks) {
  EXPECT_NE(errorOf(scene("none", rowDeck(""))).find("Solver"), std::string::npos);
  const std::string two = errorOf(scene("wrong", rowDeck("Solver: {Final Time: 1.0, Diffussion: {}}\nBlokcs: {}\n")));
  EXPECT_NE(two.find("Diffussion"), std::string::npos) << two;
  EXPECT_NE(two.find("Blokcs"), std::string::npos) << two;
  RunOptions options;
  options.deckFile = "no such deck.yaml";
  EXPECT_THROW(runDeck(options, comm), DeckError);
}

}  // namespace
}  // namespace pd::test
