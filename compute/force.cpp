// Force: force of the bonds on each point, N.
#include "compute_support.hpp"
#include "plugins.hpp"

namespace pd {

class Force : public TabledCompute {
 public:
  struct Fields : FieldTable {
    FieldHandle volume = reads(pd::fields::volume());
    FieldHandle forceDensity = reads(pd::fields::forceDensity());
    FieldHandle force;
    explicit Fields(const Teuchos::ParameterList& parameters)
        : force(writes(outputField(parameters, pd::fields::steppedVector, "N", "Force of the bonds on the point."))) {}
  };
  static void declareParameters(ParameterDeclarations& declarations) { declareCommonParameters(declarations, "Force"); }
  Force(ComputeParameters params, ComputeComm comm, ComputeParameters globalData)
      : TabledCompute(completeParameters<Force>(params, "Force"), params, comm, globalData), fields_(parameters_) {}

  const Fields& fields() const override { return fields_; }
  int compute(Blocks blocks) const override {
    for (PeridigmNS::Block& block : *blocks) {
      const double* volume = view(block, fields_.volume);
      const double* density = view(block, fields_.forceDensity);
      double* force = view(block, fields_.force);
      const auto neighborhood = block.getNeighborhoodData();
      for (int i = 0; i < neighborhood->NumOwnedPoints(); ++i) {
        const int id = neighborhood->OwnedIDs()[i];
        for (int k = 0; k < 3; ++k) force[3 * id + k] = volume[id] * density[3 * id + k];
      }
    }
    return 0;
  }

 private:
  Fields fields_;
};

}  // namespace pd

using pd::Force;
PD_REGISTER_COMPUTE(Force, "Force", "Force of the bonds on each point.")
