// Total_Current: current through the dissolving surface, A.
#include "plugins.hpp"
#include "surface_current.hpp"

namespace pd {

class TotalCurrent : public SurfaceCurrent {
 public:
  static void declareParameters(ParameterDeclarations& declarations) {
    SurfaceCurrent::declareParameters(declarations, "Total_Current");
  }
  TotalCurrent(ComputeParameters params, ComputeComm comm, ComputeParameters globalData)
      : SurfaceCurrent(completeParameters<TotalCurrent>(params, "Total_Current"), params, comm, globalData,
                       PeridigmNS::PeridigmField::SCALAR) {}

  int compute(Blocks blocks) const override {
    setGlobal(blocks, outputField_, currentAndArea(blocks)[0]);
    return 0;
  }
};

}  // namespace pd

using pd::TotalCurrent;
PD_REGISTER_COMPUTE(TotalCurrent, "Total_Current", "Current through the dissolving surface, A.")
