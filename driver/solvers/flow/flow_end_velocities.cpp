#include "flow_end_velocities.hpp"

#include <fmt/format.h>

#include <cmath>

#include "../../model/collective.hpp"

namespace pd {

EndVelocities::Vector EndVelocities::ofWall(int point, const End& end) const {
  return geometry_.wallVelocity(end.boundary, geometry_.placeOn(point, end, end.fraction), t_);
}

SourceWeights<double> EndVelocities::sourceOf(int point, const End& end, double weight) {
  return sources_.at(end.boundary, geometry_.placeOn(point, end, end.fraction), false, weight);
}

void EndVelocities::tooFewNeighbors(int point) const {
  const double* x = placeOf(point);
  throw DeckError(
      fmt::format("the neighbours of the fluid point at ({:g}, {:g}, {:g}) m do not suffice for its "
                  "gradients: the gap is too narrow there, or points beyond a wall are missing; they are "
                  "needed one horizon deep. Where points are irregular, a larger Horizon, or Gradient Horizon of the "
                  "material, helps",
                  x[0], x[1], x[2]));
}

kernels::BondEnds EndVelocities::bondsOf(const std::vector<End>& ends, bool areWhole) const {
  kernels::BondEnds bonds;
  bonds.dimension = geometry_.dimension();
  for (const End& end : ends) {
    const double part = areWhole ? 1.0 : end.fraction;
    const Vector xi{part * end.xi[0], part * end.xi[1], part * end.xi[2]};
    bonds.add(xi.data(), end.volume);
  }
  return bonds;
}

EndVelocity EndVelocities::at(int point, const std::vector<End>& ends, const End& end) {
  if (end.kind == FlowGeometry::Kind::Fluid) return {{{end.point, end.copy, 1.0}}};
  if (end.kind == FlowGeometry::Kind::Wall && geometry_.law().reflectsPoints) return reflectedValue(point, ends, end);
  if (end.kind == FlowGeometry::Kind::Wall) return {{}, ofWall(point, end), sourceOf(point, end, 1.0)};
  return mirroredValue(point, ends, geometry_.mirrored(point, end));
}

/// At the place `seen` from the point: of the point that is there, or of a fit to the ends near it.
EndVelocity EndVelocities::mirroredValue(int point, const std::vector<End>& ends, const Vector& seen) {
  const double near = 1e-3 * geometry_.spacingOf(point);
  if (std::hypot(seen[0], seen[1], seen[2]) < near) return {{{point, 0, 1.0}}};
  std::vector<End> usable;
  for (const End& end : ends) {
    if (end.kind == FlowGeometry::Kind::Fluid &&
        std::hypot(end.xi[0] - seen[0], end.xi[1] - seen[1], end.xi[2] - seen[2]) < near)
      return {{{end.point, end.copy, 1.0}}};
    if (end.kind != FlowGeometry::Kind::Beyond) usable.push_back(end);
  }
  const std::vector<double> weights = kernels::interpolationWeights(bondsOf(usable), seen.data(), 2);
  if (weights.empty()) tooFewNeighbors(point);
  EndVelocity value;
  double rest = 1.0;
  for (std::size_t k = 0; k < usable.size(); ++k) {
    rest -= weights[k];
    if (usable[k].kind == FlowGeometry::Kind::Fluid) {
      value.parts.push_back({usable[k].point, usable[k].copy, weights[k]});
    } else {
      const Vector velocity = ofWall(point, usable[k]);
      for (std::size_t a = 0; a < 3; ++a) value.constant[a] += weights[k] * velocity[a];
      for (const auto& source : sourceOf(point, usable[k], weights[k])) value.sources.push_back(source);
    }
  }
  value.parts.push_back({point, 0, rest});
  return value;
}

/// Of the point beyond a wall: twice the wall's velocity less that of the mirrored place.
EndVelocity EndVelocities::reflectedValue(int point, const std::vector<End>& ends, const End& end) {
  requireNormal(point, end);
  const Vector seen = geometry_.mirroredAtWall(point, end);
  Vector foot;
  for (std::size_t a = 0; a < 3; ++a) foot[a] = placeOf(point)[a] + 0.5 * (end.xi[a] + seen[a]);
  EndVelocity value = mirroredValue(point, ends, seen);
  const Vector atFoot = geometry_.wallVelocity(end.boundary, foot, t_);
  for (auto& part : value.parts) part.weight = -part.weight;
  for (auto& [source, share] : value.sources) share = -share;
  for (std::size_t a = 0; a < 3; ++a) value.constant[a] = 2.0 * atFoot[a] - value.constant[a];
  for (const auto& source : sources_.at(end.boundary, foot, false, 2.0)) value.sources.push_back(source);
  return value;
}

void EndVelocities::requireNormal(int point, const End& end) const {
  if (geometry_.normalAt(end.boundary, geometry_.placeOn(point, end, end.fraction)) != Vector{}) return;
  const double* x = placeOf(point);
  throw DeckError(
      fmt::format("the wall beside the fluid point at ({:g}, {:g}, {:g}) m has no Surface, by which \"Walls: Reflected "
                  "Points\" of Navier Stokes mirrors what is beyond it; give it one, or leave Walls out, as with "
                  "metal that dissolves",
                  x[0], x[1], x[2]));
}

}  // namespace pd
