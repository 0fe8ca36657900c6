#include "transport_step.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "field_names.hpp"

namespace pd {

namespace {

const std::string rateField = fluxDivergenceField("Concentration");

}  // namespace

TransportStep::Fields::Fields(Model& model)
    : concentration(model.field("Concentration")),
      rate(model.field(rateField)),
      salt(model.field("Salt_Coverage")),
      dissolution(model.field("Dissolution_Rate")),
      slope(model.field("Dissolution_Rate_Slope")),
      saturation(model.field("Saturation_Concentration")),
      volume(model.field("Volume")),
      damage(model.field("Damage")),
      area(model.field("Interface_Area_Density")) {}

void TransportStep::findUnknowns(Simulation& simulation, const Fields& fields) {
  const auto n = static_cast<std::size_t>(simulation.model.nOwned());
  const std::vector<char>& isHeld = simulation.conditions.valueIsPrescribed("Concentration");
  isUnknown_.assign(n, 0);
  isSaturated_.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    isUnknown_[i] = fields.damage[i] >= 1.0 && isHeld[i] == 0;
    // A guess, from fields alone, so that a restarted run makes the same.
    isSaturated_[i] = isUnknown_[i] != 0 && fields.area[i] > 0.0 && fields.salt[i] > 0.0;
  }
}

double TransportStep::dot(Simulation& simulation, const Fields& fields, const std::vector<double>& a,
                          const std::vector<double>& b) const {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += fields.volume[i] * a[i] * b[i];
  return simulation.model.comm().sum(sum);
}

/// residual_ = C_old + h rate - C where C is unknown; returns the largest, relative to saturation. Saturated points
/// have none: there S takes up the difference.
double TransportStep::residual(Simulation& simulation, const Fields& fields, double h) {
  Model& model = simulation.model;
  std::fill(fields.salt, fields.salt + model.nPoints(), 0.0);
  model.importGhosts("Concentration");
  model.evaluateFluxDivergence(h, rateField);
  double largest = 0.0;
  for (std::size_t i = 0; i < residual_.size(); ++i) {
    residual_[i] = isUnknown_[i] != 0 ? before_[i] + h * fields.rate[i] - fields.concentration[i] : 0.0;
    slope_[i] = fields.slope[i];
    if (isSaturated_[i] == 0) largest = std::max(largest, std::abs(residual_[i]) / fields.saturation[i]);
  }
  return model.comm().max(largest);
}

/// From the residual with bare surfaces everywhere. Returns whether any point has changed sides.
bool TransportStep::updateSaturated(Simulation& simulation, const Fields& fields) {
  bool hasChanged = false;
  for (std::size_t i = 0; i < residual_.size(); ++i) {
    if (isUnknown_[i] == 0 || fields.area[i] == 0.0) continue;
    const double excess = fields.concentration[i] - fields.saturation[i];
    const bool isSaturated = isSaturated_[i] != 0 ? residual_[i] > 0.0 : excess > 1e-12 * fields.saturation[i];
    if (isSaturated && isSaturated_[i] == 0) fields.concentration[i] = fields.saturation[i];
    hasChanged = hasChanged || isSaturated != (isSaturated_[i] != 0);
    isSaturated_[i] = isSaturated ? 1 : 0;
  }
  return simulation.model.comm().any(hasChanged);
}

/// image = (1 - h L - h s') direction at free points that are not saturated. The flux of an electrolyte whose surfaces
/// salt covers is linear.
void TransportStep::applyMatrix(Simulation& simulation, const Fields& fields, double h,
                                const std::vector<double>& direction, std::vector<double>& image) {
  Model& model = simulation.model;
  std::copy(direction.begin(), direction.end(), fields.concentration);
  model.importGhosts("Concentration");
  model.evaluateFluxDivergence(h, rateField);
  for (std::size_t i = 0; i < image.size(); ++i) {
    const bool isFree = isUnknown_[i] != 0 && isSaturated_[i] == 0;
    image[i] = isFree ? (1.0 - h * slope_[i]) * direction[i] - h * fields.rate[i] : 0.0;
  }
}

