// Force: force of the bonds on each point, N.
#include "compute_support.hpp"
#include "plugins.hpp"

namespace pd {

namespace PeridigmField = PeridigmNS::PeridigmField;

class Force : public PeridigmNS::Compute {
 public:
  static void declareParameters(ParameterDeclarations& declarations) { declareCommonParameters(declarations, "Force"); }
  Force(ComputeParameters params, ComputeComm comm, ComputeParameters globalData)
      : Compute(params, comm, globalData),
        volumeField_(volumeField()),
        forceDensityField_(forceDensityField()),
        outputField_(pointVectorField(completeParameters<Force>(params, "Force").get<std::string>("Output Label"))) {}

  std::vector<int> FieldIds() const override { return {volumeField_, forceDensityField_, outputField_}; }

  int compute(Blocks blocks) const override {
    for (PeridigmNS::Block& block : *blocks) {
      const double* volume = view(block, volumeField_, PeridigmField::STEP_NONE);
      const double* density = view(block, forceDensityField_, PeridigmField::STEP_NP1);
      double* force = view(block, outputField_, PeridigmField::STEP_NP1);
      const auto neighborhood = block.getNeighborhoodData();
      for (int i = 0; i < neighborhood->NumOwnedPoints(); ++i) {
        const int id = neighborhood->OwnedIDs()[i];
        for (int k = 0; k < 3; ++k) force[3 * id + k] = volume[id] * density[3 * id + k];
      }
    }
    return 0;
  }

 private:
  int volumeField_, forceDensityField_, outputField_;
};

}  // namespace pd

using pd::Force;
PD_REGISTER_COMPUTE(Force, "Force", "Force of the bonds on each point.")
