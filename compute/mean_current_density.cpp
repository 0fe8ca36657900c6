// Mean_Current_Density: mean current density of the dissolving surface, A/m2; 0 where there is none.
#include "plugins.hpp"
#include "surface_current.hpp"

namespace pd {

class MeanCurrentDensity : public SurfaceCurrent {
 public:
  struct Fields : SurfaceCurrent::Fields {
    explicit Fields(const Teuchos::ParameterList& parameters)
        : SurfaceCurrent::Fields(parameters, pd::fields::globalScalar, "A/m2", "Mean of the dissolving surface.") {}
  };
  static void declareParameters(ParameterDeclarations& declarations) {
    SurfaceCurrent::declareParameters(declarations, "Mean_Current_Density");
  }
  MeanCurrentDensity(ComputeParameters params, ComputeComm comm, ComputeParameters globalData)
      : SurfaceCurrent(completeParameters<MeanCurrentDensity>(params, "Mean_Current_Density"), params, comm,
                       globalData),
        fields_(parameters_) {}

  const Fields& fields() const override { return fields_; }
  int compute(Blocks blocks) const override {
    const auto [current, area] = currentAndArea(blocks);
    setGlobal(blocks, fields_.result, area > 0.0 ? current / area : 0.0);
    return 0;
  }

 private:
  Fields fields_;
};

}  // namespace pd

using pd::MeanCurrentDensity;
PD_REGISTER_COMPUTE(MeanCurrentDensity, "Mean_Current_Density", "Mean current density of the dissolving surface, A/m2.")
