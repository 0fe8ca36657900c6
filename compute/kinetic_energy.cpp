// Kinetic_Energy: kinetic energy of each point, J.
#include "compute_support.hpp"
#include "plugins.hpp"

namespace pd {

class KineticEnergy : public TabledCompute {
 public:
  struct Fields : FieldTable {
    FieldHandle volume = reads(pd::fields::volume());
    FieldHandle velocity = reads(pd::fields::velocity());
    FieldHandle energy;
    explicit Fields(const Teuchos::ParameterList& parameters)
        : energy(writes(outputField(parameters, pd::fields::elementScalar, "J", "Kinetic energy of the point."))) {}
  };
  static void declareParameters(ParameterDeclarations& declarations) {
    declareCommonParameters(declarations, "Kinetic_Energy");
  }
  KineticEnergy(ComputeParameters params, ComputeComm comm, ComputeParameters globalData)
      : TabledCompute(completeParameters<KineticEnergy>(params, "Kinetic_Energy"), params, comm, globalData),
        fields_(parameters_) {}

  const Fields& fields() const override { return fields_; }
  int compute(Blocks blocks) const override {
    for (PeridigmNS::Block& block : *blocks) {
      const double* volume = view(block, fields_.volume);
      const double* velocity = view(block, fields_.velocity);
      double* energy = view(block, fields_.energy);
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
  Fields fields_;
};

}  // namespace pd

using pd::KineticEnergy;
PD_REGISTER_COMPUTE(KineticEnergy, "Kinetic_Energy", "Kinetic energy of each point.")
