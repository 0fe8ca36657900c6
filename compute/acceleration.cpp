// Acceleration: of each point by the forces of its bonds and by loads, m/s2.
#include "compute_support.hpp"
#include "plugins.hpp"

namespace pd {

namespace PeridigmField = PeridigmNS::PeridigmField;

class Acceleration : public PeridigmNS::Compute {
 public:
  static void declareParameters(ParameterDeclarations& declarations) {
    declareCommonParameters(declarations, "Acceleration");
  }
  Acceleration(ComputeParameters params, ComputeComm comm, ComputeParameters globalData)
      : Compute(params, comm, globalData),
        forceDensityField_(forceDensityField()),
        loadField_(externalForceDensityField()),
        outputField_(pointVectorField(
            completeParameters<Acceleration>(params, "Acceleration").get<std::string>("Output Label"))) {}

  std::vector<int> FieldIds() const override { return {forceDensityField_, loadField_, outputField_}; }

  int compute(Blocks blocks) const override {
    for (PeridigmNS::Block& block : *blocks) {
      const double* force = view(block, forceDensityField_, PeridigmField::STEP_NP1);
      const double* load = view(block, loadField_, PeridigmField::STEP_NP1);
      double* acceleration = view(block, outputField_, PeridigmField::STEP_NP1);
      const double density = block.getMaterialModel()->Density();
      const auto neighborhood = block.getNeighborhoodData();
      for (int i = 0; i < neighborhood->NumOwnedPoints(); ++i) {
        const int id = neighborhood->OwnedIDs()[i];
        for (int k = 3 * id; k < 3 * id + 3; ++k) acceleration[k] = (force[k] + load[k]) / density;
      }
    }
    return 0;
  }

 private:
  int forceDensityField_, loadField_, outputField_;
};

}  // namespace pd

using pd::Acceleration;
PD_REGISTER_COMPUTE(Acceleration, "Acceleration", "Acceleration of each point by the forces of its bonds and by loads.")
