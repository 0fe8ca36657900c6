// Peak_Current_Density: largest current density of the dissolving surface, A/m2; 0 where there is none.
#include "plugins.hpp"
#include "surface_current.hpp"

namespace pd {

class PeakCurrentDensity : public SurfaceCurrent {
 public:
  static void declareParameters(ParameterDeclarations& declarations) {
    SurfaceCurrent::declareParameters(declarations, "Peak_Current_Density");
  }
  PeakCurrentDensity(ComputeParameters params, ComputeComm comm, ComputeParameters globalData)
      : SurfaceCurrent(completeParameters<PeakCurrentDensity>(params, "Peak_Current_Density"), params, comm, globalData,
                       PeridigmNS::PeridigmField::SCALAR) {}

  int compute(Blocks blocks) const override {
    setGlobal(blocks, outputField_, peak(blocks));
    return 0;
  }
};

}  // namespace pd

using pd::PeakCurrentDensity;
PD_REGISTER_COMPUTE(PeakCurrentDensity, "Peak_Current_Density",
                    "Largest current density of the dissolving surface, A/m2.")
