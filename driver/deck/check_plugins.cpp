// Plug-ins refuse some values only when they are made, and only they know the fields of a run: make them all.
#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <sstream>

#include "../../materials/registry/needs_loads.hpp"
#include "../../materials/registry/plugins.hpp"
#include "../boundary/condition.hpp"
#include "../solvers/event_solver.hpp"
#include "Peridigm_Field.hpp"
#include "block_plugins.hpp"
#include "check_deck.hpp"
#include "function.hpp"
#include "peridigm_deck.hpp"
#include "run_parts.hpp"
#include "sections.hpp"

namespace pd {

namespace {

using Kind = DeckSection::Kind;
using PeridigmNS::FieldManager;

/// What computes are made with before there is a run: one rank, whose sums are its own values.
class OneRank : public PeridigmNS::Communicator {
 public:
  int MyPID() const override { return 0; }
  int NumProc() const override { return 1; }
  int SumAll(double* from, double* to, int n) const override { return copy(from, to, n); }
  int SumAll(int* from, int* to, int n) const override { return copy(from, to, n); }
  int MaxAll(double* from, double* to, int n) const override { return copy(from, to, n); }
  int MaxAll(int* from, int* to, int n) const override { return copy(from, to, n); }
  int MinAll(double* from, double* to, int n) const override { return copy(from, to, n); }
  int MinAll(int* from, int* to, int n) const override { return copy(from, to, n); }

 private:
  template <class Value>
  static int copy(const Value* from, Value* to, int n) {
    std::copy(from, from + n, to);
    return 0;
  }
};

constexpr double manySteps = 1e8;

/// The place of the first value of a section whose key the message quotes; empty where it quotes none.
std::string placeOfQuoted(const DeckNode& section, const std::string& message) {
  for (const auto& [key, value] : section.entries()) {
    const bool isMeant = message.find("\"" + key + "\"") != std::string::npos ||
                         (value.isScalar() && message.find("\"" + value.text() + "\"") != std::string::npos);
    if (isMeant) return value.isMap() ? value.keyPlace() : value.place();
    if (const std::string inside = placeOfQuoted(value, message); !inside.empty()) return inside;
  }
  return "";
}

class PluginCheck {
 public:
  explicit PluginCheck(const DeckUnderCheck& check) : check_(check), deck_(check.deck), mistakes_(deck_.mistakes()) {
    labels_ = {"Displacement"};
    labels_.insert(driverLabels_.begin(), driverLabels_.end());
    parts_.ofHost = labels_;
    run_.hasDamageModel = check.hasDamageModel();
  }

  void run() {
    isComplete_ = !check_.ofKind(Kind::Block).empty();
    for (const CheckedSection* block : check_.ofKind(Kind::Block)) blockPlugins(*block);
    for (const CheckedSection* solver : check_.ofKind(Kind::Solver))
      makePart(*solver, [&] { return solverPlugin(*solver); });
    for (const CheckedSection* solver : check_.ofKind(Kind::Solver)) watchedFields(*solver);
    bool hasAllConditions = true;
    for (const CheckedSection* checked : check_.ofKind(Kind::Condition)) hasAllConditions &= condition(*checked);
    mayHaveLoads_ = mayHaveLoads_ || !hasAllConditions;
    computes();
    isComplete_ = isComplete_ && hasAllConditions;
    if (isComplete_) checkNeeds(deck_, parts_);
    for (const CheckedSection* output : check_.ofKind(Kind::Output)) outputVariables(output->section.node);
    for (const CheckedSection* entry : check_.ofKind(Kind::ExactSolution)) isKnown(entry->section.node["Field"]);
  }

 private:
  /// Calls `create`, which makes the plug-in of the section and returns its fields. False where it cannot be made.
  template <class Create>
  bool make(const CheckedSection& checked, const Create& create) {
    return checked.isGood && make(checked.section.node, checked.section.node.keyPlace(), create);
  }
  /// `place`: of mistakes that speak of nothing in the section.
  template <class Create>
  bool make(const DeckNode& section, const std::string& place, const Create& create) {
    try {
      for (const int id : create()) {
        const PeridigmNS::FieldSpec spec = FieldManager::self().getFieldSpec(id);
        (spec.getRelation() == PeridigmNS::PeridigmField::BOND ? bondLabels_ : labels_).insert(spec.getLabel());
      }
      return true;
    } catch (const DeckError& error) {
      addAll(mistakes_, error);
    } catch (const std::exception& error) {
      std::istringstream lines(error.what());
      for (std::string line; std::getline(lines, line);) {
        const std::string named = placeOfQuoted(section, line);
        mistakes_.add(named.empty() ? place : named, section.path() + ": " + line);
      }
    }
    return false;
  }

