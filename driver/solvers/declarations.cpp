#include "declarations.hpp"

#include <algorithm>
#include <stdexcept>

#include "../deck/names.hpp"

namespace pd {

namespace {

bool hasRule(const ParameterDeclarations& declarations, const ParameterDeclarations::Rule& rule) {
  const auto& rules = declarations.rules();
  return std::any_of(rules.begin(), rules.end(),
                     [&](const auto& other) { return other.kind == rule.kind && other.names == rule.names; });
}

void addRule(ParameterDeclarations& to, const ParameterDeclarations::Rule& rule) {
  using Kind = ParameterDeclarations::Rule::Kind;
  switch (rule.kind) {
    case Kind::ExactlyOne:
      return to.exactlyOneOf(rule.names);
    case Kind::AtMostOne:
      return to.atMostOneOf(rule.names);
    case Kind::AtLeastOne:
      return to.atLeastOneOf(rule.names);
    case Kind::Needs:
      return to.needs(rule.names.front(), {rule.names.begin() + 1, rule.names.end()});
  }
}

}  // namespace

void addDeclarations(ParameterDeclarations& to, const ParameterDeclarations& from,
                     const std::vector<std::string>& except) {
  for (const Parameter& parameter : from.parameters()) {
    if (contains(except, parameter.name)) continue;
    if (const Parameter* known = to.find(parameter.name)) {
      if (known->type != parameter.type || known->defaultValue != parameter.defaultValue)
        throw std::logic_error("\"" + parameter.name + "\" is declared twice, with another type or default");
      continue;
    }
    to.real(parameter.name, "", "") = parameter;
  }
  for (const auto& sublist : from.sublists())
    if (!contains(except, sublist.name) && to.findSublist(sublist.name) == nullptr)
      to.sublist(sublist.name, sublist.meaning) = sublist.declarations.front();
  for (const auto& rule : from.rules()) {
    const bool isLeftOut =
        std::any_of(rule.names.begin(), rule.names.end(), [&](const auto& name) { return contains(except, name); });
    if (!isLeftOut && !hasRule(to, rule)) addRule(to, rule);
  }
}

Teuchos::ParameterList entriesKnownTo(const ParameterDeclarations& declarations, const Teuchos::ParameterList& given) {
  Teuchos::ParameterList result(given.name());
  for (auto it = given.begin(); it != given.end(); ++it) {
    const std::string& name = given.name(it);
    if (declarations.find(name) != nullptr || declarations.findSublist(name) != nullptr)
      result.setEntry(name, given.entry(it));
  }
  return result;
}

}  // namespace pd
