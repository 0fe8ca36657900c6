// Plug-ins refuse some values only when they are made, and only they know the fields of a run: make them all.
#include <algorithm>
#include <map>
#include <set>
#include <sstream>

#include "../../materials/registry/plugins.hpp"
#include "../boundary/condition.hpp"
#include "../solvers/solver.hpp"
#include "Peridigm_Field.hpp"
#include "block_plugins.hpp"
#include "check_deck.hpp"
#include "function.hpp"
#include "peridigm_deck.hpp"
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

class PluginCheck {
 public:
  explicit PluginCheck(const DeckUnderCheck& check) : check_(check), deck_(check.deck), mistakes_(deck_.mistakes()) {
    labels_ = {"Displacement"};
    labels_.insert(driverLabels_.begin(), driverLabels_.end());
    run_.hasDamageModel = check.hasDamageModel();
  }

  void run() {
    isComplete_ = !check_.ofKind(Kind::Block).empty();
    for (const CheckedSection* block : check_.ofKind(Kind::Block)) blockPlugins(*block);
    loadedBlocksFollowPhases();
    for (const CheckedSection* solver : check_.ofKind(Kind::Solver))
      makePart(*solver, [&] {
        const auto made = SolverRegistry::self().create(solver->section.plugin, solver->list);
        for (const std::string& label : made->fieldsWithFarField()) run_.fieldsWithFarField.insert(label);
        for (const FieldUse& use : made->fields().uses()) run_.solverFields.insert(use.field.label);
        return made->fields().ids();
      });
    for (const CheckedSection* solver : check_.ofKind(Kind::Solver)) watchedFields(*solver);
    bool hasAllConditions = true;
    for (const CheckedSection* checked : check_.ofKind(Kind::Condition)) hasAllConditions &= condition(*checked);
    computes();
    isComplete_ = isComplete_ && hasAllConditions;
    for (const CheckedSection* output : check_.ofKind(Kind::Output)) outputVariables(output->section.node);
    for (const CheckedSection* entry : check_.ofKind(Kind::ExactSolution)) isKnown(entry->section.node["Field"]);
  }

