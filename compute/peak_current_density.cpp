// Peak_Current_Density: largest current density of the dissolving surface, A/m2; 0 where there is none.
#include "plugins.hpp"
#include "surface_current.hpp"

namespace pd {

class PeakCurrentDensity : public SurfaceCurrent {
 public:
  struct Fields : SurfaceCurrent::Fields {
    explicit Fields(const Teuchos::ParameterList& parameters)
        : SurfaceCurrent::Fields(parameters, pd::fields::globalScalar, "A/m2", "Largest of the dissolving surface.") {}
  };
  static void declareParameters(ParameterDeclarations& declarations) {
    SurfaceCurrent::declareParameters(declarations, "Peak_Current_Density");
  }
  PeakCurrentDensity(ComputeParameters params, ComputeComm comm, ComputeParameters globalData)
      : SurfaceCurrent(completeParameters<PeakCurrentDensity>(params, "Peak_Current_Density"), params, comm,
                       globalData),
        fields_(parameters_) {}

  const Fields& fields() const override { return fields_; }
  int compute(Blocks blocks) const override {
    setGlobal(blocks, fields_.result, peak(blocks));
    return 0;
  }

 private:
  Fields fields_;
};

}  // namespace pd

using pd::PeakCurrentDensity;
PD_REGISTER_COMPUTE(PeakCurrentDensity, "Peak_Current_Density",
                    "Largest current density of the dissolving surface, A/m2.")
