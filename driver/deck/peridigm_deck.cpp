#include "peridigm_deck.hpp"

#include <algorithm>
#include <cctype>
#include <sstream>

#include "../boundary/condition.hpp"
#include "section_walk.hpp"
#include "sections.hpp"

namespace pd {

namespace {

using Data = DeckNode::Data;
using Entry = std::shared_ptr<Data>;

/// A key that Peridigm reads and we do not.
struct ForeignKey {
  const char* name;
  /// Of a key whose effect is missing here: the only value that means nothing; empty: every value is refused. Null: the
  /// key has no effect here, whatever its value.
  const char* harmless;
  const char* remark;  ///< why it has no effect; or what is missing and what to do
};

const std::vector<ForeignKey> keysOfTop{
    {"Verbose", nullptr, "the log holds all there is to say; --quiet keeps it off the terminal"},
    {"Multiphysics", "0", "fluid pressure is not solved for; remove it, or set it to 0"},
    {"Restart", "false",
     "write checkpoints by \"Checkpoint Frequency\" in Output, go on with pdrun --restart FILE, and remove this key"},
    {"Optimization Based Coupling", "false", "coupling to other programs is not there; remove it"},
    {"Contact", "", "bodies that touch do not feel each other; if yours never do, remove this section"},
    {"Data Loader", "", "fields are not read from files during a run; use conditions with functions of x, y, z, t"}};

const std::vector<ForeignKey> keysOfDiscretization{
    {"Verbose", nullptr, ""},
    {"Store Exodus Mesh", nullptr, "elements are not kept beside their points"},
    {"Construct Interfaces", nullptr, "surfaces between elements are not written"},
    {"Construct Neighborhood Lists", "true", "all points have neighbours; remove it"},
    {"Compute Element-Horizon Intersections", "false", "volumes of neighbours are not cut at the horizon; remove it"}};

const std::vector<ForeignKey> keysOfMaterials{
    {"Apply Shear Correction Factor", nullptr, "Peridigm does not read it for these materials either"},
    {"Hourglass Coefficient", nullptr, "Peridigm does not read it for these materials either"},
    {"Compute Partial Stress", "false", "the compute Bond_Stress gives stresses; remove this key"},
    {"Thermal Expansion Coefficient", "0",
     "thermal expansion is not modelled; remove it where no temperature changes"}};

const std::vector<ForeignKey> keysOfDamageModels{
    {"Thermal Expansion Coefficient", "0",
     "thermal expansion is not modelled; remove it where no temperature changes"}};

const std::vector<ForeignKey> keysOfConditions{
    {"Create Node Set For Rank Deficient Nodes", nullptr, "QuasiStatic finds points and parts that nothing holds"}};

const std::vector<ForeignKey> keysOfSolver{
    {"Jacobian Diagnostics", nullptr, ""},
    {"Disable Heuristics", nullptr, "Newton's method has other safeguards here"},
    {"Initialize Predictor From Previous Solver", nullptr,
     "the first load step of a solver starts without a prediction"},
    {"Peridigm Preconditioner", nullptr, "\"Preconditioner\" of QuasiStatic chooses one"},
    {"Solve For Displacement", nullptr, "the solver's name says what is solved for"},
    {"Solve For Temperature", nullptr, "the solver's name says what is solved for"},
    {"Solve For Concentration", nullptr, "the solver's name says what is solved for"},
    {"Solve For Pressure", "false", "fluid pressure is not solved for; remove it"},
    {"Implicit", "",
     "implicit dynamics (Newmark) is not there; use Verlet, or QuasiStatic where inertia does not matter"}};

const std::vector<ForeignKey> keysOfNox{
    {"Nonlinear Solver", nullptr, "Newton's method with line search"},
    {"Direction", nullptr, "\"Linear Solver\" and \"Preconditioner\" are ours"},
    {"Line Search", nullptr, "Newton's method searches along its steps anyway"},
    {"Solver Options", nullptr, ""},
    {"Printing", nullptr, ""},
    {"Verbose", nullptr, ""},
    {"Max Age Of Prec", nullptr, "the preconditioner is as old as the tangent"},
    {"Preconditioner Reuse Policy", nullptr, "the preconditioner is as old as the tangent"}};

const std::vector<ForeignKey> keysOfAdaptiveLoadStepping{
    {"Maximum total load step reductions", nullptr, "only those in one load step are limited"},
    {"Reduce all remaining load steps", nullptr, "each load step is tried at its full length"},
    {"Adaptive output frequency", nullptr, "parts of a load step are not written"},
    {"Switch to Verlet", nullptr, "a load step without equilibrium ends the run with a message"}};

const std::vector<ForeignKey> keysOfOutput{
    {"Output File Type", nullptr, "results are HDF5 with an XDMF file, not ExodusII"},
    {"Output Format", nullptr, "results are binary"},
    {"Parallel Write", nullptr, "all ranks write one file"}};

class Translation {
 public:
  Translation(Mistakes& mistakes, Mistakes& warnings) : mistakes_(mistakes), warnings_(warnings) {}

