// The deck as it was understood: with all defaults written out.
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <map>

#include "check_deck.hpp"
#include "deck_data.hpp"
#include "sections.hpp"

namespace pd {

namespace {

/// Whether a rule speaks of the parameter: then writing its default could break the rule.
bool isInRule(const ParameterDeclarations& declarations, const std::string& name) {
  const auto& rules = declarations.rules();
  return std::any_of(rules.begin(), rules.end(), [&](const ParameterDeclarations::Rule& rule) {
    return std::find(rule.names.begin(), rule.names.end(), name) != rule.names.end();
  });
}

class Writer {
 public:
  explicit Writer(const Deck& deck) : deck_(deck), check_(readSections(deck)) {
    for (const CheckedSection& checked : check_.sections) sections_[checked.section.node.path()] = &checked;
  }

  std::string write() {
    out_ << YAML::BeginMap;
    if (deck_.isPeridigmDeck()) out_ << YAML::Key << "Peridigm" << YAML::Value << YAML::BeginMap;
    for (const auto& [key, node] : deck_.root().entries()) {
      out_ << YAML::Key << key << YAML::Value;
      value(node, nullptr);
    }
    if (deck_.isPeridigmDeck()) out_ << YAML::EndMap;
    out_ << YAML::EndMap;
    return "# " + deck_.fileName() + " with all defaults written out by pdrun.\n" + out_.c_str() + "\n";
  }

 private:
  void value(const DeckNode& node, const ParameterDeclarations* declarations) {
    if (node.isScalar()) {
      if (node.isQuoted())
        out_ << YAML::DoubleQuoted << node.text();
      else
        out_ << node.text();
    } else if (node.isSequence()) {
      out_ << YAML::Flow << YAML::BeginSeq;
      for (const DeckNode& item : node.items()) value(item, nullptr);
      out_ << YAML::EndSeq;
    } else {
      section(node, declarations);
    }
  }

  void section(const DeckNode& node, const ParameterDeclarations* declarations) {
    const auto found = sections_.find(node.path());
    if (found != sections_.end()) declarations = &found->second->section.declarations;
    out_ << YAML::BeginMap;
    for (const auto& [key, entry] : node.entries()) {
      const auto* sublist = declarations == nullptr ? nullptr : declarations->findSublist(key);
      out_ << YAML::Key << key << YAML::Value;
      value(entry, sublist == nullptr ? nullptr : &sublist->declarations.front());
    }
    if (declarations != nullptr) defaults(node, *declarations);
    driverDefaults(node);
    out_ << YAML::EndMap;
  }

  void defaults(const DeckNode& node, const ParameterDeclarations& declarations) {
    for (const Parameter& parameter : declarations.parameters()) {
      const auto& value = parameter.defaultValue;
      if (node[parameter.name] || std::holds_alternative<std::monostate>(value)) continue;
      const bool isFalse = std::holds_alternative<bool>(value) && !std::get<bool>(value);  // breaks no rule
      if (isInRule(declarations, parameter.name) && !isFalse) continue;
      out_ << YAML::Key << parameter.name << YAML::Value;
      if (std::holds_alternative<double>(value)) out_ << realText(std::get<double>(value));
      if (std::holds_alternative<int>(value)) out_ << std::get<int>(value);
      if (std::holds_alternative<bool>(value)) out_ << std::get<bool>(value);
      if (std::holds_alternative<std::string>(value)) out_ << std::get<std::string>(value);
    }
  }

  /// Defaults that depend on whether the deck is Peridigm's.
  void driverDefaults(const DeckNode& node) {
    const std::string key = "Include Partial Neighbors";
    if (node.path() == "Discretization" && !node[key])
      out_ << YAML::Key << key << YAML::Value << !deck_.isPeridigmDeck();
  }

  const Deck& deck_;
  DeckUnderCheck check_;
  std::map<std::string, const CheckedSection*> sections_;
  YAML::Emitter out_;
};

}  // namespace

std::string resolvedDeck(const Deck& deck) { return Writer(deck).write(); }

}  // namespace pd
