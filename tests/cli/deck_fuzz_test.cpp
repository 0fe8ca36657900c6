// Mutated decks, meshes and node sets: pdrun --check says yes or no, and never crashes, hangs or fails otherwise.
#include <gtest/gtest.h>
#include <mpi.h>

#include <cstdlib>
#include <random>
#include <sstream>

#include "../support/scene_files.hpp"
#include "driver/command_line/command_line.hpp"
#include "driver/deck/sections.hpp"
#include "good_scene.hpp"

namespace pd {
namespace {

/// Changes texts at random, the same way in every run.
class Mutator {
 public:
  explicit Mutator(unsigned seed) : random_(seed) {}

  std::string mutate(std::string text) {
    for (std::size_t n = below(3) == 0 ? 3 : 1; n > 0; --n) text = once(std::move(text));
    return text;
  }

 private:
  std::size_t below(std::size_t n) { return n == 0 ? 0 : random_() % n; }

  std::string once(std::string text) {
    switch (below(8)) {
      case 0:  // any byte
        if (!text.empty()) text[below(text.size())] = static_cast<char>(below(256));
        return text;
      case 1:  // a piece of YAML or of a function
        return text.insert(below(text.size() + 1), piece());
      case 2:  // cut off
        return text.substr(0, below(text.size() + 1));
      case 3: {  // a hole
        const std::size_t at = below(text.size());
        return text.erase(at, below(30));
      }
      case 4:
        return withLines(text, [&](std::vector<std::string>& lines) { lines.erase(lines.begin() + line(lines)); });
      case 5:
        return withLines(text, [&](std::vector<std::string>& lines) {
          std::swap(lines[below(lines.size())], lines[below(lines.size())]);
        });
      case 6:
        return withLines(text, [&](std::vector<std::string>& lines) {
          const std::string copy = lines[below(lines.size())];
          lines.insert(lines.begin() + line(lines), copy);
        });
      default:  // another value
        return withLines(text, [&](std::vector<std::string>& lines) {
          std::string& victim = lines[below(lines.size())];
          const std::size_t colon = victim.find(": ");
          victim = (colon == std::string::npos ? "" : victim.substr(0, colon + 2)) + value();
        });
    }
  }

  std::string piece() {
    static const std::vector<std::string> pieces{
        ":",           ": ",  "- ",       "[",      "]",    "{",  "}",    "\"",           "'",
        "#",           "&a ", "*a",       "!!int ", "|\n",  "? ", "\n",   "\n   ",        "\t",
        "%",           "@",   "---\n",    "...\n",  "<<: ", "\\", "\xff", "\xef\xbb\xbf", "e",
        "1e999",       "nan", "Infinity", "-",      ",",    "~",  "null", "true",         "Solver: ",
        "Peridigm:\n", "\r",  "=="};
    return pieces[below(pieces.size())];
  }

  std::string value() {
    static const std::vector<std::string> values{"",
                                                 "0",
                                                 "-1",
                                                 "1e300",
                                                 "-1e-300",
                                                 "nan",
                                                 "1e999",
                                                 "[]",
                                                 "{}",
                                                 "[[], []]",
                                                 "true",
                                                 "\"x\"",
                                                 "99999",
                                                 "~",
                                                 "One",
                                                 "x",
                                                 "t",
                                                 "2.5",
                                                 "[0]",
                                                 "{a: b}",
                                                 "\"while(1)\"",
                                                 "value = x",
                                                 "{Table: []}",
                                                 "{Table: [[0, 1], [0, 2]]}",
                                                 "{Box: [[0,0,0],[1,1,1]]}",
                                                 "/",
                                                 ".",
                                                 "block_1 block_1",
                                                 "PDHE",
                                                 "Euler",
                                                 "Verlet",
                                                 "2147483647",
                                                 "default",
                                                 "\"1/0\"",
                                                 "None",
                                                 "Displacement"};
    return values[below(values.size())];
  }

  template <class Change>
  std::string withLines(const std::string& text, const Change& change) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string one; std::getline(stream, one);) lines.push_back(one);
    if (lines.empty()) return text;
    change(lines);
    std::string result;
    for (const std::string& one : lines) result += one + "\n";
    return result;
  }

  std::ptrdiff_t line(const std::vector<std::string>& lines) {
    return static_cast<std::ptrdiff_t>(below(lines.size()));
  }

