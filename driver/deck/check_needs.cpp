// Solvers, materials and damage models that cannot work together: what one of them needs, as its table of fields says,
// and nothing in the deck gives.
#include <algorithm>
#include <map>
#include <set>

#include "../../materials/registry/diffusivity_field.hpp"
#include "../../materials/registry/flow_fields.hpp"
#include "../../materials/registry/plugins.hpp"
#include "../solvers/solver.hpp"
#include "deck_parameters.hpp"
#include "names.hpp"
#include "run_parts.hpp"

namespace pd {

namespace {

bool isNeed(const FieldUse& use) { return use.access == FieldAccess::Reads && !use.isOptional; }
/// Of one that somebody else brings, too: whoever reads it does.
bool isChange(const FieldUse& use) { return use.access != FieldAccess::Reads; }

const FieldUse* useOf(const FieldTable& table, const std::string& label) {
  const auto& uses = table.uses();
  const auto found =
      std::find_if(uses.begin(), uses.end(), [&](const FieldUse& use) { return use.field.label == label; });
  return found == uses.end() ? nullptr : &*found;
}

/// The scalars whose rates the part gives.
std::vector<std::string> scalarsOf(const RunPart& part) {
  std::vector<std::string> labels;
  for (const FieldUse& use : part.table.uses())
    if (use.access == FieldAccess::Adds && !use.field.rateOf.empty()) labels.push_back(use.field.rateOf);
  return labels;
}

/// Of a part without a table nobody knows.
bool mayRead(const RunPart& part, const FieldDescription& field) {
  const FieldUse* use = useOf(part.table, field.label);
  return !part.hasTable || (use != nullptr && isNeed(*use));
}
bool mayReadAny(const RunPart& part, const std::vector<std::string>& scalars,
                FieldDescription (*description)(const std::string&)) {
  return std::any_of(scalars.begin(), scalars.end(),
                     [&](const std::string& label) { return mayRead(part, description(label)); });
}

/// Names of the plug-ins whose fields, with their default names, have such a use.
template <class Registry, class Test>
std::vector<std::string> pluginsWith(const Registry& registry, const Test& test) {
  std::vector<std::string> names;
  for (const std::string& name : registry.names()) {
    const FieldTable table = registry.find(name)->fields();
    if (std::any_of(table.uses().begin(), table.uses().end(), test)) names.push_back(name);
  }
  return names;
}

std::string placeOfKey(const DeckNode& section, const std::string& key) {
  return section[key] ? section[key].place() : section.keyPlace();
}

/// The place of the value `text` in a section, or of the section where it names it nowhere.
std::string placeOf(const DeckNode& section, const std::string& text) {
  for (const auto& [key, value] : section.entries()) {
    if (value.isScalar() && value.text() == text) return value.place();
    if (!value.isMap()) continue;
    if (const std::string place = placeOf(value, text); place != value.keyPlace()) return place;
  }
  return section.keyPlace();
}

class NeedCheck {
 public:
  NeedCheck(const Deck& deck, const RunParts& parts) : mistakes_(deck.mistakes()), deck_(deck), parts_(parts) {}

  void run() {
    const std::size_t before = mistakes_.lines().size();
    for (const BlockParts& block : parts_.blocks)
      for (const RunPart* metal :
           BlockParts::thatUse(block.materials, fields::saturationConcentration(), FieldAccess::Writes))
        dissolution(block, *metal);
    carriedScalars();
    loadedBlocksFollowPhases();
    keysOfFields();
    densities();
    if (mistakes_.lines().size() > before) return;
    for (const SolverPart& solver : parts_.solvers)
      forEachNeed(solver, [&](const FieldDescription& field) {
        if (require(solver, field)) needsOfMaterials(field);
      });
    for (const BlockParts& block : parts_.blocks)
      for (const RunPart& damage : block.damageModels)
        forEachNeed(damage, [&](const FieldDescription& field) { require(damage, field); });
    report();
    if (mistakes_.lines().size() > before) return;
    for (const BlockParts& block : parts_.blocks) breakageWithoutLoad(block);
  }

 private:
  /// All materials, damage models and solvers.
  template <class Visit>
  void forEachPart(const Visit& visit) const {
    for (const BlockParts& block : parts_.blocks) {
      for (const RunPart& part : block.materials) visit(part);
      for (const RunPart& part : block.damageModels) visit(part);
    }
    for (const SolverPart& part : parts_.solvers) visit(part);
  }

