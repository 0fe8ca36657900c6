// The equation of a stage of an implicit method: c - h f(c) = r, with f the flux divergence of the field.
#ifndef PD_IMPLICIT_STAGE_HPP
#define PD_IMPLICIT_STAGE_HPP

#include <memory>
#include <string>
#include <vector>

#include "../../linear/linear_system.hpp"
#include "../damage_watch.hpp"
#include "rate_integrator.hpp"
#include "scalar_rate.hpp"

namespace pd {

/// Solves stages by Newton's method with the matrix V - h dF/dc (V the volumes, F = V f), which is symmetric for
/// conservative fluxes. One matrix and its preconditioner serve as long as h, the held points and the broken bonds
/// stay the same: for a linear flux each stage is one linear solve.
class ImplicitStage {
 public:
  static void declareParameters(ParameterDeclarations& declare);
  explicit ImplicitStage(const Teuchos::ParameterList& parameters);

  /// At the start of an increment: looks whether the matrix is still right.
  void begin(Simulation& simulation, const std::string& field);

  /// From the present values of free points (the first guess); held points keep theirs. `right` [nOwned]. Throws
  /// RunError where no solution is found. Collective.
  void solve(Simulation& simulation, ScalarRate& rate, double t, double h, const std::vector<double>& right);

  /// values = (1 - h df/dc)^-1 values at free points, roughly: what filters the stiff part out of an error estimate.
  void smooth(std::vector<double>& values);

  std::string summary() const;
  // The h of the matrix: after a checkpoint, where a matrix of earlier values is forgotten, a run and its restart must
  // make the same one again, to the last bit.
  double matrixStep() const { return matrixStep_; }
  void setMatrixStep(double h) { matrixStep_ = h; }
  void forgetMatrix() { hasMatrix_ = false; }

 private:
  void assemble(Simulation& simulation, const std::string& field, double h);
  double residual(Simulation& simulation, ScalarRate& rate, double h, const std::vector<double>& right);

  std::string linearSolver_, preconditioner_;
  double linearTolerance_;
  int maximumLinearIterations_;
  std::unique_ptr<LinearSystem> system_;
  std::vector<char> isHeld_;  ///< [nPoints]
  bool hasMatrix_ = false;
  double matrixStep_ = 0.0;  ///< s; 0: none yet
  BondDamageSum bondDamageSum_;
  double bondDamage_ = -1.0;  ///< sum over all bonds when the matrix was made; negative: not known
  double stiffness_ = 0.0;    ///< norm of the diagonal of the matrix
  std::vector<double> residual_, step_;
  long long nSolves_ = 0, nMatrices_ = 0, nLinearIterations_ = 0;
  double largestResidual_ = 0.0;
};

}  // namespace pd

#endif
