#include "explicit_step.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "../diffusion/scalar_unknown.hpp"
#include "Peridigm_SerialMatrix.hpp"

namespace pd {

namespace {

/// Sums of what couples each point to others, of a matrix whose couplings are positive.
class CouplingSums : public PeridigmNS::SerialMatrix {
 public:
  explicit CouplingSums(const Discretization& d) : sums_(static_cast<std::size_t>(d.nGlobal), 0.0) {}

  void addValue(int row, int column, double value) override {
    if (row != column) sums_[static_cast<std::size_t>(row) % sums_.size()] += value;
  }
  void addValues(int n, const int* ids, const double* const* values) override {
    for (int a = 0; a < n; ++a)
      for (int b = 0; b < n; ++b) addValue(ids[a], ids[b], values[a][b]);
  }
  void addBlockDiagonalValues(int, const int*, const double* const*) override {}
  void putScalar(double) override {}

  double of(int globalId) const { return sums_[static_cast<std::size_t>(globalId)]; }

 private:
  std::vector<double> sums_;  ///< by global id, images with what they mirror
};

}  // namespace

void ExplicitStep::Change::resize(std::size_t nLiquid, std::size_t nSolid) {
  liquid.assign(nLiquid, 0.0);
  solid.assign(nSolid, 0.0);
  inflow.assign(nLiquid, 0.0);
}

void ExplicitStep::Change::advance(const StabilizedStage& stage, double h, const Change& rate, const Change& firstRate,
                                   Change& older) {
  const auto combine = [&](std::vector<double>& values, std::vector<double>& before, const std::vector<double>& now,
                           const std::vector<double>& first) {
    for (std::size_t k = 0; k < values.size(); ++k) {
      const double old = values[k];
      values[k] = stage.mu * old + stage.nu * before[k] + h * (stage.muTilde * now[k] + stage.gammaTilde * first[k]);
      before[k] = old;
    }
  };
  combine(liquid, older.liquid, rate.liquid, firstRate.liquid);
  combine(solid, older.solid, rate.solid, firstRate.solid);
  combine(inflow, older.inflow, rate.inflow, firstRate.inflow);
}

void ExplicitStep::Change::add(const Change& other) {
  const auto sum = [](std::vector<double>& values, const std::vector<double>& more) {
    for (std::size_t k = 0; k < values.size(); ++k) values[k] += more[k];
  };
  sum(liquid, other.liquid);
  sum(solid, other.solid);
  sum(inflow, other.inflow);
}

void ExplicitStep::findBound(Model& model, const Fields& fields, double h) {
  // Points only ever turn liquid: as many as before are the same.
  if (!model.comm().any(nOfBound_ == 0 || ids_.size() != nOfBound_)) return;
  const ScalarUnknown unknown(fields.label);
  CouplingSums sums(model.discretization());
  model.assembleJacobian(h, sums);
  const double* volume = model.field("Volume");
  bound_ = 0.0;
  for (std::size_t k = 0; k < ids_.size(); ++k) {
    const int global = model.discretization().globalIds[static_cast<std::size_t>(ids_[k])];
    if (isUnknown_[k] != 0) bound_ = std::max(bound_, sums.of(global) / volume[ids_[k]] + exchange_[k]);
  }
  bound_ = model.comm().max(bound_);
  nOfBound_ = ids_.size();
}

bool ExplicitStep::findSalt(const Fields& fields, double h, const StabilizedStage& stage) {
  bool isAny = false;
  coverage_.assign(ids_.size(), 0.0);
  for (std::size_t k = 0; k < ids_.size(); ++k) {
    const int i = ids_[k];
    if (isUnknown_[k] == 0 || fields.area[i] == 0.0 || !(fields.dissolution[i] > 0.0)) continue;
    const double rate = fields.rate[i] + exchange_[k] * (farValue_[k] - fields.concentration[i]);
    const double result = start_[k] + stage.mu * change_.liquid[k] + stage.nu * older_.liquid[k] +
                          h * (stage.muTilde * rate + stage.gammaTilde * first_.liquid[k]);
    const double excess = result - fields.saturation[i];
    coverage_[k] = std::clamp(excess / (h * stage.muTilde * fields.dissolution[i]), 0.0, 1.0);
    isAny = isAny || coverage_[k] > 0.0;
  }
  return isAny;
}

void ExplicitStep::evaluate(Model& model, const Fields& fields, double h, const StabilizedStage& stage) {
  const auto rates = [&] {
    model.evaluateFluxDivergence(h, fields.rateLabel, true);
    ++nEvaluations_;
  };
  model.importGhosts(fields.label);
  if (!pauses()) {
    fields.coverWithSalt(ids_, 0.0);
    rates();
    if (model.comm().any(findSalt(fields, h, stage))) {
      fields.setSalt(model, ids_, coverage_);
      rates();
    }
  } else {
    rates();
  }
  for (std::size_t k = 0; k < ids_.size(); ++k) {
    const int i = ids_[k];
    now_.inflow[k] = exchange_[k] * (farValue_[k] - fields.concentration[i]);
    now_.liquid[k] = fields.rate[i] + now_.inflow[k];
  }
  for (std::size_t k = 0; k < solidIds_.size(); ++k) now_.solid[k] = fields.rate[solidIds_[k]];
}

void ExplicitStep::takeSubStep(Model& model, const Fields& fields, double h) {
  for (Change* change : {&change_, &older_, &now_, &first_}) change->resize(ids_.size(), solidIds_.size());
  start_.resize(ids_.size());
  for (std::size_t k = 0; k < ids_.size(); ++k) start_[k] = fields.concentration[ids_[k]];
  if (pauses()) {
    findPaused(fields, coverage_);
    fields.setSalt(model, ids_, coverage_);
  }
  for (std::size_t j = 0; j < scheme_.stages.size(); ++j) {
    const StabilizedStage& stage = scheme_.stages[j];
    evaluate(model, fields, h, stage);
    if (j == 0) first_ = now_;  // before, it is 0, as its factor is in the first stage
    change_.advance(stage, h, now_, first_, older_);
    for (std::size_t k = 0; k < ids_.size(); ++k)
      if (isUnknown_[k] != 0) fields.concentration[ids_[k]] = start_[k] + change_.liquid[k];
  }
  total_.add(change_);
  ++nSubSteps_;
}

void ExplicitStep::useScheme(int nStages) {
  mostStages_ = std::max(mostStages_, nStages);
  if (scheme_.stages.size() == static_cast<std::size_t>(nStages)) return;
  if (method_ == ExplicitMethod::Legendre)
    scheme_ = stabilizedScheme(StabilizedFamily::Legendre, nStages);
  else
    scheme_.stages = {{1.0, 0.0, 1.0, 0.0, 1.0}};
}

bool ExplicitStep::advance(Simulation& simulation, const Fields& fields, double, double h) {
  constexpr double margin = 0.9;  // of the longest stable step, in which no point takes more from another than it has
  Model& model = simulation.model;
  findBound(model, fields, h);
  long long nSubSteps = 1;
  if (method_ == ExplicitMethod::Euler) {
    nSubSteps = std::max(1LL, std::llround(std::ceil(h * bound_ / margin)));
    useScheme(1);
    errorFactor_ = 0.5 / static_cast<double>(nSubSteps);
  } else {
    // Gershgorin: no eigenvalue exceeds twice the bound.
    useScheme(requiredStages(StabilizedFamily::Legendre, 2.0 * bound_ * h / margin));
  }
  total_.resize(ids_.size(), solidIds_.size());
  for (long long n = 0; n < nSubSteps; ++n) takeSubStep(model, fields, h / static_cast<double>(nSubSteps));
  bool isFinite = true;
  for (std::size_t k = 0; k < ids_.size(); ++k) {
    rate_[k] = total_.liquid[k] / h;
    inflow_[k] = total_.inflow[k] / h;
    isFinite = isFinite && std::isfinite(total_.liquid[k]);
    fields.concentration[ids_[k]] = before_[k] + (isUnknown_[k] != 0 ? total_.liquid[k] : 0.0);
  }
  for (std::size_t k = 0; k < solidIds_.size(); ++k)
    fields.concentration[solidIds_[k]] = solidBefore_[k] + total_.solid[k];
  return !model.comm().any(!isFinite);
}

std::string ExplicitStep::work() const {
  if (method_ == ExplicitMethod::Euler)
    return fmt::format("{} sub-steps of Euler, {} evaluations", nSubSteps_, nEvaluations_);
  return fmt::format("RKL of at most {} stages, {} evaluations", mostStages_, nEvaluations_);
}

}  // namespace pd
