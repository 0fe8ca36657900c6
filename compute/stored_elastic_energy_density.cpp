// Stored_Elastic_Energy_Density: elastic energy of each point per volume, J/m3, as its material defines it.
#include "plugins.hpp"
#include "stored_energy.hpp"

namespace pd {

class StoredElasticEnergyDensity : public TabledCompute {
 public:
  struct Fields : FieldTable {
    FieldHandle density = writes(pd::fields::storedEnergyDensity());  ///< by the materials
  };
  static void declareParameters(ParameterDeclarations& declarations) {
    declarations.text("Compute Class", "Name of the compute.");
  }
  StoredElasticEnergyDensity(ComputeParameters params, ComputeComm comm, ComputeParameters globalData)
      : TabledCompute(completeParameters<StoredElasticEnergyDensity>(params, "Stored_Elastic_Energy_Density"), params,
                      comm, globalData) {}

  const Fields& fields() const override { return fields_; }
  int compute(Blocks blocks) const override {
    fillStoredEnergyDensity(blocks);
    return 0;
  }

 private:
  Fields fields_;
};

}  // namespace pd

using pd::StoredElasticEnergyDensity;
PD_REGISTER_COMPUTE(StoredElasticEnergyDensity, "Stored_Elastic_Energy_Density",
                    "Elastic energy of each point per volume.")
