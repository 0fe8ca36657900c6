#include "field_run.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "../support/corroded_body.hpp"
#include "bond_family.hpp"
#include "fields.hpp"
#include "linear_bonds.hpp"
#include "plugins.hpp"

namespace pdtest {

using namespace PeridigmNS;

namespace {

/// Bits of all values by label and step.
using Memory = std::map<std::pair<std::string, PeridigmField::Step>, std::vector<double>>;

Memory memoryOf(SmallBody& body) {
  Memory memory;
  for (Block& block : *body.blocks())
    for (const int id : block.getDataManager()->getFieldIds())
      for (const auto step : {PeridigmField::STEP_NONE, PeridigmField::STEP_N, PeridigmField::STEP_NP1}) {
        if (!block.hasData(id, step)) continue;
        const FieldVector& values = *block.getData(id, step);
        std::vector<double>& copy = memory[{FieldManager::self().getFieldSpec(id).label, step}];
        for (int i = 0; i < values.MyLength(); ++i) copy.push_back(values[i]);
      }
  return memory;
}

bool isSame(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

/// Labels of fields that have changed, with the steps.
std::set<std::pair<std::string, PeridigmField::Step>> changes(const Memory& before, const Memory& after) {
  std::set<std::pair<std::string, PeridigmField::Step>> result;
  for (const auto& [place, values] : before)
    if (!std::equal(values.begin(), values.end(), after.at(place).begin(), isSame)) result.insert(place);
  return result;
}

const pd::FieldUse* useOf(const pd::FieldTable& table, const std::string& label) {
  for (const pd::FieldUse& use : table.uses())
    if (use.field.label == label) return &use;
  return nullptr;
}

std::string unsaidWrites(const pd::FieldTable& table, const Memory& before, const Memory& after) {
  std::string lines;
  for (const auto& [label, step] : changes(before, after)) {
    const pd::FieldUse* use = useOf(table, label);
    if (use == nullptr || use->access == pd::FieldAccess::Reads)
      lines += "writes " + label + ", which its table does not say\n";
    else if (step == PeridigmField::STEP_N)
      lines += "writes " + label + " of the step before\n";
  }
  return lines;
}

std::string namesOf(const std::set<int>& ids) {
  std::string names;
  for (const int id : ids) names += " " + FieldManager::self().getFieldSpec(id).label;
  return names;
}

std::string comparedIds(const std::string& what, const std::vector<int>& said, const std::vector<int>& inTable) {
  const std::set<int> a(said.begin(), said.end()), b(inTable.begin(), inTable.end());
  return a == b ? "" : what + ":" + namesOf(a) + "; its table:" + namesOf(b) + "\n";
}

std::vector<int> idsOf(const pd::FieldTable& table) {
  std::vector<int> ids;
  for (const pd::FieldUse& use : table.uses()) ids.push_back(use.id);
  return ids;
}

}  // namespace

std::string gapsIn(const pd::FieldTable& table) {
  std::string lines = table.uses().empty() ? "no field at all\n" : "";
  for (const pd::FieldUse& use : table.uses()) {
    if (use.field.label.empty()) lines += "a field without a label\n";
    if (use.field.unit.empty()) lines += use.field.label + " without a unit\n";
    if (use.field.meaning.empty() || use.field.meaning.back() != '.')
      lines += use.field.label + " without a sentence of what it means\n";
  }
  return lines;
}

std::string brokenFieldContract(const Sample& sample, PluginKind kind) {
  Layout layout;
  layout.bondSteps = BondSteps::Copied;  // N and NP1 apart
  StepRun run(sample, kind, layout);
  const pd::FieldTable& table = run.table();
  std::string lines = gapsIn(table);
  lines += comparedIds("FieldIds()", run.fieldIds(), table.ids());
  lines += comparedIds("to synchronise after initialize", run.synchronised(pd::Ghosts::AfterInitialize),
                       table.ids(pd::Ghosts::AfterInitialize));
  lines += comparedIds("to synchronise after precompute", run.synchronised(pd::Ghosts::AfterPrecompute),
                       table.ids(pd::Ghosts::AfterPrecompute));
  run.body().allocate(idsOf(table));
  for (int step = 1; step <= 3; ++step) {
    run.load(0.35 * step);
    const Memory before = memoryOf(run.body());
    run.evaluate();
    lines += unsaidWrites(table, before, memoryOf(run.body()));
    run.accept();
  }
  return lines;
}

namespace {

/// Reports an energy, and springs of one stiffness.
class StillMaterial : public Material, public pd::LinearBonds {
 public:
  StillMaterial() : Material(Teuchos::ParameterList()) {}
  std::string Name() const override { return "Still"; }
  double Density() const override { return 2.0; }
  double BulkModulus() const override { return 3.0; }
  double ShearModulus() const override { return 1.0; }
  std::vector<int> FieldIds() const override { return {}; }
  void computeStoredElasticEnergyDensity(const double, const int n, const int* owned, const int*,
                                         DataManager& data) const override {
    FieldVector& energy = *data.getData(pd::fields::storedEnergyDensity().id(), PeridigmField::STEP_NONE);
    for (int i = 0; i < n; ++i) energy[owned[i]] = 1.0 + owned[i];
  }
  pd::LinearSprings::Family springFamily() const override { return pd::LinearSprings::Family::None; }
  pd::LinearSprings springs(const pd::Call& call, DataManager&) const override {
    pd::LinearSprings springs;
    pd::forEachBond(call, [&](int, int, std::size_t) { springs.along.push_back(1.0); });
    return springs;
  }
};

BodyOptions plateOptions() {
  BodyOptions options;
  options.horizon = 1.5;
  options.blockOf = [](int id) { return id % 6 < 3 ? 1 : 2; };
  options.bondSteps = BondSteps::Copied;
  return options;
}

/// What nobody writes by chance.
constexpr double untouched = -12345.678;

/// What is read gets values from 0.5 to 1.5, except what the body has dissolved to.
void fill(SmallBody& body, const pd::FieldTable& table) {
  for (const pd::FieldUse& use : table.uses()) {
    const std::string& label = use.field.label;
    const bool isRead = use.access == pd::FieldAccess::Reads;
    if (isRead && (label == "Damage" || label.find("oncentration") != std::string::npos || label == "Volume" ||
                   label == "Model_Coordinates"))
      continue;
    for (Block& block : *body.blocks()) {
      const auto step =
          use.field.temporal == PeridigmField::TWO_STEP ? PeridigmField::STEP_NP1 : PeridigmField::STEP_NONE;
      FieldVector& values = *block.getData(use.id, step);
      for (int i = 0; i < values.MyLength(); ++i) values[i] = isRead ? 1.0 + 0.5 * noise(i, 60) : untouched;
    }
  }
}

}  // namespace

std::string brokenFieldContract(const ComputeSample& sample) {
  CorrodedBody body(stretchedLattice({6, 6, 1}, {1.0, 1.0, 1.0}, {0.0, -1.5, 0.0}), plateOptions(), 1);
  body.dissolve([](const Point& x) { return 0.3 * (2.0 - x[1]); });
  body.addNodeSet("Surface", {12, 13, 14, 15, 16, 17});
  body.allocate({pd::fields::bondDamage().id()});
  for (Block& block : *body.blocks()) block.setMaterialModel(Teuchos::rcp(new StillMaterial));
  const auto compute =
      pd::ComputeRegistry::self().create(sample.plugin, Teuchos::rcp(new Teuchos::ParameterList(sample.parameters)),
                                         Teuchos::rcp(new SerialComm), body.globalData());
  const pd::FieldTable* table = pd::fieldTableOf(*compute);
  if (table == nullptr) return "it has no table\n";
  std::string lines = gapsIn(*table);
  lines += comparedIds("FieldIds()", compute->FieldIds(), table->ids());
  body.allocate(idsOf(*table));
  fill(body, *table);
  compute->initialize(body.blocks());
  const Memory before = memoryOf(body);
  compute->compute(body.blocks());
  const Memory after = memoryOf(body);
  lines += unsaidWrites(*table, before, after);
  const auto changed = changes(before, after);
  for (const pd::FieldUse& use : table->uses())
    if (use.access != pd::FieldAccess::Reads &&
        std::none_of(changed.begin(), changed.end(), [&](const auto& place) { return place.first == use.field.label; }))
      lines += "does not write " + use.field.label + ", as its table says\n";
  return lines;
}

std::vector<ComputeSample> computeSamples() {
  std::map<std::string, Teuchos::ParameterList> given;
  const auto text = [&](const char* plugin, const char* key, const char* value) {
    given[plugin].set<std::string>(key, value);
  };
  for (const char* plugin : {"Corrosion_Depth", "Maximum_Depth", "Mean_Depth", "Deepest_Place", "Pit_Width",
                             "Pit_Count", "Pit_Depth", "Front_Speed"}) {
    text(plugin, "Node Set", "Surface");
    given[plugin].set("Into Y", 1.0);
  }
  for (const char* plugin : {"Pit_Count", "Pit_Depth"}) given[plugin].set("Deeper Than", 0.5);
  text("Corrosion_Rate", "Over", "Last Interval");
  given["Wire_Diameter"].set("First Diameter", 6.0);
  given["Wire_Diameter"].set("Slice Width", 2.0);
  for (const char* plugin : {"Field_Mean", "Field_Integral", "Field_Minimum", "Field_Maximum", "Block_Data",
                             "Node_Set_Data", "Nearest_Point_Data"}) {
    text(plugin, "Variable", "Displacement");
    text(plugin, "Output Label", (std::string("Of_Displacement_") + plugin).c_str());
  }
  for (const char* plugin : {"Block_Data", "Node_Set_Data"}) text(plugin, "Calculation Type", "Sum");
  text("Block_Data", "Block", "block_1");
  text("Node_Set_Data", "Node Set", "Surface");
  text("Reaction_Force", "Node Set", "Surface");
  for (const char* axis : {"X", "Y", "Z"}) given["Nearest_Point_Data"].set(axis, 0.5);
  text("Bond_Field_Mean", "Variable", "Bond_Damage");
  given["Coverage"].set("Saturation Concentration", 20.0);
  given["Mass_Loss"].set("Molar Mass", 0.055);
  given["Crack_Area"].set("Horizon", 1.5);
  for (const auto& [key, value] :
       std::map<const char*, double>{{"Thickness", 1.0}, {"Inner Radius", 0.5}, {"Outer Radius", 4.0}})
    for (const char* plugin : {"J_Integral", "Stress_Intensity"}) given[plugin].set(key, value);
  for (const char* key : {"Ahead", "Behind", "Above", "Thickness"}) given["Nonlocal_J_Integral"].set(key, 2.0);
  given["Flow_Force"].set("Inner Radius", 0.5);
  given["Flow_Force"].set("Outer Radius", 4.0);
  given["Mass_Flow"].set("Width", 2.0);
  std::vector<ComputeSample> samples;
  for (const std::string& name : pd::ComputeRegistry::self().names())
    if (name.find("Test") != 0) samples.push_back({name, given[name]});
  return samples;
}

}  // namespace pdtest