 private:
  /// Calls `create`, which makes the plug-in of the section and returns its fields. False where it cannot be made.
  template <class Create>
  bool make(const CheckedSection& checked, const Create& create) {
    return checked.isGood && make(checked.section.node.keyPlace(), checked.section.node.path(), create);
  }
  template <class Create>
  bool make(const std::string& place, const std::string& path, const Create& create) {
    try {
      for (const int id : create()) {
        const PeridigmNS::FieldSpec spec = FieldManager::self().getFieldSpec(id);
        if (spec.getRelation() != PeridigmNS::PeridigmField::BOND) labels_.insert(spec.getLabel());
      }
      return true;
    } catch (const DeckError& error) {
      addAll(mistakes_, error);
    } catch (const std::exception& error) {
      std::istringstream lines(error.what());
      for (std::string line; std::getline(lines, line);) mistakes_.add(place, path + ": " + line);
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

  /// What block plug-ins mean for the rest of the deck.
  struct BlockFields {
    DeckNode block;
    std::vector<NamedTable> plugins;  ///< the material, and the damage model where it has one
    bool changes(const FieldDescription& field, FieldAccess access) const {
      return std::any_of(plugins.begin(), plugins.end(), [&](const NamedTable& plugin) {
        const FieldUse* use = plugin.table.find(field.id());
        return use != nullptr && use->access == access;
      });
    }
  };

  void blockPlugins(const CheckedSection& block) {
    const DeckNode& node = block.section.node;
    blocks_.push_back({node, {}});
    if (!block.isGood) {
      isComplete_ = false;
      return;
    }
    const Function horizon = Function::fromDeck(node["Horizon"]);
    if (!horizon.dependsOnTime())
      makeOfBlock(MaterialRegistry::self(), Kind::Material, node["Material"], [&](Teuchos::ParameterList& list) {
        if (horizon.isConstant()) list.set("Horizon", horizon(0.0, 0.0, 0.0, 0.0));
      });
    if (!hasNone(node))
      makeOfBlock(DamageModelRegistry::self(), Kind::DamageModel, node["Damage Model"], [](Teuchos::ParameterList&) {});
    for (const std::string& message : contestedFields(blocks_.back().plugins))
      mistakes_.add(node.keyPlace(), node.path() + ": " + message);
  }

  /// The plug-in that the block names, or several as one, which `adjust` gives what the block has for it.
  template <class Registry, class Adjust>
  void makeOfBlock(const Registry& registry, Kind kind, const DeckNode& names, const Adjust& adjust) {
    std::vector<NamedPlugin> parts;
    const CheckedSection* only = nullptr;
    for (const DeckNode& name : names.each()) {
      only = named(kind, name);
      const bool isNew =
          std::none_of(parts.begin(), parts.end(), [&](const NamedPlugin& part) { return part.name == name.text(); });
      if (only != nullptr && only->isGood && isNew) parts.push_back({name.text(), only->section.plugin, only->list});
    }
    if (parts.empty() || parts.size() != names.each().size()) {
      isComplete_ = false;
      return;
    }
    NamedPlugin whole = asOne(registry, parts);
    const auto create = [&] {
      if (registry.find(whole.plugin)->declare().find("Horizon") != nullptr) adjust(whole.parameters);
      const auto made = registry.create(whole.plugin, whole.parameters);
      addOrigins(*made);
      blocks_.back().plugins.push_back({whole.name, fieldsIn(*made)});
      return made->FieldIds();
    };
    const bool isMade = parts.size() == 1 ? make(*only, create) : make(names.place(), names.path(), create);
    if (!isMade) isComplete_ = false;
  }

  /// Of a bond between blocks both see to their own side.
  void loadedBlocksFollowPhases() {
    const auto isLoaded = [](const BlockFields& fields) {
      return fields.changes(fields::forceDensity(), FieldAccess::Adds);
    };
    const auto dissolves = [&](const BlockFields& fields) {
      return isLoaded(fields) && fields.changes(fields::saturationConcentration(), FieldAccess::Writes);
    };
    const DeckNode omitted = deck_["Discretization"]["Omit Bonds Between Blocks"];
    const bool areJoined = !(omitted.isScalar() && omitted.text() == "All");
    const auto dissolving = std::find_if(blocks_.begin(), blocks_.end(), dissolves);
    if (dissolving == blocks_.end()) return;
    for (const BlockFields& block : blocks_) {
      if (!isLoaded(block) || !(areJoined || dissolves(block))) continue;
      if (block.changes(fields::saturationConcentration(), FieldAccess::Reads)) continue;
      mistakes_.add(block.block.keyPlace(),
                    block.block.path() + ": its bonds to points that dissolve in " + dissolving->block.path() +
                        " would go on carrying load; add the damage model by which points dissolve to its list, as in "
                        "\"Damage Model: [Breakage, Dissolving]\"");
    }
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
    const bool isThere = FieldManager::self().hasField(label);  // damage models may leave No_Failure to a condition
    if (given && !isKnown(given)) return;
    const std::string start = given ? given.path() + ": " : condition.node().path() + ": ";
    const std::string place = given ? given.place() : condition.node().keyPlace();
    if (isComplete_ && !isThere && labels_.count(label) == 0)
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
      if (isComplete_) ComputeRegistry::self().create(name, Teuchos::null, oneRank, noGlobalData);
    for (const CheckedSection* compute : check_.ofKind(Kind::Compute)) {
      labels_.insert(compute->section.plugin);
      if (!isComplete_) continue;
      makePart(*compute, [&] {
        const auto list = Teuchos::rcp<const Teuchos::ParameterList>(new Teuchos::ParameterList(compute->list));
        return ComputeRegistry::self().create(compute->section.plugin, list, oneRank, noGlobalData)->FieldIds();
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

  void outputVariables(const DeckNode& output) {
    const DeckNode variables = output["Output Variables"];
    for (const auto& [name, isWanted] : variables.entries())
      if (!isLeftOut(name, isWanted)) isKnownLabel(name, isWanted.keyPlace(), variables.path());
    for (const DeckNode& item : variables.items())
      if (item.isScalar()) isKnownLabel(item.text(), item.place(), variables.path());
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
    mistakes_.add(place, path + ": nothing in this deck provides \"" + label + "\"" + didYouMean(label, known) +
                             "; there are: " + quotedList(known));
    return false;
  }

  const DeckUnderCheck& check_;
  const Deck& deck_;
  Mistakes& mistakes_;
  /// The driver fills or makes these itself.
  const std::set<std::string> driverLabels_{"Model_Coordinates", "Coordinates", "Volume",  "Block_Id",
                                            "Element_Id",        "Proc_Num",    "Horizon", "External_Force_Density"};
  std::vector<BlockFields> blocks_;
  std::set<std::string> labels_;                ///< all that is known
  std::map<std::string, std::string> origins_;  ///< of fields that materials and damage models set
  RunContents run_;
  bool isComplete_ = true;  ///< all plug-ins could be made
};

}  // namespace

void checkPluginsAndFields(const DeckUnderCheck& check) { PluginCheck(check).run(); }

}  // namespace pd