  std::mt19937 random_;
};

struct Counts {
  int good = 0, bad = 0;
};

/// Checks `count` scenes, each with its deck, mesh and node set as `mutate` changes them.
template <class Mutate>
Counts checkMutants(const std::string& name, int count, const Mutate& mutate) {
  const pd_test::SceneFiles scene("fuzz_" + name);
  const Communicator comm(MPI_COMM_WORLD);
  Counts counts;
  for (int i = 0; i < count; ++i) {
    std::string deck = pd_test::goodDeck, mesh = pd_test::goodMesh(), nodeSet = pd_test::goodNodeSet;
    mutate(static_cast<unsigned>(i), deck, mesh, nodeSet);
    scene.write("deck.yaml", deck);
    scene.write("mesh.txt", mesh);
    scene.write("left.txt", nodeSet);
    const std::string fileName = scene.path("deck.yaml");
    const char* argv[] = {"pdrun", "--check", fileName.c_str()};
    testing::internal::CaptureStderr();
    testing::internal::CaptureStdout();
    const int code = runCommandLine(3, argv, comm);
    testing::internal::GetCapturedStdout();
    const std::string errors = testing::internal::GetCapturedStderr();
    EXPECT_TRUE(code == 0 || code == 2) << "mutant " << i << ": exit code " << code << "\n" << errors << "\n" << deck;
    if (code == 2) {
      EXPECT_NE(errors, "") << "mutant " << i;
    }
    ++(code == 0 ? counts.good : counts.bad);
  }
  return counts;
}

TEST(Fuzz, MutatedDecks) {
  const Counts counts = checkMutants("decks", 1200, [](unsigned seed, std::string& deck, std::string&, std::string&) {
    deck = Mutator(seed).mutate(deck);
  });
  // Both answers occur: neither are all mutants stopped by the YAML reader, nor are all harmless.
  EXPECT_GT(counts.good, 20);
  EXPECT_GT(counts.bad, 300);
}

TEST(Fuzz, MutatedMeshes) {
  const Counts counts = checkMutants("meshes", 300, [](unsigned seed, std::string&, std::string& mesh, std::string&) {
    mesh = Mutator(seed).mutate(mesh);
  });
  EXPECT_GT(counts.bad, 100);
}

TEST(Fuzz, MutatedNodeSets) {
  const Counts counts = checkMutants(
      "node_sets", 200,
      [](unsigned seed, std::string&, std::string&, std::string& nodeSet) { nodeSet = Mutator(seed).mutate(nodeSet); });
  EXPECT_GT(counts.bad, 50);
}

// Formulas of a deck, wherever it may have one.

/// A bar that dissolves, with the formula at one of the places that take one.
std::string deckWithFormula(std::size_t place, const std::string& formula) {
  const std::vector<std::string> good{"5.1e3*(1 + pH)", "2 - C/4", "5.1e3", "3.1e-3",
                                      "x < 0.005",      "0.1*x",   "1 + t", "1/zeta"};
  std::vector<std::string> formulas;
  for (std::size_t i = 0; i < good.size(); ++i) formulas.push_back("\"" + (i == place ? formula : good[i]) + "\"");
  return "Discretization: {Type: Text File, Input Mesh File: mesh.txt, Thickness: 1.0e-3, Influence Function: " +
         formulas[7] +
         "}\nMaterials:\n  Metal: {Material Model: Corrosion Dissolution, Plane Strain: true, Thickness: 1.0e-3, "
         "Diffusivity: 8.6e-10, Charge Number: 2.19, Solid Concentration: 142900.0, Saturation Concentration: 4600.0, "
         "Phase Blocks: [block_1], Phase Current Densities: [" +
         formulas[2] + "], Current Density: " + formulas[0] + ", pH: " + formulas[1] +
         "}\nDamage Models:\n  Phases: {Damage Model: Dissolution}\nBlocks:\n  Bar: {Block Names: block_1, Material: "
         "Metal, Damage Model: Phases, Horizon: " +
         formulas[3] + "}\nBoundary Conditions:\n  Solid Node Set: {Expression: " + formulas[4] +
         "}\n  Start: {Type: Initial Concentration, Node Set: Solid Node Set, Value: " + formulas[5] +
         "}\nSolver:\n  Final Time: 10.0\n  Corrosion: {Fixed dt: 1.0}\nExact Solution:\n  Metal: {Field: "
         "Concentration, Value: " +
         formulas[6] + "}\nOutput: {Output Filename: results, Output Variables: [Concentration]}\n";
}

