// Front_Speed: speed at which the depth of a surface grows, m/s, since the evaluation before; 0 at the first.
//
// The evaluation before is kept in a field, so that it survives a restart. Evaluating twice at one time changes
// nothing.
#include <stdexcept>

#include "plugins.hpp"
#include "surface_compute.hpp"

namespace pd {

namespace PeridigmField = PeridigmNS::PeridigmField;

class FrontSpeed : public SurfaceCompute {
 public:
  static void declareParameters(ParameterDeclarations& declarations) {
    SurfaceCompute::declareParameters(declarations, "Front_Speed");
    declarations.text("Depth", "Which depth of the surface.").oneOf({"Maximum", "Mean"}).defaultTo("Maximum");
  }
  FrontSpeed(ComputeParameters params, ComputeComm comm, ComputeParameters globalData)
      : FrontSpeed(completeParameters<FrontSpeed>(params, "Front_Speed"), params, comm, globalData) {}

  std::vector<int> FieldIds() const override {
    std::vector<int> ids = SurfaceCompute::FieldIds();
    ids.insert(ids.end(), {timeField_, lastField_});
    return ids;
  }
  int compute(Blocks blocks) const override;

 private:
  FrontSpeed(const Teuchos::ParameterList& parameters, ComputeParameters params, ComputeComm comm,
             ComputeParameters globalData)
      : SurfaceCompute(parameters, params, comm, globalData, scalarResult),
        isMaximum_(parameters.get<std::string>("Depth") == "Maximum"),
        timeField_(stateField("Time", PeridigmField::SCALAR)),
        lastField_(stateField(parameters.get<std::string>("Output Label") + "_Last", PeridigmField::VECTOR)) {}

  static int stateField(const std::string& label, PeridigmField::Length length) {
    return PeridigmNS::FieldManager::self().getFieldId(PeridigmField::GLOBAL, length, PeridigmField::TWO_STEP, label);
  }

  bool isMaximum_;
  int timeField_, lastField_;
};

int FrontSpeed::compute(Blocks blocks) const {
  const SurfaceColumns::Profile columns = profile(blocks);
  const double depth = isMaximum_ ? maximumDepth(columns) : meanDepth(columns);
  const double time = *view(blocks->front(), timeField_, PeridigmField::STEP_NP1);
  double* last = view(blocks->front(), lastField_, PeridigmField::STEP_NP1);  // depth, time, is there any
  if (last[2] != 0.0 && time == last[1]) {
    if (depth == last[0]) return 0;
    throw std::runtime_error(
        "Front_Speed: the depth has changed, but not the field Time, which this host does not keep");
  }
  setGlobal(blocks, outputField_, last[2] != 0.0 ? (depth - last[0]) / (time - last[1]) : 0.0);
  last[0] = depth;
  last[1] = time;
  last[2] = 1.0;
  return 0;
}

}  // namespace pd

using pd::FrontSpeed;
PD_REGISTER_COMPUTE(FrontSpeed, "Front_Speed", "Speed at which a surface dissolves, m/s, since the last evaluation.")
