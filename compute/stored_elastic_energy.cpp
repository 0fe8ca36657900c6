// Stored_Elastic_Energy: elastic energy of each point, J.
#include "plugins.hpp"
#include "stored_energy.hpp"

namespace pd {

class StoredElasticEnergy : public PeridigmNS::Compute {
 public:
  static void declareParameters(ParameterDeclarations& declarations) {
    declareCommonParameters(declarations, "Stored_Elastic_Energy");
  }
  StoredElasticEnergy(ComputeParameters params, ComputeComm comm, ComputeParameters globalData)
      : Compute(params, comm, globalData),
        densityField_(storedEnergyDensityField()),
        volumeField_(volumeField()),
        outputField_(elementScalarField(completeParameters<StoredElasticEnergy>(params, "Stored_Elastic_Energy")
                                            .get<std::string>("Output Label"))) {}

  std::vector<int> FieldIds() const override { return {densityField_, volumeField_, outputField_}; }

  int compute(Blocks blocks) const override {
    constexpr auto none = PeridigmNS::PeridigmField::STEP_NONE;
    fillStoredEnergyDensity(blocks);
    for (PeridigmNS::Block& block : *blocks) {
      const double* density = view(block, densityField_, none);
      const double* volume = view(block, volumeField_, none);
      double* energy = view(block, outputField_, none);
      const auto neighborhood = block.getNeighborhoodData();
      for (int i = 0; i < neighborhood->NumOwnedPoints(); ++i) {
        const int id = neighborhood->OwnedIDs()[i];
        energy[id] = density[id] * volume[id];
      }
    }
    return 0;
  }

 private:
  int densityField_, volumeField_, outputField_;
};

}  // namespace pd

using pd::StoredElasticEnergy;
PD_REGISTER_COMPUTE(StoredElasticEnergy, "Stored_Elastic_Energy", "Elastic energy of each point.")
