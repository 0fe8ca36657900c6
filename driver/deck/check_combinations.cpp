// Values of a deck that are good alone and must fit each other.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <functional>
#include <limits>
#include <map>
#include <optional>

#include "../solvers/event_solver.hpp"
#include "block_plugins.hpp"
#include "check_deck.hpp"
#include "deck_data.hpp"
#include "function.hpp"
#include "names.hpp"
#include "quantity.hpp"
#include "symmetry_planes.hpp"
#include "vector3.hpp"

namespace pd {

namespace {

using Kind = DeckSection::Kind;

class CombinationCheck {
 public:
  explicit CombinationCheck(const DeckUnderCheck& check)
      : check_(check), deck_(check.deck), mistakes_(deck_.mistakes()) {}

  void run() {
    influence();
    if (deck_["Discretization"][axisOfRevolution])
      ofRevolution();
    else
      agreesWithMaterials("Thickness", {"Plane Stress", "Plane Strain"});
    agreesWithMaterials("Cross Section Area", {"One Dimensional"});
    for (const CheckedSection* block : check_.ofKind(Kind::Block)) {
      isTimeless(block->section.node["Horizon"]);
      damageAgreesWithMaterial(*block);
    }
    for (const CheckedSection* filter : check_.ofKind(Kind::BondFilter)) directions(*filter);
    const std::vector<const CheckedSection*> planes = check_.ofKind(Kind::SymmetryPlane);
    if (std::all_of(planes.begin(), planes.end(), [](const CheckedSection* plane) { return plane->isGood; }))
      readSymmetryPlanes(deck_, mistakes_);
    for (const CheckedSection* set : check_.ofKind(Kind::NodeSet)) {
      if (set->section.node["Box"]) box(set->section.node["Box"]);
      isTimeless(set->section.node["Expression"]);
    }
    cutBondsCount();
    forcesOfFlows();
    labels();
    times();
    firstScans();
    outputs();
  }

 private:
  void influence() {
    const DeckNode node = deck_["Discretization"]["Influence Function"];
    if (!node.isScalar()) return;
    const std::vector<std::string> names{"One", "Parabolic Decay", "Gaussian"};
    if (std::find(names.begin(), names.end(), node.text()) != names.end()) return;
    std::function<double(double, double)> function;
    try {
      function = influenceFunction(node.text(), node.place(), node.isPeridigms());
    } catch (const DeckError& error) {
      if (const std::string meant = didYouMean(node.text(), names); !meant.empty())
        mistakes_.add(node.place(), "unknown influence function \"" + node.text() + "\"" + meant +
                                        "; there are: " + quotedList(names) + ", or a function of zeta and horizon");
      else
        mistakes_.add("", std::string(error.what()) + "; names known here: " + quotedList(names));
      return;
    }
    try {
      tryInfluence(function);
    } catch (const DeckError& error) {
      mistakes_.add("", error.what());
    }
  }

  /// Within each horizon that is known before the mesh is.
  void tryInfluence(const std::function<double(double, double)>& influence) {
    constexpr int nParts = 64;
    for (const CheckedSection* block : check_.ofKind(Kind::Block)) {
      const DeckNode horizon = block->section.node["Horizon"];
      const auto radius = block->isGood && horizon.isScalar() ? parseReal(horizon.text()) : std::nullopt;
      for (int k = 1; radius && k <= nParts; ++k) influence(*radius * (k - 0.5) / nParts, *radius);
    }
  }

  /// The volumes of a plane mesh hold its thickness (those of a bar its cross section), which materials and
  /// neighbourhoods must take alike.
  void agreesWithMaterials(const std::string& key, const std::vector<std::string>& flags) {
    const DeckNode mine = deck_["Discretization"][key];
    if (mine && !(mine.isScalar() && parseReal(mine.text()) && mine.real() > 0.0)) return;
    for (const CheckedSection* material : check_.ofKind(Kind::Material)) {
      if (!material->isGood) continue;
      const DeckNode& whole = material->section.node;
      for (const DeckNode& part : materialParts(whole)) {
        const std::string name = part.path() == whole.path() ? "" : part.path().substr(whole.path().size() + 1);
        agreesWithMaterial(key, flags, part, name.empty() ? material->list : material->list.sublist(name));
      }
    }
  }

