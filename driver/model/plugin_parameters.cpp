#include "plugin_parameters.hpp"

namespace pd {

namespace {

/// `declarations` as the deck sees them: with the key that names the plug-in, without what the host injects.
ParameterDeclarations deckDeclarations(const ParameterDeclarations& declarations, const std::string& kindKey,
                                       const Teuchos::ParameterList& injected) {
  ParameterDeclarations result;
  for (const Parameter& parameter : declarations.parameters()) {
    if (injected.isParameter(parameter.name) || parameter.name == kindKey) continue;
    Parameter& copy = result.real(parameter.name, parameter.unit, parameter.meaning);
    copy = parameter;
  }
  result.text(kindKey, "Name of the plug-in.").required();
  for (const auto& sublist : declarations.sublists())
    result.sublist(sublist.name, sublist.meaning) = sublist.declarations.front();
  for (const auto& rule : declarations.rules()) {
    switch (rule.kind) {
      case ParameterDeclarations::Rule::ExactlyOne:
        result.exactlyOneOf(rule.names);
        break;
      case ParameterDeclarations::Rule::AtMostOne:
        result.atMostOneOf(rule.names);
        break;
      case ParameterDeclarations::Rule::AtLeastOne:
        result.atLeastOneOf(rule.names);
        break;
      case ParameterDeclarations::Rule::Needs:
        result.needs(rule.names.front(), {rule.names.begin() + 1, rule.names.end()});
        break;
    }
  }
  return result;
}

}  // namespace

Teuchos::ParameterList pluginParameters(const DeckNode& node, const ParameterDeclarations& declarations,
                                        const std::string& kindKey, const Teuchos::ParameterList& injected) {
  Teuchos::ParameterList list = node.parameters(deckDeclarations(declarations, kindKey, injected));
  if (declarations.find(kindKey) == nullptr) list.remove(kindKey);
  for (auto entry = injected.begin(); entry != injected.end(); ++entry) {
    const std::string& name = injected.name(entry);
    if (declarations.find(name) != nullptr) list.set(name, injected.get<double>(name));
  }
  return list;
}

}  // namespace pd