  void deck(Data& root) {
    foreignKeys(root, keysOfTop);
    for (const auto& [name, node] : root.entries) {
      if (node->kind != Data::Kind::Map) continue;
      if (name.find("Solver") != std::string::npos) solver(*node);
      if (name.find("Output") != std::string::npos) foreignKeys(*node, keysOfOutput);
    }
    if (Data* discretization = section(root, "Discretization")) foreignKeys(*discretization, keysOfDiscretization);
    if (Data* list = section(root, "Boundary Conditions")) {
      foreignKeys(*list, keysOfConditions);
      for (const auto& entry : list->entries) condition(*entry.second);
    }
    inEachEntry(root, "Materials", keysOfMaterials);
    inEachEntry(root, "Damage Models", keysOfDamageModels);
    neighbourhoodsAsTheyAre(root);
  }

 private:
  static Data* section(const Data& parent, const std::string& name) {
    Data* node = parent.entry(name);
    return node != nullptr && node->kind == Data::Kind::Map ? node : nullptr;
  }

  static void remove(Data& parent, const std::string& name) {
    auto& entries = parent.entries;
    entries.erase(
        std::remove_if(entries.begin(), entries.end(), [&](const auto& entry) { return entry.first == name; }),
        entries.end());
  }

  /// Without effect where there is no `from`, or `to` is there as well, of which the checks will speak.
  static void rename(Data& parent, const std::string& from, const std::string& to) {
    if (parent.entry(to) != nullptr) return;
    for (auto& entry : parent.entries)
      if (entry.first == from) entry.first = to;
  }

  static std::string keyPlace(const Data& node) { return node.placeOf(node.keyLine, node.keyColumn); }

  static bool isHarmless(const Data& value, const std::string& harmless) {
    if (harmless.empty() || value.kind != Data::Kind::Scalar) return false;
    const auto number = parseReal(value.scalar);
    return number ? number == parseReal(harmless) : parseFlag(value.scalar) == parseFlag(harmless);
  }

  void foreignKeys(Data& parent, const std::vector<ForeignKey>& keys) {
    for (const ForeignKey& key : keys) {
      const Data* value = parent.entry(key.name);
      if (value == nullptr) continue;
      const std::string name = std::string("\"") + key.name + "\"", remark = key.remark;
      if (key.harmless == nullptr)
        warnings_.add(keyPlace(*value), name + " has no effect here" + (remark.empty() ? "" : ": " + remark));
      else if (!isHarmless(*value, key.harmless))
        mistakes_.add(keyPlace(*value), name + (parent.path.empty() ? "" : " in " + parent.path) + ": " + remark);
      remove(parent, key.name);
    }
  }

  void inEachEntry(const Data& root, const std::string& name, const std::vector<ForeignKey>& keys) {
    const Data* list = section(root, name);
    if (list == nullptr) return;
    for (const auto& entry : list->entries)
      if (entry.second->kind == Data::Kind::Map) foreignKeys(*entry.second, keys);
  }

  /// Peridigm does not tell apart upper and lower case, nor blanks and underscores, in types; and where a field has no
  /// components, it takes Coordinate x.
  static void condition(const Data& node) {
    Data *type = node.entry("Type"), *coordinate = node.entry("Coordinate");
    if (type == nullptr) return;
    for (const std::string& known : ConditionRegistry::self().names())
      if (plainName(known) == plainName(type->scalar)) type->scalar = known;
    if (coordinate == nullptr || coordinate->scalar.size() != 1) return;
    coordinate->scalar[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(coordinate->scalar[0])));
    const auto* plugin = ConditionRegistry::self().find(type->scalar);
    const bool isScalarField = plugin != nullptr && plugin->declare().find("Coordinate") == nullptr;
    if (isScalarField && coordinate->scalar == "x") coordinate->isIgnored = true;
  }

  void solver(Data& node) {
    foreignKeys(node, keysOfSolver);
    if (Data* nox = section(node, "NOXQuasiStatic"); nox != nullptr && node.entry("QuasiStatic") == nullptr) {
      warnings_.add(
          keyPlace(*nox),
          "NOXQuasiStatic is carried out by QuasiStatic: the same equilibrium, by a Newton method of its own");
      foreignKeys(*nox, keysOfNox);
      rename(*nox, "Max Solver Iterations", "Maximum Solver Iterations");
      rename(node, "NOXQuasiStatic", "QuasiStatic");
    }
    setDefault(node, "Verlet", "Critical Step", "Bulk Modulus");
    setDefault(node, "QuasiStatic", "Velocity From Increments", "true");
    for (const char* name : {"QuasiStatic", "ImplicitDiffusion"})
      if (Data* loadSteps = section(node, name)) {
        adaptiveLoadStepping(*loadSteps);
        timesOfSteps(node, *loadSteps);
      }
  }

