// Stored_Elastic_Energy: elastic energy of each point, J.
#include "plugins.hpp"
#include "stored_energy.hpp"

namespace pd {

class StoredElasticEnergy : public TabledCompute {
 public:
  struct Fields : FieldTable {
    FieldHandle density = writes(pd::fields::storedEnergyDensity());  ///< by the materials
    FieldHandle volume = reads(pd::fields::volume());
    FieldHandle energy;
    explicit Fields(const Teuchos::ParameterList& parameters)
        : energy(writes(outputField(parameters, pd::fields::elementScalar, "J", "Elastic energy of the point."))) {}
  };
  static void declareParameters(ParameterDeclarations& declarations) {
    declareCommonParameters(declarations, "Stored_Elastic_Energy");
  }
  StoredElasticEnergy(ComputeParameters params, ComputeComm comm, ComputeParameters globalData)
      : TabledCompute(completeParameters<StoredElasticEnergy>(params, "Stored_Elastic_Energy"), params, comm,
                      globalData),
        fields_(parameters_) {}

  const Fields& fields() const override { return fields_; }
  int compute(Blocks blocks) const override {
    fillStoredEnergyDensity(blocks);
    for (PeridigmNS::Block& block : *blocks) {
      const double* density = view(block, fields_.density);
      const double* volume = view(block, fields_.volume);
      double* energy = view(block, fields_.energy);
      const auto neighborhood = block.getNeighborhoodData();
      for (int i = 0; i < neighborhood->NumOwnedPoints(); ++i) {
        const int id = neighborhood->OwnedIDs()[i];
        energy[id] = density[id] * volume[id];
      }
    }
    return 0;
  }

 private:
  Fields fields_;
};

}  // namespace pd

using pd::StoredElasticEnergy;
PD_REGISTER_COMPUTE(StoredElasticEnergy, "Stored_Elastic_Energy", "Elastic energy of each point.")