  void agreesWithMaterial(const std::string& key, const std::vector<std::string>& flags, const DeckNode& node,
                          const Teuchos::ParameterList& list) {
    const DeckNode mine = deck_["Discretization"][key];
    // Cracks and voids have no flag for planes, where they need the thickness of cells.
    const bool hasCells = mine && valueOr(list, "Material Model", std::string()) == "Bond Decomposition";
    const bool needsIt = hasCells || std::any_of(flags.begin(), flags.end(),
                                                 [&](const std::string& flag) { return valueOr(list, flag, false); });
    if (!list.isParameter(key) || !(node[key] || needsIt)) return;
    const double theirs = list.get<double>(key);
    const std::string place = node[key] ? node[key].place() : node.keyPlace();
    if (!mine && theirs != 1.0)
      mistakes_.add(place, fmt::format("{}/{} is {}, but Discretization has none; add \"{}: {}\" there too, since "
                                       "it is needed to find the distance of points from their volumes",
                                       node.path(), key, theirs, key, theirs));
    else if (mine && mine.real() != theirs)
      mistakes_.add(place, fmt::format("{}/{} is {}, but Discretization/{} is {}; they must agree", node.path(), key,
                                       theirs, key, mine.real()));
  }

  const CheckedSection* named(Kind kind, const DeckNode& name) const {
    for (const CheckedSection* checked : check_.ofKind(kind))
      if (name.isScalar() && checked->section.name == name.text()) return checked->isGood ? checked : nullptr;
    return nullptr;
  }

  /// Damage models that need the constants of the material are told them again, since their interface does not show
  /// them the material.
  void damageAgreesWithMaterial(const CheckedSection& block) {
    const DeckNode& node = block.section.node;
    for (const DeckNode& damage : node["Damage Model"].each()) {
      const CheckedSection* model = named(Kind::DamageModel, damage);
      if (model == nullptr) continue;
      agreesWithBlock(*model, node);
      for (const DeckNode& material : node["Material"].each())
        if (const CheckedSection* other = named(Kind::Material, material)) agrees(*model, *other);
    }
  }

  /// Nodal Energy needs to know how much of a neighbourhood a crack has cut.
  void cutBondsCount() {
    const std::vector<const CheckedSection*> models = check_.ofKind(Kind::DamageModel);
    const auto needsThem = std::find_if(models.begin(), models.end(), [](const CheckedSection* model) {
      return model->section.plugin.find("Nodal Energy") != std::string::npos;
    });
    if (needsThem == models.end()) return;
    for (const CheckedSection* filter : check_.ofKind(Kind::BondFilter))
      if (filter->isGood && !filter->list.get<bool>("Count In Damage"))
        mistakes_.add(
            filter->section.node.keyPlace(),
            fmt::format("{}: {} would take the faces of this crack for free surfaces, which need more energy to "
                        "break; add \"Count In Damage: true\"",
                        filter->section.node.path(), (*needsThem)->section.node.path()));
  }

  template <class Value>
  void agree(const CheckedSection& damage, const std::string& key, const std::string& owner, const Value& mine,
             const Value& other) {
    const DeckNode& node = damage.section.node;
    if (mine == other) return;
    mistakes_.add(
        node[key] ? node[key].place() : node.keyPlace(),
        fmt::format("{}/{} is {}, but {}/{} is {}; they must agree", node.path(), key, mine, owner, key, other));
  }

  void agreesWithBlock(const CheckedSection& damage, const DeckNode& block) {
    const DeckNode horizon = block["Horizon"];
    if (damage.section.node["Horizon"] && damage.list.isType<double>("Horizon") && horizon.isScalar() &&
        parseReal(horizon.text()))
      agree(damage, "Horizon", block.path(), damage.list.get<double>("Horizon"), horizon.real());
  }

