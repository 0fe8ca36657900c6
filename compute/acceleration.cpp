// Acceleration: of each point by the forces of its bonds and by loads, m/s2.
#include "compute_support.hpp"
#include "plugins.hpp"

namespace pd {

class Acceleration : public TabledCompute {
 public:
  struct Fields : FieldTable {
    FieldHandle forceDensity = reads(pd::fields::forceDensity());
    FieldHandle load = reads(pd::fields::externalForceDensity());
    FieldHandle acceleration;
    explicit Fields(const Teuchos::ParameterList& parameters)
        : acceleration(
              writes(outputField(parameters, pd::fields::steppedVector, "m/s2", "By the bonds and by loads."))) {}
  };
  static void declareParameters(ParameterDeclarations& declarations) {
    declareCommonParameters(declarations, "Acceleration");
  }
  Acceleration(ComputeParameters params, ComputeComm comm, ComputeParameters globalData)
      : TabledCompute(completeParameters<Acceleration>(params, "Acceleration"), params, comm, globalData),
        fields_(parameters_) {}

  const Fields& fields() const override { return fields_; }
  int compute(Blocks blocks) const override {
    for (PeridigmNS::Block& block : *blocks) {
      const double* force = view(block, fields_.forceDensity);
      const double* load = view(block, fields_.load);
      double* acceleration = view(block, fields_.acceleration);
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
  Fields fields_;
};

}  // namespace pd

using pd::Acceleration;
PD_REGISTER_COMPUTE(Acceleration, "Acceleration", "Acceleration of each point by the forces of its bonds and by loads.")
