#include "flow_blocks.hpp"

#include <algorithm>

namespace pd {

FlowBlocks findFlowBlocks(Model& model, const std::string& solver) {
  FlowBlocks found;
  std::string first;
  for (PeridigmNS::Block& block : *model.blocks()) {
    const auto* material = dynamic_cast<const FlowMaterial*>(block.getMaterialModel().get());
    if (material == nullptr || material->flowLaw() == nullptr) continue;
    const FlowLaw& law = *material->flowLaw();
    if (found.law == nullptr) {
      found.law = &law;
      first = block.getName();
    } else if (law.density != found.law->density || law.viscosity != found.law->viscosity ||
               law.viscousKernel != found.law->viscousKernel || law.gradientHorizon != found.law->gradientHorizon ||
               law.fluxHorizon != found.law->fluxHorizon || law.reflectsPoints != found.law->reflectsPoints ||
               law.family.horizon != found.law->family.horizon) {
      throw RunError(solver + ": the fluids of the blocks \"" + first + "\" and \"" + block.getName() +
                     "\" differ; give both one material and one Horizon");
    }
    found.numbers.push_back(block.getID());
  }
  if (found.law == nullptr) throw RunError(solver + ": no block has a material for flows, as Navier Stokes is one");
  if (!model.discretization().symmetry.isAlongAxes())
    throw RunError(solver + ": planes of symmetry must be perpendicular to x, y or z");
  if (model.discretization().dimension < 2) throw RunError(solver + ": a flow needs two or three dimensions");
  return found;
}

void markFluid(Model& model, const FlowGeometry& geometry) {
  double* fluid = model.field("Fluid");
  std::fill_n(fluid, model.nPoints(), 0.0);
  for (const int point : geometry.fluid()) fluid[point] = 1.0;
  model.importGhosts("Fluid");
}

}  // namespace pd