  void agrees(const CheckedSection& damage, const CheckedSection& material) {
    if (!damage.section.node["Fracture Energy"]) return;
    const Teuchos::ParameterList &mine = damage.list, &other = material.list;
    const std::string owner = material.section.node.path();
    for (const char* key : {"Young's Modulus", "Poisson's Ratio", "Thickness"})
      if (mine.isType<double>(key) && other.isType<double>(key))
        agree(damage, key, owner, mine.get<double>(key), other.get<double>(key));
    for (const char* key : {"Plane Stress", "Plane Strain", "One Dimensional", "Lattice Rescaling"})
      if (mine.isType<bool>(key) && other.isType<bool>(key))
        agree(damage, key, owner, mine.get<bool>(key), other.get<bool>(key));
    if (const char* key = "Volume Correction"; mine.isType<std::string>(key) && other.isType<std::string>(key))
      agree(damage, key, owner, mine.get<std::string>(key), other.get<std::string>(key));
  }

  void isTimeless(const DeckNode& node) {
    if (!node) return;
    try {
      if (Function::fromDeck(node).dependsOnTime())
        mistakes_.add(node.place(), node.path() + " depends on the time, but it is evaluated once; use x, y, z alone");
    } catch (const DeckError&) {
      // Reported where the section was read.
    }
  }

  Vector3 vectorOf(const Teuchos::ParameterList& list, const std::string& name) {
    return {list.get<double>(name + "_X"), list.get<double>(name + "_Y"), list.get<double>(name + "_Z")};
  }

  void directions(const CheckedSection& filter) {
    if (!filter.isGood || filter.section.declarations.find("Normal_X") == nullptr) return;
    const DeckNode& node = filter.section.node;
    const auto normal = vectorOf(filter.list, "Normal");
    const double normalLength = length(normal);
    if (normalLength == 0.0) mistakes_.add(node["Normal_X"].place(), node.path() + ": the normal has no length");
    if (filter.section.plugin != "Rectangular_Plane") return;
    const auto bottom = vectorOf(filter.list, "Bottom_Unit_Vector");
    const double bottomLength = length(bottom);
    const DeckNode place = node["Bottom_Unit_Vector_X"];
    if (bottomLength == 0.0)
      mistakes_.add(place.place(), node.path() + ": the bottom vector has no length");
    else if (std::abs(dot(normal, bottom)) > 1.0e-6 * normalLength * bottomLength)
      (deck_.isPeridigmDeck() ? deck_.warnings() : mistakes_)
          .add(place.place(),
               node.path() + ": the bottom vector must be perpendicular to the normal" +
                   (deck_.isPeridigmDeck() ? "; as in Peridigm its part within the plane is taken" : ""));
  }

  /// A coordinate, m; with the mistake of a unit that does not fit.
  std::optional<double> lengthOf(const DeckNode& value) {
    if (!value.isScalar() || value.isQuoted()) return std::nullopt;
    if (const auto plain = parseReal(value.text())) return plain;
    std::string complaint;
    const auto number = readQuantity(value.text(), "m", minusSignOf(value), complaint);
    if (number) value.becomes(realText(*number));
    if (!complaint.empty())
      mistakes_.add(value.place(), value.path() + ": \"" + shortened(value.text()) + "\": " + complaint);
    return number;
  }

  void box(const DeckNode& node) {
    std::vector<Vector3> corners;
    const auto items = node.items();
    for (const DeckNode& corner : items) {
      const auto numbers = corner.items();
      Vector3 values{};
      bool isGood = numbers.size() == 3;
      for (std::size_t i = 0; isGood && i < 3; ++i) {
        const auto value = lengthOf(numbers[i]);
        isGood = value.has_value();
        if (isGood) values[i] = *value;
      }
      if (isGood) corners.push_back(values);
    }
    if (items.size() != 2 || corners.size() != 2) {
      mistakes_.add(node.place(), node.path() + " must be two corners, lowest first: [[x, y, z], [x, y, z]]");
      return;
    }
    for (std::size_t i = 0; i < 3; ++i)
      if (corners[0][i] > corners[1][i])
        mistakes_.add(items[0].items()[i].place(),
                      fmt::format("{}: the first corner has {} = {}, above {} of the second; the lowest comes first",
                                  node.path(), "xyz"[i], corners[0][i], corners[1][i]));
  }

