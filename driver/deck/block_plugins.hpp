// Which plug-ins a block has, and their parameters: one of an entry of Materials or Damage Models, or a combination of
// several.
#ifndef PD_BLOCK_PLUGINS_HPP
#define PD_BLOCK_PLUGINS_HPP

#include <Teuchos_ParameterList.hpp>
#include <string>
#include <utility>
#include <vector>

#include "../../materials/kernels/rings.hpp"
#include "../../materials/registry/plugins.hpp"
#include "deck.hpp"

namespace pd {

/// Declarations of the plug-in that this entry of Materials or Damage Models names, with those of its parts where it
/// combines some. Throws DeckError.
template <class Registry>
ParameterDeclarations declarationsOf(const Registry& registry, const DeckNode& entry) {
  const std::string key = modelKey(registry);
  const auto* plugin = registry.find(entry[key].text());
  if (plugin == nullptr) throw DeckError(entry[key].place() + ": unknown " + key);
  ParameterDeclarations declarations = plugin->declare();
  if (plugin->partsKey.empty()) return declarations;
  std::vector<std::pair<std::string, std::string>> parts;
  for (const DeckNode& name : entry[plugin->partsKey].each()) {
    const DeckNode part = entry[name.text()];
    if (!part.isMap() || !part[key].isScalar())
      throw DeckError(name.place() + ": " + entry.path() + " lacks the part \"" + name.text() +
                      "\": give it a section under this name, with a \"" + key + "\"");
    parts.emplace_back(name.text(), part[key].text());
  }
  try {
    declareParts(declarations, registry, parts, entry.path());
  } catch (const std::invalid_argument& error) {
    throw DeckError(entry.keyPlace() + ": " + error.what());
  }
  return declarations;
}

/// This entry of Materials, or where it combines parts, theirs.
inline std::vector<DeckNode> materialParts(const DeckNode& entry) {
  const DeckNode model = entry["Material Model"];
  const auto* plugin = model.isScalar() ? MaterialRegistry::self().find(model.text()) : nullptr;
  if (plugin == nullptr || plugin->partsKey.empty()) return {entry};
  std::vector<DeckNode> parts;
  for (const DeckNode& name : entry[plugin->partsKey].each()) parts.push_back(entry[name.text()]);
  return parts;
}

/// Tells a plug-in that declares the key of Discretization/Axis Of Revolution. Others, but for those that combine
/// materials, do not work in a body of revolution, and a check of the deck refuses them.
inline void giveAxisOfRevolution(const Deck& deck, const ParameterDeclarations& declarations,
                                 Teuchos::ParameterList& list) {
  const DeckNode axis = deck["Discretization"][axisOfRevolution];
  if (axis.isScalar() && declarations.find(axisOfRevolution) != nullptr) list.set(axisOfRevolution, axis.text());
}

/// An entry that a block names: its name, the plug-in and the parameters.
struct NamedPlugin {
  std::string name, plugin;
  Teuchos::ParameterList parameters;
};

/// `parts` as one: the only one as it is, several as parameters of the plug-in that combines them.
template <class Registry>
NamedPlugin asOne(const Registry& registry, const std::vector<NamedPlugin>& parts) {
  if (parts.size() == 1) return parts.front();
  NamedPlugin whole;
  whole.plugin = registry.combining().name;
  Teuchos::Array<std::string> names;
  for (const NamedPlugin& part : parts) {
    whole.name += (whole.name.empty() ? "" : ", ") + part.name;
    names.push_back(part.name);
    Teuchos::ParameterList& list = whole.parameters.sublist(part.name);
    list = part.parameters;
    list.set(modelKey(registry), part.plugin);
  }
  whole.parameters.set(registry.combining().partsKey, names);
  return whole;
}

}  // namespace pd

#endif
