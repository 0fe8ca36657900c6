// The operators of a flow over whole neighbourhoods, chunk by chunk, and the rates that follow from them.
#ifndef PD_FLOW_KERNEL_HPP
#define PD_FLOW_KERNEL_HPP

#include <array>
#include <vector>

#include "chunked_neighborhood.hpp"
#include "point_arrays.hpp"

namespace pd::kernels {

/// Rows of weights over the differences of neighbours from a point. Fixed in memory, since neighbourhoods refer to it.
class FlowStencils {
 public:
  /// `points`: local ids, ascending; `list`: their neighbours, flat, as Peridigm lays it out, ascending in each;
  /// `weights` [bonds of the list][width].
  FlowStencils(std::vector<int> points, std::vector<int> list, const std::vector<double>& weights, int width);
  FlowStencils(const FlowStencils&) = delete;
  FlowStencils& operator=(const FlowStencils&) = delete;

  const ChunkedNeighborhood& neighborhood() const { return neighborhood_; }
  const BondConstants& weights() const { return weights_; }
  /// Share of the bonds whose weights are kept once a chunk.
  double uniformShare() const;

 private:
  std::vector<int> points_, list_;
  ChunkedNeighborhood neighborhood_;
  BondConstants weights_;
};

/// Of all points of this rank, by local id; zero where there is no flow.
struct FlowState {
  PointArrays velocity;  ///< m/s
  PointArrays pressure;  ///< Pa, one component
};

/// What the operators make of a state.
struct FlowOperators {
  PointArrays convection;        ///< (v.grad) v, m/s2
  PointArrays viscous;           ///< lap v, 1/(m s)
  PointArrays pressureGradient;  ///< Pa/m
  PointArrays divergence;        ///< div v, 1/s
  PointArrays smoothing;         ///< S p, Pa/m2
};

/// How the weights of a bond act on the components of a velocity.
enum class FlowWeights {
  Scalar,  ///< on all alike
  Matrix   ///< each on each, as where a bond passes on what is across it, or planes of symmetry mirror it
};

/// viscous_a = sum_j w_ab (v_b(j) - v_b) at the points of the stencils. Weights a bond: w, or w[D a + b].
void applyViscosity(const FlowStencils& stencils, FlowWeights kind, int dimension, const FlowState& state,
                    FlowOperators& result);
/// With g_ab = sum_j w_b(a) (v_a(j) - v_a): convection_a = sum_b v_b g_ab, divergence = sum_a g_aa, and
/// pressureGradient_b = sum_j q_b (p_j - p). Weights a bond: w[b], or w[D a + b]; then q[b].
void applyGradients(const FlowStencils& stencils, FlowWeights kind, int dimension, const FlowState& state,
                    FlowOperators& result);

/// A barotropic fluid by Tait's equation, p = rho0 c^2/n [(rho/rho0)^n - 1], with whole exponents n.
struct TaitFluid {
  double density, viscosity;  ///< rho0, kg/m3; Pa s
  double soundSpeed;          ///< c at p = 0, m/s
  int exponent;

  double bulkModulus(double pressure) const { return density * soundSpeed * soundSpeed + exponent * pressure; }
  /// Pa, at which the density is zero.
  double leastPressure() const { return -density * soundSpeed * soundSpeed / exponent; }
  /// kg/m3; to rounding for pressures within half of -leastPressure(), NaN below it.
  double densityAt(double pressure) const;
};

/// Of the first `nPoints` points,
///   dv/dt = -(v.grad) v + (mu lap v - grad p + f)/rho,
///   dp/dt = -K (div v - tau S p) - v.grad p,   K = rho dp/drho = rho0 c^2 + n p,
/// the second of which is d rho/dt + div(rho v) = rho tau S p. `force`: f, N/m3; `tau`: m s/kg, by local id, readable
/// as the state is. `density`: rho of the state.
void flowRates(const TaitFluid& fluid, int dimension, int nPoints, const FlowState& state,
               const FlowOperators& operators, const PointArrays& force, const PointArrays& tau, FlowState& rates,
               PointArrays& density);

/// result = base + factor rates, of the first nPoints points.
void advanceFlow(int dimension, int nPoints, const FlowState& base, double factor, const FlowState& rates,
                 FlowState& result);

}  // namespace pd::kernels

#endif