  /// What does not know rings would be wrong in silence.
  void ofRevolution() {
    const std::string body = std::string("bodies of revolution (Discretization/") + axisOfRevolution + ")";
    std::vector<std::string> known;
    for (const std::string& name : MaterialRegistry::self().names())
      if (const auto* plugin = MaterialRegistry::self().find(name);
          plugin->partsKey.empty() && plugin->declare().find(axisOfRevolution) != nullptr)
        known.push_back(name);
    const DeckNode section = deck_["Discretization"];
    if (section["Thickness"])
      mistakes_.add(section["Thickness"].place(),
                    fmt::format("{}: rings of {} have no thickness; leave it out, and let the volumes of the mesh be "
                                "areas, m2, as of a plane 1 m thick",
                                section["Thickness"].path(), body));
    for (const CheckedSection* material : check_.ofKind(Kind::Material))
      for (const DeckNode& part : materialParts(material->section.node)) {
        const DeckNode thickness = part["Thickness"];
        if (thickness.isScalar() && parseReal(thickness.text()).value_or(1.0) != 1.0)
          mistakes_.add(thickness.place(),
                        fmt::format("{}: rings of {} have no thickness; leave it out", thickness.path(), body));
        const DeckNode model = part["Material Model"];
        if (!model.isScalar() || MaterialRegistry::self().find(model.text()) == nullptr ||
            std::find(known.begin(), known.end(), model.text()) != known.end())
          continue;
        mistakes_.add(model.place(),
                      fmt::format("{}: {} does not know {}; there are: {}. For others model the body in space",
                                  part.path(), model.text(), body, quotedList(known)));
      }
    for (const CheckedSection* compute : check_.ofKind(Kind::Compute)) {
      const ParameterDeclarations& declarations = compute->section.declarations;
      for (const char* ofPlanes : {"Thickness", "Plane Stress", "Into X"})
        if (declarations.find(ofPlanes) != nullptr) {
          mistakes_.add(compute->section.node.keyPlace(),
                        fmt::format("{}: {} is for points of a plane or of space and does not know {}; leave it out",
                                    compute->section.node.path(), compute->section.plugin, body));
          break;
        }
    }
  }

  /// The momentum that passes a ring is the force on the body where the flow is steady and nothing else acts on the
  /// fluid within.
  void forcesOfFlows() {
    const auto find = [&](Kind kind, const std::string& plugin) -> const CheckedSection* {
      for (const CheckedSection* checked : check_.ofKind(kind))
        if (checked->section.plugin == plugin) return checked;
      return nullptr;
    };
    const CheckedSection* compute = find(Kind::Compute, "Flow_Force");
    if (compute == nullptr) return;
    const DeckNode& node = compute->section.node;
    if (const CheckedSection* force = find(Kind::Condition, "Flow Body Force"))
      mistakes_.add(node.keyPlace(),
                    fmt::format("{}: Flow_Force does not count {}, which acts on the fluid within its ring; leave one "
                                "of them out, or let pressures of outflows drive the flow",
                                node.path(), force->section.node.path()));
    if (const CheckedSection* solver = find(Kind::Solver, "Weakly Compressible Flow"))
      deck_.warnings().add(node.keyPlace(), fmt::format("{}: Flow_Force is that of steady flow; with {} it counts once "
                                                        "the flow has become steady",
                                                        node.path(), solver->section.node.path()));
  }

  /// Of fields that the deck names: they go into the headings of files.
  void labels() {
    const auto check = [&](const DeckNode& label) {
      if (!label.isScalar()) return;
      if (const std::string complaint = complaintOfLabel(label.text()); !complaint.empty())
        mistakes_.add(label.place(), label.path() + " " + complaint);
    };
    for (const CheckedSection* compute : check_.ofKind(Kind::Compute)) check(compute->section.node["Output Label"]);
    for (const CheckedSection* material : check_.ofKind(Kind::Material))
      for (const auto& [key, value] : material->section.node.entries())
        if (key.size() > 5 && key.compare(key.size() - 5, 5, "Field") == 0) check(value);
  }

