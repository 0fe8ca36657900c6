#include "flow_jumps.hpp"

#include <algorithm>
#include <cmath>

#include "../../model/collective.hpp"

namespace pd {

namespace {

/// Up to this many spacings from a jump the divergence is a balance of mass. (On a lattice points are whole numbers of
/// spacings apart: those at this very distance are within it, however they are rounded.)
constexpr double jumpReach = 8.0 + 1e-6;
/// Jumps above this part of the largest velocity count.
constexpr double jumpShare = 0.05;

using PlaceVector = std::array<double, 3>;

double distanceOf(const PlaceVector& a, const PlaceVector& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

/// How far the velocities of two walls differ beside the point, m/s.
double largestJump(const FlowGeometry& geometry, int point, const std::vector<FlowGeometry::End>& ends, double t) {
  using End = FlowGeometry::End;
  const double reach = geometry.spacingOf(point);
  const auto velocity = [&](const End& wall, const PlaceVector& place) {
    return geometry.wallVelocity(wall.boundary, place, t);
  };
  double largest = 0.0;
  for (std::size_t k = 0; k < ends.size(); ++k)
    for (std::size_t m = 0; m < k; ++m) {
      const End &one = ends[k], &other = ends[m];
      const bool areWalls = one.kind == FlowGeometry::Kind::Wall && other.kind == FlowGeometry::Kind::Wall;
      if (!areWalls || one.boundary == other.boundary) continue;
      const PlaceVector here = geometry.placeOn(point, one, one.fraction);
      const PlaceVector there = geometry.placeOn(point, other, other.fraction);
      if (distanceOf(here, there) > reach) continue;
      // An inlet's profile that ends in the velocity of the wall does not jump, however near to it bonds end.
      largest = std::max(largest, std::min(distanceOf(velocity(one, here), velocity(other, here)),
                                           distanceOf(velocity(one, there), velocity(other, there))));
    }
  return largest;
}

}  // namespace

bool FlowJumps::areNear(const FlowGeometry& geometry, int point) const {
  const double* x = &geometry.mesh().x[3 * static_cast<std::size_t>(point)];
  const double reach = jumpReach * geometry.spacingOf(point);
  for (std::size_t k = 0; k < places.size(); k += 3)
    if (std::hypot(x[0] - places[k], x[1] - places[k + 1], x[2] - places[k + 2]) < reach) return true;
  return false;
}

FlowJumps findFlowJumps(const FlowGeometry& geometry, const Communicator& comm, double t) {
  FlowJumps jumps;
  std::vector<std::pair<int, double>> found;
  collectively(comm, [&] {
    for (const int point : geometry.fluid()) {
      if (!geometry.isNearBoundary(point)) continue;
      const std::vector<FlowGeometry::End> ends = geometry.endsOf(point);
      for (const FlowGeometry::End& end : ends) {
        if (end.kind != FlowGeometry::Kind::Wall) continue;
        const PlaceVector velocity = geometry.wallVelocity(end.boundary, geometry.placeOn(point, end, end.fraction), t);
        jumps.largestVelocity = std::max(jumps.largestVelocity, std::hypot(velocity[0], velocity[1], velocity[2]));
      }
      found.emplace_back(point, largestJump(geometry, point, ends, t));
    }
  });
  jumps.largestVelocity = comm.max(jumps.largestVelocity);
  std::vector<double> places;
  for (const auto& [point, jump] : found) {
    if (!(jump > jumpShare * jumps.largestVelocity)) continue;
    const double* x = &geometry.mesh().x[3 * static_cast<std::size_t>(point)];
    places.insert(places.end(), x, x + 3);
  }
  jumps.places = comm.gather(places);
  return jumps;
}

}  // namespace pd
