#include "assembled_stage.hpp"

#include <algorithm>
#include <cmath>

#include "../diffusion/scalar_unknown.hpp"

namespace pd {

void AssembledStage::assemble(StageEquation& equation, const std::vector<double>& slope) {
  Model& model = equation.model();
  const std::vector<int>& ids = equation.ids();
  if (!system_) system_ = std::make_unique<LinearSystem>(model.comm(), model.discretization(), 1, false);
  system_->putScalar(0.0);
  {
    const ScalarUnknown unknown(equation.fields().label);
    model.assembleJacobian(equation.h(), *system_);
  }
  const Timers::Scope timer(model.timers(), "matrix assembly");
  system_->scale(-equation.h());
  std::vector<double> isHeld(static_cast<std::size_t>(model.nPoints()), 1.0);
  for (std::size_t k = 0; k < ids.size(); ++k) {
    if (equation.isFree()[k] == 0) continue;
    isHeld[static_cast<std::size_t>(ids[k])] = 0.0;
    system_->addToDiagonal(ids[k], 0,
                           equation.fields().volume[ids[k]] * (1.0 + equation.h() * (equation.exchange(k) - slope[k])));
  }
  model.exchange().import(isHeld.data(), 1, Reflection::Even);
  system_->finish({isHeld.begin(), isHeld.end()});
  const std::vector<double> diagonal = system_->diagonal();
  largestDiagonal_ = 1.0;
  for (std::size_t k = 0; k < ids.size(); ++k)
    if (equation.isFree()[k] != 0)
      largestDiagonal_ =
          std::max(largestDiagonal_, diagonal[static_cast<std::size_t>(ids[k])] / equation.fields().volume[ids[k]]);
  largestDiagonal_ = model.comm().max(largestDiagonal_);
}

int AssembledStage::solve(StageEquation& equation, const std::vector<double>& slope, double tolerance,
                          int mostIterations, std::vector<double>& step) {
  assemble(equation, slope);
  const std::vector<int>& ids = equation.ids();
  const auto nOwned = static_cast<std::size_t>(equation.model().nOwned());
  std::vector<double> right(nOwned, 0.0), solution(nOwned, 0.0);
  for (std::size_t k = 0; k < ids.size(); ++k)
    if (equation.isFree()[k] != 0)
      right[static_cast<std::size_t>(ids[k])] = equation.fields().volume[ids[k]] * equation.residual()[k];
  const Timers::Scope timer(equation.model().timers(), "linear solve");
  const LinearSolveReport report =
      system_->solve(right.data(), solution.data(), "GMRES", "ILU", tolerance, mostIterations);
  for (std::size_t k = 0; k < ids.size(); ++k)
    step[k] = equation.isFree()[k] != 0 ? solution[static_cast<std::size_t>(ids[k])] : 0.0;
  // What is left of a solve that gains little more is for the next of Newton's steps.
  constexpr double enough = 0.3;
  return report.relativeResidual <= std::max(tolerance, enough) ? report.iterations : -1;
}

}  // namespace pd