  template <class Visit>
  static void forEachNeed(const RunPart& part, const Visit& visit) {
    if (!part.hasTable) return;
    for (const FieldUse& use : part.table.uses())
      if (isNeed(use)) visit(use.field);
  }

  bool isGiven(const std::string& label) const {
    bool isFound = parts_.ofHost.count(label) != 0 || parts_.ofConditions.count(label) != 0;
    forEachPart([&](const RunPart& part) {
      const FieldUse* use = useOf(part.table, label);
      isFound = isFound || (use != nullptr && (isChange(*use) || !part.hasTable));
    });
    return isFound;
  }

  /// False where nothing gives the field.
  bool require(const RunPart& part, const FieldDescription& field) {
    if (isGiven(field.label)) return true;
    std::vector<std::string>& labels = missing_[{part.node.path(), remedy(field)}];
    if (!contains(labels, field.label)) labels.push_back(field.label);
    const std::string& scalar = field.rateOf.empty() ? field.label : field.rateOf;
    places_.emplace(part.node.path(), placeOf(part.node, scalar));
    names_.emplace(part.node.path(), part.plugin);
    return false;
  }

  void report() {
    for (const auto& [key, labels] : missing_)
      mistakes_.add(places_[key.first], key.first + ": nothing in this deck provides " + quotedList(labels) +
                                            ", which " + names_[key.first] + " needs; " + key.second);
  }

  /// Materials that give a field which a solver reads need what they make it from: but for their own scalars, which the
  /// rest of the deck may leave as they are, and for bonds that nothing damages, which are whole.
  void needsOfMaterials(const FieldDescription& given) {
    for (const BlockParts& block : parts_.blocks)
      for (const RunPart& part : block.materials) {
        const FieldUse* use = useOf(part.table, given.label);
        if (use == nullptr || !isChange(*use)) continue;
        const std::vector<std::string> own = scalarsOf(part);
        forEachNeed(part, [&](const FieldDescription& field) {
          if (!contains(own, field.label) && field.label != fields::bondDamage().label) require(part, field);
        });
      }
  }

  std::string remedy(const FieldDescription& field) const {
    const bool isRate = !field.rateOf.empty();
    std::vector<std::string> scalars;
    for (const BlockParts& block : parts_.blocks)
      for (const RunPart& part : block.materials)
        for (const std::string& label : scalarsOf(part))
          if (!contains(scalars, label)) scalars.push_back(label);
    if (isRate && !scalars.empty())
      return "materials of this deck give rates of " + quotedList(scalars) + didYouMean(field.rateOf, scalars);
    const auto gives = [&](const FieldUse& use) {
      return isChange(use) && (use.field.label == field.label || (isRate && !use.field.rateOf.empty()));
    };
    std::string text;
    const auto add = [&](const char* kind, const std::vector<std::string>& names) {
      if (!names.empty()) text += (text.empty() ? "" : ", or ") + std::string(kind) + " " + quotedList(names);
    };
    add("the material", pluginsWith(MaterialRegistry::self(), gives));
    add("the damage model", pluginsWith(DamageModelRegistry::self(), gives));
    add("the solver", pluginsWith(SolverRegistry::self(), gives));
    return text.empty() ? "let a solver advance it, or a condition set it" : "given by " + text;
  }

  /// Keys that say more of a field which nothing gives.
  void keysOfFields() {
    std::set<std::string> told;
    const auto look = [&](const RunPart& part, const auto& registry) {
      const auto* plugin = registry.find(part.plugin);
      if (plugin == nullptr) return;
      const ParameterDeclarations declarations = plugin->declare();
      for (const Parameter& parameter : declarations.parameters()) {
        const DeckNode key = part.node[parameter.name];
        if (parameter.field.empty() || !key || isGiven(parameter.field) || !told.insert(key.path()).second) continue;
        mistakes_.add(key.keyPlace(), key.path() + " does nothing, since nothing in this deck gives \"" +
                                          parameter.field + "\"; let a condition set it, or leave this key out");
      }
    };
    for (const BlockParts& block : parts_.blocks) {
      for (const RunPart& part : block.materials) look(part, MaterialRegistry::self());
      for (const RunPart& part : block.damageModels) look(part, DamageModelRegistry::self());
    }
  }

