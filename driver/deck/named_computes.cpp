// Computes that need no section of their own.
#include <algorithm>
#include <set>

#include "../../materials/registry/plugins.hpp"
#include "sections.hpp"

namespace pd {

std::string withUnderscores(std::string name) {
  std::replace(name.begin(), name.end(), ' ', '_');
  return name;
}

namespace {

bool needsParameters(const std::string& name) {
  const ParameterDeclarations declarations = ComputeRegistry::self().find(name)->declare();
  const auto& parameters = declarations.parameters();
  return std::any_of(parameters.begin(), parameters.end(), [](const Parameter& p) { return p.isRequired; });
}

}  // namespace

std::vector<std::string> computesWithoutSection(const Deck& deck) {
  std::vector<std::string> labels;
  std::set<std::string> known;
  for (const auto& [name, entry] : deck["Compute Class Parameters"].entries()) {
    if (entry["Compute Class"].isScalar()) known.insert(withUnderscores(entry["Compute Class"].text()));
    // What an entry calls its result is that entry's, even where a class has this name.
    if (entry["Output Label"].isScalar()) known.insert(withUnderscores(entry["Output Label"].text()));
    if (entry["Variable"].isScalar()) labels.push_back(entry["Variable"].text());
  }
  for (const auto& [key, output] : deck.root().entries()) {
    if (!isSectionOf(deck, key, "Output")) continue;
    for (const auto& [label, isWanted] : output["Output Variables"].entries()) labels.push_back(label);
    for (const DeckNode& item : output["Output Variables"].items())
      if (item.isScalar()) labels.push_back(item.text());
  }
  std::vector<std::string> result;
  for (const std::string& label : labels) {
    const std::string name = withUnderscores(label);
    if (ComputeRegistry::self().find(name) != nullptr && !needsParameters(name) && known.insert(name).second)
      result.push_back(name);
  }
  return result;
}

}  // namespace pd
