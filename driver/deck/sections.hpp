// The grammar of a deck: declarations of every section that is not a plug-in's own, and the check of a whole deck.
#ifndef PD_DECK_SECTIONS_HPP
#define PD_DECK_SECTIONS_HPP

#include <string>
#include <vector>

#include "deck.hpp"

namespace pd {

std::vector<std::string> discretizationTypes();
/// "Discretization" with this Type, without its bond filters, cracks, voids and planes of symmetry; throws for an
/// unknown type.
const ParameterDeclarations& discretizationDeclarations(const std::string& type);
const ParameterDeclarations& bondFilterDeclarations(const std::string& type);  ///< throws for an unknown type
std::vector<std::string> crackTypes();                                         ///< of Discretization/Cracks
std::vector<std::string> voidTypes();                                          ///< of Discretization/Voids
const ParameterDeclarations& crackDeclarations(const std::string& type);       ///< throws for an unknown type
const ParameterDeclarations& voidDeclarations(const std::string& type);        ///< throws for an unknown type
void declareBondDecomposition(ParameterDeclarations& declare);
ParameterDeclarations bondDecompositionDeclarations();
const ParameterDeclarations& symmetryPlaneDeclarations();  ///< an entry of Symmetry
const ParameterDeclarations& nodeSetDeclarations();        ///< node sets by geometry
const ParameterDeclarations& blockDeclarations();
std::vector<std::string> bondFilterTypes();
const ParameterDeclarations& outputDeclarations();
const ParameterDeclarations& exactSolutionDeclarations();  ///< an entry of "Exact Solution"
const ParameterDeclarations& solverDeclarations();         ///< what all solvers share: times, verbosity

/// Whether the key of the top level is a section "Solver" or "Output" (`word`), one of several with a number behind it
/// ("Solver2"). In decks of Peridigm, as there, all keys count that contain the word.
bool isSectionOf(const Deck& deck, const std::string& key, const std::string& word);

/// Where entries of Materials, Damage Models, Boundary Conditions, Compute Class Parameters, Exact Solution and Bond
/// Filters name node sets or blocks: the values, each name by itself, of keys that are `what` ("Node Set", "Block") or
/// end with it, as "First Node Set" and "Phase Blocks" do.
std::vector<DeckNode> namesOf(const Deck& deck, const std::string& what);

/// Computes may be named with blanks in place of underscores.
std::string withUnderscores(std::string name);

/// Names of computes without required parameters that an output or another compute names, and that have no entry in
/// Compute Class Parameters. The deck need not have been checked.
std::vector<std::string> computesWithoutSection(const Deck& deck);

/// Checks the whole deck against these and the plug-ins' declarations: unknown keys, types, ranges, names that
/// refer to something (materials of blocks, node sets of boundary conditions, fields of outputs), and what materials,
/// damage models and solvers refuse when they are made. Adds every mistake to deck.mistakes() in the order of the
/// file, and what is only odd to deck.warnings(); reads no mesh.
void checkDeck(const Deck& deck);

/// The deck with all defaults filled in, as YAML.
std::string resolvedDeck(const Deck& deck);

}  // namespace pd

#endif
