#include "implicit_step.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pd {

namespace {

const double gammaOfSdirk = 1.0 - std::sqrt(0.5);

}  // namespace

StageEquation ImplicitStep::equation(Model& model, const Fields& fields) {
  return {model, fields, {ids_, isUnknown_, exchange_, farValue_}, paused_, nEvaluations_};
}

void ImplicitStep::finishStage(StageEquation& equation, Rates& rates) const {
  const TransportFields& fields = equation.fields();
  equation.setSalt();
  equation.findRates();
  for (auto* values : {&rates.liquid, &rates.inflow, &rates.dissolution}) values->resize(ids_.size());
  rates.solid.resize(solidIds_.size());
  for (std::size_t k = 0; k < ids_.size(); ++k) {
    const int i = ids_[k];
    rates.inflow[k] = equation.inflow(k);
    rates.liquid[k] = fields.rate[i] + rates.inflow[k];
    rates.dissolution[k] = fields.area[i] > 0.0 ? (1.0 - fields.salt[i]) * fields.dissolution[i] : 0.0;
  }
  for (std::size_t k = 0; k < solidIds_.size(); ++k) rates.solid[k] = fields.rate[solidIds_[k]];
}

bool ImplicitStep::takeEulerStep(Model& model, const Fields& fields, double h) {
  order_ = 1;
  StageEquation stage = equation(model, fields);
  stage.begin(before_, h, std::vector<double>(ids_.size(), 0.0));
  if (!solver_->solve(stage)) return false;
  finishStage(stage, first_);
  rate_ = first_.liquid;
  inflow_ = first_.inflow;
  for (std::size_t k = 0; k < ids_.size(); ++k)
    if (isUnknown_[k] != 0) fields.concentration[ids_[k]] = before_[k] + h * rate_[k];
  for (std::size_t k = 0; k < solidIds_.size(); ++k)
    fields.concentration[solidIds_[k]] = solidBefore_[k] + h * first_.solid[k];
  return true;
}

bool ImplicitStep::takeTwoStages(Simulation& simulation, const Fields& fields, double t, double h) {
  Model& model = simulation.model;
  order_ = 2;
  setBoundary(simulation, t + gammaOfSdirk * h);
  StageEquation stage = equation(model, fields);
  stage.begin(before_, gammaOfSdirk * h, std::vector<double>(ids_.size(), 0.0));
  if (!solver_->solve(stage)) return false;
  finishStage(stage, first_);

  std::vector<double> start(ids_.size()), least(ids_.size());
  for (std::size_t k = 0; k < ids_.size(); ++k) {
    start[k] = before_[k] + (1.0 - gammaOfSdirk) * h * first_.liquid[k];
    least[k] = -(1.0 - gammaOfSdirk) / gammaOfSdirk * first_.dissolution[k];
  }
  setBoundary(simulation, t + h);
  stage.begin(start, gammaOfSdirk * h, least);
  if (!solver_->solve(stage)) return false;
  finishStage(stage, second_);

  const auto mean = [](double a, double b) { return (1.0 - gammaOfSdirk) * a + gammaOfSdirk * b; };
  for (std::size_t k = 0; k < ids_.size(); ++k) {
    const int i = ids_[k];
    rate_[k] = mean(first_.liquid[k], second_.liquid[k]);
    inflow_[k] = mean(first_.inflow[k], second_.inflow[k]);
    if (isUnknown_[k] != 0) fields.concentration[i] = before_[k] + h * rate_[k];
    // What lies on the surface in the mean, since a stage may take back what the other gives.
    if (!pauses() && fields.salt[i] > 0.0 && fields.dissolution[i] > 0.0)
      fields.salt[i] =
          std::clamp(1.0 - mean(first_.dissolution[k], second_.dissolution[k]) / fields.dissolution[i], 0.0, 1.0);
  }
  for (std::size_t k = 0; k < solidIds_.size(); ++k)
    fields.concentration[solidIds_[k]] = solidBefore_[k] + h * mean(first_.solid[k], second_.solid[k]);
  if (!isWithinBounds(model, fields)) return false;
  // The current of that salt, for results.
  model.importGhosts("Salt_Coverage");
  stage.findRates();
  return true;
}

bool ImplicitStep::isWithinBounds(Model& model, const Fields& fields) const {
  constexpr double undershoot = 1e-6;  // what steps may owe at most
  bool isBeyond = false;
  for (std::size_t k = 0; k < ids_.size(); ++k) {
    const double share = fields.concentration[ids_[k]] / fields.saturation[ids_[k]];
    isBeyond = isBeyond || share < -undershoot || share > fullest();
  }
  return !model.comm().any(isBeyond);
}

bool ImplicitStep::advance(Simulation& simulation, const Fields& fields, double t, double h) {
  paused_.clear();
  if (pauses()) findPaused(fields, paused_);
  if (method_ == ImplicitMethod::Sdirk2) {
    if (takeTwoStages(simulation, fields, t, h)) return true;
    ++nReplaced_;
    simulation.takeBackStep();
    setBoundary(simulation, t + h);
  }
  const bool isSolved = takeEulerStep(simulation.model, fields, h);
  if (!isSolved) trouble_ = solver_->trouble();
  return isSolved;
}

/// Backward Euler: h^2/2 C'', from the change of the rate since the last step. SDIRK2: (3 sqrt(2) - 4)/6 h^3 C''', the
/// first term that its stability function lacks, from the rates at the end of the last step and of both stages.
double ImplicitStep::error(std::size_t k, double lastRate, double h) const {
  if (order_ == 1) return 0.5 * h * (rate_[k] - lastRate);
  const double constant = (3.0 * std::sqrt(2.0) - 4.0) / 6.0;
  const double early = (first_.liquid[k] - lastRate) / gammaOfSdirk;
  const double late = (second_.liquid[k] - first_.liquid[k]) / (1.0 - gammaOfSdirk);
  return 2.0 * constant * h * (late - early);
}

double ImplicitStep::fullest() const {
  constexpr double overshoot = 1e-2;
  return (method_ == ImplicitMethod::Sdirk2 ? 1.0 + overshoot : 1.0) * TransportStep::fullest();
}

std::string ImplicitStep::work() const {
  const std::string replaced = method_ == ImplicitMethod::Sdirk2
                                   ? fmt::format(", {} steps of backward Euler instead of SDIRK2", nReplaced_)
                                   : "";
  return fmt::format("{}, {} evaluations{}", solver_->work(), nEvaluations_, replaced);
}

}  // namespace pd