  void times() {
    const CheckedSection* previous = nullptr;
    for (const CheckedSection* solver : check_.ofKind(Kind::SolverTimes)) {
      const DeckNode& node = solver->section.node;
      const double start = valueOr(solver->list, "Initial Time", 0.0);
      const double end = valueOr(solver->list, "Final Time", 1.0);
      if (solver->isGood && end <= start)
        mistakes_.add(node[node["Final Time"] ? "Final Time" : "Initial Time"].place(),
                      fmt::format("{}: Final Time {} must be after Initial Time {}", node.path(), end, start));
      if (previous != nullptr && previous->isGood && solver->isGood) {
        const double before = valueOr(previous->list, "Final Time", 1.0);
        if (std::abs(start - before) > 1.0e-9 * std::abs(before))
          mistakes_.add(node["Initial Time"] ? node["Initial Time"].place() : node.keyPlace(),
                        fmt::format("{}: Initial Time {} must be {}, the Final Time of {}", node.path(), start, before,
                                    previous->section.node.path()));
      }
      previous = solver;
    }
  }

  /// Losses are 0 until the scan that they count from.
  void firstScans() {
    const std::vector<const CheckedSection*> solvers = check_.ofKind(Kind::SolverTimes);
    if (solvers.empty() || !solvers.back()->isGood) return;
    const double end = valueOr(solvers.back()->list, "Final Time", 1.0);
    for (const CheckedSection* compute : check_.ofKind(Kind::Compute)) {
      const DeckNode node = compute->section.node["First Scan"];
      if (!node || !compute->isGood || compute->list.get<double>("First Scan") < end) continue;
      const std::string unit = timeUnit();
      deck_.warnings().add(node.place(),
                           fmt::format("{}, {} {}, is not before the end of the run, {} {}: the value is "
                                       "0 all the time",
                                       node.path(), compute->list.get<double>("First Scan"), unit, end, unit));
    }
  }

  /// Of the run, which is that of its first solver. What keeps it from being made is said where plug-ins are checked.
  std::string timeUnit() const {
    const std::vector<const CheckedSection*> solvers = check_.ofKind(Kind::Solver);
    if (solvers.empty() || !solvers.front()->isGood) return "s";
    try {
      return timeUnitOf(*SolverRegistry::self().create(solvers.front()->section.plugin, solvers.front()->list));
    } catch (const std::exception&) {
      return "s";
    }
  }

  void outputs() {
    std::map<std::string, std::string> files;
    for (const CheckedSection* output : check_.ofKind(Kind::Output)) {
      const DeckNode& node = output->section.node;
      for (const DeckNode& step : node["Output Steps"].items())
        if (const auto number = step.isScalar() ? parseReal(step.text()) : std::nullopt;
            number && !(*number == std::trunc(*number) && *number <= std::numeric_limits<int>::max()))
          mistakes_.add(step.place(), step.path() + " must be an integer, not \"" + step.text() + "\"");
      if (!output->isGood) continue;
      const std::string file = output->list.get<std::string>("Output Filename");
      const std::string place = node["Output Filename"] ? node["Output Filename"].place() : node.keyPlace();
      if (const std::string complaint = complaintOfFileName(file); !complaint.empty())
        mistakes_.add(place, node.path() + "/Output Filename " + complaint);
      const auto [it, isNew] = files.emplace(std::filesystem::path(file).lexically_normal().string(), node.path());
      // Peridigm writes values for the whole body and fields into files of one name with different endings, as we do.
      if (!isNew && !deck_.isPeridigmDeck())
        mistakes_.add(place, node.path() + ": \"" + file + "\" is the Output Filename of " + it->second +
                                 " already; each writes a file of its own");
      const int first = valueOr(output->list, "Initial Output Step", 0);
      if (output->list.isParameter("Final Output Step") && output->list.get<int>("Final Output Step") < first)
        mistakes_.add(node["Final Output Step"].place(),
                      fmt::format("{}: Final Output Step {} is before Initial Output Step {}", node.path(),
                                  output->list.get<int>("Final Output Step"), first));
    }
  }

  const DeckUnderCheck& check_;
  const Deck& deck_;
  Mistakes& mistakes_;
};

}  // namespace

void checkCombinations(const DeckUnderCheck& check) { CombinationCheck(check).run(); }

}  // namespace pd