  /// The same of a plug-in without which it is not known which fields there are.
  template <class Create>
  void makePart(const CheckedSection& checked, const Create& create) {
    if (!make(checked, create)) isComplete_ = false;
  }

  const CheckedSection* named(Kind kind, const DeckNode& name) const {
    for (const CheckedSection* checked : check_.ofKind(kind))
      if (name.isScalar() && checked->section.name == name.text()) return checked;
    return nullptr;
  }

  void blockPlugins(const CheckedSection& block) {
    const DeckNode& node = block.section.node;
    parts_.blocks.push_back({node, {}, {}});
    if (!block.isGood) {
      isComplete_ = false;
      return;
    }
    const Function horizon = Function::fromDeck(node["Horizon"]);
    std::vector<NamedTable> wholes;
    const auto add = [&](const NamedPlugin& named, const auto& made) {
      addOrigins(*made);
      wholes.push_back({named.name, fieldsIn(*made)});
      for (const FieldUse& use : wholes.back().table.uses()) usedLabels_.insert(use.field.label);
      return made->FieldIds();
    };
    const auto material = [&](NamedPlugin named) {
      if (MaterialRegistry::self().find(named.plugin)->declare().find("Horizon") != nullptr) {
        if (!horizon.isConstant())
          throw DeckError(node["Horizon"].place() + ": " + node["Horizon"].path() + " depends on the place, but \"" +
                          named.plugin + "\" takes one horizon for all points of a block; give a number");
        named.parameters.set("Horizon", horizon(0.0, 0.0, 0.0, 0.0));
      }
      giveAxisOfRevolution(deck_, MaterialRegistry::self().find(named.plugin)->declare(), named.parameters);
      return MaterialRegistry::self().create(named.plugin, named.parameters);
    };
    const auto damageModel = [](const NamedPlugin& named) {
      return DamageModelRegistry::self().create(named.plugin, named.parameters);
    };
    BlockParts& parts = parts_.blocks.back();
    if (horizon.dependsOnTime())
      isComplete_ = false;
    else
      makeOfBlock(MaterialRegistry::self(), Kind::Material, node["Material"], parts.materials, material, add);
    if (!hasNone(node))
      makeOfBlock(DamageModelRegistry::self(), Kind::DamageModel, node["Damage Model"], parts.damageModels, damageModel,
                  add);
    for (const std::string& message : contestedFields(wholes))
      mistakes_.add(node.keyPlace(), node.path() + ": " + message);
  }

  /// The plug-in that the block names, or several as one: `create` makes it, `add` takes it up and returns its fields.
  /// `made`: gets each of them alone.
  template <class Registry, class Create, class Add>
  void makeOfBlock(const Registry& registry, Kind kind, const DeckNode& names, std::vector<RunPart>& made,
                   const Create& create, const Add& add) {
    std::vector<NamedPlugin> parts;
    std::vector<const CheckedSection*> sections;
    for (const DeckNode& name : names.each()) {
      const CheckedSection* section = named(kind, name);
      const bool isNew =
          std::none_of(parts.begin(), parts.end(), [&](const NamedPlugin& part) { return part.name == name.text(); });
      if (section == nullptr || !section->isGood || !isNew) continue;
      parts.push_back({name.text(), section->section.plugin, section->list});
      sections.push_back(section);
    }
    if (parts.empty() || parts.size() != names.each().size()) {
      isComplete_ = false;
      return;
    }
    const NamedPlugin whole = asOne(registry, parts);
    const auto makeWhole = [&] {
      const auto ids = add(whole, create(whole));
      for (std::size_t k = 0; k < parts.size(); ++k) {
        const auto part = create(parts[k]);
        // The table of a plug-in that combines others does not say which of them needs what.
        const bool saysWhatItNeeds = fieldTableOf(*part) != nullptr && registry.find(parts[k].plugin)->partsKey.empty();
        made.push_back({sections[k]->section.node, parts[k].plugin, fieldsIn(*part), saysWhatItNeeds});
        if constexpr (std::is_same_v<Registry, MaterialRegistry>) made.back().densityTrouble = densityTrouble(*part);
      }
      return ids;
    };
    const bool isMade = parts.size() == 1 ? make(*sections.front(), makeWhole) : make(names, names.place(), makeWhole);
    if (!isMade) isComplete_ = false;
  }

