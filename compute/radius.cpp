// Radius: of the ball with the volume of each point, m.
#include <cmath>

#include "compute_support.hpp"
#include "plugins.hpp"

namespace pd {

class Radius : public PeridigmNS::Compute {
 public:
  static void declareParameters(ParameterDeclarations& declarations) {
    declareCommonParameters(declarations, "Radius");
  }
  Radius(ComputeParameters params, ComputeComm comm, ComputeParameters globalData)
      : Compute(params, comm, globalData),
        volumeField_(volumeField()),
        outputField_(
            elementScalarField(completeParameters<Radius>(params, "Radius").get<std::string>("Output Label"))) {}

  std::vector<int> FieldIds() const override { return {volumeField_, outputField_}; }

  // Volumes do not change during a run, but a restart overwrites fields: so in compute, not in initialize.
  int compute(Blocks blocks) const override {
    constexpr auto none = PeridigmNS::PeridigmField::STEP_NONE;
    const double pi = std::acos(-1.0);
    for (PeridigmNS::Block& block : *blocks) {
      const double* volume = view(block, volumeField_, none);
      double* radius = view(block, outputField_, none);
      const auto neighborhood = block.getNeighborhoodData();
      for (int i = 0; i < neighborhood->NumOwnedPoints(); ++i) {
        const int id = neighborhood->OwnedIDs()[i];
        radius[id] = std::cbrt(0.75 / pi * volume[id]);
      }
    }
    return 0;
  }

 private:
  int volumeField_, outputField_;
};

}  // namespace pd

using pd::Radius;
PD_REGISTER_COMPUTE(Radius, "Radius", "Radius of the ball with the volume of each point.")
