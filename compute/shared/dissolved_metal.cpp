#include "dissolved_metal.hpp"

#include <stdexcept>

namespace pd {

void requireDissolvingMetal(const Blocks& blocks, const FieldTable& fields) {
  for (const FieldUse& use : fields.uses())
    for (PeridigmNS::Block& block : *blocks)
      if (use.isOptional && !FieldHandle(use.id, use.field.temporal).isIn(*block.getDataManager()))
        throw std::invalid_argument(
            "this compute is about dissolving metal, and no material of this run keeps the field \"" + use.field.label +
            "\": give a block the material \"Corrosion Dissolution\", or leave it out");
}

void DissolvedMetal::declareParameters(ParameterDeclarations& declarations) {
  declarations.text("Concentration Field", "Label of the metal ions' concentration, as of the material.")
      .defaultTo("Concentration");
}

void DissolvedMetal::initialize(const Blocks& blocks) const { requireDissolvingMetal(blocks, fields_); }

DissolvedMetal::View DissolvedMetal::of(PeridigmNS::Block& block) const {
  View result;
  result.damage_ = view(block, fields_.damage);
  result.concentration_ = view(block, fields_.concentration);
  result.solid_ = view(block, fields_.solid);
  result.saturation_ = view(block, fields_.saturation);
  result.volume_ = view(block, fields_.volume);
  result.countsPartly_ = countsPartly_;
  return result;
}

}  // namespace pd
