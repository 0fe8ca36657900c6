#include "section_walk.hpp"

#include <algorithm>
#include <cctype>

#include "../../materials/registry/plugins.hpp"
#include "../boundary/condition.hpp"
#include "../solvers/solver.hpp"
#include "block_plugins.hpp"
#include "sections.hpp"

namespace pd {

namespace {

using Kind = DeckSection::Kind;

class SectionFinder {
 public:
  explicit SectionFinder(const Deck& deck) : deck_(deck), mistakes_(deck.mistakes()) {}

  std::vector<DeckSection> find() {
    for (const auto& [key, node] : deck_.root().entries()) root(key, node);
    for (const char* key : {"Discretization", "Materials", "Blocks"})
      if (!deck_[key]) mistakes_.add(deck_.fileName(), std::string("the deck has no section \"") + key + "\"");
    if (!hasSolver_)
      mistakes_.add(deck_.fileName(),
                    "the deck has no section \"Solver\"; it holds the times and a solver, one of " + solverNames());
    return std::move(sections_);
  }

 private:
  static std::string solverNames() { return quotedList(SolverRegistry::self().names()); }

  void root(const std::string& key, const DeckNode& node) {
    const bool isSolver = isSectionOf(deck_, key, "Solver"), isOutput = isSectionOf(deck_, key, "Output");
    static const std::vector<std::string> known{
        "Discretization",           "Materials", "Damage Models", "Blocks", "Boundary Conditions", "Solver",
        "Compute Class Parameters", "Output",    "Exact Solution"};
    const bool isKnown = isSolver || isOutput || std::find(known.begin(), known.end(), key) != known.end();
    if (!isKnown) {
      unknownKey(node, "unknown key \"" + key + "\" at the top level" + didYouMean(key, known) +
                           "; known here: " + quotedList(known) + ", and Solver2, Output2 ...");
    } else if (key == "Exact Solution") {
      exactSolution(node);
    } else if (!node.isMap()) {
      mistakes_.add(node.place(), key + " must be a section with keys of its own");
    } else if (isSolver) {
      solver(key, node);
    } else if (isOutput) {
      add(Kind::Output, key, node, outputDeclarations());
    } else if (key == "Discretization") {
      discretization(node);
    } else if (key == "Blocks") {
      blocks(node);
    } else if (key == "Boundary Conditions") {
      conditions(node);
    } else if (key == "Materials") {
      plugins(Kind::Material, node, "Material Model", MaterialRegistry::self());
    } else if (key == "Damage Models") {
      plugins(Kind::DamageModel, node, "Damage Model", DamageModelRegistry::self());
    } else {
      plugins(Kind::Compute, node, "Compute Class", ComputeRegistry::self());
    }
  }

  DeckSection& add(Kind kind, const std::string& name, const DeckNode& node,
                   const ParameterDeclarations& declarations) {
    DeckSection section{kind, name, "", node, declarations, {}};
    sections_.push_back(std::move(section));
    return sections_.back();
  }

  /// In a lenient reading of a deck of Peridigm a warning, and the key is ignored.
  void unknownKey(const DeckNode& node, const std::string& message) {
    (deck_.isLenient() ? deck_.warnings() : mistakes_).add(node.keyPlace(), message);
    if (deck_.isLenient()) node.ignore();
  }

  bool isSection(const DeckNode& node) {
    if (!node.isMap()) mistakes_.add(node.place(), node.path() + " must be a section with keys of its own");
    return node.isMap();
  }

  /// The text of a key that chooses the declarations, or empty after a mistake.
  std::string choice(const DeckNode& node, const std::string& key, const std::vector<std::string>& known) {
    const DeckNode value = node[key];
    if (!value) {
      mistakes_.add(node.keyPlace(), node.path() + " lacks \"" + key + "\", one of " + quotedList(known));
    } else if (!value.isScalar()) {
      mistakes_.add(value.place(), value.path() + " must be one of " + quotedList(known));
    } else if (std::find(known.begin(), known.end(), value.text()) == known.end()) {
      mistakes_.add(value.place(), "unknown " + key + " \"" + value.text() + "\"" + inSection(node) +
                                       didYouMean(value.text(), known) + "; known here: " + quotedList(known));
    } else {
      return value.text();
    }
    return "";
  }

  template <class Registry>
  void plugins(Kind kind, const DeckNode& list, const std::string& kindKey, const Registry& registry) {
    for (const auto& [name, node] : list.entries())
      if (isSection(node)) plugin(kind, name, node, kindKey, registry);
  }

