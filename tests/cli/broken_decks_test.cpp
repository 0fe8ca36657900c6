// One small mistake at a time in a good deck, mesh or node set: each is reported with its place, what is wrong and the
// remedy, and ends pdrun with exit code 2.
#include "broken_decks.hpp"

#include <gtest/gtest.h>
#include <mpi.h>

#include <algorithm>
#include <sstream>

#include "driver/deck/sections.hpp"
#include "good_scene.hpp"
#include "run_pdrun.hpp"

namespace pd {
namespace {

using pd_test::Broken;
using pd_test::Outcome;
using pd_test::SceneFiles;

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  if (at == std::string::npos || text.find(from, at + 1) != std::string::npos)
    ADD_FAILURE() << "\"" << from << "\" must stand in the good deck once";
  else
    text.replace(at, from.size(), to);
  return text;
}

/// The good mesh with another fourth line.
std::string meshWith(const std::string& fourthLine) {
  std::istringstream lines(pd_test::goodMesh());
  std::string result, line;
  for (int number = 1; std::getline(lines, line); ++number) result += (number == 4 ? fourthLine : line) + "\n";
  return result;
}

/// Runs `pdrun deck.yaml` on the files of the scene; names of files in messages lose their folder.
Outcome run(const SceneFiles& scene, std::vector<std::string> arguments = {}) {
  return pd_test::runPdrun(scene, scene.path("deck.yaml"), std::move(arguments));
}

void writeScene(const SceneFiles& scene, const std::string& deck, const std::string& mesh, const std::string& nodeSet) {
  scene.write("deck.yaml", deck);
  scene.write("mesh.txt", mesh);
  scene.write("left.txt", nodeSet);
}

/// What pdrun says to the broken scene. `writesThere`: results go beside its files.
Outcome outcomeOf(const Broken& broken, std::vector<std::string> arguments, bool writesThere = false) {
  std::string deck = pd_test::goodDeck;
  for (const auto& [from, to] : broken.edits) deck = replaced(deck, from, to);
  const SceneFiles scene("broken_" + broken.name);
  writeScene(scene, deck, broken.meshLine.empty() ? pd_test::goodMesh() : meshWith(broken.meshLine),
             broken.nodeSet.empty() ? pd_test::goodNodeSet : broken.nodeSet);
  if (writesThere) arguments.insert(arguments.end(), {"--set", "Output/Output Filename=" + scene.path("results")});
  return run(scene, arguments);
}

void expectLines(const Outcome& outcome, const std::vector<std::string>& lines) {
  for (const std::string& expected : lines)
    EXPECT_NE(outcome.errors.find(expected), std::string::npos) << expected << "\n--- is not in ---\n"
                                                                << outcome.errors;
}

std::size_t countMistakes(const Outcome& outcome) {
  std::istringstream lines(outcome.errors);
  std::size_t count = 0;
  for (std::string line; std::getline(lines, line);) count += line.rfind("warning: ", 0) == 0 ? 0 : 1;
  return count;
}

class BrokenDecks : public testing::TestWithParam<Broken> {};

TEST_P(BrokenDecks, AreReportedWithPlaceAndRemedy) {
  const Broken& broken = GetParam();
  for (const std::vector<std::string>& arguments : {std::vector<std::string>{}, {"--check"}}) {
    const Outcome outcome = outcomeOf(broken, arguments);
    EXPECT_EQ(outcome.exitCode, 2);
    expectLines(outcome, broken.expected);
    // One mistake makes few lines: the reader should not have to find it among its consequences.
    EXPECT_LE(countMistakes(outcome), broken.expected.size()) << outcome.errors;
  }
}

INSTANTIATE_TEST_SUITE_P(Table, BrokenDecks, testing::ValuesIn(pd_test::brokenDecks()),
                         [](const testing::TestParamInfo<Broken>& info) { return info.param.name; });

TEST(RefusedStarts, AreKnownToTheCheck) {
  for (const Broken& broken : pd_test::refusedStarts()) {
    SCOPED_TRACE(broken.name);
    const Outcome checked = outcomeOf(broken, {"--check"});
    EXPECT_EQ(checked.exitCode, 2);
    expectLines(checked, broken.expected);
    EXPECT_EQ(countMistakes(checked), broken.expected.size()) << checked.errors;
    EXPECT_EQ(outcomeOf(broken, {}, true).exitCode, 3);
  }
}

TEST(GoodScene, IsGood) {
  const SceneFiles scene("good");
  writeScene(scene, pd_test::goodDeck, pd_test::goodMesh(), pd_test::goodNodeSet);
  const Outcome outcome = run(scene, {"--check"});
  EXPECT_EQ(outcome.exitCode, 0) << outcome.errors;
  EXPECT_EQ(outcome.errors, "");
}

TEST(BrokenFiles, AnEmptyMeshIsReported) {
  const SceneFiles scene("empty_mesh");
  writeScene(scene, pd_test::goodDeck, "# no points\n", pd_test::goodNodeSet);
  const Outcome outcome = run(scene);
  EXPECT_EQ(outcome.exitCode, 2);
  EXPECT_NE(outcome.errors.find("mesh.txt: the mesh has no points"), std::string::npos) << outcome.errors;
}

TEST(BrokenFiles, AMissingDeckIsReported) {
  const SceneFiles scene("missing_deck");
  const Outcome outcome = run(scene);
  EXPECT_EQ(outcome.exitCode, 2);
  EXPECT_EQ(outcome.errors, "deck.yaml: cannot be read (No such file or directory)\n");
}

TEST(BrokenArguments, AreReported) {
  const SceneFiles scene("arguments");
  writeScene(scene, pd_test::goodDeck, pd_test::goodMesh(), pd_test::goodNodeSet);
  const std::vector<std::pair<std::vector<std::string>, std::string>> cases{
      {{"--sett", "a=1"}, "Try pdrun --help."},
      {{"another.yaml"}, "Try pdrun --help."},
      {{"--set"}, "Try pdrun --help."},
      {{"--set", "Solver/Final Time"}, "write it as path=value"},
      {{"--set", "Solvr/Final Time=1.0"}, "the deck has no \"Solvr\" in its top level (did you mean \"Solver\"?)"},
      {{"--set", "Solver/Final Time=soon"},
       "--set \"Solver/Final Time=soon\": Solver/Final Time must be a number in s, not \"soon\""},
      {{"--set", "Solver/Final Tim=1.0"}, "unknown key \"Final Tim\" in Solver (did you mean \"Final Time\"?)"},
      {{"--check", "--restart", "x.h5"}, "deck.yaml: the start of the run: cannot open \"x.h5\": No such file"},
      {{"--explain", "Verlt"}, "nothing is called \"Verlt\" (did you mean \"Verlet\"?)"}};
  for (const auto& [arguments, expected] : cases) {
    const Outcome outcome = run(scene, arguments);
    EXPECT_EQ(outcome.exitCode, 2) << arguments.front();
    EXPECT_NE(outcome.errors.find(expected), std::string::npos) << expected << "\n--- is not in ---\n"
                                                                << outcome.errors;
  }
}

TEST(GoodScene, ResolvesToADeckThatIsGoodAndComplete) {
  const SceneFiles scene("resolved");
  writeScene(scene, pd_test::goodDeck, pd_test::goodMesh(), pd_test::goodNodeSet);
  const std::string once = resolvedDeck(Deck::read(scene.path("deck.yaml")));
  for (const char* expected : {"Count In Damage: false", "Influence Function: One", "Include Partial Neighbors: true",
                               "Volume Correction: Ramp Beyond Horizon", "Maximum Iterations: 100000"})
    EXPECT_NE(once.find(expected), std::string::npos) << expected << "\n--- is not in ---\n" << once;
  scene.write("deck.yaml", once);
  EXPECT_EQ(run(scene, {"--check"}).exitCode, 0);
  EXPECT_EQ(resolvedDeck(Deck::read(scene.path("deck.yaml"))), once);
}

TEST(GoodScene, TakesUnitsAndProductsEverywhere) {
  const SceneFiles scene("units");
  std::string deck = pd_test::goodDeck;
  for (const auto& [from, to] :
       std::vector<std::pair<std::string, std::string>>{{"  Thickness: 1.0e-3\n  Bond", "  Thickness: 1 mm\n  Bond"},
                                                        {"Lower_Left_Corner_Y: 0.5e-3", "Lower_Left_Corner_Y: 0.05 cm"},
                                                        {"Density: 7850.0", "Density: 7.85 g/cm^3"},
                                                        {"Young's Modulus: 2.0e11", "Young's Modulus: 200 GPa"},
                                                        {"Diffusivity: 1.0e-9", "Diffusivity: 1e-3 mm2/s"},
                                                        {"Critical Stretch: 0.01", "Critical Stretch: 1/100"},
                                                        {"Horizon: 3.1e-3", "Horizon: 3.1 mm"},
                                                        {"[0.0095, -1.0, -1.0]", "[9.5 mm, -100 cm, -1 m]"},
                                                        {"[10.0, 1.0e-7]", "[2*5 s, 0.1 um]"},
                                                        {"Final Time: 10.0", "Final Time: 10000 ms"},
                                                        {"Load Steps: 2", "Load Steps: 4/2"}})
    deck = replaced(deck, from, to);
  writeScene(scene, deck, pd_test::goodMesh(), pd_test::goodNodeSet);
  const std::string resolved = resolvedDeck(Deck::read(scene.path("deck.yaml")));
  for (const char* expected : {"Thickness: 0.001\n", "Lower_Left_Corner_Y: 0.0005\n", "Density: 7850.0\n",
                               "Young's Modulus: 200000000000.0\n", "Diffusivity: 1e-09\n", "Critical Stretch: 0.01\n",
                               "Horizon: 0.0031\n", "[10.0, 1e-07]", "Final Time: 10.0\n", "Load Steps: 2\n"})
    EXPECT_NE(resolved.find(expected), std::string::npos) << expected << "\n--- is not in ---\n" << resolved;
  const Outcome outcome = run(scene, {"--check", "--set", "Materials/Steel/Young's Modulus=2e5 N/mm2"});
  EXPECT_EQ(outcome.exitCode, 0) << outcome.errors;
}

TEST(GoodScene, TakesHorizonsAsExpressions) {
  const SceneFiles scene("horizon");
  writeScene(scene, pd_test::goodDeck, pd_test::goodMesh(), pd_test::goodNodeSet);
  const Outcome outcome = run(scene, {"--set", "Blocks/Plate/Horizon=\"3.1*0.001\""});
  EXPECT_EQ(outcome.exitCode, 0) << outcome.errors;
}

TEST(GoodScene, WarnsOfWhatIsNotUsed) {
  const SceneFiles scene("unused");
  const std::string deck = replaced(pd_test::goodDeck, "Damage Models:\n",
                                    "  Spare: {Material Model: PDHE, Diffusivity: 1.0}\nDamage Models:\n");
  writeScene(scene, deck, pd_test::goodMesh(), pd_test::goodNodeSet);
  const Outcome outcome = run(scene, {"--check"});
  EXPECT_EQ(outcome.exitCode, 0) << outcome.errors;
  EXPECT_EQ(outcome.errors, "warning: deck.yaml:28:3: Materials/Spare is used by no block\n");
}

}  // namespace
}  // namespace pd
