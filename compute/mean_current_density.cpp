// Mean_Current_Density: mean current density of the dissolving surface, A/m2; 0 where there is none.
#include "plugins.hpp"
#include "surface_current.hpp"

namespace pd {

class MeanCurrentDensity : public SurfaceCurrent {
 public:
  static void declareParameters(ParameterDeclarations& declarations) {
    SurfaceCurrent::declareParameters(declarations, "Mean_Current_Density");
  }
  MeanCurrentDensity(ComputeParameters params, ComputeComm comm, ComputeParameters globalData)
      : SurfaceCurrent(completeParameters<MeanCurrentDensity>(params, "Mean_Current_Density"), params, comm, globalData,
                       PeridigmNS::PeridigmField::SCALAR) {}

  int compute(Blocks blocks) const override {
    const auto [current, area] = currentAndArea(blocks);
    setGlobal(blocks, outputField_, area > 0.0 ? current / area : 0.0);
    return 0;
  }
};

}  // namespace pd

using pd::MeanCurrentDensity;
PD_REGISTER_COMPUTE(MeanCurrentDensity, "Mean_Current_Density", "Mean current density of the dissolving surface, A/m2.")
