#include "flow_geometry.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "../../boundary/condition.hpp"
#include "../../model/collective.hpp"

namespace pd {

std::vector<char> solidPoints(Model& model) {
  std::vector<char> isSolid(static_cast<std::size_t>(model.nPoints()), 0);
  const std::string metal = fields::saturationConcentration().label, dissolved = fields::damage().label;
  if (!model.hasField(metal) || !model.hasField(dissolved)) return isSolid;
  const double *saturation = model.field(metal), *damage = model.field(dissolved);
  for (std::size_t i = 0; i < isSolid.size(); ++i) isSolid[i] = saturation[i] > 0.0 && damage[i] < 1.0 ? 1 : 0;
  return isSolid;
}

namespace {

/// What is solid dissolves and becomes fluid. Collective.
void requireForcesOnFluid(const FlowGeometry& geometry, const Simulation& simulation) {
  Mistakes mistakes;
  for (const auto& condition : simulation.conditions.all()) {
    if (dynamic_cast<const FlowForce*>(condition.get()) == nullptr) continue;
    const std::vector<int>& points = condition->points();
    const bool moves = std::any_of(points.begin(), points.end(),
                                   [&](int point) { return geometry.isFluid(point) || geometry.isSolid(point); });
    if (!simulation.model.comm().any(moves))
      mistakes.add(condition->node().keyPlace(),
                   condition->title() +
                       " moves nothing: none of its points is fluid; give it a node set that holds "
                       "points before the walls, inlets and outflows");
  }
  mistakes.report();
}

}  // namespace

FlowGeometry::FlowGeometry(Simulation& simulation, const FlowLaw& law, const std::vector<int>& flowBlocks,
                           std::vector<char> isSolid)
    : simulation_(simulation), mesh_(simulation.model.discretization()), law_(law), isSolid_(std::move(isSolid)) {
  for (const auto& condition : simulation.conditions.all()) {
    const auto* boundary = dynamic_cast<const FlowBoundary*>(condition.get());
    if (boundary == nullptr) continue;
    boundaries_.push_back(boundary);
    titles_.push_back(condition->node().keyPlace() + ": " + condition->title());
    beyond_.push_back(condition->points());
  }
  findKinds(flowBlocks);
  collectively(simulation.model.comm(), [&] { checkSides(); });
  requireForcesOnFluid(*this, simulation);
  findNearBoundary();
  collectively(simulation.model.comm(), [&] {
    checkClaims();
    findWallsAtAxis();
  });
}

void FlowGeometry::findKinds(const std::vector<int>& flowBlocks) {
  const auto nPoints = static_cast<std::size_t>(mesh_.nPoints);
  kind_.assign(nPoints, Kind::Wall);
  boundaryOf_.assign(nPoints, -1);
  for (std::size_t i = 0; i < nPoints; ++i)
    if (std::find(flowBlocks.begin(), flowBlocks.end(), mesh_.blockId[i]) != flowBlocks.end()) kind_[i] = Kind::Fluid;
  // Where a wall ends at an outflow, what is beyond both is wall.
  for (const bool isOutflow : {true, false})
    for (std::size_t b = 0; b < boundaries_.size(); ++b) {
      if (boundaries_[b]->isOutflow() != isOutflow) continue;
      for (const int point : beyond_[b]) {
        kind_[index(point)] = isOutflow ? Kind::Beyond : Kind::Wall;
        boundaryOf_[index(point)] = static_cast<int>(b);
      }
    }
  for (int point = 0; point < mesh_.nOwned; ++point) {
    if (!isFluid(point)) continue;
    if (isSolid_[index(point)] == 0) {
      fluid_.push_back(point);
      possibleOf_.push_back(nPossible_);
    }
    ++nPossible_;
  }
  for (std::size_t i = 0; i < nPoints; ++i)
    if (isSolid_[i] != 0) kind_[i] = Kind::Wall;
  for (int point = 0; point < mesh_.nPoints; ++point) {
    isCell_.push_back(isCell(point) ? 1 : 0);
    hasCells_ = hasCells_ || isCell_.back() != 0;
  }
}

/// The first point of each kind of trouble on this rank.
void FlowGeometry::checkSides() const {
  const auto at = [&](int point) {
    const double* x = placeOf(point);
    return fmt::format("point {} at ({:g}, {:g}, {:g}) m", mesh_.globalIds[index(point)] + 1, x[0], x[1], x[2]);
  };
  Mistakes mistakes;
  for (std::size_t b = 0; b < boundaries_.size(); ++b) {
    for (const int point : beyond_[b])
      if (dimension() == 2 &&
          boundaries_[b]->velocityAt(placeOf(point), simulation_.conditions.runTime(0.0))[2] != 0.0) {
        mistakes.add("", titles_[b] + ": its Velocity has a component along z, but the flow is one in the x-y plane");
        break;
      }
    if (!boundaries_[b]->hasSurface()) continue;
    for (const int point : beyond_[b])
      if (!(boundaries_[b]->surfaceAt(placeOf(point)) < 0.0)) {
        mistakes.add("",
                     fmt::format("{}: {} of its node set is not beyond its Surface, which is {:g} there; it must be "
                                 "negative",
                                 titles_[b], at(point), boundaries_[b]->surfaceAt(placeOf(point))));
        break;
      }
    for (const int point : fluid_)
      if (!(boundaries_[b]->surfaceAt(placeOf(point)) > 0.0)) {
        mistakes.add("", fmt::format("{}: its Surface is {:g} at {}, which is fluid; it must be positive there, or the "
                                     "point be in its node set",
                                     titles_[b], boundaries_[b]->surfaceAt(placeOf(point)), at(point)));
        break;
      }
  }
  mistakes.report();
}

void FlowGeometry::findNearBoundary() {
  isNear_.assign(static_cast<std::size_t>(mesh_.nPoints), 0.0);
  for (const int point : fluid_)
    for (const int neighbor : neighborsOf(point))
      if (!isFluid(neighbor)) isNear_[index(point)] = 1.0;
  simulation_.model.exchange().import(isNear_.data(), 1, Reflection::Even);
}

std::vector<int> FlowGeometry::neighborsOf(int point) const {
  const int* list = mesh_.neighborhoodList.data() + mesh_.neighborhoodStart[index(point)];
  return {list + 1, list + 1 + *list};
}

std::vector<FlowGeometry::End> FlowGeometry::endsOf(int point) const {
  std::vector<End> ends;
  const std::vector<int> neighbors = neighborsOf(point);
  for (const int neighbor : neighbors) {
    End end = endOf(point, neighbor, neighbors);
    if (end.volume > 0.0) ends.push_back(end);
  }
  return ends;
}

std::vector<FlowGeometry::End> FlowGeometry::compactEndsOf(int point, const std::vector<int>& candidates) const {
  std::vector<End> ends;
  for (const int neighbor : candidates) {
    if (neighbor == point) continue;
    const ReferenceBond bond(mesh_.x.data(), point, neighbor);
    if (!law_.gradientsReach(bond.length)) continue;
    End end = endOf(point, neighbor, candidates);
    if (end.volume > 0.0) ends.push_back(end);
  }
  return ends;
}

FlowGeometry::End FlowGeometry::endOf(int point, int neighbor, const std::vector<int>& candidates) const {
  const ReferenceBond bond(mesh_.x.data(), point, neighbor);
  const double volume = law_.volumeOf(bond.length, planeVolume(point), planeVolume(neighbor));
  End end{mesh_.sourceOf(neighbor), mesh_.copyOf(neighbor), kindOf(neighbor), bond.xi, bond.length, volume};
  if (volume > 0.0 && (isNear_[index(point)] != 0.0 || isNear_[index(neighbor)] != 0.0))
    meetBoundaries(point, candidates, end);
  return end;
}

double FlowGeometry::compactWeight(int point, const End& end) const {
  const double own = mesh_.volume[index(point)], other = mesh_.volume[index(end.point)];
  const double spacing = 0.5 * (spacingOf(point) + spacingOf(end.point));
  return kernels::pressureSmoothing(dimension(), spacing, end.length) * 2.0 * other / (own + other);
}

void FlowGeometry::meetBoundaries(int point, const std::vector<int>& candidates, End& end) const {
  constexpr double rounding = 1e-9;  // a bond into a corner ends at the boundary that the deck names first
  end.fraction = 2.0;
  for (std::size_t b = 0; b < boundaries_.size(); ++b) {
    if (!boundaries_[b]->hasSurface()) continue;
    const double fraction = crossing(*boundaries_[b], placeOf(point), end);
    double& nearest = boundaries_[b]->isOutflow() ? end.openFraction : end.fraction;
    if (fraction >= nearest - rounding) continue;
    nearest = fraction;
    (boundaries_[b]->isOutflow() ? end.outflow : end.boundary) = static_cast<int>(b);
  }
  if (hasCells_) meetCells(point, candidates, end);
  if (end.openFraction >= end.fraction - rounding) end.openFraction = 2.0;
  if (end.fraction <= 1.0)
    end.kind = Kind::Wall;
  else
    end.fraction = 1.0;
}

namespace {

/// The square of the distance from a place of a bond xi, at the fraction f of it, to a point at d from its beginning is
/// square - f along, but for (f |xi|)^2, which all points have in common.
struct Nearness {
  double square, along;  ///< |d|^2, 2 xi.d
  int point;
  bool isCell;
};

/// Of the points that are nearer than the beginning of the bond somewhere on it, the one that is the nearest after
/// `now`, from where on `nearest` is overtaken; null: none. Of two that are equally near one that is no cell.
const Nearness* overtakes(const std::vector<Nearness>& points, const Nearness& now, double& from) {
  constexpr double rounding = 1e-9;
  const Nearness* next = nullptr;
  double first = 1.0;
  for (const Nearness& other : points) {
    const double steeper = other.along - now.along;
    if (!(steeper > rounding * other.along)) continue;
    const double meeting = (other.square - now.square) / steeper;
    if (meeting > first + rounding) continue;
    const bool isBetter = next == nullptr || meeting < first - rounding ||
                          other.along > next->along * (1.0 + rounding) ||
                          (other.along > next->along * (1.0 - rounding) && !other.isCell);
    if (!isBetter) continue;
    first = std::min(meeting, 1.0);
    next = &other;
  }
  from = std::max(from, first);
  return next;
}

}  // namespace

/// The first place of the bond to which a point of a wall without a surface is nearer than the point and all fluid, but
/// for places so short that none of twelve equal steps finds them. A surface at the same place comes first.
void FlowGeometry::meetCells(int point, const std::vector<int>& candidates, End& end) const {
  constexpr double nSteps = 12.0, rounding = 1e-9;
  if (std::none_of(candidates.begin(), candidates.end(), [&](int other) { return isCell_[index(other)] != 0; })) return;
  std::vector<Nearness> nearer;
  bool isAny = false;
  for (const int other : candidates) {
    const double *x = placeOf(other), *from = placeOf(point);
    const std::array<double, 3> d{x[0] - from[0], x[1] - from[1], x[2] - from[2]};
    const double square = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
    const double along = 2.0 * (end.xi[0] * d[0] + end.xi[1] * d[1] + end.xi[2] * d[2]);
    if (!(square < along)) continue;
    nearer.push_back({square, along, other, isCell_[index(other)] != 0});
    isAny = isAny || nearer.back().isCell;
  }
  if (!isAny) return;
  const Nearness own{0.0, 0.0, point, false};
  double from = 0.0, since = 0.0;
  const Nearness* cell = nullptr;
  for (const Nearness* nearest = overtakes(nearer, own, from); nearest != nullptr && from < end.fraction - rounding;) {
    if (!nearest->isCell)
      cell = nullptr;
    else if (cell == nullptr) {
      cell = nearest;
      since = from;
    }
    const Nearness* next = overtakes(nearer, *nearest, from);
    const double until = next == nullptr ? 1.0 : from;
    if (cell != nullptr && std::floor(until * nSteps + rounding) > std::floor(since * nSteps - rounding)) {
      end.fraction = since;
      end.boundary = boundaryOf_[index(mesh_.sourceOf(cell->point))];
      return;
    }
    nearest = next;
  }
}

/// The first fraction of the bond at which the surface's function turns negative; 2 where it does not.
double FlowGeometry::crossing(const FlowBoundary& boundary, const double* from, const End& end) const {
  const auto valueAt = [&](double fraction) {
    const std::array<double, 3> x{from[0] + fraction * end.xi[0], from[1] + fraction * end.xi[1],
                                  from[2] + fraction * end.xi[2]};
    return boundary.surfaceAt(x.data());
  };
  // A body may reach into the bond between its ends.
  double low = 0.0, high = 2.0;
  for (const double fraction : {0.25, 0.5, 0.75, 1.0}) {
    if (valueAt(fraction) < 0.0) {
      high = fraction;
      break;
    }
    low = fraction;
  }
  if (high > 1.0) return high;
  for (int halving = 0; halving < 40; ++halving) {
    const double middle = 0.5 * (low + high);
    (valueAt(middle) < 0.0 ? high : low) = middle;
  }
  return high;
}

std::array<double, 3> FlowGeometry::placeOn(int point, const End& end, double fraction) const {
  const double* x = placeOf(point);
  return {x[0] + fraction * end.xi[0], x[1] + fraction * end.xi[1], x[2] + fraction * end.xi[2]};
}

std::array<double, 3> FlowGeometry::wallVelocity(int boundary, const std::array<double, 3>& place, double t) const {
  if (boundary < 0) return {};
  return boundaries_[static_cast<std::size_t>(boundary)]->velocityAt(place.data(), simulation_.conditions.runTime(t));
}

double FlowGeometry::outflowPressure(int boundary, const std::array<double, 3>& place, double t) const {
  return boundaries_[static_cast<std::size_t>(boundary)]->pressureAt(place.data(), simulation_.conditions.runTime(t));
}

bool FlowGeometry::wallsChangeWithTime() const {
  return std::any_of(boundaries_.begin(), boundaries_.end(),
                     [](const FlowBoundary* boundary) { return !boundary->isOutflow() && boundary->dependsOnTime(); });
}

std::array<double, 3> FlowGeometry::normalAt(int boundary, const std::array<double, 3>& place) const {
  std::array<double, 3> normal{};
  if (boundary < 0 || !boundaries_[static_cast<std::size_t>(boundary)]->hasSurface()) return normal;
  normal = boundaries_[static_cast<std::size_t>(boundary)]->surfaceGradient(place.data(), 1e-5 * law_.family.horizon,
                                                                            dimension());
  const double size = std::sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]);
  if (size > 0.0)
    for (double& component : normal) component /= size;
  return normal;
}

std::array<double, 3> FlowGeometry::mirrored(int point, const End& end) const {
  const int outflow = end.outflow >= 0 ? end.outflow : boundaryOf_[index(end.point)];
  return mirroredAt(outflow, end.openFraction <= 1.0 ? end.openFraction : 1.0, point, end);
}

/// By the plane that touches the boundary where the bond meets it.
std::array<double, 3> FlowGeometry::mirroredAt(int boundary, double fraction, int point, const End& end) const {
  const std::array<double, 3> place = placeOn(point, end, fraction);
  const std::array<double, 3> normal = normalAt(boundary, place);
  double beyond = 0.0;  // how far the end is beyond the plane through `place`
  for (std::size_t a = 0; a < 3; ++a) beyond += normal[a] * (placeOf(point)[a] + end.xi[a] - place[a]);
  std::array<double, 3> result = end.xi;
  for (std::size_t a = 0; a < 3; ++a) result[a] -= 2.0 * beyond * normal[a];
  return result;
}

}  // namespace pd