  /// Why the material has no mass density; empty where it has one.
  static std::string densityTrouble(const PeridigmNS::Material& material) {
    try {
      return material.Density() > 0.0 ? "" : "its mass density is not positive";
    } catch (const std::exception& error) {
      return error.what();
    }
  }

  void countSteps(const CheckedSection& checked, const Solver& solver) {
    const std::string path = checked.section.node.path();
    for (const CheckedSection* times : check_.ofKind(Kind::SolverTimes)) {
      if (!times->isGood || path.rfind(times->section.node.path() + "/", 0) != 0) continue;
      const double start = valueOr(times->list, "Initial Time", 0.0), end = valueOr(times->list, "Final Time", 1.0);
      if (!(end > start)) continue;
      const double n = solver.leastSteps(start, end);
      nSteps_ += n;
      const std::string unit = timeUnitOf(solver);
      const std::string message =
          fmt::format("{}: {:.3g} steps at least from {:g} to {:g} {}", path, n, start, end, unit);
      if (nSteps_ > std::numeric_limits<int>::max())
        mistakes_.add(checked.section.node.keyPlace(),
                      message + (n < nSteps_ ? fmt::format(", {:.3g} with those of the solvers before", nSteps_) : "") +
                          ": more than the 2.1e9 that can be counted; take longer steps, or shorten the run");
      else if (n >= manySteps)
        deck_.warnings().add(checked.section.node.keyPlace(),
                             message + ": days of work even for a small body; are the times in " + unit + "?");
    }
  }

  std::vector<int> solverPlugin(const CheckedSection& checked) {
    const auto made = SolverRegistry::self().create(checked.section.plugin, checked.list);
    const FieldTable& table = made->fields();
    for (const std::string& label : made->fieldsWithFarField()) run_.fieldsWithFarField.insert(label);
    for (const FieldUse& use : table.uses()) run_.solverFields.insert(use.field.label);
    countSteps(checked, *made);
    parts_.solvers.push_back({{checked.section.node, checked.section.plugin, table, true, ""}, made->needsDensity()});
    return table.ids();
  }

  /// Where the values of the fields come from that a plug-in sets.
  template <class PlugIn>
  void addOrigins(const PlugIn& plugin) {
    const FieldTable* table = fieldTableOf(plugin);
    if (table == nullptr) return;
    for (const FieldUse& use : table->uses()) {
      std::string& origin = origins_[use.field.label];
      if (use.access == FieldAccess::Worsens)
        origin =
            "damage models find it from broken bonds; a Bond Filter with \"Count In Damage: true\" breaks some at the "
            "start";
      else if (!use.field.rateOf.empty())
        origin = "it is the rate of " + use.field.rateOf + ", which a material computes";
      else if (use.access != FieldAccess::Reads)
        origin = "a material or damage model computes it";
    }
  }

  /// False where it cannot be made.
  bool condition(const CheckedSection& checked) {
    return make(checked, [&] {
      const DeckSection& section = checked.section;
      const auto made = ConditionRegistry::self().create(section.plugin, {section.name, section.node, checked.list});
      const std::vector<int> ids = made->fieldIds();
      parts_.ofConditions.insert(made->field());
      mayHaveLoads_ = mayHaveLoads_ || made->isLoad();
      const std::string obstacle = isComplete_ ? made->obstacle(run_) : "";
      if (!obstacle.empty())
        mistakes_.add(section.node.keyPlace(),
                      section.node.path() + ": " + section.plugin + " does nothing, since " + obstacle);
      else
        fieldOf(*made);
      return ids;
    });
  }

