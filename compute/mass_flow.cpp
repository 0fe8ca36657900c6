// Mass_Flow: what flows through a plane, kg/s.
#include <cmath>
#include <stdexcept>

#include "flow_fields.hpp"
#include "plugins.hpp"
#include "point_selection.hpp"

namespace pd {

/// int rho v.n w(d) dV with d the distance from the plane and w a hat of unit area, as wide on either side as "Width":
/// on lattices along the plane whose spacing the width is a multiple of, the mean over rows of points.
class MassFlow : public TabledCompute {
 public:
  struct Fields : FieldTable {
    FieldHandle x = reads(pd::fields::modelCoordinates());
    FieldHandle volume = reads(pd::fields::volume());
    FieldHandle velocity = reads(pd::fields::velocity());
    FieldHandle fluid = reads(pd::fields::fluidShare());
    FieldHandle flow;
    explicit Fields(const Teuchos::ParameterList& parameters)
        : flow(
              writes(outputField(parameters, pd::fields::globalScalar, "kg/s", "Mass that flows through the plane."))) {
    }
  };
  static void declareParameters(ParameterDeclarations& declarations) {
    declareCommonParameters(declarations, "Mass_Flow");
    PointSelection::declareParameters(declarations);
    declareVector(declarations, "Point", "m", "A point of the plane");
    declareVector(declarations, "Normal", "1", "Normal of the plane, into which the flow counts as positive");
    declarations.real("Width", "m", "Points no further than this from the plane count; two spacings are enough.")
        .positive()
        .required();
  }
  MassFlow(ComputeParameters params, ComputeComm comm, ComputeParameters globalData)
      : TabledCompute(completeParameters<MassFlow>(params, "Mass_Flow"), params, comm, globalData),
        points_(parameters_, globalData),
        point_(vectorOf(parameters_, "Point")),
        normal_(directionOf(parameters_, "Normal")),
        width_(parameters_.get<double>("Width")),
        fields_(parameters_) {}

  const Fields& fields() const override { return fields_; }
  void initialize(Blocks blocks) override {
    points_.initialize(blocks);
    double nPoints = 0.0;
    points_.forEach(blocks, [&](std::size_t b, int id) { nPoints += shareOf((*blocks)[b], id) > 0.0 ? 1.0 : 0.0; });
    if (sumOverRanks(*epetraComm, nPoints) == 0.0)
      throw std::invalid_argument("Mass_Flow: no point lies within \"Width\" of the plane; move it, or widen it");
  }

  int compute(Blocks blocks) const override {
    double flow = 0.0;
    points_.forEach(blocks, [&](std::size_t b, int id) {
      PeridigmNS::Block& block = (*blocks)[b];
      const auto point = static_cast<std::size_t>(id);
      const double share = shareOf(block, id);
      if (share <= 0.0 || view(block, fields_.fluid)[point] == 0.0) return;
      flow += block.getMaterialModel()->Density() * dot(normal_, view(block, fields_.velocity) + 3 * point) * share *
              view(block, fields_.volume)[point];
    });
    setGlobal(blocks, fields_.flow, sumOverRanks(*epetraComm, flow));
    return 0;
  }

 private:
  /// w(d) of a point, 1/m; not above 0 where it is too far from the plane.
  double shareOf(PeridigmNS::Block& block, int id) const {
    const double* x = view(block, fields_.x) + 3 * static_cast<std::size_t>(id);
    const double distance = dot(normal_, x) - dot(normal_, point_.data());
    return (1.0 - std::abs(distance) / width_) / width_;
  }

  PointSelection points_;
  Vector3 point_, normal_;
  double width_;
  Fields fields_;
};

}  // namespace pd

using pd::MassFlow;
PD_REGISTER_COMPUTE(MassFlow, "Mass_Flow", "Mass that flows through a plane, per second.")
