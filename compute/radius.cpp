// Radius: of the ball with the volume of each point, m.
#include <cmath>

#include "compute_support.hpp"
#include "plugins.hpp"

namespace pd {

class Radius : public TabledCompute {
 public:
  struct Fields : FieldTable {
    FieldHandle volume = reads(pd::fields::volume());
    FieldHandle radius;
    explicit Fields(const Teuchos::ParameterList& parameters)
        : radius(writes(outputField(parameters, pd::fields::elementScalar, "m",
                                    "Radius of the ball with the volume of the point."))) {}
  };
  static void declareParameters(ParameterDeclarations& declarations) {
    declareCommonParameters(declarations, "Radius");
  }
  Radius(ComputeParameters params, ComputeComm comm, ComputeParameters globalData)
      : TabledCompute(completeParameters<Radius>(params, "Radius"), params, comm, globalData), fields_(parameters_) {}

  const Fields& fields() const override { return fields_; }
  // Volumes do not change during a run, but a restart overwrites fields: so in compute, not in initialize.
  int compute(Blocks blocks) const override {
    const double pi = std::acos(-1.0);
    for (PeridigmNS::Block& block : *blocks) {
      const double* volume = view(block, fields_.volume);
      double* radius = view(block, fields_.radius);
      const auto neighborhood = block.getNeighborhoodData();
      for (int i = 0; i < neighborhood->NumOwnedPoints(); ++i) {
        const int id = neighborhood->OwnedIDs()[i];
        radius[id] = std::cbrt(0.75 / pi * volume[id]);
      }
    }
    return 0;
  }

 private:
  Fields fields_;
};

}  // namespace pd

using pd::Radius;
PD_REGISTER_COMPUTE(Radius, "Radius", "Radius of the ball with the volume of each point.")
