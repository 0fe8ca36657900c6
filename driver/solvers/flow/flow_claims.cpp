// Boundaries of a flow that contradict each other, or the axis of a body of revolution.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "../../deck/deck.hpp"
#include "flow_geometry.hpp"

namespace pd {

namespace {

constexpr double onePlace = 1e-9;  // of a bond, of a velocity: what is rounding

double sizeOf(const std::array<double, 3>& v) { return std::hypot(v[0], v[1], v[2]); }

}  // namespace

/// The first point of each kind of trouble on this rank. After findNearBoundary().
void FlowGeometry::checkClaims() const {
  Mistakes mistakes;
  std::set<std::array<int, 3>> told;  // kind and boundaries
  const auto tell = [&](int kind, int one, int other, int point, const std::string& trouble) {
    if (!told.insert({kind, one, other}).second) return;
    const double* x = placeOf(point);
    mistakes.add("", fmt::format("{}: {}; beside point {} at ({:g}, {:g}, {:g}) m", titleOf(one), trouble,
                                 mesh_.globalIds[index(point)] + 1, x[0], x[1], x[2]));
  };
  for (const int point : fluid_) {
    if (!isNearBoundary(point)) continue;
    const std::vector<int> neighbors = neighborsOf(point);
    for (const int neighbor : neighbors) {
      if (ReferenceBond(mesh_.x.data(), point, neighbor).length > law_.gradientHorizon * (1.0 + onePlace)) continue;
      if (const int wall = wallAcrossAxis(point, neighbor, neighbors); wall >= 0)
        tell(0, wall, wall, point,
             "its Velocity has a component across the Axis Of Revolution at the axis, which is no flow; make it zero "
             "there, as with a factor y");
      const std::vector<int> behind = boundariesBefore(neighbor);
      for (const int one : behind) {
        if (cutsAnotherChannel(one, point, neighbor, neighbors))
          tell(1, one, one, point,
               "its Surface also cuts bonds of fluid around which no point of its node set lies, as in a channel "
               "beside it, and would give its pressure to that; let it be positive there, as \"1 - x + 9*(y > 1.5)\" "
               "is above y = 1.5");
        for (const int other : behind)
          if (other < one && claimOnePlace(other, one, point, neighbor))
            tell(2, one, other, point,
                 fmt::format("its Surface and that of {} are one place there, to which they give different values; let "
                             "each be positive where the other is the boundary, as \"max(y, x - 1)\" is zero at y = 0 "
                             "up to x = 1",
                             titleOf(other)));
      }
    }
  }
  mistakes.report();
}

/// Those beyond whose Surface the neighbour lies, wherever the points of their node sets are.
std::vector<int> FlowGeometry::boundariesBefore(int neighbor) const {
  std::vector<int> found;
  for (int b = 0; b < nBoundaries(); ++b)
    if (boundaries_[index(b)]->hasSurface() && boundaries_[index(b)]->surfaceAt(placeOf(neighbor)) < 0.0)
      found.push_back(b);
  return found;
}

/// The wall or inlet that the bond meets, where that has a velocity across the axis beside which the point lies; or -1.
int FlowGeometry::wallAcrossAxis(int point, int neighbor, const std::vector<int>& candidates) const {
  if (!rings().areUsed() || rings().radius(mesh_.x.data(), point) > spacingOf(point)) return -1;
  const End end = endOf(point, neighbor, candidates);
  if (!(end.volume > 0.0) || end.kind != Kind::Wall || end.boundary < 0 || end.openFraction <= 1.0) return -1;
  std::array<double, 3> place = placeOn(point, end, end.fraction);
  place[rings().radial()] = 0.0;
  const std::array<double, 3> velocity = wallVelocity(end.boundary, place, 0.0);
  return std::abs(velocity[rings().radial()]) > onePlace * sizeOf(velocity) ? end.boundary : -1;
}

/// Whether an outflow ends the bond of a point that has none of the points beyond the outflow around it.
bool FlowGeometry::cutsAnotherChannel(int outflow, int point, int neighbor, const std::vector<int>& candidates) const {
  const auto isBeyond = [&](int other) { return isBeyondOutflow(other) && boundaryOf(other) == outflow; };
  if (!isOutflow(outflow) || std::any_of(candidates.begin(), candidates.end(), isBeyond)) return false;
  const End end = endOf(point, neighbor, candidates);
  return end.volume > 0.0 && end.outflow == outflow && end.openFraction <= 1.0;
}

/// Whether both, with different values, end the bond at one place and are parallel there. (Where they cross, as at the
/// corners of a lid, each has its own bonds beside.)
bool FlowGeometry::claimOnePlace(int one, int other, int point, int neighbor) const {
  const FlowBoundary &first = *boundaries_[index(one)], &second = *boundaries_[index(other)];
  const ReferenceBond bond(mesh_.x.data(), point, neighbor);
  End end{};
  end.xi = bond.xi;
  const double fraction = crossing(first, placeOf(point), end);
  if (std::abs(crossing(second, placeOf(point), end) - fraction) > onePlace) return false;
  const std::array<double, 3> place = placeOn(point, end, fraction);
  const std::array<double, 3> normal = normalAt(one, place), otherNormal = normalAt(other, place);
  double cosine = 0.0;
  for (std::size_t a = 0; a < 3; ++a) cosine += normal[a] * otherNormal[a];
  if (cosine < 1.0 - 1e-6) return false;
  if (first.isOutflow() != second.isOutflow() || first.dependsOnTime() || second.dependsOnTime()) return true;
  if (first.isOutflow()) return outflowPressure(one, place, 0.0) != outflowPressure(other, place, 0.0);
  const std::array<double, 3> velocity = wallVelocity(one, place, 0.0), ofOther = wallVelocity(other, place, 0.0);
  return sizeOf({velocity[0] - ofOther[0], velocity[1] - ofOther[1], velocity[2] - ofOther[2]}) >
         onePlace * std::max(sizeOf(velocity), sizeOf(ofOther));
}

}  // namespace pd
