// Kinetic_Energy: kinetic energy of each point, J.
#include "compute_support.hpp"
#include "plugins.hpp"

namespace pd {

class KineticEnergy : public PeridigmNS::Compute {
 public:
  static void declareParameters(ParameterDeclarations& declarations) {
    declareCommonParameters(declarations, "Kinetic_Energy");
  }
  KineticEnergy(ComputeParameters params, ComputeComm comm, ComputeParameters globalData)
      : Compute(params, comm, globalData),
        volumeField_(volumeField()),
        velocityField_(velocityField()),
        outputField_(elementScalarField(
            completeParameters<KineticEnergy>(params, "Kinetic_Energy").get<std::string>("Output Label"))) {}

  std::vector<int> FieldIds() const override { return {volumeField_, velocityField_, outputField_}; }

  int compute(Blocks blocks) const override {
    namespace PeridigmField = PeridigmNS::PeridigmField;
    for (PeridigmNS::Block& block : *blocks) {
      const double* volume = view(block, volumeField_, PeridigmField::STEP_NONE);
      const double* velocity = view(block, velocityField_, PeridigmField::STEP_NP1);
      double* energy = view(block, outputField_, PeridigmField::STEP_NONE);
      const double density = block.getMaterialModel()->Density();
      const auto neighborhood = block.getNeighborhoodData();
      for (int i = 0; i < neighborhood->NumOwnedPoints(); ++i) {
        const int id = neighborhood->OwnedIDs()[i];
        const double* v = velocity + 3 * id;
        energy[id] = 0.5 * density * volume[id] * (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
      }
    }
    return 0;
  }

 private:
  int volumeField_, velocityField_, outputField_;
};

}  // namespace pd

using pd::KineticEnergy;
PD_REGISTER_COMPUTE(KineticEnergy, "Kinetic_Energy", "Kinetic energy of each point.")
