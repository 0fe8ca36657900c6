#include "stage_equation.hpp"

#include <algorithm>
#include <cmath>

namespace pd {

StageEquation::StageEquation(Model& model, const TransportFields& fields, const Points& points,
                             const std::vector<double>& paused, long long& nEvaluations)
    : model_(model), fields_(fields), points_(points), paused_(paused), nEvaluations_(nEvaluations) {}

void StageEquation::begin(const std::vector<double>& start, double h, const std::vector<double>& least) {
  start_ = start;
  least_ = least;
  h_ = h;
  limitsAreHeld_ = false;
  residual_.resize(ids().size());
  isFree_ = points_.isUnknown;
  isBeyond_.assign(ids().size(), 0);
  for (std::size_t k = 0; k < ids().size() && !pauses(); ++k) {
    const int i = ids()[k];
    if (isFree_[k] == 0 || !(fields_.area[i] > 0.0 && fields_.salt[i] > 0.0)) continue;
    isFree_[k] = 0;
    fields_.concentration[i] = fields_.saturation[i];
  }
}

void StageEquation::limitAgain() {
  for (int i = 0; i < fields_.nPoints; ++i) fields_.limitedAt[i] = std::max(0.0, fields_.concentration[i]);
}

void StageEquation::carryUpwind() { std::fill_n(fields_.limitedAt, fields_.nPoints, 0.0); }

bool StageEquation::isBelowZero() const {
  constexpr double mostOwed = 0.5e-6;  // of saturation: half of what Corrosion lets points owe
  bool isAny = false;
  for (std::size_t k = 0; k < ids().size(); ++k)
    isAny = isAny || (isFree_[k] != 0 && fields_.concentration[ids()[k]] < -mostOwed * fields_.saturation[ids()[k]]);
  return model_.comm().any(isAny);
}

double StageEquation::dot(const std::vector<double>& a, const std::vector<double>& b) const {
  double sum = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) sum += fields_.volume[ids()[k]] * a[k] * b[k];
  return model_.comm().sum(sum);
}

void StageEquation::findRates() {
  model_.evaluateFluxDivergence(h_, fields_.rateLabel, true);
  ++nEvaluations_;
}

void StageEquation::applyJacobian(const std::vector<double>& slope, const std::vector<double>& direction,
                                  std::vector<double>& image) {
  for (std::size_t k = 0; k < ids().size(); ++k) fields_.concentration[ids()[k]] = direction[k];
  model_.importGhosts(fields_.label);
  findRates();
  for (std::size_t k = 0; k < ids().size(); ++k) {
    const double diagonal = 1.0 + h_ * (exchange(k) - slope[k]);
    image[k] = isFree_[k] != 0 ? diagonal * direction[k] - h_ * fields_.rate[ids()[k]] : 0.0;
  }
}

double StageEquation::inflow(std::size_t k) const {
  return points_.exchange[k] * (points_.farValue[k] - fields_.concentration[ids()[k]]);
}

double StageEquation::slope(std::size_t k) const {
  if (isBeyond_[k] != 0) return 0.0;
  const double slope = fields_.slope[ids()[k]];
  return pauses() ? (1.0 - paused_[k]) * slope : slope;
}

double StageEquation::evaluate() {
  if (pauses())
    fields_.setSalt(model_, ids(), paused_);
  else
    fields_.coverWithSalt(ids(), 0.0);
  model_.importGhosts(fields_.label);
  if (!limitsAreHeld_) fields_.limitHere();
  findRates();
  double largest = 0.0;
  for (std::size_t k = 0; k < ids().size(); ++k) {
    const int i = ids()[k];
    const double c = fields_.concentration[i];
    residual_[k] = points_.isUnknown[k] != 0 ? start_[k] + h_ * (fields_.rate[i] + inflow(k)) - c : 0.0;
    if (isBeyond_[k] != 0) residual_[k] -= h_ * (fields_.dissolution[i] - least_[k]);
    if (isFree_[k] != 0) largest = std::max(largest, std::abs(residual_[k]) / fields_.saturation[i]);
  }
  return model_.comm().max(largest);
}

bool StageEquation::release(double tolerance) {
  if (pauses()) return false;
  bool isAny = false;
  for (std::size_t k = 0; k < ids().size(); ++k) {
    const int i = ids()[k];
    if (!isHeld(k)) continue;
    const double small = tolerance * fields_.saturation[i], widest = h_ * (fields_.dissolution[i] - least_[k]);
    isBeyond_[k] = residual_[k] > widest + small;
    isFree_[k] = residual_[k] <= -small || isBeyond_[k] != 0;
    isAny = isAny || isFree_[k] != 0;
  }
  return model_.comm().any(isAny);
}

bool StageEquation::hold(double tolerance) {
  if (pauses()) return false;
  bool isAny = false;
  for (std::size_t k = 0; k < ids().size(); ++k) {
    const int i = ids()[k];
    if (isFree_[k] == 0 || fields_.area[i] == 0.0) continue;
    const double excess = fields_.concentration[i] - fields_.saturation[i], small = tolerance * fields_.saturation[i];
    if (isBeyond_[k] != 0 ? excess >= -small : excess <= small) continue;
    fields_.concentration[i] = fields_.saturation[i];
    isFree_[k] = isBeyond_[k] = 0;
    isAny = true;
  }
  return model_.comm().any(isAny);
}

void StageEquation::setSalt() {
  for (std::size_t k = 0; k < ids().size() && !pauses(); ++k) {
    const int i = ids()[k];
    const double dissolution = fields_.dissolution[i];
    if ((!isHeld(k) && isBeyond_[k] == 0) || !(dissolution > 0.0)) continue;
    const double most = 1.0 - least_[k] / dissolution;
    fields_.salt[i] = isBeyond_[k] != 0 ? most : std::clamp(residual_[k] / (h_ * dissolution), 0.0, most);
  }
  model_.importGhosts("Salt_Coverage");
}

}  // namespace pd
