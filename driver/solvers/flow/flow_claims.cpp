// Boundaries of a flow that contradict each other, or the axis of a body of revolution.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "../../deck/deck.hpp"
#include "../../deck/vector3.hpp"
#include "flow_geometry.hpp"

namespace pd {

namespace {

constexpr double rounding = 1e-9;  // of a bond, of a velocity
constexpr double onePlace = 1e-3;  // of a spacing: surfaces nearer than that are one
constexpr double besides = 1.5;    // spacings within which a cut has a point beyond its outflow, on any lattice

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
      if (!law_.gradientsReach(ReferenceBond(mesh_.x.data(), point, neighbor).length)) continue;
      const std::vector<int> behind = boundariesBefore(neighbor);
      for (const int one : behind) {
        if (cutsAnotherChannel(one, point, neighbor, neighbors))
          tell(1, one, one, point,
               "its Surface also cuts bonds of fluid around which no point of its node set lies, as in a channel "
               "beside it, and would give its pressure to that; let it be positive there, as \"1 - x + 9*(y > 1.5)\" "
               "is above y = 1.5");
        else if (const int wall = wallCutAt(one, point, neighbor, neighbors); wall >= 0)
          tell(3, one, wall, point,
               fmt::format("its Surface also ends bonds into {}, with none of its own points around, and fluid leaves "
                           "through that wall; let it be positive there, as \"1 - x + 9*(y > 1.5)\" is above y = 1.5",
                           titleOf(wall)));
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

/// Where bonds of points beside the axis meet walls and inlets, moved to the axis.
void FlowGeometry::findWallsAtAxis() {
  if (!rings().areUsed()) return;
  for (const int point : fluid_) {
    if (!isNearBoundary(point) || rings().radius(mesh_.x.data(), point) > spacingOf(point)) continue;
    for (const End& end : compactEndsOf(point, neighborsOf(point))) {
      if (end.kind != Kind::Wall || end.boundary < 0 || end.openFraction <= 1.0) continue;
      std::array<double, 3> place = placeOn(point, end, end.fraction);
      place[rings().radial()] = 0.0;
      wallsAtAxis_.push_back({end.boundary, point, place});
    }
  }
}

void FlowGeometry::requireNoneAcrossAxis(double t) const {
  for (const auto& [boundary, point, place] : wallsAtAxis_) {
    const std::array<double, 3> velocity = wallVelocity(boundary, place, t);
    if (std::abs(velocity[rings().radial()]) <= rounding * length(velocity)) continue;
    const double* x = placeOf(point);
    throw DeckError(fmt::format(
        "{}: its Velocity has a component across the Axis Of Revolution at the axis, which is no flow; make it zero "
        "there, as with a factor y; beside point {} at ({:g}, {:g}, {:g}) m, t = {:g} s",
        titleOf(boundary), mesh_.globalIds[index(point)] + 1, x[0], x[1], x[2], simulation_.conditions.runTime(t)));
  }
}

/// Whether two outflows, such as one with two node sets, have the same surface and pressure at a place beyond them.
bool FlowGeometry::isOneOutflow(int one, int other, const std::array<double, 3>& place) const {
  if (one == other) return true;
  const FlowBoundary &first = *boundaries_[index(one)], &second = *boundaries_[index(other)];
  if (std::abs(second.surfaceAt(place.data()) / first.surfaceAt(place.data()) - 1.0) > rounding) return false;
  if (first.isGivenAs(second)) return true;
  return !first.dependsOnTime() && !second.dependsOnTime() &&
         outflowPressure(one, place, 0.0) == outflowPressure(other, place, 0.0);
}

/// The wall in whose node set the end of a bond is that the outflow ends, far from all points beyond the outflow; or
/// -1.
int FlowGeometry::wallCutAt(int outflow, int point, int neighbor, const std::vector<int>& candidates) const {
  const int wall = boundaryOf(neighbor);
  if (!isOutflow(outflow) || kindOf(neighbor) != Kind::Wall || wall < 0) return -1;
  const End end = endOf(point, neighbor, candidates);
  if (!(end.volume > 0.0) || end.outflow != outflow || end.openFraction > 1.0) return -1;
  const std::array<double, 3> place = placeOn(point, end, end.openFraction);
  const bool hasOwn = std::any_of(candidates.begin(), candidates.end(), [&](int other) {
    const double* x = placeOf(other);
    return isBeyondOutflow(other) &&
           std::hypot(x[0] - place[0], x[1] - place[1], x[2] - place[2]) <= besides * spacingOf(other);
  });
  return hasOwn ? -1 : wall;
}

/// Whether an outflow ends the bond of a point that has none of the points beyond the outflow around it.
bool FlowGeometry::cutsAnotherChannel(int outflow, int point, int neighbor, const std::vector<int>& candidates) const {
  if (!isOutflow(outflow)) return false;
  const auto isBeyond = [&](int other) {
    const double* x = placeOf(other);
    return isBeyondOutflow(other) && isOneOutflow(outflow, boundaryOf(other), {x[0], x[1], x[2]});
  };
  if (std::any_of(candidates.begin(), candidates.end(), isBeyond)) return false;
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
  if (std::abs(crossing(second, placeOf(point), end) - fraction) * bond.length > onePlace * spacingOf(point))
    return false;
  const std::array<double, 3> place = placeOn(point, end, fraction);
  const std::array<double, 3> normal = normalAt(one, place), otherNormal = normalAt(other, place);
  double cosine = 0.0;
  for (std::size_t a = 0; a < 3; ++a) cosine += normal[a] * otherNormal[a];
  if (cosine < 1.0 - 1e-6) return false;
  if (first.isGivenAs(second)) return false;
  if (first.isOutflow() != second.isOutflow() || first.dependsOnTime() || second.dependsOnTime()) return true;
  if (first.isOutflow()) return outflowPressure(one, place, 0.0) != outflowPressure(other, place, 0.0);
  const std::array<double, 3> velocity = wallVelocity(one, place, 0.0), ofOther = wallVelocity(other, place, 0.0);
  return length(difference(velocity, ofOther)) > rounding * std::max(length(velocity), length(ofOther));
}

}  // namespace pd