  void densities() {
    const auto asks = std::find_if(parts_.solvers.begin(), parts_.solvers.end(),
                                   [](const SolverPart& solver) { return solver.needsDensity; });
    if (asks == parts_.solvers.end()) return;
    for (const BlockParts& block : parts_.blocks) {
      const auto hasDensity = [](const RunPart& part) { return part.densityTrouble.empty(); };
      if (std::any_of(block.materials.begin(), block.materials.end(), hasDensity)) continue;
      for (const RunPart& part : block.materials)
        mistakes_.add(part.node.keyPlace(), part.node.path() + ": " + asks->node.path() +
                                                " needs a mass density, in kg/m3: " + part.densityTrouble);
    }
  }

  /// A block whose `metal` dissolves, with a solver that lets it: the solver must know the ions, a damage model the
  /// phases.
  void dissolution(const BlockParts& block, const RunPart& metal) {
    const FieldDescription saturation = fields::saturationConcentration();
    const std::vector<std::string> ions = scalarsOf(metal);
    const std::string theirs =
        quotedList(ions) + ", into which the metal of " + metal.node.path() + " dissolves; give both the same ";
    for (const RunPart& damage : block.damageModels)
      if (mayRead(damage, saturation) && !mayReadAny(damage, ions, fields::ionConcentration))
        mistakes_.add(placeOfKey(damage.node, "Concentration Field"),
                      damage.node.path() + ": it does not follow " + theirs + "\"Concentration Field\"");
    for (const SolverPart& solver : parts_.solvers) {
      if (!solver.hasTable || !mayRead(solver, saturation)) continue;
      if (!mayReadAny(solver, ions, fields::ionFluxDivergence))
        mistakes_.add(placeOfKey(solver.node, "Concentration Field"),
                      solver.node.path() + ": it does not advance " + theirs + "\"Concentration Field\"");
      const bool isFollowed = std::any_of(block.damageModels.begin(), block.damageModels.end(),
                                          [&](const RunPart& damage) { return mayRead(damage, saturation); });
      if (isFollowed) continue;
      const auto follows = [&](const FieldUse& use) { return isNeed(use) && use.field.label == saturation.label; };
      mistakes_.add(placeOfKey(block.block, "Damage Model"),
                    block.block.path() + ": the metal of " + metal.node.path() +
                        " dissolves, and needs a damage model that changes its phase: " +
                        quotedList(pluginsWith(DamageModelRegistry::self(), follows)));
    }
  }

  /// Scalars that a flow carries along: some solver advances them, after one that finds the flow, and one material of a
  /// block alone lets ions diffuse.
  void carriedScalars() {
    std::set<std::string> told;
    for (const BlockParts& block : parts_.blocks)
      for (const RunPart* part : BlockParts::thatUse(block.materials, fields::bondFlow(), FieldAccess::Reads)) {
        flowsInBlock(block, *part);
        for (const std::string& label : scalarsOf(*part)) {
          diffusesTwice(block, *part, label);
          if (told.insert(part->node.path() + "/" + label).second) advancesCarried(*part, label);
        }
      }
  }

  /// A block without a fluid is a wall.
  void flowsInBlock(const BlockParts& block, const RunPart& carried) {
    const auto mayFlow = [](const RunPart& part) {
      return !part.hasTable || useOf(part.table, fields::viscosity().label) != nullptr;
    };
    if (std::any_of(block.materials.begin(), block.materials.end(), mayFlow)) return;
    mistakes_.add(placeOfKey(block.block, "Material"),
                  block.block.path() + ": a flow is to carry what " + carried.node.path() +
                      " is about, but no material of this block is a fluid; name one in its list, as in \"Material: "
                      "[Water, Salt]\"");
  }

  void advancesCarried(const RunPart& part, const std::string& label) {
    const FieldDescription rate = fields::fluxDivergence(label);
    const auto advances = [&](const SolverPart& solver) { return mayRead(solver, rate); };
    const auto findsFlow = [](const SolverPart& solver) {
      const FieldUse* use = useOf(solver.table, fields::bondFlow().label);
      return !solver.hasTable || (use != nullptr && isChange(*use));
    };
    const auto first = std::find_if(parts_.solvers.begin(), parts_.solvers.end(), advances);
    const auto flow = std::find_if(parts_.solvers.begin(), parts_.solvers.end(), findsFlow);
    if (first == parts_.solvers.end())
      mistakes_.add(placeOfKey(part.node, "Field"),
                    part.node.path() + ": no solver of this deck advances \"" + label +
                        "\", which the flow is to carry; name the Field that one advances, or add a solver of it");
    else if (flow != parts_.solvers.end() && first < flow)
      mistakes_.add(first->node.keyPlace(), first->node.path() + ": it advances \"" + label +
                                                "\", which a flow carries, before " + flow->node.path() +
                                                " finds the flow; put that one before it");
  }

