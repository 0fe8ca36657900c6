#include "dimension_check.hpp"

#include <algorithm>
#include <set>

#include "../deck/block_plugins.hpp"

namespace pd {

namespace {

const std::map<std::string, int> dimensions{{"Plane Stress", 2}, {"Plane Strain", 2}, {"One Dimensional", 1}};

/// What points of such a mesh fill.
std::string spaceOf(int dimension) { return dimension == 1 ? "a line" : dimension == 2 ? "a plane" : "space"; }

/// "set "Plane Stress: true" or ...", as far as the material has these keys.
std::string remedy(const ParameterDeclarations& declarations, int dimension, const std::string& given) {
  std::string flags;
  for (const auto& [flag, of] : dimensions)
    if (of == dimension && declarations.find(flag) != nullptr)
      flags += (flags.empty() ? "\"" : " or \"") + flag + ": true\"";
  if (dimension == 3) return "remove \"" + given + "\"";
  if (flags.empty()) return "use another material, as PDHE";
  return "set " + flags + (given.empty() ? "" : " in place of \"" + given + "\"");
}

void checkMaterial(const Deck& deck, const DeckNode& material, int dimension, const std::string& mesh) {
  const DeckNode model = material["Material Model"];
  const auto* plugin = model.isScalar() ? MaterialRegistry::self().find(model.text()) : nullptr;
  if (plugin == nullptr) return;
  const ParameterDeclarations declarations = plugin->declare();
  const bool isSaid = std::any_of(dimensions.begin(), dimensions.end(),
                                  [&](const auto& flag) { return declarations.find(flag.first) != nullptr; });
  if (!isSaid) return;
  // In a body of revolution materials that know such bodies are told by that alone.
  const bool isOfRevolution =
      deck["Discretization"][axisOfRevolution] && declarations.find(axisOfRevolution) != nullptr;
  int own = isOfRevolution ? 2 : 3;
  std::string given;
  for (const auto& [flag, of] : dimensions)
    if (material.flag(flag, false)) {
      own = of;
      given = flag;
    }
  if (own == dimension) return;
  (deck.isPeridigmDeck() ? deck.warnings() : deck.mistakes())
      .add(given.empty() ? material.keyPlace() : material[given].place(),
           material.path() + ": its constants are those of points that fill " + spaceOf(own) + ", but those of " +
               mesh + " fill " + spaceOf(dimension) + "; " + remedy(declarations, dimension, given));
}

}  // namespace

void checkDimensions(const Deck& deck, const std::map<int, DeckNode>& entries, int dimension, const std::string& mesh) {
  std::set<std::string> seen;
  for (const auto& entry : entries)
    for (const DeckNode& name : entry.second["Material"].each())
      for (const DeckNode& part : materialParts(deck["Materials"][name.text()]))
        if (seen.insert(part.path()).second) checkMaterial(deck, part, dimension, mesh);
}

}  // namespace pd
