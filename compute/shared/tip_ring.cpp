#include "tip_ring.hpp"

namespace pd {

void TipRing::declareParameters(ParameterDeclarations& declarations, const char* compute) {
  TipPlace::declareParameters(declarations, compute);
  HookesLaw::declareParameters(declarations);
  declarations.real("Inner Radius", "m", "Inner radius of the ring; one horizon at least.").positive().required();
  declarations.real("Outer Radius", "m", "Outer radius of the ring.").positive().required();
}

TipRing::TipRing(const Teuchos::ParameterList& parameters, std::string compute)
    : TipPlace(parameters, std::move(compute)),
      innerRadius_(parameters.get<double>("Inner Radius")),
      outerRadius_(parameters.get<double>("Outer Radius")),
      isPlaneStress_(parameters.get<bool>("Plane Stress")) {
  if (!(outerRadius_ > innerRadius_))
    throw std::invalid_argument(compute_ + ": \"Outer Radius\" must be larger than \"Inner Radius\"");
}

}  // namespace pd
