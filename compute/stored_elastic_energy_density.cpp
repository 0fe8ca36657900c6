// Stored_Elastic_Energy_Density: elastic energy of each point per volume, J/m3, as its material defines it.
#include "plugins.hpp"
#include "stored_energy.hpp"

namespace pd {

class StoredElasticEnergyDensity : public PeridigmNS::Compute {
 public:
  static void declareParameters(ParameterDeclarations& declarations) {
    declarations.text("Compute Class", "Name of the compute.");
  }
  StoredElasticEnergyDensity(ComputeParameters params, ComputeComm comm, ComputeParameters globalData)
      : Compute(params, comm, globalData), densityField_(storedEnergyDensityField()) {
    completeParameters<StoredElasticEnergyDensity>(params, "Stored_Elastic_Energy_Density");
  }
  std::vector<int> FieldIds() const override { return {densityField_}; }
  int compute(Blocks blocks) const override {
    fillStoredEnergyDensity(blocks);
    return 0;
  }

 private:
  int densityField_;
};

}  // namespace pd

using pd::StoredElasticEnergyDensity;
PD_REGISTER_COMPUTE(StoredElasticEnergyDensity, "Stored_Elastic_Energy_Density",
                    "Elastic energy of each point per volume.")
