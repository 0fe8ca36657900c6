#include "fields.hpp"

#include <algorithm>
#include <map>
#include <stdexcept>

#include "diffusivity_field.hpp"
#include "field_names.hpp"

namespace pd {

namespace Field = PeridigmNS::PeridigmField;

namespace {

/// What fields::find() knows of a label.
struct KnownField {
  FieldDescription field;
  bool isOptional;
};

std::map<std::string, KnownField>& knownFields() {
  static std::map<std::string, KnownField> known;
  return known;
}

bool leavesUnitToDeck(const FieldDescription& field) { return field.unit.rfind(fields::unitOfDeck, 0) == 0; }

int idOf(const FieldDescription& field, bool isOptional) {
  const int id = PeridigmNS::FieldManager::self().getFieldId(field.relation, field.length, field.temporal, field.label);
  KnownField& known = knownFields().emplace(field.label, KnownField{field, true}).first->second;
  if (!leavesUnitToDeck(field)) known.field = field;
  known.isOptional = known.isOptional && isOptional;
  return id;
}

}  // namespace

FieldDescription& FieldDescription::growing() {
  onlyGrows = true;
  return *this;
}

FieldDescription& FieldDescription::state() {
  isState = true;
  return *this;
}

FieldDescription& FieldDescription::reflected(Reflection rule) {
  reflection = rule;
  return *this;
}

FieldDescription& FieldDescription::in(const std::string& itsUnit) {
  unit = itsUnit;
  return *this;
}

int FieldDescription::id() const { return idOf(*this, false); }

const FieldUse* FieldTable::find(int id) const {
  const auto found = std::find_if(uses_.begin(), uses_.end(), [id](const FieldUse& use) { return use.id == id; });
  return found == uses_.end() ? nullptr : &*found;
}

std::vector<int> FieldTable::ids() const {
  std::vector<int> result;
  for (const FieldUse& use : uses_)
    if (!use.isOptional && use.id >= 0) result.push_back(use.id);
  return result;
}

std::vector<int> FieldTable::ids(Ghosts when) const {
  std::vector<int> result;
  for (const FieldUse& use : uses_)
    if (use.ghosts == when) result.push_back(use.id);
  return result;
}

std::vector<int> FieldTable::sums() const {
  std::vector<int> result;
  for (const FieldUse& use : uses_)
    if (use.access == FieldAccess::Adds && !use.isOptional) result.push_back(use.id);
  return result;
}

int FieldTable::rateOf(const std::string& label) const {
  for (const FieldUse& use : uses_)
    if (use.access == FieldAccess::Adds && use.field.rateOf == label) return use.id;
  return -1;
}

FieldHandle FieldTable::reads(const FieldDescription& field, Ghosts ghosts) {
  return use(field, FieldAccess::Reads, ghosts, false);
}
FieldHandle FieldTable::readsIfThere(const FieldDescription& field) {
  return use(field, FieldAccess::Reads, Ghosts::None, true);
}
FieldHandle FieldTable::writes(const FieldDescription& field, Ghosts ghosts) {
  return use(field, FieldAccess::Writes, ghosts, false);
}
FieldHandle FieldTable::writesIfThere(const FieldDescription& field) {
  return use(field, FieldAccess::Writes, Ghosts::None, true);
}
/// Solvers find rates by their names.
FieldHandle FieldTable::adds(const FieldDescription& field) {
  if (!field.rateOf.empty() && field.label != fluxDivergenceField(field.rateOf))
    throw std::logic_error("the rate of \"" + field.rateOf + "\" must be called \"" +
                           fluxDivergenceField(field.rateOf) + "\", not \"" + field.label + "\"");
  return use(field, FieldAccess::Adds, Ghosts::None, false);
}
FieldHandle FieldTable::addsIfThere(const FieldDescription& field) {
  return use(field, FieldAccess::Adds, Ghosts::None, true);
}
FieldHandle FieldTable::worsens(const FieldDescription& field) {
  return use(field, FieldAccess::Worsens, Ghosts::None, false);
}
FieldHandle FieldTable::worsensIfThere(const FieldDescription& field) {
  return use(field, FieldAccess::Worsens, Ghosts::None, true);
}

FieldHandle FieldTable::use(const FieldDescription& field, FieldAccess access, Ghosts ghosts, bool isOptional) {
  const int id = field.isNamed() ? idOf(field, isOptional) : -1;
  const auto known =
      std::find_if(uses_.begin(), uses_.end(), [&](const FieldUse& other) { return other.field.label == field.label; });
  if (known == uses_.end()) {
    uses_.push_back({field, access, ghosts, isOptional, id});
  } else {  // parts of a plug-in may share a field: the stronger claim holds
    if (known->access == FieldAccess::Reads) known->access = access;
    if (known->ghosts == Ghosts::None) known->ghosts = ghosts;
    known->isOptional = known->isOptional && isOptional;
    known->field.onlyGrows = known->field.onlyGrows && field.onlyGrows;
    known->field.isState = known->field.isState || field.isState;
  }
  return {id, field.temporal};
}

void FieldTable::include(const FieldTable& part) {
  for (const FieldUse& other : part.uses_) use(other.field, other.access, other.ghosts, other.isOptional);
}

FieldTable assumedFields(const std::vector<int>& ids) {
  struct Assumed : FieldTable {
    void assume(int id) {
      const PeridigmNS::FieldSpec spec = PeridigmNS::FieldManager::self().getFieldSpec(id);
      if (spec.getLabel() == fields::forceDensity().label) {
        adds(fields::forceDensity());
      } else if (spec.getLabel() == fluxDivergenceField("Temperature")) {
        adds(fields::fluxDivergence("Temperature"));
      } else {
        FieldDescription field;
        field.label = spec.getLabel();
        field.relation = spec.getRelation();
        field.length = spec.getLength();
        field.temporal = spec.getTemporal();
        reads(field);
      }
    }
  };
  Assumed table;
  for (const int id : ids) table.assume(id);
  return table;
}

std::vector<std::string> contestedFields(const std::vector<NamedTable>& plugins) {
  std::vector<std::string> messages;
  for (std::size_t a = 0; a < plugins.size(); ++a)
    for (const FieldUse& own : plugins[a].table.uses())
      for (std::size_t b = 0; b < plugins.size(); ++b) {
        const FieldUse* other = b == a ? nullptr : plugins[b].table.find(own.id);
        if (own.access != FieldAccess::Writes || other == nullptr || other->access == FieldAccess::Reads) continue;
        if (other->access == FieldAccess::Writes && (b < a || isDiffusivity(own.field)))
          continue;  // said already; adds up
        messages.push_back("\"" + plugins[a].name + "\" and \"" + plugins[b].name + "\" both write the field \"" +
                           own.field.label + "\", which can have one writer in a block");
      }
  return messages;
}

namespace fields {

namespace {

FieldDescription described(const std::string& label, Field::Relation relation, Field::Length length,
                           Field::Temporal temporal, const std::string& unit, const std::string& meaning) {
  FieldDescription field;
  field.label = label;
  field.relation = relation;
  field.length = length;
  field.temporal = temporal;
  field.unit = unit;
  field.meaning = meaning;
  if (length == Field::VECTOR) field.reflection = Reflection::Vector;
  return field;
}

}  // namespace

const FieldDescription* find(const std::string& label) {
  const auto known = knownFields().find(label);
  return known == knownFields().end() ? nullptr : &known->second.field;
}
FieldDescription describe(const std::string& label) {
  if (const FieldDescription* known = find(label)) return *known;
  auto& manager = PeridigmNS::FieldManager::self();
  const PeridigmNS::FieldSpec spec = manager.getFieldSpec(manager.getFieldId(label));
  return described(label, spec.getRelation(), spec.getLength(), spec.getTemporal(), unitOfDeck, "A field of the host.");
}
bool isOptionalEverywhere(const std::string& label) {
  const auto known = knownFields().find(label);
  return known != knownFields().end() && known->second.isOptional;
}
std::string unitOf(const std::string& label) {
  const FieldDescription* field = find(label);
  return field == nullptr || leavesUnitToDeck(*field) ? "" : field->unit;
}

FieldDescription namedBy(const std::string& key, const std::string& unit, const std::string& meaning) {
  return described("<" + key + ">", Field::UNDEFINED_RELATION, Field::UNDEFINED_LENGTH, Field::UNDEFINED_TEMPORAL, unit,
                   meaning);
}
FieldDescription globalScalar(const std::string& label, const std::string& unit, const std::string& meaning) {
  return described(label, Field::GLOBAL, Field::SCALAR, Field::CONSTANT, unit, meaning);
}
FieldDescription globalVector(const std::string& label, const std::string& unit, const std::string& meaning) {
  return described(label, Field::GLOBAL, Field::VECTOR, Field::CONSTANT, unit, meaning);
}
FieldDescription elementScalar(const std::string& label, const std::string& unit, const std::string& meaning) {
  return described(label, Field::ELEMENT, Field::SCALAR, Field::CONSTANT, unit, meaning);
}
FieldDescription elementTensor(const std::string& label, const std::string& unit, const std::string& meaning) {
  return described(label, Field::ELEMENT, Field::FULL_TENSOR, Field::CONSTANT, unit, meaning);
}
FieldDescription pointScalar(const std::string& label, const std::string& unit, const std::string& meaning) {
  return described(label, Field::NODE, Field::SCALAR, Field::CONSTANT, unit, meaning);
}
FieldDescription pointVector(const std::string& label, const std::string& unit, const std::string& meaning) {
  return described(label, Field::NODE, Field::VECTOR, Field::CONSTANT, unit, meaning);
}
FieldDescription steppedScalar(const std::string& label, const std::string& unit, const std::string& meaning) {
  return described(label, Field::NODE, Field::SCALAR, Field::TWO_STEP, unit, meaning);
}
FieldDescription steppedVector(const std::string& label, const std::string& unit, const std::string& meaning) {
  return described(label, Field::NODE, Field::VECTOR, Field::TWO_STEP, unit, meaning);
}
FieldDescription bondScalar(const std::string& label, const std::string& unit, const std::string& meaning) {
  return described(label, Field::BOND, Field::SCALAR, Field::TWO_STEP, unit, meaning);
}

FieldDescription modelCoordinates() {
  return pointVector("Model_Coordinates", "m", "Reference position.").reflected(Reflection::Position);
}
FieldDescription coordinates() {
  return steppedVector("Coordinates", "m", "Current position.").reflected(Reflection::Position);
}
FieldDescription displacement() { return steppedVector("Displacement", "m", "Displacement."); }
FieldDescription velocity() { return steppedVector("Velocity", "m/s", "Velocity."); }
FieldDescription velocityRate() {
  FieldDescription field = steppedVector("Velocity_Flux_Divergence", "m/s2", "Rate of the velocity at a fixed place.");
  field.rateOf = "Velocity";
  return field;
}
FieldDescription pressure() { return pointScalar("Pressure", "Pa", "Pressure of the fluid.").state(); }
FieldDescription volume() { return elementScalar("Volume", "m3", "Volume of the point's cell."); }
FieldDescription blockId() { return elementScalar("Block_Id", "1", "Number of the point's block."); }
FieldDescription elementId() { return elementScalar("Element_Id", "1", "Number of the point in the mesh, from 1."); }
FieldDescription horizon() { return elementScalar("Horizon", "m", "Radius of the point's neighbourhood."); }
FieldDescription forceDensity() { return steppedVector("Force_Density", "N/m3", "Internal force per volume."); }
FieldDescription externalForceDensity() {
  return steppedVector("External_Force_Density", "N/m3", "Body forces and tractions per volume.");
}
FieldDescription damage() {
  return described("Damage", Field::ELEMENT, Field::SCALAR, Field::TWO_STEP, "1",
                   "Share of the point's bonds that are broken; of dissolving metal, 1 where it is liquid.")
      .growing();
}
FieldDescription bondDamage() {
  return bondScalar("Bond_Damage", "1", "1 where the bond is broken, 0 where it is whole.").growing();
}
FieldDescription interactionShare() {
  return described(
      "Interaction_Share", Field::BOND, Field::SCALAR, Field::CONSTANT, "1",
      "Share of the connections between the bond's two cells that no crack and no void of the deck meets.");
}
FieldDescription cellVolume() {
  return elementScalar("Cell_Volume", "m3", "Volume of the point's cell, voids of the deck included.");
}
FieldDescription countedBonds() {
  return pointScalar("Counted_Bonds", "1",
                     "Bonds of which Damage is the lost share: the sum of Interaction_Share, and of what cracks of the "
                     "deck took where they count in Damage.");
}
FieldDescription noFailure() {
  return pointScalar("No_Failure", "1", "Bonds of points where it is not 0 never break.");
}
FieldDescription storedEnergyDensity() {
  return elementScalar("Stored_Elastic_Energy_Density", "J/m3", "Strain energy per volume.");
}
FieldDescription weightedVolume() {
  return elementScalar("Weighted_Volume", "m5", "Influence x length^2 x volume, summed over the neighbours.");
}
FieldDescription dilatation() {
  return described("Dilatation", Field::ELEMENT, Field::SCALAR, Field::TWO_STEP, "1", "Change of volume over volume.");
}
FieldDescription solidConcentration() {
  return pointScalar("Solid_Concentration", "mol/m3",
                     "Metal in the solid that the point was at first; 0 of electrolyte.");
}
FieldDescription saturationConcentration() {
  return pointScalar("Saturation_Concentration", "mol/m3", "Most metal ions that the electrolyte holds.");
}
FieldDescription interfaceAreaDensity() {
  return pointScalar("Interface_Area_Density", "1/m", "Surface of metal around a liquid point per volume.");
}
FieldDescription saltCoverage() {
  return pointScalar("Salt_Coverage", "1", "Share of the surface near a liquid point that salt covers.").state();
}
FieldDescription filmCoverage() {
  return pointScalar("Film_Coverage", "1",
                     "Share of the metal's surface near the point that a film keeps from "
                     "dissolving.");
}
FieldDescription dissolutionDemand() {
  return pointScalar("Dissolution_Demand", "mol/(m2 s)",
                     "Flux from the surface that a solver asks for besides the current's.");
}
FieldDescription dissolutionRate() {
  return pointScalar("Dissolution_Rate", "mol/(m3 s)", "What a surface without salt gives.");
}
FieldDescription dissolutionRateSlope() {
  return pointScalar("Dissolution_Rate_Slope", "1/s", "Derivative of Dissolution_Rate by the concentration.");
}
FieldDescription currentDensity() {
  return pointScalar("Current_Density", "A/m2", "Of the surface near a liquid point.");
}
FieldDescription diffusingScalar(const std::string& label) {
  if (label == "Temperature") return steppedScalar(label, "K", "Temperature.");
  return steppedScalar(label, unitOfDeck, "Concentration that diffuses, in the unit that the deck gives it.");
}
FieldDescription fluxDivergence(const std::string& label) {
  FieldDescription field =
      steppedScalar(fluxDivergenceField(label), diffusingScalar(label).unit + "/s", "Rate of " + label + ".");
  field.rateOf = label;
  return field;
}
FieldDescription ionConcentration(const std::string& label) {
  return steppedScalar(label, "mol/m3", "Metal, solid or as ions.");
}
FieldDescription ionFluxDivergence(const std::string& label) { return fluxDivergence(label).in("mol/(m3 s)"); }

}  // namespace fields

}  // namespace pd