/// A formula that somebody may write, changed at random.
std::string mutatedFormula(unsigned seed) {
  static const std::vector<std::string> honest{
      "5.1e3*sqrt(1 - C/4.0)",
      "1.0e4*pow(10, 1.151*exp(-0.723*pH) - 7.647)",
      "value = 5.1e3; if (C > 2) { value = 2*C; } else { double a = C^2; value = a; }",
      "double r = sqrt(x^2 + y^2); value = r < 1e-3 ? 1 : 0;",
      "min(t/10, 1)*erfc(x/2.0e-3)",
      "x < 0.005 && y > 0",
      "3 mm",
      "2*3600 h"};
  static const std::vector<std::string> pieces{"1..2",
                                               "while (value < 2) ",
                                               "for (;;) ",
                                               "printf(x)",
                                               "readline('/etc/hostname', C)",
                                               "value",
                                               "=",
                                               "==",
                                               ";",
                                               "{",
                                               "}",
                                               "(",
                                               ")",
                                               "[",
                                               "]",
                                               "/0",
                                               "^",
                                               "^-9e9",
                                               "-",
                                               "*",
                                               "sqrt(-1)",
                                               "log(",
                                               "if",
                                               "else ",
                                               "int ",
                                               "double ",
                                               ",",
                                               "?",
                                               ":",
                                               "!",
                                               "&&",
                                               "||",
                                               "1e999",
                                               "nan",
                                               "inf",
                                               "x",
                                               "y",
                                               "z",
                                               "t",
                                               "C",
                                               "pH",
                                               "zeta",
                                               "horizon",
                                               "e",
                                               "E",
                                               ".",
                                               " GPa",
                                               " m",
                                               "%",
                                               "//",
                                               "/*",
                                               "*/",
                                               "#",
                                               "'",
                                               "\\\\",
                                               "\\0",
                                               "gamma(",
                                               "i0(",
                                               "pow(",
                                               "min(",
                                               "_pi",
                                               "\\n",
                                               "0x10",
                                               "\xc2\xb5"};
  std::mt19937 random(seed);
  const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random()) % n; };
  std::string text = honest[below(honest.size())];
  for (std::size_t n = 1 + below(3); n > 0; --n) {
    const std::size_t at = below(text.size() + 1);
    const std::string& piece = pieces[below(pieces.size())];
    if (below(3) > 0)
      text.insert(at, piece);
    else
      text.replace(at, below(12), piece);
  }
  return text;
}

/// Others than those of the suite with the environment variable PD_FUZZ_FIRST_SEED.
unsigned firstSeed() {
  const char* const text = std::getenv("PD_FUZZ_FIRST_SEED");
  return text == nullptr ? 0u : static_cast<unsigned>(std::strtoul(text, nullptr, 10));
}

TEST(Fuzz, MutatedFormulas) {
  const std::size_t nPlaces = 8;
  const Counts counts =
      checkMutants("formulas", 400, [&](unsigned seed, std::string& deck, std::string&, std::string&) {
        deck = deckWithFormula(seed % nPlaces, mutatedFormula(firstSeed() + seed));
      });
  EXPECT_GT(counts.good, 0);
  EXPECT_GT(counts.bad, 200);
}

TEST(Fuzz, MutatedOverrides) {
  const pd_test::SceneFiles scene("fuzz_overrides");
  scene.write("deck.yaml", pd_test::goodDeck);
  scene.write("mesh.txt", pd_test::goodMesh());
  scene.write("left.txt", pd_test::goodNodeSet);
  int bad = 0;
  for (unsigned seed = 0; seed < 300; ++seed) {
    const std::string text = Mutator(seed).mutate("Solver/Staggered/Load Steps=5");
    try {
      const Deck deck = Deck::read(scene.path("deck.yaml"), {text});
      checkDeck(deck);
      deck.mistakes().report();
    } catch (const DeckError&) {
      ++bad;
    }
  }
  EXPECT_GT(bad, 100);
}

}  // namespace
}  // namespace pd
