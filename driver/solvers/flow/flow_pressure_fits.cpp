#include "flow_pressure_fits.hpp"

#include <cmath>

namespace pd {

const PressureFit& PressureFits::at(int point, const std::vector<int>& candidates) {
  const auto found = fits_.find(point);
  if (found != fits_.end()) return found->second;
  const std::vector<End> ends =
      geometry_.compactEndsOf(point, point < geometry_.mesh().nOwned ? geometry_.neighborsOf(point) : candidates);
  std::vector<End> used, fluid;
  for (const End& end : ends) {
    const bool isOpen = end.openFraction <= 1.0;
    if (isOpen || end.kind == FlowGeometry::Kind::Fluid) used.push_back(end);
    if (!isOpen && end.kind == FlowGeometry::Kind::Fluid) fluid.push_back(end);
  }
  PressureFit fit;
  if (!used.empty()) {
    const std::vector<double> weights = kernels::linearGradientWeights(wholeBonds(used));
    Vector opposite{};
    for (std::size_t k = 0; k < used.size(); ++k) {
      Vector weight{};
      for (std::size_t a = 0; a < n_; ++a) {
        weight[a] = weights[n_ * k + a];
        opposite[a] -= weight[a];
      }
      if (used[k].openFraction > 1.0)
        fit.terms.push_back({used[k].point, used[k].copy, weight});
      else
        addMirroredPressure(point, used[k], fluid, weight, fit);
    }
    fit.terms.push_back({geometry_.mesh().sourceOf(point), geometry_.mesh().copyOf(point), opposite});
  }
  return fits_.emplace(point, std::move(fit)).first->second;
}

kernels::BondEnds PressureFits::wholeBonds(const std::vector<End>& ends) const {
  kernels::BondEnds bonds;
  bonds.dimension = geometry_.dimension();
  for (const End& end : ends) bonds.add(end.xi.data(), end.volume);
  return bonds;
}

void PressureFits::addMirroredPressure(int point, const End& end, const std::vector<End>& fluid, const Vector& weight,
                                       PressureFit& fit) {
  const Vector seen = geometry_.mirrored(point, end);
  Vector place;  // between the end and what is seen in its place, where the bond itself need not pass
  for (std::size_t a = 0; a < 3; ++a)
    place[a] = geometry_.mesh().x[3 * static_cast<std::size_t>(point) + a] + 0.5 * (end.xi[a] + seen[a]);
  const double pressure = geometry_.outflowPressure(end.outflow, place, t_);
  Vector twice{};
  for (std::size_t a = 0; a < n_; ++a) {
    twice[a] = 2.0 * weight[a];
    fit.constant[a] += pressure * twice[a];
  }
  for (const auto& source : sources_.at(end.outflow, place, true, twice)) fit.sources.push_back(source);
  const auto add = [&](int other, int copy, double share) {
    Vector part{};
    for (std::size_t a = 0; a < n_; ++a) part[a] = -share * weight[a];
    fit.terms.push_back({other, copy, part});
  };
  const std::vector<double> shares = sharesAt(point, fluid, seen);
  double rest = 1.0;
  for (std::size_t k = 0; k < shares.size(); ++k) {
    if (shares[k] != 0.0) add(fluid[k].point, fluid[k].copy, shares[k]);
    rest -= shares[k];
  }
  if (rest != 0.0) add(geometry_.mesh().sourceOf(point), geometry_.mesh().copyOf(point), rest);
}

/// Of the ends in the value at a place `seen` from the point, whose share is the rest: of the one that is there, or
/// of a linear fit.
std::vector<double> PressureFits::sharesAt(int point, const std::vector<End>& ends, const Vector& seen) const {
  const double near = 1e-3 * geometry_.spacingOf(point);
  std::vector<double> shares(ends.size(), 0.0);
  if (std::hypot(seen[0], seen[1], seen[2]) < near) return shares;
  for (std::size_t k = 0; k < ends.size(); ++k)
    if (std::hypot(ends[k].xi[0] - seen[0], ends[k].xi[1] - seen[1], ends[k].xi[2] - seen[2]) < near) {
      shares[k] = 1.0;
      return shares;
    }
  return kernels::interpolationWeights(wholeBonds(ends), seen.data(), 1);
}

void PressureFits::forget() {
  constexpr std::size_t most = 50000;
  if (fits_.size() > most) fits_.clear();
}

}  // namespace pd
