// The equations of a steady flow: their residual and their matrix.
#ifndef PD_FLOW_EQUATIONS_HPP
#define PD_FLOW_EQUATIONS_HPP

#include <cmath>
#include <memory>
#include <optional>
#include <vector>

#include "../../linear/sparse_rows.hpp"
#include "flow_pockets.hpp"

namespace pd {

/// Of each fluid point, with velocity v and pressure p,
///   rho (v.grad) v + grad p - mu lap v - f = 0,
///   div v - tau S p + lambda = 0,
/// S the smoothing of FlowRows, tau = c h^2/(mu (1 + rho |v| h/(4 mu))), h the spacing, v that of the last iterate: c
/// h^2/mu where viscosity rules a bond, and of the order of h/(rho |v|) where convection does. lambda is one number a
/// closed pocket: what its walls let through too much, over its volume, since its velocities are exact to the order of
/// the operators alone; there the pressure of one point is zero.
///
/// Unknowns and residuals are velocities: pressures times h/mu, momentum times h^2/mu, divergence times h, h the
/// spacing of the finest points. Points that are solid, but may dissolve, have unknowns, too, whose equations say that
/// they are zero: so a factor of the matrix fits when they have.
class FlowEquations {
 public:
  /// `smoothing`: c; `isSolid`: as of solidPoints(). Collective.
  FlowEquations(Simulation& simulation, const FlowLaw& law, const std::vector<int>& flowBlocks, double smoothing,
                const std::vector<char>& isSolid);

  /// From those of fewer points, before some of them dissolved: operators are made anew only where that is near.
  /// `earlier` is of no use then. Before setTime().
  void goOnFrom(FlowEquations& earlier);
  /// The operators with the boundaries' values at the solver's time t. Collective.
  void setTime(double t);
  /// From the fields Velocity and Pressure, ghosts included, and the pockets' lambda. [unknowns]
  std::vector<double> residual(bool hasConvection) const;
  /// What drives a flow, m/s: the norm of the residual of a fluid at rest, by velocities of walls and inlets, forces,
  /// and differences of outflows' pressures. A weight counts where pressures would balance it, too. Collective.
  double drive() const;
  /// Of the residual by the unknowns.
  SparseRows matrix(bool hasConvection) const;
  /// The same of some rows of fluid points of this rank, in their order, and of their own unknowns alone.
  SparseRows matrixWithin(const std::vector<std::size_t>& rows, bool hasConvection) const;
  /// y = matrix x, without the matrix, over the unknowns of this rank. Collective.
  void apply(bool hasConvection, const double* x, double* y) const;
  /// Adds `factor` times a change of the unknowns to the fields; ghosts are brought up to date. Collective.
  void add(double factor, const std::vector<double>& change);
  /// tau of the present velocities, and their gradients, for matrix() and apply().
  void refreshSmoothing();
  /// For a first guess: where a pocket's outflows have other pressures than in `before` [points], all of its pressures
  /// change with them, since a flow follows from their differences alone. Collective.
  void followOutflows(const std::vector<double>& before);
  /// No velocity, and everywhere in a pocket the pressure of its outflows, or none: what a fluid at rest has besides is
  /// rounding. Collective.
  void comeToRest();
  /// Pressures of closed pockets get zero mean, and points that are not fluid the boundary's values. Collective.
  void settle(double t);

  const FlowGeometry& geometry() const { return geometry_; }
  const FlowRows& rows() const { return rows_; }
  const FlowPockets& pockets() const { return pockets_; }
  double density() const { return density_; }
  double viscosity() const { return viscosity_; }
  double unit() const { return unit_; }                                   ///< h of the units, m
  std::size_t count() const { return nOfPoints() + ownPockets_.size(); }  ///< unknowns of this rank
  /// The unknown of a row; component n of n dimensions is the pressure.
  std::size_t place(std::size_t row, std::size_t component) const {
    return index(geometry_.possibleOf()[row]) * (n_ + 1) + component;
  }

  /// own[a] += what convection of the present flow makes of a change of the velocities, which `state` has as
  /// flow_products want it, ghosts included; momentum in the residuals' unit.
  void addConvection(std::size_t row, const std::vector<double>& state, double* own) const;
  /// For preconditioners. Of divergences [rows] takes the mean of each closed pocket, which is lambda among the
  /// unknowns `z`, where that is not null. Collective.
  void balancePockets(std::vector<double>& divergence, double* z) const;
  /// Shifts pressures [rows, in the unknowns' unit] of closed pockets to what the residuals `r` say of one of their
  /// points. Collective.
  void shiftPockets(const double* r, std::vector<double>& pressure) const;

  double largestSpeed() const;  ///< of fluid points, all ranks, m/s
  /// Of fluid, walls and inlets, and no less than what rounding of the pressures makes of a fluid at rest, m/s.
  double scaleOfSpeed() const;
  double speedOfRounding() const;      ///< that of the pressures alone, m/s
  double largestCellReynolds() const;  ///< rho |v| h/mu, all ranks
  /// Largest net flow into a closed pocket, over its largest velocity times its width. All ranks.
  double largestNetFlow() const;
  double leakage() const;            ///< largest |lambda|, 1/s
  double largestDivergence() const;  ///< |div v|, all ranks, 1/s

 private:
  static std::size_t index(int point) { return static_cast<std::size_t>(point); }
  std::size_t nOfPoints() const { return index(geometry_.nPossible()) * (n_ + 1); }  ///< unknowns, but for pockets
  long long column(int point, std::size_t component) const;
  void makeRows(double t);
  void numberUnknowns();
  std::vector<std::pair<long long, double>> entriesOf(std::size_t row, std::size_t component, bool hasConvection) const;
  void addMomentumEntries(std::size_t row, std::size_t a, bool hasConvection,
                          std::vector<std::pair<long long, double>>& entries) const;
  std::array<double, 9> gradientAt(std::size_t row) const;
  std::vector<double> presentState() const;
  void addStokes(std::size_t row, const std::vector<double>& state, double* own) const;
  void addLinear(std::size_t row, const std::vector<double>& state, double* own) const;
  std::vector<double> ofPockets(const double* x) const;
  std::vector<double> outflowPressures(const double* pressure) const;
  double speed(int point) const;

  Simulation& simulation_;
  Model& model_;
  FlowGeometry geometry_;
  const double smoothing_, density_, viscosity_;
  const std::size_t n_;         ///< components of the velocity
  double unit_ = 0.0;           ///< h of the units, m
  double time_ = -HUGE_VAL;     ///< of rows_, s
  long long firstUnknown_ = 0;  ///< of this rank
  bool hasRows_ = false;
  FlowRows rows_;
  std::optional<EarlierFlowRows> earlier_;
  FlowPockets pockets_;
  std::vector<double> force_;                     ///< [3 owned points] f, N/m3
  std::vector<double> firstColumn_;               ///< [points] of the unknowns of fluid points
  std::vector<long long> pocketColumn_;           ///< of lambda by pocket; -1: open
  std::vector<double> lambda_;                    ///< by pocket, times unit, m/s
  std::vector<int> ownPockets_;                   ///< closed ones whose lambda is an unknown of this rank
  std::vector<double> tau_;                       ///< [rows] m s/kg
  std::vector<std::array<double, 9>> gradients_;  ///< [rows] dv_a/dx_b at 3a + b, 1/s
};

}  // namespace pd

#endif
