// Rates of a flow whose density follows its pressure.
#ifndef PD_FLOW_RATES_HPP
#define PD_FLOW_RATES_HPP

#include <array>
#include <map>
#include <memory>
#include <vector>

#include "flow_kernel.hpp"
#include "flow_pockets.hpp"

namespace pd {

/// The operators of FlowRows laid out for vector loops: differences of the neighbours from each point, and what is left
/// of rows beside boundaries, whose weights do not add up to zero and that have constants, which follow boundaries from
/// time to time. In a pocket that nothing leaves mass is kept: what the divergence has too much, by the error of the
/// operators at walls, is taken out of all of the pocket.
class FlowRates {
 public:
  /// `densityDiffusion`: eta of the diffusivity eta c h of the density, h the spacing; it is less where viscosity rules
  /// a bond (diffusivityAt()). Collective.
  FlowRates(Simulation& simulation, const FlowGeometry& geometry, FlowRows rows, const kernels::TaitFluid& fluid,
            double densityDiffusion);

  /// From the fields Velocity and Pressure: the points of the flow, others zero. Collective.
  void read(kernels::FlowState& state) const;
  void write(const kernels::FlowState& state) const;
  kernels::FlowState makeState() const;
  /// Rates at owned points at the solver's time t; ghosts of the state are brought up to date. Collective.
  void evaluate(kernels::FlowState& state, double t, kernels::FlowState& rates);

  /// What of the rates is linear about rest, each part times a factor.
  struct Parts {
    double acoustics, viscosity, diffusion;
  };
  /// With boundaries at rest and no forces. Collective.
  void evaluateLinear(kernels::FlowState& state, const Parts& parts, kernels::FlowState& rates);

  const FlowGeometry& geometry() const { return geometry_; }
  const FlowRows& rows() const { return rows_; }
  const kernels::TaitFluid& fluid() const { return fluid_; }
  int nOwned() const { return model_.nOwned(); }
  int dimension() const { return dimension_; }
  double leastSpacing() const { return leastSpacing_; }             ///< all ranks, m
  double largestDiffusionNumber() const { return largestNumber_; }  ///< D/h^2 of the density, all ranks, 1/s
  long long nBonds() const { return nBonds_; }                      ///< directed, of points of the flow on this rank
  double uniformShare() const;                                      ///< of nBonds() on this rank
  /// Mass of the pockets that nothing leaves over that at p = 0, less 1; 0 where there are none. Collective.
  double excessMass(const kernels::FlowState& state) const;
  /// Of the last evaluate(): largest net flow into a closed pocket, over `velocity` times its width.
  double largestNetFlow(double velocity) const;

 private:
  /// Scalar and other rows of one operator; null where there are none.
  struct Stencils {
    std::unique_ptr<kernels::FlowStencils> scalar, matrix;
  };
  /// A row beside a boundary: what its weights add up to, which acts on the point itself.
  struct Edge {
    int point;
    std::array<double, 9> viscous{}, gradient{};
    std::array<double, 3> pressureGradient{}, divergence{};
    double smoothing = 0.0;
  };
  /// weight times component of a source less what it was at first, in one of the constants.
  struct Share {
    std::size_t constant, value;
    double weight;
  };
  // Constants of an edge, one after the other.
  static constexpr std::size_t ofViscous = 0, ofGradient = 3, ofPressure = 12, ofDivergence = 15, ofSmoothing = 16,
                               nConstants = 17;

  void makeStencils();
  void makeDivergence();
  void makeEdges();
  void makeShares();
  void makeTau(double densityDiffusion);
  void findClosedPockets();
  void applyOperators(const kernels::FlowState& state);
  void addEdges(const kernels::FlowState& state, bool isLinear);
  void followBoundaries(double t);
  void followForces(double t);
  void keepMass(const kernels::FlowState& state, kernels::FlowState& rates);
  void exchange(kernels::FlowState& state) const;

  Model& model_;
  const FlowGeometry& geometry_;
  const FlowRows rows_;
  const kernels::TaitFluid fluid_;
  const int dimension_;
  const FlowForces sources_;
  double leastSpacing_ = 0.0, largestNumber_ = 0.0;
  long long nBonds_ = 0;

  Stencils viscous_, gradients_;
  std::unique_ptr<kernels::FlowStencils> smoothing_;
  std::vector<std::unique_ptr<kernels::FlowStencils>> divergence_;  ///< a component each, at balanced_
  std::vector<int> balanced_;                                       ///< points whose divergence is a balance of mass
  std::vector<Edge> edges_;
  std::map<std::size_t, std::size_t> edgeOf_;       ///< by row
  std::vector<double> constants_, firstConstants_;  ///< [nConstants edges]
  std::vector<Share> shares_;
  std::vector<double> values_;  ///< [3 sources]
  double boundariesAt_, forcesAt_;
  kernels::PointArrays forces_, tau_, density_;  ///< N/m3, m s/kg, kg/m3
  kernels::FlowOperators operators_;
  FlowPockets pockets_;
  std::vector<char> isClosed_;   ///< by pocket
  std::vector<double> leakage_;  ///< by pocket, 1/s
  bool hasClosed_ = false;
};

}  // namespace pd

#endif
