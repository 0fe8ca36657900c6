// Total_Current: current through the dissolving surface, A.
#include "plugins.hpp"
#include "surface_current.hpp"

namespace pd {

class TotalCurrent : public SurfaceCurrent {
 public:
  struct Fields : SurfaceCurrent::Fields {
    explicit Fields(const Teuchos::ParameterList& parameters)
        : SurfaceCurrent::Fields(parameters, pd::fields::globalScalar, "A", "Current through the dissolving surface.") {
    }
  };
  static void declareParameters(ParameterDeclarations& declarations) {
    SurfaceCurrent::declareParameters(declarations, "Total_Current");
  }
  TotalCurrent(ComputeParameters params, ComputeComm comm, ComputeParameters globalData)
      : SurfaceCurrent(completeParameters<TotalCurrent>(params, "Total_Current"), params, comm, globalData),
        fields_(parameters_) {}

  const Fields& fields() const override { return fields_; }
  int compute(Blocks blocks) const override {
    setGlobal(blocks, fields_.result, currentAndArea(blocks)[0]);
    return 0;
  }

 private:
  Fields fields_;
};

}  // namespace pd

using pd::TotalCurrent;
PD_REGISTER_COMPUTE(TotalCurrent, "Total_Current", "Current through the dissolving surface, A.")
