#include "dissolved_metal.hpp"

#include <stdexcept>

#include "Peridigm_Field.hpp"

namespace pd {

namespace PeridigmField = PeridigmNS::PeridigmField;
using PeridigmNS::FieldManager;

int corrosionField(const std::string& label) {
  FieldManager& fields = FieldManager::self();
  return fields.hasField(label) ? fields.getFieldId(label) : -1;
}

void requireCorrosionFields(const Blocks& blocks, const std::vector<std::string>& labels) {
  for (const std::string& label : labels) {
    const int id = corrosionField(label);
    for (PeridigmNS::Block& block : *blocks)
      if (id < 0 || !(block.hasData(id, PeridigmField::STEP_NONE) || block.hasData(id, PeridigmField::STEP_NP1)))
        throw std::invalid_argument(
            "this compute is about dissolving metal, and no material of this run keeps the field \"" + label +
            "\": give a block the material \"Corrosion Dissolution\", or leave it out");
  }
}

DissolvedMetal::DissolvedMetal(bool countsPartly)
    : damage_("Damage"), concentration_("Concentration"), volumeField_(volumeField()), countsPartly_(countsPartly) {
  solidField_ = corrosionField("Solid_Concentration");
  saturationField_ = corrosionField("Saturation_Concentration");
}

std::vector<int> DissolvedMetal::fieldIds() const {
  std::vector<int> ids = {volumeField_};
  for (const FieldVariable* field : {&damage_, &concentration_})
    for (const int id : field->fieldIds()) ids.push_back(id);
  for (const int id : {solidField_, saturationField_})
    if (id >= 0) ids.push_back(id);
  return ids;
}

void DissolvedMetal::initialize(const Blocks& blocks) {
  requireCorrosionFields(blocks, {"Solid_Concentration", "Saturation_Concentration", "Concentration", "Damage"});
  damage_.initialize(blocks);
  concentration_.initialize(blocks);
}

DissolvedMetal::View DissolvedMetal::of(PeridigmNS::Block& block) const {
  View result;
  result.damage_ = damage_.values(block);
  result.concentration_ = concentration_.values(block);
  result.solid_ = view(block, solidField_, PeridigmField::STEP_NONE);
  result.saturation_ = view(block, saturationField_, PeridigmField::STEP_NONE);
  result.volume_ = view(block, volumeField_, PeridigmField::STEP_NONE);
  result.countsPartly_ = countsPartly_;
  return result;
}

}  // namespace pd