/// step_ from residual_; conjugate gradients, the matrix being symmetric in the product weighted by volumes.
bool TransportStep::solveLinear(Simulation& simulation, const Fields& fields, double h, double target) {
  Model& model = simulation.model;
  const std::size_t n = residual_.size();
  const std::vector<double> present(fields.concentration, fields.concentration + n);
  std::fill(fields.salt, fields.salt + model.nPoints(), 1.0);
  std::vector<double> r(n), p, image(n);
  for (std::size_t i = 0; i < n; ++i) r[i] = isSaturated_[i] != 0 ? 0.0 : residual_[i];
  step_.assign(n, 0.0);
  p = r;
  double square = dot(simulation, fields, r, r);
  bool isSolved = square == 0.0;
  for (int k = 0; !isSolved && k < settings_.maximumLinearIterations; ++k) {
    applyMatrix(simulation, fields, h, p, image);
    const double curvature = dot(simulation, fields, p, image);
    // A rate that grows quickly with C makes a long step indefinite.
    if (!(curvature > 0.0)) break;
    const double length = square / curvature;
    double largest = 0.0;
    for (std::size_t i = 0; i < n; ++i) {
      step_[i] += length * p[i];
      r[i] -= length * image[i];
      largest = std::max(largest, std::abs(r[i]) / fields.saturation[i]);
    }
    ++nLinearIterations;
    isSolved = model.comm().max(largest) <= target;
    const double next = dot(simulation, fields, r, r);
    for (std::size_t i = 0; i < n; ++i) p[i] = r[i] + next / square * p[i];
    square = next;
  }
  std::copy(present.begin(), present.end(), fields.concentration);
  if (!isSolved) trouble_ = fmt::format("the linear system of a step of {:.3g} s is not solved", h);
  return isSolved;
}

bool TransportStep::solve(Simulation& simulation, double h) {
  Model& model = simulation.model;
  const Fields fields(model);
  const auto n = static_cast<std::size_t>(model.nOwned());
  before_.assign(fields.concentration, fields.concentration + n);
  residual_.resize(n);
  slope_.resize(n);
  trouble_.clear();
  findUnknowns(simulation, fields);
  for (std::size_t i = 0; i < n; ++i)
    if (isSaturated_[i] != 0) fields.concentration[i] = fields.saturation[i];

  bool hasConverged = false;
  for (int iteration = 0; iteration < settings_.maximumNewtonIterations; ++iteration) {
    double largest = residual(simulation, fields, h);
    if (updateSaturated(simulation, fields))
      largest = residual(simulation, fields, h);
    else if (largest <= settings_.tolerance) {
      hasConverged = true;
      break;
    }
    if (!std::isfinite(largest)) break;
    if (!solveLinear(simulation, fields, h, std::max(0.1 * settings_.tolerance, 1e-4 * largest))) break;
    for (std::size_t i = 0; i < n; ++i) fields.concentration[i] += step_[i];
    ++nNewtonIterations;
  }
  if (!hasConverged) {
    if (trouble_.empty()) trouble_ = fmt::format("a step of {:.3g} s does not converge", h);
    std::copy(before_.begin(), before_.end(), fields.concentration);
    model.importGhosts("Concentration");
    return false;
  }
  for (std::size_t i = 0; i < n; ++i)
    if (isSaturated_[i] != 0 && fields.dissolution[i] > 0.0)
      fields.salt[i] = std::clamp(residual_[i] / (h * fields.dissolution[i]), 0.0, 1.0);
  model.importGhosts("Salt_Coverage");
  model.evaluateFluxDivergence(h, rateField);
  rate_.assign(fields.rate, fields.rate + n);
  const std::vector<char>& isHeld = simulation.conditions.valueIsPrescribed("Concentration");
  for (std::size_t i = 0; i < n; ++i) fields.concentration[i] = isHeld[i] != 0 ? before_[i] : before_[i] + h * rate_[i];
  return true;
}

}  // namespace pd
