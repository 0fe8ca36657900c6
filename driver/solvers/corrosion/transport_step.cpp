#include "transport_step.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "field_names.hpp"

namespace pd {

const std::string lastTransportRate = "Last_Transport_Rate";

namespace {

const std::string rateField = fluxDivergenceField("Concentration");

}  // namespace

TransportStep::Fields::Fields(Model& model)
    : nOwned(model.nOwned()),
      nPoints(model.nPoints()),
      concentration(model.field("Concentration")),
      rate(model.field(rateField)),
      salt(model.field("Salt_Coverage")),
      dissolution(model.field("Dissolution_Rate")),
      slope(model.field("Dissolution_Rate_Slope")),
      saturation(model.field("Saturation_Concentration")),
      volume(model.field("Volume")),
      area(model.field("Interface_Area_Density")),
      lastRate(model.field(lastTransportRate)) {}

/// Salt_Coverage of all points that are liquid here or elsewhere.
void TransportStep::coverWithSalt(const Fields& fields, double coverage) const {
  for (const int i : ids_) fields.salt[i] = coverage;
  std::fill(fields.salt + fields.nOwned, fields.salt + fields.nPoints, coverage);
}

void TransportStep::begin(Simulation& simulation, const Fields& fields) {
  const std::vector<char>& isHeld = simulation.conditions.valueIsPrescribed("Concentration");
  const std::size_t n = ids_.size();
  for (auto* values : {&before_, &residual_, &step_, &slope_, &rate_}) values->resize(n);
  isUnknown_.resize(n);
  isFree_.resize(n);
  for (std::size_t k = 0; k < n; ++k) {
    const int i = ids_[k];
    before_[k] = fields.concentration[i];
    isUnknown_[k] = isHeld[static_cast<std::size_t>(i)] == 0;
    // A guess, from fields alone, so that a restarted run makes the same.
    isFree_[k] = isUnknown_[k] != 0 && !(fields.area[i] > 0.0 && fields.salt[i] > 0.0);
  }
}

double TransportStep::dot(Model& model, const Fields& fields, const std::vector<double>& a,
                          const std::vector<double>& b) const {
  double sum = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) sum += fields.volume[ids_[k]] * a[k] * b[k];
  return model.comm().sum(sum);
}

/// residual_ = C_old + h rate - C where C is unknown; returns the largest, relative to saturation. Saturated points
/// have none: there S takes up the difference.
double TransportStep::residual(Model& model, const Fields& fields, double h) {
  coverWithSalt(fields, 0.0);
  model.importGhosts("Concentration");
  model.evaluateFluxDivergence(h, rateField, true);
  double largest = 0.0;
  for (std::size_t k = 0; k < ids_.size(); ++k) {
    const int i = ids_[k];
    residual_[k] = isUnknown_[k] != 0 ? before_[k] + h * fields.rate[i] - fields.concentration[i] : 0.0;
    slope_[k] = fields.slope[i];
    if (isFree_[k] != 0) largest = std::max(largest, std::abs(residual_[k]) / fields.saturation[i]);
  }
  return model.comm().max(largest);
}

/// From the residual with bare surfaces everywhere. Returns whether any point has changed sides.
bool TransportStep::updateSaturated(Model& model, const Fields& fields) {
  bool hasChanged = false;
  for (std::size_t k = 0; k < ids_.size(); ++k) {
    const int i = ids_[k];
    if (isUnknown_[k] == 0 || fields.area[i] == 0.0) continue;
    const double excess = fields.concentration[i] - fields.saturation[i];
    const bool isSaturated = isFree_[k] == 0 ? residual_[k] > 0.0 : excess > 1e-12 * fields.saturation[i];
    if (isSaturated && isFree_[k] != 0) fields.concentration[i] = fields.saturation[i];
    hasChanged = hasChanged || isSaturated != (isFree_[k] == 0);
    isFree_[k] = isSaturated ? 0 : 1;
  }
  return model.comm().any(hasChanged);
}

/// image = (1 - h L - h s') direction at free points. The flux of an electrolyte whose surfaces salt covers is linear.
void TransportStep::applyMatrix(Model& model, const Fields& fields, double h, const std::vector<double>& direction,
                                std::vector<double>& image) {
  for (std::size_t k = 0; k < ids_.size(); ++k) fields.concentration[ids_[k]] = direction[k];
  model.importGhosts("Concentration");
  model.evaluateFluxDivergence(h, rateField, true);
  for (std::size_t k = 0; k < ids_.size(); ++k)
    image[k] = isFree_[k] != 0 ? (1.0 - h * slope_[k]) * direction[k] - h * fields.rate[ids_[k]] : 0.0;
}

void TransportStep::precondition(Model& model, const std::vector<double>& r, std::vector<double>& z) {
  if (preconditioner_.isBuilt())
    preconditioner_.apply(model, ids_, isFree_, r, z);
  else
    z = r;
}

int TransportStep::conjugateGradients(Model& model, const Fields& fields, double h, double target, int mostIterations) {
  const std::size_t n = ids_.size();
  std::vector<double> r(n), p, z(n), image(n);
  applyMatrix(model, fields, h, step_, image);
  for (std::size_t k = 0; k < n; ++k) r[k] = isFree_[k] != 0 ? residual_[k] - image[k] : 0.0;
  precondition(model, r, z);
  p = z;
  double square = dot(model, fields, r, z);
  for (int iteration = 1; square != 0.0; ++iteration) {
    applyMatrix(model, fields, h, p, image);
    const double curvature = dot(model, fields, p, image);
    // A rate that grows quickly with C makes a long step indefinite.
    if (!(curvature > 0.0)) return -1;
    const double length = square / curvature;
    double largest = 0.0;
    for (std::size_t k = 0; k < n; ++k) {
      step_[k] += length * p[k];
      r[k] -= length * image[k];
      largest = std::max(largest, std::abs(r[k]) / fields.saturation[ids_[k]]);
    }
    ++nLinearIterations;
    if (model.comm().max(largest) <= target) return iteration;
    if (iteration >= mostIterations) return -2;
    precondition(model, r, z);
    const double next = dot(model, fields, r, z);
    for (std::size_t k = 0; k < n; ++k) p[k] = z[k] + next / square * p[k];
    square = next;
  }
  return 0;
}