  /// Neighbourhoods of boxes and cylinders reach beyond the horizon, and everybody in them counts; a bond between
  /// blocks has to each of its ends the constants of that block.
  static void neighbourhoodsAsTheyAre(const Data& root) {
    const Data* materials = section(root, "Materials");
    if (materials == nullptr) return;
    for (const auto& [name, node] : materials->entries) {
      const Data* model = node->entry("Material Model");
      for (const char* theirs : {"Elastic", "Elastic Bond Based", "Diffusion"})
        if (model != nullptr && model->scalar == theirs)
          setDefault(*materials, name, "Volume Correction", "Every Neighbor");
      if (model != nullptr && model->scalar == "Diffusion")
        setDefault(*materials, name, "Interface Flux", "Own Constants");
    }
  }

  /// What an entry of `parent` is in Peridigm, where the deck does not say.
  static void setDefault(const Data& parent, const std::string& name, const std::string& key, const char* value) {
    Data* node = parent.entry(name);
    if (node == nullptr || (node->kind != Data::Kind::Map && node->kind != Data::Kind::Null) || node->entry(key))
      return;
    node->kind = Data::Kind::Map;
    auto entry = std::make_shared<Data>(*node);
    entry->kind = Data::Kind::Scalar;
    entry->entries.clear();
    entry->scalar = value;
    node->entries.emplace_back(key, entry);
  }

  void adaptiveLoadStepping(Data& quasiStatic) {
    Data* adaptive = section(quasiStatic, "Adaptive Load-Stepping");
    if (adaptive == nullptr) return;
    foreignKeys(*adaptive, keysOfAdaptiveLoadStepping);
    for (const auto& [key, value] : adaptive->entries) {
      if (key == "Maximum load step reductions in one step" &&
          quasiStatic.entry("Maximum Load Step Reductions") == nullptr)
        quasiStatic.entries.emplace_back("Maximum Load Step Reductions", value);
      else
        mistakes_.add(keyPlace(*value), "unknown key \"" + key + "\" in " + adaptive->path);
    }
    remove(quasiStatic, "Adaptive Load-Stepping");
  }

  /// In Peridigm, a list of times stands for Initial Time and Final Time, whatever these say.
  void timesOfSteps(Data& solver, const Data& loadSteps) {
    const Data* steps = loadSteps.entry("Time Steps");
    if (steps == nullptr || steps->kind != Data::Kind::Scalar || loadSteps.entry("Number of Load Steps") != nullptr)
      return;
    std::istringstream words(steps->scalar);
    std::vector<std::string> times;
    for (std::string word; words >> word;) times.push_back(word);
    if (times.size() < 2 || !parseReal(times.front()) || !parseReal(times.back())) return;
    setTime(solver, "Initial Time", times.front(), *steps);
    setTime(solver, "Final Time", times.back(), *steps);
  }

  void setTime(Data& solver, const std::string& name, const std::string& time, const Data& steps) {
    if (const Data* given = solver.entry(name)) {
      if (given->kind == Data::Kind::Scalar && parseReal(given->scalar) == parseReal(time)) return;
      warnings_.add(keyPlace(*given), "\"" + name + "\" has no effect here: the Time Steps say " + time);
      remove(solver, name);
    }
    auto value = std::make_shared<Data>(steps);
    value->scalar = time;
    value->isQuoted = false;
    value->xmlType = steps.xmlType.empty() ? "" : "double";
    solver.entries.emplace_back(name, value);
  }

  Mistakes &mistakes_, &warnings_;
};

}  // namespace

void translatePeridigmDeck(Data& root, Mistakes& mistakes, Mistakes& warnings) {
  Translation(mistakes, warnings).deck(root);
  root.setPath(root.path);
  root.setPeridigms();
}

const std::vector<std::string>& fieldsOfPeridigmAlone() {
  static const std::vector<std::string> labels{"Angular_Momentum",
                                               "Bond_Visualization",
                                               "Concentration",
                                               "Contact_Force",
                                               "Contact_Force_Density",
                                               "Damage",
                                               "Dilatation",
                                               "Flux_Divergence",
                                               "Force_Density",
                                               "Global_Angular_Momentum",
                                               "Global_Linear_Momentum",
                                               "Interfaces",
                                               "Linear_Momentum",
                                               "Neighborhood_Volume",
                                               "Node_Type",
                                               "Nonlinear_Solver_Iterations",
                                               "OBC_Functional",
                                               "Partial_Stress",
                                               "Surface_Correction_Factor",
                                               "Temperature",
                                               "Temperature_Change",
                                               "Velocity",
                                               "Velocity_Gradient",
                                               "Weighted_Volume"};
  return labels;
}

}  // namespace pd
