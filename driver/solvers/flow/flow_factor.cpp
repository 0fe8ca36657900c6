#include "flow_factor.hpp"

#include <algorithm>

namespace pd {

namespace {

/// Of the rows, that may have changed.
constexpr double mostChanged = 0.25;

}  // namespace

FlowFactor::FlowFactor(const Communicator& comm) : comm_(comm), factor_(comm) {}

std::string FlowFactor::make(const FlowEquations& equations, bool hasConvection, FactorPrecision precision) {
  unknowns_.clear();
  around_.reset();
  hasChanged_ = isOld_ = false;
  wasSolid_ = solidOf(equations.geometry());
  return factor_.factor(equations.matrix(hasConvection), precision);
}

bool FlowFactor::isMadeFor(const FlowEquations& equations) const {
  return factor_.isMadeFor(equations.count()) && !isOld_;
}

void FlowFactor::follow(const FlowEquations& equations, bool hasConvection) {
  unknowns_.clear();
  around_.reset();
  hasChanged_ = false;
  if (!isMadeFor(equations)) return;
  const std::vector<std::size_t> rows = rowsAroundChanges(equations.geometry());
  const auto sum = [&](std::size_t ofRank) { return comm_.sum(static_cast<double>(ofRank)); };
  const double nChanged = sum(rows.size());
  isOld_ = nChanged > mostChanged * sum(equations.geometry().fluid().size());
  hasChanged_ = nChanged > 0.0;
  if (isOld_ || rows.empty()) return;
  around_ = std::make_unique<RowInverse>(alone_);
  if (!around_->factor(equations.matrixWithin(rows, hasConvection), FactorPrecision::Single).empty()) return;
  const auto nComponents = static_cast<std::size_t>(equations.geometry().dimension()) + 1;
  for (const std::size_t row : rows)
    for (std::size_t component = 0; component < nComponents; ++component)
      unknowns_.push_back(equations.place(row, component));
}

std::vector<char> FlowFactor::solidOf(const FlowGeometry& geometry) {
  std::vector<char> isSolid(static_cast<std::size_t>(geometry.mesh().nPoints));
  for (std::size_t point = 0; point < isSolid.size(); ++point)
    isSolid[point] = geometry.isSolid(static_cast<int>(point)) ? 1 : 0;
  return isSolid;
}

/// Of fluid points that have dissolved since, or have such neighbours.
std::vector<std::size_t> FlowFactor::rowsAroundChanges(const FlowGeometry& geometry) const {
  const auto hasChanged = [&](int point) {
    return (wasSolid_[static_cast<std::size_t>(point)] != 0) != geometry.isSolid(point);
  };
  std::vector<std::size_t> rows;
  for (std::size_t row = 0; row < geometry.fluid().size(); ++row) {
    const int point = geometry.fluid()[row];
    const std::vector<int> neighbors = geometry.neighborsOf(point);
    if (hasChanged(point) || std::any_of(neighbors.begin(), neighbors.end(), hasChanged)) rows.push_back(row);
  }
  return rows;
}

void FlowFactor::apply(const FlowEquations& equations, bool hasConvection, const double* r, double* z) const {
  if (!hasChanged_) return factor_.apply(r, z);
  const std::size_t count = equations.count();
  std::vector<double> near(count, 0.0), left(count), given(unknowns_.size()), found(unknowns_.size());
  if (!unknowns_.empty()) {
    std::transform(unknowns_.begin(), unknowns_.end(), given.begin(), [&](std::size_t k) { return r[k]; });
    around_->apply(given.data(), found.data());
    for (std::size_t k = 0; k < unknowns_.size(); ++k) near[unknowns_[k]] = found[k];
  }
  equations.apply(hasConvection, near.data(), left.data());
  for (std::size_t k = 0; k < count; ++k) left[k] = r[k] - left[k];
  factor_.apply(left.data(), z);
  for (std::size_t k = 0; k < count; ++k) z[k] += near[k];
}

}  // namespace pd
