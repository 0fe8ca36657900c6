// Decks of Peridigm brought into our own form: what is left out, refused, renamed and filled in.
#include <algorithm>
#include <filesystem>

#include "deck_from_text.hpp"

namespace pd {
namespace {

/// `sections` indented below the root key.
Deck peridigmDeck(const std::string& sections) {
  std::string text = "Peridigm:\n", line;
  std::istringstream lines(sections);
  while (std::getline(lines, line)) text += "  " + line + "\n";
  return deckFromText(text);
}

bool hasLine(const Mistakes& mistakes, const std::string& part) {
  return std::any_of(mistakes.lines().begin(), mistakes.lines().end(),
                     [&](const std::string& line) { return line.find(part) != std::string::npos; });
}

TEST(PeridigmDeck, LeavesOutWhatMeansNothingHereAndSaysSo) {
  const Deck deck = peridigmDeck(R"(Verbose: false
Multiphysics: 0
Materials:
  Rock: {Material Model: Elastic, Apply Shear Correction Factor: false, Thermal Expansion Coefficient: 0.0}
Boundary Conditions:
  Create Node Set For Rank Deficient Nodes: true
Solver1:
  Peridigm Preconditioner: None
  Solve For Displacement: true
Output1:
  Output File Type: ExodusII
  Output Filename: rock
)");
  EXPECT_TRUE(deck.mistakes().empty());
  for (const char* expected :
       {":2:3: \"Verbose\" has no effect here", ":5:37: \"Apply Shear Correction Factor\" has no effect here",
        "\"Create Node Set For Rank Deficient Nodes\" has no effect here: QuasiStatic finds points and parts",
        "\"Peridigm Preconditioner\" has no effect here", "\"Solve For Displacement\" has no effect here",
        "\"Output File Type\" has no effect here: results are HDF5 with an XDMF file, not ExodusII"})
    EXPECT_TRUE(hasLine(deck.warnings(), expected)) << expected;
  // What is harmless because of its value needs no word.
  EXPECT_EQ(deck.warnings().lines().size(), 6u);
  for (const char* key : {"Verbose", "Multiphysics"}) EXPECT_FALSE(deck[key].exists()) << key;
  EXPECT_FALSE(deck["Output1"]["Output File Type"].exists());
  EXPECT_EQ(deck["Output1"]["Output Filename"].text(), "rock");
}

TEST(PeridigmDeck, RefusesWhatIsMissingHereWithARemedy) {
  const Deck deck = peridigmDeck(R"(Multiphysics: 1
Restart: true
Contact: {Search Radius: 1.0}
Data Loader: {File Name: loads.e}
Materials:
  Rock: {Material Model: Elastic, Thermal Expansion Coefficient: 1.0e-5}
Solver:
  Solve For Pressure: true
  Implicit: {Fixed dt: 1.0}
)");
  for (const char* expected :
       {":2:3: \"Multiphysics\": fluid pressure is not solved for; remove it, or set it to 0",
        ":3:3: \"Restart\": write checkpoints by \"Checkpoint Frequency\" in Output", ":4:3: \"Contact\": bodies that",
        ":5:3: \"Data Loader\": ", "\"Thermal Expansion Coefficient\" in Materials/Rock: thermal expansion is not",
        "\"Solve For Pressure\" in Solver: ", "\"Implicit\" in Solver: implicit dynamics (Newmark) is not there; use"})
    EXPECT_TRUE(hasLine(deck.mistakes(), expected)) << expected;
  EXPECT_EQ(deck.mistakes().lines().size(), 7u);
}

TEST(PeridigmDeck, NoxIsCarriedOutByQuasiStatic) {
  const Deck deck = peridigmDeck(R"(Solver:
  Final Time: 1.0
  NOXQuasiStatic:
    Nonlinear Solver: Line Search Based
    Number of Load Steps: 4
    Max Solver Iterations: 30
    Relative Tolerance: 1.0e-8
    Direction: {Method: Newton}
    Line Search: {Method: Polynomial}
    Misspelt: 1
)");
  EXPECT_FALSE(deck["Solver"]["NOXQuasiStatic"].exists());
  const DeckNode solver = deck["Solver"]["QuasiStatic"];
  EXPECT_EQ(solver["Number of Load Steps"].integer(), 4);
  EXPECT_EQ(solver["Maximum Solver Iterations"].integer(), 30);
  EXPECT_DOUBLE_EQ(solver["Relative Tolerance"].real(), 1.0e-8);
  EXPECT_FALSE(solver["Direction"].exists());
  EXPECT_TRUE(solver["Misspelt"].exists());  // for the checks to find
  EXPECT_TRUE(hasLine(deck.warnings(), "NOXQuasiStatic is carried out by QuasiStatic"));
  EXPECT_TRUE(hasLine(deck.warnings(), "\"Line Search\" has no effect here"));
}

TEST(PeridigmDeck, AdaptiveLoadSteppingLimitsHalvings) {
  const Deck deck = peridigmDeck(R"(Solver:
  QuasiStatic:
    Number of Load Steps: 4
    Adaptive Load-Stepping:
      Maximum load step reductions in one step: 3
      Maximum total load step reductions: 9
      Switch to Verlet: {Safety Factor: 0.5}
)");
  const DeckNode solver = deck["Solver"]["QuasiStatic"];
  EXPECT_EQ(solver["Maximum Load Step Reductions"].integer(), 3);
  EXPECT_FALSE(solver["Adaptive Load-Stepping"].exists());
  EXPECT_TRUE(
      hasLine(deck.warnings(), "\"Switch to Verlet\" has no effect here: a load step without equilibrium ends"));
}

TEST(PeridigmDeck, TimeStepsSayWhenASolverStartsAndEnds) {
  const Deck deck = peridigmDeck(
      "Solver:\n  Final Time: 7.0\n  QuasiStatic: {Time Steps: \"0.5 0.75 2.0\", Absolute Tolerance: 1.0}\n");
  EXPECT_DOUBLE_EQ(deck["Solver"]["Initial Time"].real(), 0.5);
  EXPECT_DOUBLE_EQ(deck["Solver"]["Final Time"].real(), 2.0);
  EXPECT_TRUE(hasLine(deck.warnings(), ":3:5: \"Final Time\" has no effect here: the Time Steps say 2.0"));
}

TEST(PeridigmDeck, TypesOfConditionsMayBeWrittenLoosely) {
  const Deck deck = peridigmDeck(R"(Boundary Conditions:
  Push: {Type: INITIAL_VELOCITY, Coordinate: Y, Value: "-t^2"}
  Warm: {Type: Initial Temperature, Coordinate: x, Value: 1.0}
)");
  const DeckNode push = deck["Boundary Conditions"]["Push"], warm = deck["Boundary Conditions"]["Warm"];
  EXPECT_EQ(push["Type"].text(), "Initial Velocity");
  EXPECT_EQ(push["Coordinate"].text(), "y");
  EXPECT_TRUE(push["Value"].isPeridigms());
  EXPECT_FALSE(warm["Coordinate"].exists());
}

TEST(PeridigmDeck, HasPeridigmsDefaults) {
  const char* const sections = R"(Materials:
  Rock: {Material Model: Elastic}
  Steel: {Material Model: PDHE}
Solver1: {Verlet: }
Solver2: {QuasiStatic: {Number of Load Steps: 1}}
)";
  const Deck deck = peridigmDeck(sections);
  EXPECT_EQ(deck["Solver1"]["Verlet"]["Critical Step"].text(), "Bulk Modulus");
  EXPECT_TRUE(deck["Solver2"]["QuasiStatic"]["Velocity From Increments"].flag());
  EXPECT_EQ(deck["Materials"]["Rock"]["Volume Correction"].text(), "Every Neighbor");
  EXPECT_FALSE(deck["Materials"]["Steel"]["Volume Correction"].exists());  // not Peridigm's own
  EXPECT_FALSE(deckFromText(sections)["Solver1"]["Verlet"]["Critical Step"].exists());
}

TEST(PeridigmDeck, FilesMayBeInTheWorkingFolder) {
  const std::string folder = deckFileName() + "_folder", name = deckFileName() + "_mesh.txt";
  std::filesystem::create_directory(folder);
  const auto read = [&](const char* text) {
    std::ofstream(folder + "/deck.yaml") << text;
    return Deck::read(folder + "/deck.yaml");
  };
  const Deck deck = read("Peridigm: {Solver: {Verlet: {}}}\n");
  EXPECT_EQ(deck.resolvePath(name), folder + "/" + name);  // which a message would name
  std::ofstream{name};
  EXPECT_EQ(deck.resolvePath(name), name);
  EXPECT_EQ(read("Solver: {Verlet: {}}\n").resolvePath(name), folder + "/" + name);
  std::ofstream{folder + "/" + name};
  EXPECT_EQ(deck.resolvePath(name), folder + "/" + name);
  std::filesystem::remove_all(folder);
  std::filesystem::remove(name);
}

TEST(PeridigmDeck, OurOwnDecksAreLeftAlone) {
  const Deck deck = deckFromText("Verbose: true\nSolver: {NOXQuasiStatic: {}}\n");
  EXPECT_TRUE(deck["Verbose"].exists());
  EXPECT_TRUE(deck["Solver"]["NOXQuasiStatic"].exists());
  EXPECT_TRUE(deck.warnings().empty());
}

}  // namespace
}  // namespace pd
