#include "implicit_step.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "field_names.hpp"

namespace pd {

namespace {

const std::string rateField = fluxDivergenceField("Concentration");

constexpr int isIndefinite = -1, stillGoing = -2;

}  // namespace

/// From fields alone, so that a restarted run makes the same guess.
void ImplicitStep::guessSaturated(const Fields& fields) {
  isFree_.resize(ids_.size());
  for (std::size_t k = 0; k < ids_.size(); ++k) {
    const int i = ids_[k];
    isFree_[k] = isUnknown_[k] != 0 && !(fields.area[i] > 0.0 && fields.salt[i] > 0.0);
    if (isUnknown_[k] != 0 && isFree_[k] == 0) fields.concentration[i] = fields.saturation[i];
  }
}

double ImplicitStep::dot(Model& model, const Fields& fields, const std::vector<double>& a,
                         const std::vector<double>& b) const {
  double sum = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) sum += fields.volume[ids_[k]] * a[k] * b[k];
  return model.comm().sum(sum);
}

/// residual_ = C_old + h rate - C where C is unknown; returns the largest, relative to saturation. Saturated points
/// have none: there S takes up the difference.
double ImplicitStep::residual(Model& model, const Fields& fields, double h) {
  if (pauses())
    setSalt(model, fields, paused_);
  else
    coverWithSalt(fields, 0.0);
  model.importGhosts("Concentration");
  model.evaluateFluxDivergence(h, rateField, true);
  double largest = 0.0;
  for (std::size_t k = 0; k < ids_.size(); ++k) {
    const int i = ids_[k];
    inflow_[k] = exchange_[k] * (farValue_[k] - fields.concentration[i]);
    residual_[k] = isUnknown_[k] != 0 ? before_[k] + h * (fields.rate[i] + inflow_[k]) - fields.concentration[i] : 0.0;
    slope_[k] = pauses() ? (1.0 - paused_[k]) * fields.slope[i] : fields.slope[i];
    if (isFree_[k] != 0) largest = std::max(largest, std::abs(residual_[k]) / fields.saturation[i]);
  }
  return model.comm().max(largest);
}

/// From the residual with bare surfaces everywhere. Returns whether any point has changed sides.
bool ImplicitStep::updateSaturated(Model& model, const Fields& fields, double tolerance) {
  if (pauses()) return false;
  bool hasChanged = false;
  for (std::size_t k = 0; k < ids_.size(); ++k) {
    const int i = ids_[k];
    if (isUnknown_[k] == 0 || fields.area[i] == 0.0) continue;
    const double excess = fields.concentration[i] - fields.saturation[i], small = tolerance * fields.saturation[i];
    const bool isSaturated = isFree_[k] == 0 ? residual_[k] > -small : excess > small;
    if (isSaturated && isFree_[k] != 0) fields.concentration[i] = fields.saturation[i];
    hasChanged = hasChanged || isSaturated != (isFree_[k] == 0);
    isFree_[k] = isSaturated ? 0 : 1;
  }
  return model.comm().any(hasChanged);
}

/// image = (1 - h L - h s' + h k) direction at free points, k: exchange with the far field. The flux of an electrolyte
/// whose surfaces salt covers is linear.
void ImplicitStep::applyMatrix(Model& model, const Fields& fields, double h, const std::vector<double>& direction,
                               std::vector<double>& image) {
  for (std::size_t k = 0; k < ids_.size(); ++k) fields.concentration[ids_[k]] = direction[k];
  model.importGhosts("Concentration");
  model.evaluateFluxDivergence(h, rateField, true);
  for (std::size_t k = 0; k < ids_.size(); ++k)
    image[k] = isFree_[k] != 0 ? (1.0 + h * (exchange_[k] - slope_[k])) * direction[k] - h * fields.rate[ids_[k]] : 0.0;
}

void ImplicitStep::precondition(Model& model, const std::vector<double>& r, std::vector<double>& z) {
  if (preconditioner_.isBuilt())
    preconditioner_.apply(model, ids_, isFree_, r, z);
  else
    z = r;
}

int ImplicitStep::conjugateGradients(Model& model, const Fields& fields, double h, double target, int mostIterations) {
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
    // A rate that grows quickly with C makes a long step's matrix indefinite.
    if (!(curvature > 0.0)) return isIndefinite;
    const double length = square / curvature;
    double largest = 0.0;
    for (std::size_t k = 0; k < n; ++k) {
      step_[k] += length * p[k];
      r[k] -= length * image[k];
      largest = std::max(largest, std::abs(r[k]) / fields.saturation[ids_[k]]);
    }
    ++nLinearIterations_;
    if (model.comm().max(largest) <= target) return iteration;
    if (iteration >= mostIterations) return stillGoing;
    precondition(model, r, z);
    const double next = dot(model, fields, r, z);
    for (std::size_t k = 0; k < n; ++k) p[k] = z[k] + next / square * p[k];
    square = next;
  }
  return 0;
}

void ImplicitStep::makePreconditioner(Model& model, double h) {
  preconditioner_.build(model, ids_, isFree_, h);
  builtFor_ = h;
  leastIterations_ = std::numeric_limits<int>::max();
  excess_ = 0;
}

