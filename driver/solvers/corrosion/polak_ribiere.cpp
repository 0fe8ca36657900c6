#include "polak_ribiere.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pd {

void PolakRibiere::findFreeResidual(const StageEquation& equation, std::vector<double>& values) const {
  values = equation.residual();
  for (std::size_t k = 0; k < values.size(); ++k)
    if (equation.isFree()[k] == 0) values[k] = 0.0;
}

/// The next direction.
void PolakRibiere::turn(const StageEquation& equation, bool isNew) {
  std::swap(residual_, lastResidual_);
  findFreeResidual(equation, residual_);
  double beta = 0.0;
  if (!isNew) {
    const double square = equation.dot(residual_, residual_), mixed = equation.dot(residual_, lastResidual_);
    beta = std::max(0.0, (square - mixed) / equation.dot(lastResidual_, lastResidual_));
  }
  for (std::size_t k = 0; k < direction_.size(); ++k)
    direction_[k] = residual_[k] + (beta > 0.0 ? beta * direction_[k] : 0.0);
  if (beta > 0.0 && equation.dot(residual_, direction_) <= 0.0) direction_ = residual_;
}

double PolakRibiere::search(StageEquation& equation) {
  constexpr double accuracy = 0.1, firstChange = 1e-3;  // of the slope at the start; of saturation
  constexpr int mostTrials = 20;
  const TransportFields& fields = equation.fields();
  const std::vector<int>& ids = equation.ids();
  if (length_ == 0.0) {
    double steepest = 0.0;
    for (std::size_t k = 0; k < ids.size(); ++k)
      steepest = std::max(steepest, std::abs(direction_[k]) / fields.saturation[ids[k]]);
    length_ = firstChange / equation.model().comm().max(steepest);
  }
  const double startSlope = equation.dot(residual_, direction_);
  double before = 0.0, slopeBefore = startSlope, at = 0.0, next = length_;
  for (int trial = 0; trial < mostTrials; ++trial) {
    for (std::size_t k = 0; k < ids.size(); ++k) fields.concentration[ids[k]] += (next - at) * direction_[k];
    before = at;
    at = next;
    const double largest = equation.evaluate(), slope = equation.dot(equation.residual(), direction_);
    if (!std::isfinite(slope)) break;
    if (std::abs(slope) <= accuracy * startSlope) {
      length_ = at;
      return largest;
    }
    // Where it does not fall, a rate that grows quickly with C is yet to reach saturation.
    const double fall = (slopeBefore - slope) / (at - before);
    next = fall > 0.0 ? std::max(0.0, at + slope / fall) : 2.0 * at;
    slopeBefore = slope;
  }
  return std::numeric_limits<double>::quiet_NaN();
}

bool PolakRibiere::solve(StageEquation& equation) {
  constexpr double settled = 0.1;  // of the residual after the last change of held points
  for (auto* values : {&residual_, &lastResidual_, &direction_}) values->assign(equation.ids().size(), 0.0);
  trouble_.clear();
  length_ = 0.0;
  double largest = equation.evaluate(), calm = tolerance_;
  bool isNew = true;
  for (int iteration = 0; iteration < maximumIterations_; ++iteration) {
    const bool isReleased = largest <= calm && equation.release(tolerance_);
    if (equation.hold(tolerance_) || isReleased) {
      largest = equation.evaluate();
      calm = std::max(tolerance_, settled * largest);
      isNew = true;
    } else if (largest <= tolerance_) {
      return true;
    }
    turn(equation, isNew);
    isNew = false;
    largest = search(equation);
    ++nIterations_;
    if (!std::isfinite(largest)) break;
  }
  trouble_ =
      fmt::format("Polak and Ribiere's iterations leave a residual of {:.2g} of saturation in a stage of {:.3g} s",
                  largest, equation.h());
  return false;
}

std::string PolakRibiere::work() const { return fmt::format("{} iterations of Polak and Ribiere", nIterations_); }

}  // namespace pd
