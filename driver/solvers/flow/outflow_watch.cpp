#include "outflow_watch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <sstream>

namespace pd {

namespace {

/// Of what leaves, below which it is taken for what corners beside walls let through.
constexpr double leastEntering = 0.01;
/// In spacings: how far from an outflow velocities are looked at, two rows of points.
constexpr double lookedAt = 2.0;

/// Through one outflow.
struct Passing {
  double entering = 0.0, leaving = 0.0;  ///< m3/s
  double fastest = 0.0;                  ///< of what enters, m/s
  int point = -1;                        ///< where that is
};

/// Of an owned fluid point: the nearest outflow that its bonds cross, -1 for none, how far it is, m, and the velocity
/// out of it, m/s.
struct Crossing {
  int outflow = -1;
  double distance = std::numeric_limits<double>::infinity();
  double velocity = 0.0;
};

Crossing crossingOf(const FlowGeometry& geometry, const double* velocity, int point) {
  Crossing nearest;
  const std::vector<int> neighbors = geometry.neighborsOf(point);
  for (const int neighbor : neighbors) {
    if (!geometry.isBeyondOutflow(neighbor)) continue;
    const FlowGeometry::End end = geometry.endOf(point, neighbor, neighbors);
    if (end.volume <= 0.0 || end.openFraction > 1.0) continue;
    const std::array<double, 3> in = geometry.normalAt(end.outflow, geometry.placeOn(point, end, end.openFraction));
    const auto outward = [&](const double* v) { return -(v[0] * in[0] + v[1] * in[1] + v[2] * in[2]); };
    const double distance = end.openFraction * outward(end.xi.data());
    if (distance < nearest.distance)
      nearest = {end.outflow, distance, outward(velocity + 3 * static_cast<std::size_t>(point))};
  }
  return nearest;
}

std::map<int, Passing> passingOf(Model& model, const FlowGeometry& geometry) {
  std::map<int, Passing> found;
  const double *velocity = model.field("Velocity"), *volume = model.field("Volume");
  for (const int point : geometry.fluid()) {
    const Crossing crossing = crossingOf(geometry, velocity, point);
    const double depth = lookedAt * geometry.spacingOf(point);
    if (crossing.outflow < 0 || crossing.distance > depth) continue;
    Passing& passing = found[crossing.outflow];
    const double amount = volume[point] / depth * std::abs(crossing.velocity);
    (crossing.velocity < 0.0 ? passing.entering : passing.leaving) += amount;
    if (-crossing.velocity <= passing.fastest) continue;
    passing.fastest = -crossing.velocity;
    passing.point = point;
  }
  return found;
}

}  // namespace

std::vector<std::string> OutflowWatch::look(Model& model, const FlowGeometry& geometry) {
  const Communicator& comm = model.comm();
  std::map<int, Passing> passing = passingOf(model, geometry);
  std::vector<std::string> lines;
  for (int outflow = 0; outflow < geometry.nBoundaries(); ++outflow) {
    if (!geometry.isOutflow(outflow) || told_.count(outflow) != 0) continue;
    const Passing& own = passing[outflow];
    const double entering = comm.sum(own.entering), leaving = comm.sum(own.leaving);
    if (!(entering > leastEntering * leaving)) continue;
    told_.insert(outflow);
    const double fastest = comm.max(own.fastest);
    std::string place;
    if (own.point >= 0 && own.fastest == fastest) {
      const double* x = geometry.mesh().x.data() + 3 * static_cast<std::size_t>(own.point);
      place = fmt::format("({:g}, {:g}, {:g})\n", x[0], x[1], x[2]);
    }
    std::istringstream places(comm.gather(place));
    std::getline(places, place);
    lines.push_back(fmt::format(
        "Steady Flow: warning: {}: fluid enters through this outflow, {:.3g} m3/s, while {:.3g} m3/s leave; "
        "fastest is {:.3g} m/s at {} m. Where it is meant only to leave, put the outflow further downstream",
        geometry.titleOf(outflow), entering, leaving, fastest, place));
  }
  return lines;
}

}  // namespace pd
