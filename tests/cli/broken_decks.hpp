// Mistakes in the good deck, mesh and node set, each with the lines that pdrun must print for it.
#ifndef PD_TESTS_BROKEN_DECKS_HPP
#define PD_TESTS_BROKEN_DECKS_HPP

#include <string>
#include <utility>
#include <vector>

namespace pd_test {

struct Broken {
  std::string name;
  std::vector<std::pair<std::string, std::string>> edits;  ///< of the good deck: text that stands there once, new text
  std::vector<std::string> expected;                       ///< a part of each line that is printed
  std::string meshLine = "";                               ///< new fourth line of the mesh; empty: as it is
  std::string nodeSet = "";                                ///< new text of left.txt; empty: as it is
};

/// In discretization, materials, damage models and blocks.
std::vector<Broken> brokenBodies();
/// In node sets, conditions, solvers, computes, outputs and files.
std::vector<Broken> brokenRuns();

/// Of solvers, materials, damage models and times.
std::vector<Broken> brokenPairings();
/// What a run finds out only as its solver starts.
std::vector<Broken> refusedStarts();

inline std::vector<Broken> brokenDecks() {
  std::vector<Broken> all = brokenBodies();
  for (const std::vector<Broken>& more : {brokenRuns(), brokenPairings()})
    all.insert(all.end(), more.begin(), more.end());
  return all;
}

}  // namespace pd_test

#endif
