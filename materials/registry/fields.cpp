#include "fields.hpp"

#include <algorithm>

#include "field_names.hpp"

namespace pd {

namespace Field = PeridigmNS::PeridigmField;

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

int FieldDescription::id() const {
  return PeridigmNS::FieldManager::self().getFieldId(relation, length, temporal, label);
}

const FieldUse* FieldTable::find(int id) const {
  const auto found = std::find_if(uses_.begin(), uses_.end(), [id](const FieldUse& use) { return use.id == id; });
  return found == uses_.end() ? nullptr : &*found;
}

std::vector<int> FieldTable::ids() const {
  std::vector<int> result;
  for (const FieldUse& use : uses_)
    if (!use.isOptional) result.push_back(use.id);
  return result;
}

std::vector<int> FieldTable::ids(Ghosts when) const {
  std::vector<int> result;
  for (const FieldUse& use : uses_)
    if (use.ghosts == when) result.push_back(use.id);
  return result;
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
FieldHandle FieldTable::adds(const FieldDescription& field) {
  return use(field, FieldAccess::Adds, Ghosts::None, false);
}
FieldHandle FieldTable::worsens(const FieldDescription& field) {
  return use(field, FieldAccess::Worsens, Ghosts::None, false);
}

FieldHandle FieldTable::use(const FieldDescription& field, FieldAccess access, Ghosts ghosts, bool isOptional) {
  const int id = field.id();
  const auto known = std::find_if(uses_.begin(), uses_.end(), [id](const FieldUse& other) { return other.id == id; });
  if (known == uses_.end()) {
    uses_.push_back({field, access, ghosts, isOptional, id});
  } else {  // parts of a plug-in may share a field: the stronger claim holds
    if (known->access == FieldAccess::Reads) known->access = access;
    if (known->ghosts == Ghosts::None) known->ghosts = ghosts;
    known->isOptional = known->isOptional && isOptional;
  }
  return {id, field.temporal};
}

void FieldTable::include(const FieldTable& part) {
  for (const FieldUse& other : part.uses_) use(other.field, other.access, other.ghosts, other.isOptional);
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
FieldDescription volume() {
  return described("Volume", Field::ELEMENT, Field::SCALAR, Field::CONSTANT, "m3", "Volume of the point's cell.");
}
FieldDescription blockId() {
  return described("Block_Id", Field::ELEMENT, Field::SCALAR, Field::CONSTANT, "1", "Number of the point's block.");
}
FieldDescription forceDensity() { return steppedVector("Force_Density", "N/m3", "Internal force per volume."); }
FieldDescription damage() {
  return described("Damage", Field::ELEMENT, Field::SCALAR, Field::TWO_STEP, "1",
                   "Share of the point's bonds that are broken; of dissolving metal, 1 where it is liquid.")
      .growing();
}
FieldDescription bondDamage() {
  return bondScalar("Bond_Damage", "1", "1 where the bond is broken, 0 where it is whole.").growing();
}
FieldDescription noFailure() {
  return pointScalar("No_Failure", "1", "Bonds of points where it is not 0 never break.");
}
FieldDescription storedEnergyDensity() {
  return described("Stored_Elastic_Energy_Density", Field::ELEMENT, Field::SCALAR, Field::CONSTANT, "J/m3",
                   "Strain energy per volume.");
}
FieldDescription weightedVolume() {
  return described("Weighted_Volume", Field::ELEMENT, Field::SCALAR, Field::CONSTANT, "m5",
                   "Influence x length^2 x volume, summed over the neighbours.");
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
FieldDescription diffusingScalar(const std::string& label) {
  if (label == "Temperature") return steppedScalar(label, "K", "Temperature.");
  return steppedScalar(label, "mol/m3", "Concentration that diffuses, in the unit that the deck gives it.");
}
FieldDescription fluxDivergence(const std::string& label) {
  FieldDescription field =
      steppedScalar(fluxDivergenceField(label), diffusingScalar(label).unit + "/s", "Rate of " + label + ".");
  field.rateOf = label;
  return field;
}

}  // namespace fields

}  // namespace pd
