#include "scalar_unknown.hpp"

#include <algorithm>
#include <cmath>

#include "Peridigm_Field.hpp"
#include "field_names.hpp"

namespace pd {

double normOverRanks(const Communicator& comm, const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value * value;
  return std::sqrt(comm.sum(sum));
}

void requireFluxDivergence(Model& model, const std::string& field, const std::string& solver) {
  const int flux = PeridigmNS::FieldManager::self().getFieldId(fluxDivergenceField(field));
  const auto& blocks = *model.blocks();
  const bool hasFlux = std::any_of(blocks.begin(), blocks.end(), [&](PeridigmNS::Block block) {
    const auto ids = block.getMaterialModel()->FieldIds();
    return std::find(ids.begin(), ids.end(), flux) != ids.end();
  });
  if (!hasFlux)
    throw RunError(solver + ": no material of this run gives a flux divergence of \"" + field +
                   "\"; give a block a material that diffuses it, or name another Field");
}

}  // namespace pd
