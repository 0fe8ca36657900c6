// The sections of a deck, each with the declarations that hold for it. Private to this folder.
#ifndef PD_SECTION_WALK_HPP
#define PD_SECTION_WALK_HPP

#include <string>
#include <vector>

#include "deck.hpp"
#include "deck_parameters.hpp"

namespace pd {

struct DeckSection {
  enum class Kind {
    Discretization,
    BondFilter,
    Crack,
    Void,
    SymmetryPlane,
    Material,
    DamageModel,
    Block,
    NodeSet,
    Condition,
    SolverTimes,
    Solver,
    Compute,
    Output,
    ExactSolution
  };
  Kind kind;
  std::string name;    ///< its key
  std::string plugin;  ///< name of the plug-in or type, where the section has one
  DeckNode node;
  ParameterDeclarations declarations;
  HostKeys hostKeys;
};

/// All sections of the deck in the order of the file, but for those whose type is not known. Adds mistakes for these,
/// for unknown keys of the top level and for what is missing there.
std::vector<DeckSection> findSections(const Deck& deck);

/// Upper case, blanks as underscores: names of node sets are compared so, as in Peridigm.
std::string plainName(const std::string& name);
/// Whether an entry of Boundary Conditions is a node set.
bool isNodeSetName(const std::string& name);

}  // namespace pd

#endif