  template <class Registry>
  void plugin(Kind kind, const std::string& name, const DeckNode& node, const std::string& kindKey,
              const Registry& registry) {
    std::string plugin =
        kind == Kind::Compute ? withUnderscores(node[kindKey].isScalar() ? node[kindKey].text() : "") : "";
    if (registry.find(plugin) == nullptr) plugin = choice(node, kindKey, registry.names());
    if (plugin.empty()) return;
    ParameterDeclarations declarations;
    try {
      if constexpr (std::is_same_v<Registry, MaterialRegistry> || std::is_same_v<Registry, DamageModelRegistry>)
        declarations = declarationsOf(registry, node);
      else
        declarations = registry.find(plugin)->declare();
    } catch (const DeckError& error) {
      return addAll(mistakes_, error);
    }
    DeckSection& section = add(kind, name, node, declarations);
    section.plugin = plugin;
    if (section.declarations.find(kindKey) == nullptr) section.hostKeys.known.push_back(kindKey);
    if (kind != Kind::Material) return;
    section.hostKeys.injected.emplace_back("Horizon");
    if (const DeckNode axis = node[axisOfRevolution]) {
      mistakes_.add(axis.keyPlace(), node.path() + " gives an " + axisOfRevolution +
                                         ", which belongs to Discretization alone; remove it here");
      if (section.declarations.find(axisOfRevolution) == nullptr) section.hostKeys.known.emplace_back(axisOfRevolution);
    }
    if (!node["Horizon"]) return;
    mistakes_.add(node["Horizon"].keyPlace(),
                  node.path() + " gives a Horizon, which belongs to the block alone; remove it here");
    if (section.declarations.find("Horizon") == nullptr) section.hostKeys.known.emplace_back("Horizon");
  }

  void discretization(const DeckNode& node) {
    const std::vector<std::string> types = discretizationTypes();
    const std::string given = node["Type"].isScalar() ? node["Type"].text() : "";
    const bool isKnown = std::find(types.begin(), types.end(), given) != types.end();
    DeckSection& section =
        add(Kind::Discretization, "Discretization", node, discretizationDeclarations(isKnown ? given : types.front()));
    // The entries of these have names of the user's choice.
    for (const char* list : {"Bond Filters", "Cracks", "Voids", "Symmetry"}) {
      section.declarations = withoutSublist(section.declarations, list);
      section.hostKeys.known.emplace_back(list);
    }
    if (const DeckNode horizon = node["Horizon"]) {
      mistakes_.add(horizon.keyPlace(), "the Horizon belongs to the entries of Blocks, not to Discretization");
      section.hostKeys.known.emplace_back("Horizon");
    }
    for (const auto& [name, filter] : sectionsIn(node["Bond Filters"])) {
      const std::string type = choice(filter, "Type", bondFilterTypes());
      if (!type.empty()) add(Kind::BondFilter, name, filter, bondFilterDeclarations(type)).plugin = type;
    }
    for (const auto& [name, crack] : sectionsIn(node["Cracks"])) {
      const std::string type = choice(crack, "Type", crackTypes());
      if (!type.empty()) add(Kind::Crack, name, crack, crackDeclarations(type)).plugin = type;
    }
    for (const auto& [name, hole] : sectionsIn(node["Voids"])) {
      const std::string type = choice(hole, "Type", voidTypes());
      if (!type.empty()) add(Kind::Void, name, hole, voidDeclarations(type)).plugin = type;
    }
    for (const auto& [name, plane] : sectionsIn(node["Symmetry"]))
      add(Kind::SymmetryPlane, name, plane, symmetryPlaneDeclarations());
  }

  /// The entries of a section whose keys are names of the user's choice; none where it is not there.
  std::vector<std::pair<std::string, DeckNode>> sectionsIn(const DeckNode& list) {
    std::vector<std::pair<std::string, DeckNode>> sections;
    if (!list || !isSection(list)) return sections;
    for (const auto& entry : list.entries())
      if (isSection(entry.second)) sections.push_back(entry);
    return sections;
  }

  static ParameterDeclarations withoutSublist(const ParameterDeclarations& declarations, const std::string& name) {
    ParameterDeclarations result;
    for (const Parameter& parameter : declarations.parameters()) result.real(parameter.name, "", "") = parameter;
    for (const auto& sublist : declarations.sublists())
      if (sublist.name != name) result.sublist(sublist.name, sublist.meaning) = sublist.declarations.front();
    for (const auto& rule : declarations.rules()) {
      if (rule.kind == ParameterDeclarations::Rule::AtMostOne) result.atMostOneOf(rule.names);
      if (rule.kind == ParameterDeclarations::Rule::ExactlyOne) result.exactlyOneOf(rule.names);
    }
    return result;
  }

  void blocks(const DeckNode& list) {
    for (const auto& [name, node] : list.entries())
      if (isSection(node)) add(Kind::Block, name, node, blockDeclarations());
    if (list.entries().empty())
      mistakes_.add(list.keyPlace(), "Blocks is empty; give each block of the mesh a material and a horizon");
  }

