// Flow_Force: force of a flow on a body that it goes round, N.
#include <cmath>

#include "compute_support.hpp"
#include "flow_fields.hpp"
#include "plugins.hpp"
#include "rings.hpp"

namespace pd {

/// In steady flow what a closed surface around the body passes on of momentum is the force on it,
///   F = -closed int (rho v v + p 1 - tau).n dA,   tau = mu (grad v + grad v^T).
/// In place of one surface the mean over all circles (or spheres) of a ring: with chi that falls from 1 at its inner to
/// 0 at its outer radius, smoothly,
///   F_i = int [rho v_i v_j d_j chi + p d_i chi + mu (v_i d_j d_j chi + v_j d_i d_j chi)] dV,
/// where the derivatives of v have gone to chi by parts. The sum over points that stands for the integral has nothing
/// to do with walls, so that it is as exact as the flow is.
class FlowForce : public TabledCompute {
 public:
  struct Fields : FieldTable {
    FieldHandle x = reads(pd::fields::modelCoordinates());
    FieldHandle volume = reads(pd::fields::volume());
    FieldHandle velocity = reads(pd::fields::velocity());
    FieldHandle pressure = reads(pd::fields::pressure());
    FieldHandle viscosity = reads(pd::fields::viscosity());
    FieldHandle fluid = reads(pd::fields::fluidShare());
    FieldHandle force;
    explicit Fields(const Teuchos::ParameterList& parameters)
        : force(writes(outputField(parameters, pd::fields::globalVector, "N", "Force of the flow on the body."))) {}
  };
  static void declareParameters(ParameterDeclarations& declarations) {
    declareCommonParameters(declarations, "Flow_Force");
    declareVector(declarations, "Center", "m", "Middle of the ring");
    declarations.real("Inner Radius", "m", "Radius within which the body lies.").positive().required();
    declarations.real("Outer Radius", "m", "Radius within which all else is fluid.").positive().required();
    declarations
        .text("Ring", "Circles about an axis along z, or spheres. A ring three spacings wide and more is enough.")
        .oneOf({"Circles", "Spheres"})
        .defaultTo("Circles");
    declarations
        .text(axisOfRevolution,
              "Axis of a body of revolution, in which spheres about its points are half circles and a force is along "
              "the axis alone; given by Discretization.")
        .oneOf({"x", "y"});
  }
  FlowForce(ComputeParameters params, ComputeComm comm, ComputeParameters globalData)
      : TabledCompute(completeParameters<FlowForce>(params, "Flow_Force"), params, comm, globalData),
        center_(vectorOf(parameters_, "Center")),
        inner_(parameters_.get<double>("Inner Radius")),
        outer_(parameters_.get<double>("Outer Radius")),
        dimension_(parameters_.get<std::string>("Ring") == "Circles" ? 2 : 3),
        rings_(parameters_.isParameter(axisOfRevolution) ? parameters_.get<std::string>(axisOfRevolution) : ""),
        fields_(parameters_) {
    if (outer_ <= inner_) throw std::invalid_argument("Flow_Force: \"Outer Radius\" must be above \"Inner Radius\"");
    if (rings_.areUsed() && (dimension_ != 3 || center_[rings_.radial()] != 0.0))
      throw std::invalid_argument(
          "Flow_Force: in a body of revolution take \"Ring: Spheres\" about a \"Center\" on its "
          "axis");
  }

  const Fields& fields() const override { return fields_; }

  int compute(Blocks blocks) const override {
    std::vector<double> sums(5, 0.0);  // force, points of fluid and others in the ring
    for (PeridigmNS::Block& block : *blocks) {
      const auto points = block.getNeighborhoodData();
      const double density = block.getMaterialModel()->Density();
      for (int i = 0; i < points->NumOwnedPoints(); ++i) addPoint(block, points->OwnedIDs()[i], density, sums);
    }
    sums = sumOverRanks(*epetraComm, sums);
    if (sums[3] + sums[4] == 0.0)
      throw std::invalid_argument("Flow_Force: no point lies between \"Inner Radius\" and \"Outer Radius\"");
    // Before the first flow nothing is known to be fluid.
    if (sums[3] > 0.0 && sums[4] > 0.0)
      throw std::invalid_argument("Flow_Force: " + std::to_string(static_cast<long long>(sums[4])) +
                                  " points between \"Inner Radius\" and \"Outer Radius\" are not fluid; the ring must "
                                  "go round the body and keep away from walls");
    if (rings_.areUsed()) sums[rings_.radial()] = 0.0;  // all around the axis
    setGlobal(blocks, fields_.force, sums.data(), 3);
    return 0;
  }

 private:
  void addPoint(PeridigmNS::Block& block, int id, double density, std::vector<double>& sums) const {
    const auto point = static_cast<std::size_t>(id);
    const double *x = view(block, fields_.x) + 3 * point, *v = view(block, fields_.velocity) + 3 * point;
    Vector3 n{};
    double square = 0.0;
    for (std::size_t a = 0; a < dimension_; ++a) {
      n[a] = x[a] - center_[a];
      square += n[a] * n[a];
    }
    const double r = std::sqrt(square);
    if (r <= inner_ || r >= outer_) return;
    const bool isFluid = view(block, fields_.fluid)[point] > 0.0;
    sums[isFluid ? 3 : 4] += 1.0;
    if (!isFluid) return;
    for (double& component : n) component /= r;
    // chi = 1 - s, s = t^4 (35 - 84 t + 70 t^2 - 20 t^3): three derivatives vanish at both ends.
    const double width = outer_ - inner_, t = (r - inner_) / width, u = t * (1.0 - t);
    const double slope = -140.0 * u * u * u / width, curvature = -420.0 * u * u * (1.0 - 2.0 * t) / (width * width);
    const double across = slope / r, laplacian = curvature + static_cast<double>(dimension_ - 1) * across;
    const double along = dot(n, v);
    const double volume = view(block, fields_.volume)[point], pressure = view(block, fields_.pressure)[point];
    const double viscosity = view(block, fields_.viscosity)[point];
    for (std::size_t a = 0; a < 3; ++a) {
      const double tangential = a < dimension_ ? v[a] - along * n[a] : 0.0;
      sums[a] += volume * (density * v[a] * along * slope + pressure * slope * n[a] +
                           viscosity * (v[a] * laplacian + curvature * along * n[a] + across * tangential));
    }
  }

  Vector3 center_;
  double inner_, outer_;
  std::size_t dimension_;
  kernels::Rings rings_;
  Fields fields_;
};

}  // namespace pd

using pd::FlowForce;
PD_REGISTER_COMPUTE(FlowForce, "Flow_Force", "Force of a flow on a body, from the momentum through a ring around it.")
