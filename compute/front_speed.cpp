// Front_Speed: speed at which the depth of a surface grows, m/s, since the evaluation before; 0 at the first.
//
// The evaluation before is kept in a field, so that it survives a restart. Evaluating twice at one time changes
// nothing.
#include "kept_rate.hpp"
#include "plugins.hpp"
#include "surface_compute.hpp"

namespace pd {

class FrontSpeed : public SurfaceCompute {
 public:
  struct Fields : SurfaceCompute::Fields {
    FieldHandle time = reads(timeOfRun());
    FieldHandle last;
    explicit Fields(const Teuchos::ParameterList& parameters)
        : SurfaceCompute::Fields(parameters, pd::fields::globalScalar, "m/s",
                                 "Speed of the depth since the last evaluation.") {
      last =
          writes(kept(pd::fields::globalVector(parameters.get<std::string>("Output Label") + "_Last", "m, s, 1",
                                               "Depth and time of the last evaluation, and 1 where there was one.")));
    }
  };
  static void declareParameters(ParameterDeclarations& declarations) {
    SurfaceCompute::declareParameters(declarations, "Front_Speed");
    declarations.text("Depth", "Which depth of the surface.").oneOf({"Maximum", "Mean"}).defaultTo("Maximum");
  }
  FrontSpeed(ComputeParameters params, ComputeComm comm, ComputeParameters globalData)
      : SurfaceCompute(completeParameters<FrontSpeed>(params, "Front_Speed"), params, comm, globalData),
        isMaximum_(parameters_.get<std::string>("Depth") == "Maximum"),
        fields_(parameters_) {}

  const Fields& fields() const override { return fields_; }
  int compute(Blocks blocks) const override;

 private:
  bool isMaximum_;
  Fields fields_;
};

int FrontSpeed::compute(Blocks blocks) const {
  const SurfaceColumns::Profile columns = profile(blocks);
  const double depth = isMaximum_ ? maximumDepth(columns) : meanDepth(columns);
  const auto speed =
      keptRate(view(blocks->front(), fields_.last), depth, *view(blocks->front(), fields_.time), false,
               "Front_Speed: the depth has changed, but not the field Time, which this host does not keep");
  if (speed) setGlobal(blocks, fields_.result, *speed);
  return 0;
}

}  // namespace pd

using pd::FrontSpeed;
PD_REGISTER_COMPUTE(FrontSpeed, "Front_Speed", "Speed at which a surface dissolves, m/s, since the last evaluation.")