/// step_ from residual_. The preconditioner is made where it pays, and again where it has grown old.
bool TransportStep::solveLinear(Model& model, const Fields& fields, double h, double target) {
  constexpr int patience = 15;
  const std::vector<double> present = [&] {
    std::vector<double> values;
    for (const int i : ids_) values.push_back(fields.concentration[i]);
    return values;
  }();
  coverWithSalt(fields, 1.0);
  std::fill(step_.begin(), step_.end(), 0.0);
  const bool wasBuilt = preconditioner_.isBuilt();
  int taken = conjugateGradients(model, fields, h, target, wasBuilt ? 2 * leastIterations_ + patience : patience);
  if (taken == -2) {
    for (std::size_t k = 0; k < ids_.size(); ++k) fields.concentration[ids_[k]] = present[k];
    preconditioner_.build(model, ids_, isFree_, h);
    ++nPreconditioners;
    taken = conjugateGradients(model, fields, h, target, settings_.maximumLinearIterations);
    leastIterations_ = std::max(taken, 0);
  } else if (taken > 0) {
    leastIterations_ = std::min(leastIterations_, taken);
  }
  for (std::size_t k = 0; k < ids_.size(); ++k) fields.concentration[ids_[k]] = present[k];
  if (taken < 0) trouble_ = fmt::format("the linear system of a step of {:.3g} s is not solved", h);
  return taken >= 0;
}

bool TransportStep::iterate(Model& model, const Fields& fields, double h) {
  for (int iteration = 0; iteration < settings_.maximumNewtonIterations; ++iteration) {
    double largest = residual(model, fields, h);
    // What rounding leaves of terms that cancel.
    const double roundOff = preconditioner_.isBuilt()
                                ? 8.0 * std::numeric_limits<double>::epsilon() * preconditioner_.largestDiagonal()
                                : 0.0;
    const double tolerance = std::max(settings_.tolerance, roundOff);
    if (updateSaturated(model, fields))
      largest = residual(model, fields, h);
    else if (largest <= tolerance)
      return true;
    if (!std::isfinite(largest)) return false;
    if (!solveLinear(model, fields, h, std::max(0.1 * tolerance, 1e-4 * largest))) return false;
    for (std::size_t k = 0; k < ids_.size(); ++k) fields.concentration[ids_[k]] += step_[k];
    ++nNewtonIterations;
  }
  return false;
}

void TransportStep::takeBack(Model& model) const {
  double* concentration = model.field("Concentration");
  for (std::size_t k = 0; k < ids_.size(); ++k) concentration[ids_[k]] = before_[k];
  for (std::size_t k = 0; k < solidBefore_.size(); ++k) concentration[solidIds_[k]] = solidBefore_[k];
  model.importGhosts("Concentration");
}

/// The salt that the step needs, and the step by rates.
void TransportStep::finish(Model& model, const Fields& fields, double h) {
  for (std::size_t k = 0; k < ids_.size(); ++k) {
    const int i = ids_[k];
    if (isUnknown_[k] != 0 && isFree_[k] == 0 && fields.dissolution[i] > 0.0)
      fields.salt[i] = std::clamp(residual_[k] / (h * fields.dissolution[i]), 0.0, 1.0);
  }
  model.importGhosts("Salt_Coverage");
  model.evaluateFluxDivergence(h, rateField, true);
  for (std::size_t k = 0; k < ids_.size(); ++k) {
    const int i = ids_[k];
    rate_[k] = fields.rate[i];
    fields.concentration[i] = isUnknown_[k] != 0 ? before_[k] + h * rate_[k] : before_[k];
  }
  for (std::size_t k = 0; k < solidBefore_.size(); ++k) {
    const int i = solidIds_[k];
    fields.concentration[i] = solidBefore_[k] + h * fields.rate[i];
  }
}

bool TransportStep::solve(Simulation& simulation, const PhaseLists& lists, double h) {
  Model& model = simulation.model;
  const Fields fields(model);
  ids_ = lists.liquid();
  trouble_.clear();
  solidBefore_.clear();
  solidIds_ = lists.dissolving();
  for (const int i : solidIds_) solidBefore_.push_back(fields.concentration[i]);
  model.evaluateFluxDivergence(h, rateField);  // takes up the phases
  begin(simulation, fields);
  // From the rates of the last step.
  for (std::size_t k = 0; k < ids_.size(); ++k) {
    const int i = ids_[k];
    double& c = fields.concentration[i];
    if (isUnknown_[k] != 0 && std::isfinite(fields.lastRate[i]))
      c = std::clamp(c + h * fields.lastRate[i], 0.0, fields.saturation[i]);
    if (isUnknown_[k] != 0 && isFree_[k] == 0) c = fields.saturation[i];
  }
  if (!iterate(model, fields, h)) {
    if (trouble_.empty()) trouble_ = fmt::format("a step of {:.3g} s does not converge", h);
    takeBack(model);
    return false;
  }
  finish(model, fields, h);
  return true;
}

}  // namespace pd
