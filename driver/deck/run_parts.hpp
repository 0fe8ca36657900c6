// What the plug-ins of a deck use, as they say when they are made. Private to this folder.
#ifndef PD_RUN_PARTS_HPP
#define PD_RUN_PARTS_HPP

#include <set>
#include <string>
#include <vector>

#include "../../materials/registry/fields.hpp"
#include "deck.hpp"

namespace pd {

/// A material, damage model or solver of the deck.
struct RunPart {
  DeckNode node;                    ///< its section
  std::string plugin;               ///< its name in the registry
  FieldTable table;                 ///< what it uses
  bool hasTable = true;             ///< it says itself what it uses; else it may bring whatever it uses
  std::string densityTrouble = "";  ///< of a material: why it has no mass density
};

struct BlockParts {
  DeckNode block;
  std::vector<RunPart> materials, damageModels;

  /// The parts of `kind` that use the field so.
  static std::vector<const RunPart*> thatUse(const std::vector<RunPart>& kind, const FieldDescription& field,
                                             FieldAccess access);
};

struct SolverPart : RunPart {
  bool needsDensity = false;
};

struct RunParts {
  std::vector<BlockParts> blocks;
  std::vector<SolverPart> solvers;
  std::set<std::string> ofHost;        ///< labels of fields that the driver fills
  std::set<std::string> ofConditions;  ///< labels of fields that conditions set
};

/// What one part needs and no other gives: fields that a solver reads and those from which materials make them; fields
/// that damage models read; the phases, scalars and damage models of metal that dissolves. Adds to the deck's mistakes.
void checkNeeds(const Deck& deck, const RunParts& parts);

}  // namespace pd

#endif
