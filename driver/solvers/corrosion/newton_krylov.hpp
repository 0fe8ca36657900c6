// Newton's method for a stage of dissolution, with conjugate gradients.
#ifndef PD_NEWTON_KRYLOV_HPP
#define PD_NEWTON_KRYLOV_HPP

#include <string>
#include <vector>

#include "asymmetric_stage.hpp"
#include "stage_equation.hpp"
#include "two_level_preconditioner.hpp"

namespace pd {

/// On an active set (Hintermueller, Ito & Kunisch, SIAM J. Optim. 13 (2002) 865), with the analytic Jacobian; each
/// linear system by conjugate gradients without a matrix, with a preconditioner of two levels where they are stiff; by
/// GMRES (asymmetric_stage.hpp) where a flow carries the ions.
class NewtonKrylov : public StageSolver {
 public:
  /// `tolerance`: residual relative to the saturation concentration, at every point.
  NewtonKrylov(double tolerance, int maximumLinearIterations)
      : tolerance_(tolerance), maximumLinearIterations_(maximumLinearIterations) {}

  bool solve(StageEquation& equation) override;
  void forget() override { preconditioner_.discard(); }
  void forgetFactors() override { asymmetric_.forget(); }
  std::string work() const override;

 private:
  bool solveLinear(StageEquation& equation, double target);
  /// Iterations taken, negative where it failed.
  int solveSymmetric(StageEquation& equation, double target);
  int solveAsymmetric(StageEquation& equation, double target);
  double largestDiagonal(double h) const;
  bool holdAgain(StageEquation& equation, int& nHolds);
  void makePreconditioner(const StageEquation& equation);
  /// Conjugate gradients from step_ on; the iterations taken, negative where it failed.
  int conjugateGradients(StageEquation& equation, double target, int mostIterations);
  void precondition(const StageEquation& equation, const std::vector<double>& r, std::vector<double>& z);

  double tolerance_;
  int maximumLinearIterations_;
  std::vector<double> step_, slope_;
  TwoLevelPreconditioner preconditioner_;
  AsymmetricStage asymmetric_;
  bool isAsymmetric_ = false;
  double builtFor_ = 0.0;                 ///< length of stage of the preconditioner
  int leastIterations_ = 0, excess_ = 0;  ///< with it: fewest of a solve; all beyond that
  long long nIterations_ = 0, nLinearIterations_ = 0, nPreconditioners_ = 0, nHeld_ = 0, nUpwind_ = 0;
};

}  // namespace pd

#endif
