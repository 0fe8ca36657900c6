#include "flow_mass_balance.hpp"

#include <cmath>

#include "exact_weights.hpp"

namespace pd {

void MassBalance::addRow(int point, const std::vector<int>& candidates, FlowOperator<3>& divergence) {
  Facets facets;
  Vector area = addPoints(point, candidates, divergence, facets), constantFlux{};
  // Without walls there would be -1/r left: the divergence of 1 along the radius.
  const kernels::Rings& rings = geometry_.rings();
  if (rings.areUsed()) area[rings.radial()] += 1.0 / rings.radius(geometry_.mesh().x.data(), point);
  splitArea(area, facets);
  for (const auto& [key, facet] : facets) {
    Vector outward{};
    for (std::size_t a = 0; a < n_; ++a) outward[a] = facet.area * facet.normal[a];
    for (double& component : outward) component /= facet.count;
    for (std::size_t a = 0; a < n_; ++a) constantFlux[0] += outward[a] * facet.velocity[a];
    for (const auto& [source, weight] : facet.sources)
      divergence.addShare(source, {weight * outward[0], weight * outward[1], weight * outward[2]});
  }
  divergence.close(point, constantFlux);
}

/// What is in it of points; returns the area vector of the walls around the point, over its volume.
MassBalance::Vector MassBalance::addPoints(int point, const std::vector<int>& candidates, FlowOperator<3>& divergence,
                                           Facets& facets) {
  const Discretization& mesh = geometry_.mesh();
  const auto volume = [&](int p) { return mesh.volume[static_cast<std::size_t>(p)]; };
  Vector area{};
  for (const int other : candidates) {
    if (!geometry_.isFluid(other)) continue;
    if (other != point && !geometry_.law().gradientsReach(ReferenceBond(mesh.x.data(), point, other).length)) continue;
    Vector weight{};
    for (const auto& part : fits_.at(other, candidates).terms)
      if (part.point == point && part.copy == 0)
        for (std::size_t a = 0; a < n_; ++a) weight[a] += part.weight[a] * volume(other) / volume(point);
    for (std::size_t a = 0; a < n_; ++a) area[a] += weight[a];
    Vector term{};
    for (std::size_t a = 0; a < n_; ++a) term[a] = -weight[a] * mesh.symmetry.matrix(mesh.copyOf(other))[4 * a];
    divergence.add(mesh.sourceOf(other), term);
    addFacets(other, candidates, facets);
  }
  return area;
}

void MassBalance::addFacets(int point, const std::vector<int>& candidates, Facets& facets) {
  const std::vector<int> own = point < geometry_.mesh().nOwned ? geometry_.neighborsOf(point) : candidates;
  for (const FlowGeometry::End& end : geometry_.compactEndsOf(point, own)) {
    if (end.kind != FlowGeometry::Kind::Wall || end.openFraction <= 1.0) continue;
    const Vector place = geometry_.placeOn(point, end, end.fraction);
    Facet& facet = facets[end.boundary];
    facet.count += 1.0;
    const Vector normal = geometry_.normalAt(end.boundary, place);
    const Vector velocity = velocities_.ofWall(point, end);
    for (std::size_t a = 0; a < n_; ++a) {
      facet.normal[a] += normal[a];
      facet.velocity[a] += velocity[a];
    }
    for (const auto& source : velocities_.sourceOf(point, end, 1.0)) facet.sources.push_back(source);
  }
}

/// Shares the area vector out among the boundaries' normals, by least squares.
void MassBalance::splitArea(const Vector& area, Facets& facets) const {
  std::vector<Facet*> list;
  for (auto& [key, facet] : facets) {
    const double size = std::hypot(facet.normal[0], facet.normal[1], facet.normal[2]);
    if (size == 0.0) continue;  // the deck does not say where it is, and nothing flows through it
    for (double& component : facet.normal) component /= size;
    if (list.size() < 9) list.push_back(&facet);
  }
  const std::size_t count = list.size();
  std::vector<double> matrix(count * count), share(count, 0.0);
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = 0; j < count; ++j)
      for (std::size_t a = 0; a < n_; ++a) matrix[i * count + j] += list[i]->normal[a] * list[j]->normal[a];
    for (std::size_t a = 0; a < n_; ++a) share[i] += list[i]->normal[a] * area[a];
  }
  kernels::solveNormalEquations(static_cast<int>(count), matrix.data(), share.data());
  for (std::size_t i = 0; i < count; ++i) list[i]->area = share[i];
}

}  // namespace pd
