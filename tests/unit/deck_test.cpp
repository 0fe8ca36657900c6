// Reading of decks: places, types, overrides, syntax errors.
#include "driver/deck/deck.hpp"

#include <Teuchos_Array.hpp>
#include <filesystem>

#include "deck_from_text.hpp"

namespace pd {
namespace {

const char* const plate = R"(# a comment
Solver:
  Final Time: 1.5
  Verlet:
    Fixed dt: 1e-7     # s
Blocks:
  My Block: {Horizon: 3, Damage Model: None}
Output:
  Output Variables: [Displacement, Damage]
)";

TEST(Deck, KnowsThePlaceOfEveryKeyAndValue) {
  const Deck deck = deckFromText(plate);
  const DeckNode step = deck["Solver"]["Verlet"]["Fixed dt"];
  EXPECT_EQ(step.place(), deckFileName() + ":5:15");
  EXPECT_EQ(step.keyPlace(), deckFileName() + ":5:5");
  EXPECT_EQ(step.path(), "Solver/Verlet/Fixed dt");
  const DeckNode horizon = deck["Blocks"]["My Block"]["Horizon"];
  EXPECT_EQ(horizon.place(), deckFileName() + ":7:23");
  EXPECT_EQ(horizon.keyPlace(), deckFileName() + ":7:14");
  const DeckNode second = deck["Output"]["Output Variables"].items()[1];
  EXPECT_EQ(second.place(), deckFileName() + ":9:36");
  EXPECT_EQ(second.path(), "Output/Output Variables[2]");
}

TEST(Deck, KeepsTheOrderOfTheFile) {
  std::vector<std::string> keys;
  for (const auto& entry : deckFromText(plate).root().entries()) keys.push_back(entry.first);
  EXPECT_EQ(keys, (std::vector<std::string>{"Solver", "Blocks", "Output"}));
}

TEST(Deck, ReadsNumbersFlagsAndText) {
  const Deck deck =
      deckFromText("A: [1, -2, 3.5, 1e-3, +4.0, .5, 2.e3, 1e-400]\nB: [true, False, yes, off]\nC: plain text\n");
  const std::vector<double> expected{1.0, -2.0, 3.5, 1.0e-3, 4.0, 0.5, 2.0e3, 0.0};
  const auto numbers = deck["A"].items();
  ASSERT_EQ(numbers.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_DOUBLE_EQ(numbers[i].real(), expected[i]);
  EXPECT_EQ(numbers[1].integer(), -2);
  const auto flags = deck["B"].items();
  EXPECT_TRUE(flags[0].flag());
  EXPECT_FALSE(flags[1].flag());
  EXPECT_TRUE(flags[2].flag());
  EXPECT_FALSE(flags[3].flag());
  EXPECT_EQ(deck["C"].text(), "plain text");
  EXPECT_DOUBLE_EQ(deck.root().real("D", 7.0), 7.0);
  EXPECT_FALSE(deck["D"]["E"].exists());
}

TEST(Deck, NamesPlaceAndPathOfAWrongType) {
  const Deck deck = deckFromText("A:\n  B: heavy\n  C: 1.5\n  D: [1]\n  E:\n  F: \"7\"\n  G: 1e999\n  H: nan\n");
  const DeckNode a = deck["A"];
  EXPECT_EQ(complaintOf([&] { a["B"].real(); }), "deck:2:6: A/B must be a finite number, not \"heavy\"");
  EXPECT_EQ(complaintOf([&] { a["C"].integer(); }), "deck:3:6: A/C must be an integer, not \"1.5\"");
  EXPECT_EQ(complaintOf([&] { a["D"].text(); }), "deck:4:6: A/D must be text, not a list");
  EXPECT_NE(complaintOf([&] { a["E"].real(); }).find("A/E must be a finite number, not nothing"), std::string::npos);
  EXPECT_NE(complaintOf([&] { a["F"].real(); }), "");
  EXPECT_NE(complaintOf([&] { a["G"].real(); }), "");
  EXPECT_NE(complaintOf([&] { a["H"].real(); }), "");
  EXPECT_EQ(complaintOf([&] { a["B"].flag(); }), "deck:2:6: A/B must be true or false, not \"heavy\"");
}

TEST(Deck, RemovesTheRootKeyOfPeridigm) {
  const Deck deck = deckFromText("Peridigm:\n  Solver:\n    Final Time: 2.0\n", {"Solver/Initial Time=1.0"});
  EXPECT_TRUE(deck.isPeridigmDeck());
  EXPECT_EQ(deck["Solver"]["Final Time"].path(), "Solver/Final Time");
  EXPECT_DOUBLE_EQ(deck["Solver"]["Initial Time"].real(), 1.0);
  EXPECT_FALSE(deckFromText(plate).isPeridigmDeck());
}

TEST(Deck, ReadsTheEscapedBracesOfPeridigm) {
  const Deck deck = deckFromText("Value: \"if(t <= 0.2)\\{ value = 0.0; \\} else\\{ value = 1.0; \\}\"\nNext: 1\n");
  EXPECT_EQ(deck["Value"].text(), "if(t <= 0.2) { value = 0.0;  } else { value = 1.0;  }");
  EXPECT_EQ(deck["Next"].integer(), 1);
}

TEST(Deck, OverridesValuesAndAddsThem) {
  const Deck deck = deckFromText(plate, {"Solver/Final Time=3", "Solver/Verlet/Safety Factor=0.5",
                                         "Output/Output Variables=[Velocity]", "Peridigm/Solver/Verbose=true"});
  EXPECT_DOUBLE_EQ(deck["Solver"]["Final Time"].real(), 3.0);
  EXPECT_DOUBLE_EQ(deck["Solver"]["Verlet"]["Safety Factor"].real(), 0.5);
  EXPECT_EQ(deck["Output"]["Output Variables"].items().size(), 1u);
  EXPECT_TRUE(deck["Solver"]["Verbose"].flag());
  EXPECT_EQ(deck["Solver"]["Final Time"].place(), "--set \"Solver/Final Time=3\"");
}

TEST(Deck, RefusesOverridesOfWhatIsNotThereAllAtOnce) {
  const std::string message = complaintOf([] {
    deckFromText(plate, {"Solvr/Final Time=1.0", "Solver/Final Time/x=1", "Solver/Final Time=", "no value", "/a=1"});
  });
  EXPECT_NE(message.find("--set \"Solvr/Final Time=1.0\": the deck has no \"Solvr\" in its top level (did you mean "
                         "\"Solver\"?)"),
            std::string::npos)
      << message;
  EXPECT_NE(message.find("Solver/Final Time is a value, not a section"), std::string::npos) << message;
  EXPECT_NE(message.find("there is no value after \"=\""), std::string::npos) << message;
  EXPECT_NE(message.find("--set \"no value\": write it as path=value"), std::string::npos) << message;
  EXPECT_NE(message.find("--set \"/a=1\": write it as path=value"), std::string::npos) << message;
}

TEST(Deck, NamesThePlaceOfASyntaxError) {
  EXPECT_EQ(complaintOf([] { deckFromText("Solver:\n  Final Time: [1.0, 2.0\nBlocks: 3\n"); }).substr(0, 23),
            "deck:3:7: YAML syntax: ");
  EXPECT_NE(complaintOf([] { deckFromText("Solver:\n\tFinal Time: 1.0\n"); }).find("deck:2:"), std::string::npos);
}

TEST(Deck, NamesEveryKeyThatIsGivenTwice) {
  const std::string message = complaintOf([] { deckFromText("A:\n  x: 1\n  y: 2\n  x: 3\nB: 1\nB: 2\n"); });
  EXPECT_EQ(message,
            "deck:4:3: key \"x\" is given twice in the same section (first in line 2); remove one of them\n"
            "deck:6:1: key \"B\" is given twice in the same section (first in line 5); remove one of them");
}

TEST(Deck, RefusesWhatIsNoDeck) {
  EXPECT_EQ(complaintOf([] { deckFromText(""); }), "deck: is empty");
  EXPECT_EQ(complaintOf([] { deckFromText("# nothing but a comment\n"); }), "deck: is empty");
  EXPECT_NE(complaintOf([] { deckFromText("[1, 2]\n"); }).find("deck:1:1: a deck is a list of sections"),
            std::string::npos);
  EXPECT_NE(complaintOf([] { deckFromText("A: 1\n---\nB: 2\n"); }).find("deck:3:1: a second YAML document"),
            std::string::npos);
  EXPECT_NE(complaintOf([] { deckFromText("[a, b]: 1\n"); }).find("deck:1:1: a key must be a name"), std::string::npos);
  EXPECT_NE(complaintOf([] { deckFromText("Peridigm: 1\n"); }).find("Peridigm must hold the sections"),
            std::string::npos);
  EXPECT_NE(
      complaintOf([] { Deck::read("no_such_deck.yaml"); }).find("no_such_deck.yaml: cannot be read (No such file"),
      std::string::npos);
  EXPECT_NE(complaintOf([] { Deck::read("."); }).find(".: is a folder"), std::string::npos);
}

TEST(Deck, AliasesCannotLoopOrBlowUp) {
  const Deck deck = deckFromText("A: &values [1, 2]\nB: *values\n");
  EXPECT_EQ(deck["B"].items().size(), 2u);
  EXPECT_EQ(deck["B"].path(), "B");
  EXPECT_NE(complaintOf([] { deckFromText("A: &loop\n  B: *loop\n"); }).find("refers to a value that contains it"),
            std::string::npos);
  std::string bomb = "a0: &a0 [x, x, x, x, x, x, x, x, x, x]\n";
  for (int i = 1; i < 9; ++i) {
    const std::string one = "*a" + std::to_string(i - 1);
    bomb += "a" + std::to_string(i) + ": &a" + std::to_string(i) + " [" + one;
    for (int k = 1; k < 10; ++k) bomb += ", " + one;
    bomb += "]\n";
  }
  EXPECT_NE(complaintOf([&] { deckFromText(bomb); }).find("aliases expand to more than"), std::string::npos);
}

TEST(Deck, DeepNestingIsAMistakeAndNoCrash) {
  EXPECT_NE(complaintOf([] { deckFromText("A: " + std::string(100000, '[') + "\n"); }), "");
}

TEST(Deck, FilesAreSeenFromTheFolderOfTheDeck) {
  std::filesystem::create_directories("deck_folder");
  std::ofstream("deck_folder/deck.yaml") << "A: 1\n";
  const Deck deck = Deck::read("deck_folder/deck.yaml");
  EXPECT_EQ(deck.directory(), "deck_folder");
  EXPECT_EQ(deck.resolvePath("mesh.txt"), "deck_folder/mesh.txt");
  EXPECT_EQ(deck.resolvePath("../mesh.txt"), "mesh.txt");
  EXPECT_EQ(deck.resolvePath("/tmp/mesh.txt"), "/tmp/mesh.txt");
}

ParameterDeclarations steel() {
  ParameterDeclarations declare;
  declare.real("Density", "kg/m3", "Mass density.").positive().required();
  declare.real("Strength", "Pa", "Strength.").between(0.0, 1.0e9).defaultTo(5.0e8);
  declare.integer("Steps", "Number of steps.").atLeast(1).defaultTo(10);
  declare.flag("Plane Stress", "Thin plate.").defaultTo(false);
  declare.text("Method", "Method.").oneOf({"Euler", "Implicit"}).defaultTo("Euler");
  declare.function("Load", "N", "Load.");
  declare.reals("Times", "s", "Times.").atLeast(0.0);
  declare.texts("Names", "Names.");
  declare.sublist("Inner", "More.").real("Radius", "m", "Radius.").positive();
  return declare;
}

TEST(DeckParameters, ConvertsToTheDeclaredTypesAndFillsDefaults) {
  const Deck deck = deckFromText(
      "A:\n  Density: 7850\n  Plane Stress: true\n  Load: 3\n  Times: [0, 1.5]\n  Names: {Damage: true, Force: false}\n"
      "  Inner: {Radius: 2}\n");
  const Teuchos::ParameterList list = deck["A"].parameters(steel());
  EXPECT_DOUBLE_EQ(list.get<double>("Density"), 7850.0);
  EXPECT_DOUBLE_EQ(list.get<double>("Strength"), 5.0e8);
  EXPECT_EQ(list.get<int>("Steps"), 10);
  EXPECT_TRUE(list.get<bool>("Plane Stress"));
  EXPECT_EQ(list.get<std::string>("Method"), "Euler");
  EXPECT_EQ(list.get<std::string>("Load"), "3");
  EXPECT_EQ(list.get<Teuchos::Array<double>>("Times").toVector(), (std::vector<double>{0.0, 1.5}));
  EXPECT_EQ(list.get<Teuchos::Array<std::string>>("Names").toVector(), std::vector<std::string>{"Damage"});
  EXPECT_DOUBLE_EQ(list.sublist("Inner").get<double>("Radius"), 2.0);
}

TEST(DeckParameters, LeavesTablesToFunction) {
  const Deck deck = deckFromText("A:\n  Density: 1.0\n  Load: {Table: [[0, 0], [1, 2]]}\n");
  EXPECT_FALSE(deck["A"].parameters(steel()).isParameter("Load"));
}

TEST(DeckParameters, ReportsAllMistakesWithTheirPlaces) {
  const Deck deck = deckFromText(
      "A:\n  Densty: 7850\n  Strength: 2e9\n  Steps: 2.5\n  Plane Stress: maybe\n  Method: Eulr\n  Load: \"2*q\"\n"
      "  Times: [0, -1]\n  Names: 3\n  Inner: {Radius: 0, Radios: 1}\n");
  const std::string message = complaintOf([&] { deck["A"].parameters(steel()); });
  for (const char* expected :
       {"deck:2:3: unknown key \"Densty\" in A (did you mean \"Density\"?); known here: \"Density\", \"Strength\"",
        "deck:3:13: A/Strength is 2000000000, must be in [0, 1000000000] Pa",
        "deck:4:10: A/Steps must be an integer >= 1, not \"2.5\" (write it without a point)",
        "deck:5:17: A/Plane Stress must be true or false, not \"maybe\"",
        "deck:6:11: A/Method \"Eulr\" is not allowed here (one of \"Euler\", \"Implicit\"); did you mean \"Euler\"?",
        "deck:7:9: cannot understand the function \"2*q\": unknown name \"q\"",
        "deck:8:14: A/Times[2] is -1, must be >= 0 s", "deck:9:10: A/Names must be a list of names, not \"3\"",
        "deck:10:19: A/Inner/Radius is 0, must be > 0 m", "deck:10:22: unknown key \"Radios\" in A/Inner"})
    EXPECT_NE(message.find(expected), std::string::npos) << expected << "\n--- is not in ---\n" << message;
}

TEST(DeckParameters, AMisspeltKeyIsNotMissingToo) {
  const auto complaint = [](const Deck& deck) { return complaintOf([&] { deck["A"].parameters(steel()); }); };
  EXPECT_EQ(complaint(deckFromText("A:\n  Steps: 3\n")),
            "deck:1:1: A lacks \"Density\" (a number > 0 kg/m3): Mass density.");
  EXPECT_EQ(complaint(deckFromText("A:\n  Densty: 3\n")).find("lacks"), std::string::npos);
}

TEST(Mistakes, AreSortedByPlaceAndNamedOnce) {
  Mistakes mistakes;
  mistakes.add("plate.yaml", "whole file");
  mistakes.add("plate.yaml:12:5", "third");
  mistakes.add("plate.yaml:2:9", "second");
  mistakes.add("plate.yaml:2:1", "first");
  mistakes.add("plate.yaml:2:1", "first");
  mistakes.sort("plate.yaml");
  EXPECT_EQ(mistakes.lines(), (std::vector<std::string>{"plate.yaml:2:1: first", "plate.yaml:2:9: second",
                                                        "plate.yaml:12:5: third", "plate.yaml: whole file"}));
}

}  // namespace
}  // namespace pd
