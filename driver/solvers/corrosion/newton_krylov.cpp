#include "newton_krylov.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "../diffusion/scalar_unknown.hpp"

namespace pd {

namespace {

constexpr int isIndefinite = -1, stillGoing = -2, maximumIterations = 50;
/// After so many, Newton's method goes to and fro at the kinks of what a flow carries; how often limits are held then.
constexpr int iterationsAtKinks = 3, mostHolds = 4;

}  // namespace

void NewtonKrylov::precondition(const StageEquation& equation, const std::vector<double>& r, std::vector<double>& z) {
  if (preconditioner_.isBuilt())
    preconditioner_.apply(equation.model(), equation.ids(), equation.isFree(), r, z);
  else
    z = r;
}

int NewtonKrylov::conjugateGradients(StageEquation& equation, double target, int mostIterations) {
  const std::vector<int>& ids = equation.ids();
  const std::size_t n = ids.size();
  std::vector<double> r(n), p, z(n), image(n);
  const bool isAtZero = std::all_of(step_.begin(), step_.end(), [](double value) { return value == 0.0; });
  if (equation.model().comm().any(!isAtZero)) equation.applyJacobian(slope_, step_, image);
  for (std::size_t k = 0; k < n; ++k) r[k] = equation.isFree()[k] != 0 ? equation.residual()[k] - image[k] : 0.0;
  precondition(equation, r, z);
  p = z;
  double square = equation.dot(r, z);
  for (int iteration = 1; square != 0.0; ++iteration) {
    equation.applyJacobian(slope_, p, image);
    const double curvature = equation.dot(p, image);
    // A rate that grows quickly with C makes a long step's matrix indefinite.
    if (!(curvature > 0.0)) return isIndefinite;
    const double length = square / curvature;
    double largest = 0.0;
    for (std::size_t k = 0; k < n; ++k) {
      step_[k] += length * p[k];
      r[k] -= length * image[k];
      largest = std::max(largest, std::abs(r[k]) / equation.fields().saturation[ids[k]]);
    }
    ++nLinearIterations_;
    if (equation.model().comm().max(largest) <= target) return iteration;
    if (iteration >= mostIterations) return stillGoing;
    precondition(equation, r, z);
    const double next = equation.dot(r, z);
    for (std::size_t k = 0; k < n; ++k) p[k] = z[k] + next / square * p[k];
    square = next;
  }
  return 0;
}

void NewtonKrylov::makePreconditioner(const StageEquation& equation) {
  preconditioner_.build(equation.model(), equation.fields().label, equation.ids(), equation.isFree(), equation.h());
  builtFor_ = equation.h();
  leastIterations_ = std::numeric_limits<int>::max();
  excess_ = 0;
  ++nPreconditioners_;
}

/// step_ from the residual.
bool NewtonKrylov::solveLinear(StageEquation& equation, double target) {
  const std::vector<int>& ids = equation.ids();
  double* concentration = equation.fields().concentration;
  const std::vector<double> present(concentration, concentration + equation.fields().nPoints);
  for (std::size_t k = 0; k < ids.size(); ++k) slope_[k] = equation.slope(k);
  equation.fields().coverWithSalt(ids, 1.0);
  std::fill(step_.begin(), step_.end(), 0.0);
  int taken = isAsymmetric_ ? solveAsymmetric(equation, target) : solveSymmetric(equation, target);
  std::copy(present.begin(), present.end(), concentration);
  if (taken < 0) trouble_ = fmt::format("the linear system of a stage of {:.3g} s is not solved", equation.h());
  return taken >= 0;
}

int NewtonKrylov::solveAsymmetric(StageEquation& equation, double target) {
  double largest = 0.0;
  for (std::size_t k = 0; k < equation.ids().size(); ++k)
    if (equation.isFree()[k] != 0)
      largest = std::max(largest, std::abs(equation.residual()[k]) / equation.fields().saturation[equation.ids()[k]]);
  largest = equation.model().comm().max(largest);
  // Beyond an inlet there may be points that are none of the equation's.
  std::fill_n(equation.fields().concentration, equation.fields().nPoints, 0.0);
  // Residuals differ from point to point: that of all is to be smaller by some more.
  const double tolerance = largest > 0.0 ? std::clamp(0.1 * target / largest, 1e-13, 0.1) : 0.1;
  return asymmetric_.solve(equation, slope_, tolerance, step_) ? 0 : -1;
}

/// The preconditioner is made where plain iterations are slow, and again where the iterations that an old one has cost
/// are worth a new one.
int NewtonKrylov::solveSymmetric(StageEquation& equation, double target) {
  constexpr int patience = 15;  // iterations that a preconditioner costs, about
  if (preconditioner_.isBuilt() && (equation.h() != builtFor_ || excess_ > patience)) makePreconditioner(equation);
  const int most = !preconditioner_.isBuilt()                            ? patience
                   : leastIterations_ == std::numeric_limits<int>::max() ? maximumLinearIterations_
                                                                         : leastIterations_ + 2 * patience;
  int taken = conjugateGradients(equation, target, most);
  if (taken == stillGoing && most < maximumLinearIterations_) {
    makePreconditioner(equation);
    taken = conjugateGradients(equation, target, maximumLinearIterations_);
  }
  if (taken == isIndefinite) {
    // A rate that grows so quickly with C mostly ends at saturation: without its slope, the iterations get there.
    std::fill(slope_.begin(), slope_.end(), 0.0);
    std::fill(step_.begin(), step_.end(), 0.0);
    taken = conjugateGradients(equation, target, maximumLinearIterations_);
  }
  if (taken >= 0 && preconditioner_.isBuilt()) {
    leastIterations_ = std::min(leastIterations_, taken);
    excess_ += taken - leastIterations_;
  }
  return taken;
}

/// With limits that are held a solution may be below zero, which the limits of its own values would not let it be. They
/// are held at those, and in the end there are none.
bool NewtonKrylov::holdAgain(StageEquation& equation, int& nHolds) {
  if (nHolds == 0 || nHolds > mostHolds || !equation.isBelowZero()) return false;
  if (nHolds == mostHolds) ++nUpwind_;
  if (nHolds++ == mostHolds)
    equation.carryUpwind();
  else
    equation.limitAgain();
  return true;
}

/// What rounding leaves of terms that cancel goes with it, and it with the length of the stage.
double NewtonKrylov::largestDiagonal(double h) const {
  if (isAsymmetric_) return asymmetric_.largestDiagonal(h);
  return preconditioner_.isBuilt() ? 1.0 + (preconditioner_.largestDiagonal() - 1.0) * h / builtFor_ : 0.0;
}

bool NewtonKrylov::solve(StageEquation& equation) {
  // As exact as the step before has earned (Eisenstat & Walker, SIAM J. Sci. Comput. 17 (1996) 16), or a small
  // residual, of which Newton's method leaves next to the square.
  constexpr double loosest = 1e-2, tightest = 1e-4;
  trouble_.clear();
  step_.resize(equation.ids().size());
  slope_.resize(equation.ids().size());
  isAsymmetric_ = rateIsAsymmetric(equation.model(), equation.fields().label);
  double before = 0.0, part = 1.0;
  int nHolds = 0;
  for (int iteration = 0; iteration < maximumIterations; ++iteration) {
    double largest = equation.evaluate();
    const double roundOff = 8.0 * std::numeric_limits<double>::epsilon() * largestDiagonal(equation.h());
    const double tolerance = std::max(tolerance_, roundOff);
    const bool isReleased = equation.release(tolerance), isHeld = equation.hold(tolerance);
    if (!isReleased && !isHeld && largest <= tolerance && !holdAgain(equation, nHolds)) return true;
    if (isReleased || isHeld || largest <= tolerance) largest = equation.evaluate();
    if (!std::isfinite(largest)) return false;
    const double ratio = before > 0.0 ? largest / before : 1.0;
    const double share = std::clamp(std::min(0.9 * ratio * ratio, 0.1 * largest), tightest, loosest);
    if (isAsymmetric_ && iteration == iterationsAtKinks) {
      equation.holdLimits();
      nHolds = 1;
      ++nHeld_;
    }
    // Until then what lies between is better.
    if (isAsymmetric_)
      part = iteration >= iterationsAtKinks ? 1.0
             : ratio > 0.5 && iteration > 1 ? std::max(0.25, 0.7 * part)
                                            : std::min(1.0, 2.0 * part);
    before = largest;
    if (!solveLinear(equation, std::max(0.1 * tolerance, (isAsymmetric_ ? 0.01 * tightest : share) * largest)))
      return false;
    for (std::size_t k = 0; k < step_.size(); ++k)
      equation.fields().concentration[equation.ids()[k]] += part * step_[k];
    ++nIterations_;
  }
  return false;
}

std::string NewtonKrylov::work() const {
  if (isAsymmetric_)
    return fmt::format("{} Newton iterations, {} of GMRES with {} factors, {} stages with limits held, {} upwind",
                       nIterations_, asymmetric_.nIterations(), asymmetric_.nFactors(), nHeld_, nUpwind_);
  return fmt::format("{} Newton and {} linear iterations with {} preconditioners", nIterations_, nLinearIterations_,
                     nPreconditioners_);
}

}  // namespace pd