  /// Whether it is there, has the right number of values, and is one to be set.
  void fieldOf(const Condition& condition) {
    const DeckNode given = condition.node()["Field"];
    const std::string& label = condition.field();
    const bool isThere = FieldManager::self().hasField(label);
    if (given && !isKnown(given)) return;
    const std::string start = given ? given.path() + ": " : condition.node().path() + ": ";
    const std::string place = given ? given.place() : condition.node().keyPlace();
    if (isComplete_ && labels_.count(label) == 0 && usedLabels_.count(label) == 0)
      mistakes_.add(place, start + "it acts on the field \"" + label +
                               "\", which no material, damage model or solver of this deck uses");
    else if (condition.width() == 1 && isThere &&
             FieldManager::self().getFieldSpec(label).getLength() != PeridigmNS::PeridigmField::SCALAR)
      mistakes_.add(place, start + "\"" + label + "\" is no scalar field");
    else if (const std::string origin = originOf(label); given && !origin.empty())
      mistakes_.add(place, start + "\"" + label + "\" cannot be set, since " + origin);
  }

  /// Where the values of a field come from that no condition may set; empty of all others.
  std::string originOf(const std::string& label) const {
    if (driverLabels_.count(label) != 0) return "it is that of the mesh or of the motion";
    const auto found = origins_.find(label);
    return found == origins_.end() ? "" : found->second;
  }

  /// Fields whose change makes a part of a staggered run advance. (Those of computes are known for output alone.)
  void watchedFields(const CheckedSection& solver) {
    for (const auto& [name, part] : solver.section.node["Solvers"].entries()) {
      const DeckNode field = part["When"]["Field"];
      if (!isKnown(field) || !FieldManager::self().hasField(field.text())) continue;
      if (FieldManager::self().getFieldSpec(field.text()).getRelation() == PeridigmNS::PeridigmField::GLOBAL)
        mistakes_.add(field.place(), field.path() + ": \"" + field.text() + "\" is no field of points");
    }
  }

  void computes() {
    const auto oneRank = Teuchos::rcp<const Epetra_Comm>(new OneRank);
    const Teuchos::RCP<const Teuchos::ParameterList> noGlobalData;
    for (const auto& [name, entry] : deck_["Compute Class Parameters"].entries()) {
      labels_.insert(name);
      if (entry["Output Label"].isScalar()) labels_.insert(entry["Output Label"].text());
    }
    // Others may use their fields.
    for (const std::string& name : computesWithoutSection(deck_))
      if (isComplete_)
        needsLoads(*ComputeRegistry::self().create(name, Teuchos::null, oneRank, noGlobalData), deck_.root(), name);
    for (const CheckedSection* compute : check_.ofKind(Kind::Compute)) {
      labels_.insert(compute->section.plugin);
      if (!isComplete_) continue;
      makePart(*compute, [&] {
        const auto list = Teuchos::rcp(new Teuchos::ParameterList(compute->list));
        giveAxisOfRevolution(deck_, ComputeRegistry::self().find(compute->section.plugin)->declare(), *list);
        const auto made = ComputeRegistry::self().create(compute->section.plugin, list, oneRank, noGlobalData);
        needsLoads(*made, compute->section.node, compute->section.node.path());
        return made->FieldIds();
      });
    }
    // Those that need no parameters may be named among the output variables alone.
    for (const std::string& name : ComputeRegistry::self().names()) {
      const ParameterDeclarations declarations = ComputeRegistry::self().find(name)->declare();
      const auto& parameters = declarations.parameters();
      if (std::none_of(parameters.begin(), parameters.end(), [](const Parameter& p) { return p.isRequired; }))
        labels_.insert(name);
    }
  }

  void needsLoads(const PeridigmNS::Compute& compute, const DeckNode& node, const std::string& name) {
    const auto* needs = dynamic_cast<const NeedsLoads*>(&compute);
    if (needs == nullptr || mayHaveLoads_ || needs->inPlaceOfLoads().empty()) return;
    mistakes_.add(node.keyPlace(),
                  name + ": no condition of this deck is a load, so that it would stay 0; " + needs->inPlaceOfLoads());
  }

  void outputVariables(const DeckNode& output) {
    const DeckNode variables = output["Output Variables"];
    for (const auto& [name, isWanted] : variables.entries())
      if (!isLeftOut(name, isWanted) && isKnownLabel(name, isWanted.keyPlace(), variables.path()))
        isLabelOfResult(name, isWanted.keyPlace(), variables.path());
    for (const DeckNode& item : variables.items())
      if (item.isScalar() && isKnownLabel(item.text(), item.place(), variables.path()))
        isLabelOfResult(item.text(), item.place(), variables.path());
  }