  void conditions(const DeckNode& list) {
    for (const auto& [name, node] : list.entries()) {
      if (isNodeSetName(name)) {
        nodeSet(name, node);
      } else if (!node.isMap()) {
        unknownKey(node, node.path() +
                             " must be a condition (a section with a Type); the names of node sets contain \"Node "
                             "Set\"");
      } else {
        plugin(Kind::Condition, name, node, "Type", ConditionRegistry::self());
      }
    }
  }

  void nodeSet(const std::string& name, const DeckNode& node) {
    if (node["Type"]) {
      mistakes_.add(node.keyPlace(),
                    node.path() + " is a condition, but names that contain \"Node Set\" are node sets; rename it");
    } else if (node.isMap()) {
      // A box is a list of lists, which the checks look at.
      DeckSection& section = add(Kind::NodeSet, name, node, ParameterDeclarations());
      section.declarations.function("Expression", "1", nodeSetDeclarations().find("Expression")->meaning);
      section.declarations.exactlyOneOf({"Box", "Expression"});
      section.hostKeys.known.emplace_back("Box");
    }
  }

  void solver(const std::string& key, const DeckNode& node) {
    hasSolver_ = true;
    // A reference into sections_ would not outlive the next section.
    const std::size_t times = sections_.size();
    add(Kind::SolverTimes, key, node, solverDeclarations());
    HostKeys& hostKeys = sections_[times].hostKeys;
    if (deck_.isPeridigmDeck()) hostKeys.injected.emplace_back("Final Time");
    const std::vector<std::string> names = SolverRegistry::self().names();
    hostKeys.known.insert(hostKeys.known.end(), names.begin(), names.end());
    std::vector<std::string> chosen;
    bool hasUnknownSection = false;
    for (const auto& [name, entry] : node.entries()) {
      const auto* plugin = SolverRegistry::self().find(name);
      hasUnknownSection = hasUnknownSection || (plugin == nullptr && entry.isMap());
      if (plugin == nullptr || !isSection(entry)) continue;
      chosen.push_back(name);
      add(Kind::Solver, name, entry, plugin->declare()).plugin = name;
    }
    if (chosen.size() > 1)
      mistakes_.add(node.keyPlace(), key + " has several solvers: " + quotedList(chosen) +
                                         "; give each a section of its own (Solver1, Solver2, ...)");
    if (chosen.empty() && !hasUnknownSection)
      mistakes_.add(node.keyPlace(), key + " names no solver; add one of " + solverNames());
  }

  void exactSolution(const DeckNode& list) {
    if (!list.isMap() && !list.isSequence()) {
      mistakes_.add(list.place(), "Exact Solution must be a list of entries");
      return;
    }
    for (const auto& [name, node] : list.entries())
      if (isSection(node)) add(Kind::ExactSolution, name, node, exactSolutionDeclarations());
    for (const DeckNode& node : list.items())
      if (isSection(node)) add(Kind::ExactSolution, "", node, exactSolutionDeclarations());
  }

  const Deck& deck_;
  Mistakes& mistakes_;
  std::vector<DeckSection> sections_;
  bool hasSolver_ = false;
};

}  // namespace

std::string plainName(const std::string& name) {
  std::string result;
  for (const char c : name) result += c == ' ' ? '_' : static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return result;
}

bool isSectionOf(const Deck& deck, const std::string& key, const std::string& word) {
  if (deck.isPeridigmDeck()) return key.find(word) != std::string::npos;
  if (key.compare(0, word.size(), word) != 0) return false;
  const std::size_t number = key.size() > word.size() && key[word.size()] == ' ' ? word.size() + 1 : word.size();
  return key.size() == word.size() || (number < key.size() && key.find_first_not_of("0123456789", number) == key.npos);
}

namespace {

bool endsWith(const std::string& text, const std::string& end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

void addNames(const DeckNode& section, const std::string& what, std::vector<DeckNode>& names) {
  for (const auto& [key, value] : section.entries()) {
    if (endsWith(key, what) || endsWith(key, what + "s"))
      for (const DeckNode& name : value.each()) names.push_back(name);
    else
      addNames(value, what, names);
  }
}

}  // namespace

std::vector<DeckNode> namesOf(const Deck& deck, const std::string& what) {
  std::vector<DeckNode> names;
  const auto addOfEntries = [&](const DeckNode& list) {
    for (const auto& entry : list.entries()) addNames(entry.second, what, names);
    for (const DeckNode& item : list.items()) addNames(item, what, names);
  };
  for (const char* list :
       {"Materials", "Damage Models", "Boundary Conditions", "Compute Class Parameters", "Exact Solution"})
    addOfEntries(deck[list]);
  addOfEntries(deck["Discretization"]["Bond Filters"]);
  return names;
}

bool isNodeSetName(const std::string& name) { return plainName(name).find("NODE_SET") != std::string::npos; }

std::vector<DeckSection> findSections(const Deck& deck) { return SectionFinder(deck).find(); }

}  // namespace pd