/// step_ from residual_. The preconditioner is made where plain iterations are slow, and again where the iterations
/// that an old one has cost are worth a new one.
bool ImplicitStep::solveLinear(Model& model, const Fields& fields, double h, double target) {
  constexpr int patience = 15;  // iterations that a preconditioner costs, about
  std::vector<double> present(ids_.size());
  for (std::size_t k = 0; k < ids_.size(); ++k) present[k] = fields.concentration[ids_[k]];
  coverWithSalt(fields, 1.0);
  std::fill(step_.begin(), step_.end(), 0.0);
  if (preconditioner_.isBuilt() && (h != builtFor_ || excess_ > patience)) makePreconditioner(model, h);
  const int most = !preconditioner_.isBuilt()                            ? patience
                   : leastIterations_ == std::numeric_limits<int>::max() ? settings_.maximumLinearIterations
                                                                         : leastIterations_ + 2 * patience;
  int taken = conjugateGradients(model, fields, h, target, most);
  if (taken == stillGoing && most < settings_.maximumLinearIterations) {
    makePreconditioner(model, h);
    taken = conjugateGradients(model, fields, h, target, settings_.maximumLinearIterations);
  }
  if (taken == isIndefinite) {
    // A rate that grows so quickly with C mostly ends at saturation: without its slope, the iterations get there.
    std::fill(slope_.begin(), slope_.end(), 0.0);
    std::fill(step_.begin(), step_.end(), 0.0);
    taken = conjugateGradients(model, fields, h, target, settings_.maximumLinearIterations);
  }
  if (taken >= 0 && preconditioner_.isBuilt()) {
    leastIterations_ = std::min(leastIterations_, taken);
    excess_ += taken - leastIterations_;
  }
  for (std::size_t k = 0; k < ids_.size(); ++k) fields.concentration[ids_[k]] = present[k];
  if (taken < 0) trouble_ = fmt::format("the linear system of a step of {:.3g} s is not solved", h);
  return taken >= 0;
}

bool ImplicitStep::iterate(Model& model, const Fields& fields, double h) {
  // As exact as the step before has earned (Eisenstat & Walker, SIAM J. Sci. Comput. 17 (1996) 16).
  constexpr double loosest = 1e-2, tightest = 1e-4;
  double before = 0.0;
  for (int iteration = 0; iteration < settings_.maximumNewtonIterations; ++iteration) {
    double largest = residual(model, fields, h);
    // What rounding leaves of terms that cancel.
    const double roundOff = preconditioner_.isBuilt()
                                ? 8.0 * std::numeric_limits<double>::epsilon() * preconditioner_.largestDiagonal()
                                : 0.0;
    const double tolerance = std::max(settings_.tolerance, roundOff);
    if (updateSaturated(model, fields, tolerance))
      largest = residual(model, fields, h);
    else if (largest <= tolerance)
      return true;
    if (!std::isfinite(largest)) return false;
    const double ratio = before > 0.0 ? largest / before : 1.0;
    const double share = std::clamp(0.9 * ratio * ratio, tightest, loosest);
    before = largest;
    if (!solveLinear(model, fields, h, std::max(0.1 * tolerance, share * largest))) return false;
    for (std::size_t k = 0; k < ids_.size(); ++k) fields.concentration[ids_[k]] += step_[k];
    ++nNewtonIterations_;
  }
  return false;
}

/// The salt that the step needs, and the step by rates.
void ImplicitStep::finish(Model& model, const Fields& fields, double h) {
  for (std::size_t k = 0; k < ids_.size() && !pauses(); ++k) {
    const int i = ids_[k];
    if (isUnknown_[k] != 0 && isFree_[k] == 0 && fields.dissolution[i] > 0.0)
      fields.salt[i] = std::clamp(residual_[k] / (h * fields.dissolution[i]), 0.0, 1.0);
  }
  model.importGhosts("Salt_Coverage");
  model.evaluateFluxDivergence(h, rateField, true);
  for (std::size_t k = 0; k < ids_.size(); ++k) {
    const int i = ids_[k];
    inflow_[k] = exchange_[k] * (farValue_[k] - fields.concentration[i]);
    rate_[k] = fields.rate[i] + inflow_[k];
    fields.concentration[i] = isUnknown_[k] != 0 ? before_[k] + h * rate_[k] : before_[k];
  }
  for (std::size_t k = 0; k < solidBefore_.size(); ++k) {
    const int i = solidIds_[k];
    fields.concentration[i] = solidBefore_[k] + h * fields.rate[i];
  }
}

bool ImplicitStep::advance(Model& model, const Fields& fields, double h) {
  for (auto* values : {&residual_, &step_, &slope_}) values->resize(ids_.size());
  if (pauses()) {
    findPaused(fields, paused_);
    isFree_ = isUnknown_;
  } else {
    guessSaturated(fields);
  }
  if (!iterate(model, fields, h)) return false;
  finish(model, fields, h);
  return true;
}

std::string ImplicitStep::work() const {
  return fmt::format("{} Newton and {} linear iterations", nNewtonIterations_, nLinearIterations_);
}

}  // namespace pd