  /// Whose entries call their results otherwise, the class of a compute yields nothing.
  void isLabelOfResult(const std::string& label, const std::string& place, const std::string& path) {
    std::vector<std::string> results;
    for (const CheckedSection* compute : check_.ofKind(Kind::Compute)) {
      const DeckNode result = compute->section.node["Output Label"];
      if (result.isScalar() && result.text() == label) return;
      if (withUnderscores(compute->section.plugin) != withUnderscores(label)) continue;
      if (!result.isScalar()) return;
      results.push_back(result.text());
    }
    if (results.empty() || usedLabels_.count(label) != 0 || driverLabels_.count(label) != 0) return;
    (deck_.isPeridigmDeck() ? deck_.warnings() : mistakes_)
        .add(place, path + ": \"" + label + "\" is a class of computes, whose results are called " +
                        quotedList(results) + " here; name what is to be written");
  }

  /// Peridigm leaves out what it knows and no block of the deck provides; in a lenient reading so do we with all else.
  bool isLeftOut(const std::string& label, const DeckNode& isWanted) {
    const std::vector<std::string>& theirs = fieldsOfPeridigmAlone();
    const bool isTheirs = std::find(theirs.begin(), theirs.end(), label) != theirs.end();
    if (!isComplete_ || labels_.count(label) != 0 || !deck_.isPeridigmDeck() || !(isTheirs || deck_.isLenient()))
      return false;
    deck_.warnings().add(isWanted.keyPlace(), "nothing in this deck provides \"" + label + "\"; it is left out");
    isWanted.ignore();
    return true;
  }

  bool isKnown(const DeckNode& field) {
    return field.isScalar() && isKnownLabel(field.text(), field.place(), field.path());
  }

  bool isKnownLabel(const std::string& label, const std::string& place, const std::string& path) {
    if (labels_.count(label) != 0) return true;
    if (bondLabels_.count(label) != 0) {
      mistakes_.add(place, path + ": \"" + label +
                               "\" is a field of bonds; name the Output Label of a Bond_Field_Mean of it, a compute");
      return false;
    }
    const std::vector<std::string> known(labels_.begin(), labels_.end());
    if (!isComplete_) {
      // With a plug-in missing, only a slip of the pen is sure to be one.
      std::vector<std::string> all{"Damage", "Concentration", "Temperature", "Velocity", "Force_Density"};
      all.insert(all.end(), known.begin(), known.end());
      const bool isThere = std::any_of(all.begin(), all.end(),
                                       [&](const std::string& other) { return plainName(other) == plainName(label); });
      if (!isThere && !nearestWord(label, all).empty())
        mistakes_.add(place, path + ": unknown field or compute \"" + label + "\"" + didYouMean(label, all));
      return false;
    }
    // All of them once, and only to whom no slip of the pen is to be shown.
    std::string help = didYouMean(label, known);
    if (help.empty())
      help =
          hasListedLabels_ ? "; another of these messages names all that it does" : "; there are: " + quotedList(known);
    hasListedLabels_ = hasListedLabels_ || help.find("there are") != std::string::npos;
    mistakes_.add(place, path + ": nothing in this deck provides \"" + label + "\"" + help);
    return false;
  }

  const DeckUnderCheck& check_;
  const Deck& deck_;
  Mistakes& mistakes_;
  /// The driver fills or makes these itself.
  const std::set<std::string> driverLabels_{"Model_Coordinates", "Coordinates", "Volume",  "Block_Id",
                                            "Element_Id",        "Proc_Num",    "Horizon", "External_Force_Density"};
  RunParts parts_;
  std::set<std::string> labels_;                ///< all that is known
  std::set<std::string> bondLabels_;            ///< fields of bonds
  std::set<std::string> usedLabels_;            ///< by plug-ins of blocks, what they leave to conditions included
  std::map<std::string, std::string> origins_;  ///< of fields that materials and damage models set
  RunContents run_;
  bool hasListedLabels_ = false;
  bool mayHaveLoads_ = false;  ///< some condition is one, or could not be made
  double nSteps_ = 0.0;        ///< of all solvers, at least
  bool isComplete_ = true;     ///< all plug-ins could be made
};

}  // namespace

void checkPluginsAndFields(const DeckUnderCheck& check) { PluginCheck(check).run(); }

}  // namespace pd