  /// Both would be added up, and metal diffuse like its ions.
  void diffusesTwice(const BlockParts& block, const RunPart& part, const std::string& label) {
    const FieldUse* own = useOf(part.table, diffusivityOf(label).label);
    if (own == nullptr || !isChange(*own)) return;
    for (const RunPart* metal :
         BlockParts::thatUse(block.materials, fields::saturationConcentration(), FieldAccess::Writes))
      if (contains(scalarsOf(*metal), label))
        mistakes_.add(placeOfKey(part.node, "Diffusivity"), part.node.path() + "/Diffusivity: " + metal->node.path() +
                                                                " of the same block lets \"" + label +
                                                                "\" diffuse already; leave it out here");
  }

  /// Damage models that look at how bonds deform, in a block that nothing deforms, as one of fluid.
  void breakageWithoutLoad(const BlockParts& block) {
    const auto hasTable = [](const RunPart& part) { return part.hasTable; };
    if (!std::all_of(block.materials.begin(), block.materials.end(), hasTable) ||
        !BlockParts::thatUse(block.materials, fields::forceDensity(), FieldAccess::Adds).empty())
      return;
    for (const RunPart* damage : BlockParts::thatUse(block.damageModels, fields::coordinates(), FieldAccess::Reads))
      (deck_.isPeridigmDeck() ? deck_.warnings() : mistakes_)
          .add(
              placeOfKey(block.block, "Damage Model"),
              block.block.path() + ": " + damage->node.path() +
                  " breaks bonds that deform, but no material of this block carries load; take it out of the block, or "
                  "give the block a material that does");
  }

  /// Of a bond between blocks both see to their own side.
  void loadedBlocksFollowPhases() {
    const auto isLoaded = [](const BlockParts& block) {
      return !BlockParts::thatUse(block.materials, fields::forceDensity(), FieldAccess::Adds).empty();
    };
    const auto dissolves = [&](const BlockParts& block) {
      return isLoaded(block) &&
             !BlockParts::thatUse(block.materials, fields::saturationConcentration(), FieldAccess::Writes).empty();
    };
    const DeckNode omitted = deck_["Discretization"]["Omit Bonds Between Blocks"];
    const bool areJoined = !(omitted.isScalar() && omitted.text() == "All");
    const auto dissolving = std::find_if(parts_.blocks.begin(), parts_.blocks.end(), dissolves);
    if (dissolving == parts_.blocks.end()) return;
    for (const BlockParts& block : parts_.blocks) {
      if (!isLoaded(block) || !(areJoined || dissolves(block))) continue;
      const auto follows =
          BlockParts::thatUse(block.damageModels, fields::saturationConcentration(), FieldAccess::Reads);
      if (!follows.empty()) continue;
      mistakes_.add(block.block.keyPlace(),
                    block.block.path() + ": its bonds to points that dissolve in " + dissolving->block.path() +
                        " would go on carrying load; add the damage model by which points dissolve to its list, as in "
                        "\"Damage Model: [Breakage, Dissolving]\"");
    }
  }

  Mistakes& mistakes_;
  const Deck& deck_;
  const RunParts& parts_;
  std::map<std::pair<std::string, std::string>, std::vector<std::string>> missing_;  ///< labels by part and remedy
  std::map<std::string, std::string> places_, names_;                                ///< of parts, by their paths
};

}  // namespace

std::vector<const RunPart*> BlockParts::thatUse(const std::vector<RunPart>& kind, const FieldDescription& field,
                                                FieldAccess access) {
  std::vector<const RunPart*> found;
  for (const RunPart& part : kind) {
    const FieldUse* use = useOf(part.table, field.label);
    if (use != nullptr && use->access == access) found.push_back(&part);
  }
  return found;
}

void checkNeeds(const Deck& deck, const RunParts& parts) { NeedCheck(deck, parts).run(); }

}  // namespace pd
