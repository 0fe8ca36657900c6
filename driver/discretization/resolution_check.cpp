#include "resolution_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "../deck/block_plugins.hpp"

namespace pd {

namespace {

/// What one point of the sample sees.
struct Surroundings {
  int point = 0;
  double nearest = std::numeric_limits<double>::infinity();  ///< distance to the next point, m
  long long nNeighbors = 0;
};

Surroundings surroundingsOf(int point, const MeshPoints& points, const NeighborRule& rule) {
  Surroundings result;
  result.point = point;
  const double* x = points.at(point);
  double nearestSquared = result.nearest;
  for (int j = 0; j < points.size(); ++j) {
    const double* y = points.at(j);
    const double dx = y[0] - x[0], dy = y[1] - x[1], dz = y[2] - x[2];
    const double distanceSquared = dx * dx + dy * dy + dz * dz;
    const double limit = rule.reach[point] + (rule.margin[point] + rule.margin[j]);
    if (j == point) continue;
    nearestSquared = std::min(nearestSquared, distanceSquared);
    result.nNeighbors += distanceSquared < limit * limit ? 1 : 0;
  }
  result.nearest = std::sqrt(nearestSquared);
  return result;
}

std::vector<Surroundings> sample(const MeshPoints& points, const NeighborRule& rule) {
  constexpr int sampleSize = 100;
  const int stride = std::max(1, points.size() / sampleSize);
  std::vector<Surroundings> result;
  for (int i = stride / 2; i < points.size(); i += stride) result.push_back(surroundingsOf(i, points, rule));
  return result;
}

/// Spacings agree with the distances of points within this factor on any sensible mesh: the nearest point of a Gmsh
/// mesh is 0.6 to 1 spacings away, of a lattice 1.
constexpr double usualFactor = 3.0;
/// For the single point of largest volume: beyond it, every search would have to reach as far as that point does.
constexpr double extremeFactor = 30.0;
/// For that of the smallest: slivers of a mesh of tetrahedra are rarely thinner.
constexpr double sliverFactor = 1000.0;

void addSpacingMistake(const Deck& deck, const MeshPoints& points, const std::vector<double>& spacing, int dimension,
                       const Surroundings& s) {
  const char* remedies[] = {
      "set Discretization/Cross Section Area (m2)",
      deck["Discretization"][axisOfRevolution]
          ? "volumes of the mesh must be areas, m2, as of a plane 1 m thick"
          : "set Discretization/Thickness (m) to the thickness that the volumes of the mesh contain",
      "coordinates must be in m and volumes in m3",
  };
  const char* formulas[] = {"volume / cross section area", "square root of volume / thickness", "cube root of volume"};
  deck.mistakes().add(
      deck["Discretization"].place(),
      fmt::format("volumes and coordinates do not fit: the volume {:g} m3 of the point {} means a spacing of {:.4g} m "
                  "({}), but the next point is {:.4g} m away; {}, or check the columns of the mesh",
                  points.volume[s.point], points.place(s.point), spacing[s.point], formulas[dimension - 1], s.nearest,
                  remedies[dimension - 1]));
}

void checkSpacing(const Deck& deck, const MeshPoints& points, const std::vector<double>& spacing, int dimension,
                  const NeighborRule& rule, std::vector<Surroundings> sampled) {
  const auto ratio = [&](const Surroundings& s) { return spacing[s.point] / s.nearest; };
  std::sort(sampled.begin(), sampled.end(),
            [&](const Surroundings& a, const Surroundings& b) { return ratio(a) < ratio(b); });
  const Surroundings median = sampled[sampled.size() / 2];
  const auto smallest = std::min_element(spacing.begin(), spacing.end());
  const auto largest = std::max_element(spacing.begin(), spacing.end());
  const Surroundings extreme = surroundingsOf(static_cast<int>(largest - spacing.begin()), points, rule);
  const Surroundings least = surroundingsOf(static_cast<int>(smallest - spacing.begin()), points, rule);
  if (ratio(median) > usualFactor || ratio(median) < 1.0 / usualFactor)
    addSpacingMistake(deck, points, spacing, dimension, median);
  else if (ratio(extreme) > extremeFactor)
    addSpacingMistake(deck, points, spacing, dimension, extreme);
  else if (ratio(least) < 1.0 / sliverFactor)
    addSpacingMistake(deck, points, spacing, dimension, least);
}

void checkSize(const Deck& deck, const MeshPoints& points, const std::vector<Surroundings>& sampled, int nRanks,
               int nCopies) {
  long long nNeighbors = 0;
  double nearest = 0.0;
  for (const Surroundings& s : sampled) {
    nNeighbors += s.nNeighbors;
    nearest += s.nearest;
  }
  const auto n = static_cast<double>(sampled.size());
  const double perPoint = static_cast<double>(nNeighbors) / n;
  const double bondsOnARank = perPoint * points.size() / nCopies / nRanks;
  if (bondsOnARank < std::numeric_limits<int>::max()) return;
  const DeckNode blocks = deck["Blocks"];
  deck.mistakes().add(
      blocks.place(),
      fmt::format("the horizon reaches over about {:.0f} neighbours a point, {:.1e} bonds on each of {} ranks, more "
                  "than the 2.1e9 that fit; points are {:.3g} m apart and horizons are usually 3 to 6 times that: "
                  "choose a smaller Horizon, or more ranks",
                  perPoint, bondsOnARank, nRanks, nearest / n));
}

/// With a horizon of hardly more than a spacing a plane or a body has the stiffness of a few directions, whatever its
/// material is. Along a line there are no others.
void checkReach(const Deck& deck, int dimension, const NeighborRule& rule, std::vector<Surroundings> sampled) {
  constexpr double leastReach = 1.45;  // of spacings; Gmsh's points are nearer to each other than they are apart
  const auto spacings = [&](const Surroundings& s) {
    return rule.reach[static_cast<std::size_t>(s.point)] / s.nearest;
  };
  const auto middle = sampled.begin() + static_cast<std::ptrdiff_t>(sampled.size() / 2);
  std::nth_element(sampled.begin(), middle, sampled.end(),
                   [&](const Surroundings& a, const Surroundings& b) { return spacings(a) < spacings(b); });
  if (dimension == 1 || rule.isBox || spacings(*middle) >= leastReach) return;
  deck.warnings().add(
      deck["Blocks"].place(),
      fmt::format(
          "the Horizon is {:.2g} times the distance of the next point ({:.3g} m) or less at half of the points; "
          "so few neighbours do not make the stiffness, conductivity or Poisson's ratio of the material. Choose "
          "one of 3 to 6 times that",
          spacings(*middle), middle->nearest));
}

}  // namespace

void checkResolution(const Deck& deck, const MeshPoints& points, const std::vector<double>& spacing, int dimension,
                     const NeighborRule& rule, int nRanks, int nCopies) {
  if (points.size() < 2) return;  // a single point is reported as one without neighbours
  const std::vector<Surroundings> sampled = sample(points, rule);
  if (!spacing.empty()) checkSpacing(deck, points, spacing, dimension, rule, sampled);
  checkReach(deck, dimension, rule, sampled);
  checkSize(deck, points, sampled, nRanks, nCopies);
}

}  // namespace pd
