// The rule of uniform partitions is a count of pairs: against the pairs, one by one, by geometry of its own.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

#include "bond_decomposition.hpp"

using namespace pd::decomposition;

namespace {

Cell square(double x, double y, double edge = 1.0) {
  return {{x, y, 0.0}, {Place{edge, 0.0, 0.0}, Place{0.0, edge, 0.0}, Place{}}, 2};
}

Cell cube(double x, double y, double z) {
  return {{x, y, z}, {Place{1.0, 0.0, 0.0}, Place{0.0, 1.0, 0.0}, Place{0.0, 0.0, 1.0}}, 3};
}

/// What the library is told, and the same as predicates.
struct Geometry {
  std::vector<std::unique_ptr<Screen>> screens;
  std::vector<std::unique_ptr<Void>> voids;
  std::vector<std::function<bool(const Place&, const Place&)>> meets;
  std::vector<std::function<bool(const Place&)>> contains;

  void addEllipsoid(const Ellipsoid& shape) {
    screens.push_back(ellipsoidScreen(shape));
    voids.push_back(ellipsoidVoid(shape));
    const auto mapped = [shape](const Place& place) {
      Place result{};
      for (std::size_t k = 0; k < shape.halfAxes.size(); ++k)
        result[k] = dot(minus(place, shape.center), shape.halfAxes[k]) / dot(shape.halfAxes[k], shape.halfAxes[k]);
      return result;
    };
    contains.push_back([mapped](const Place& p) { return lengthOf(mapped(p)) < 1.0; });
    meets.push_back([mapped](const Place& p, const Place& q) {
      const Place a = mapped(p), way = minus(mapped(q), a);
      const double s = std::clamp(-dot(a, way) / dot(way, way), 0.0, 1.0);
      return lengthOf(plus(a, way, s)) < 1.0;  // the place nearest to the centre
    });
  }
  void addSegment(const Place& a, const Place& b) {
    screens.push_back(segmentScreen(a, b));
    meets.push_back([a, b](const Place& p, const Place& q) {
      const Place along = minus(b, a), way = minus(q, p);
      const double turn = crossed(way, along)[2];
      const double s = crossed(minus(a, p), along)[2] / turn, t = crossed(minus(a, p), way)[2] / turn;
      return s >= 0.0 && s <= 1.0 && t >= 0.0 && t <= 1.0;
    });
  }
  void addPolygonalHole(const std::vector<Place>& corners) {
    voids.push_back(polygonVoid(corners));
    // How often the outline goes round the place.
    contains.push_back([corners](const Place& p) {
      double turn = 0.0;
      for (std::size_t k = 0; k < corners.size(); ++k) {
        const Place a = minus(corners[k], p), b = minus(corners[(k + 1) % corners.size()], p);
        turn += std::atan2(crossed(a, b)[2], dot(a, b));
      }
      return std::abs(turn) > 3.0;
    });
    for (std::size_t k = 0; k < corners.size(); ++k) addSegment(corners[k], corners[(k + 1) % corners.size()]);
  }
  /// A flat crack in space, of which `covers` says whether a place of its plane is on it.
  void addFlat(std::unique_ptr<Screen> screen, const Place& origin, const Place& normal,
               const std::function<bool(const Place&)>& covers) {
    screens.push_back(std::move(screen));
    meets.push_back([=](const Place& p, const Place& q) {
      const double a = dot(minus(p, origin), normal), b = dot(minus(q, origin), normal);
      return (a > 0.0) != (b > 0.0) && covers(plus(p, minus(q, p), a / (a - b)));
    });
  }

  bool isVoid(const Place& p) const {
    return std::any_of(contains.begin(), contains.end(), [&](const auto& has) { return has(p); });
  }
  bool isCut(const Place& p, const Place& q) const {
    return std::any_of(meets.begin(), meets.end(), [&](const auto& cuts) { return cuts(p, q); });
  }
  NearDiscontinuities near() const {
    NearDiscontinuities all;
    for (const auto& screen : screens) all.screens.push_back(screen.get());
    for (const auto& v : voids) all.voids.push_back(v.get());
    return all;
  }
};

/// Middles of n^D parts with material, on the side of the cell's point.
std::vector<Place> countedParts(const Cell& cell, const Geometry& geometry, int n) {
  std::vector<Place> parts;
  const std::optional<Place> seenFrom = placeThatSees(cell, geometry.near().voids);
  for (int k = 0; k < n; ++k)
    for (int l = 0; l < n; ++l)
      for (int m = 0; m < (cell.dimension == 3 ? n : 1); ++m) {
        Place place = plus(plus(cell.center, cell.edges[0], (k + 0.5) / n - 0.5), cell.edges[1], (l + 0.5) / n - 0.5);
        if (cell.dimension == 3) place = plus(place, cell.edges[2], (m + 0.5) / n - 0.5);
        if (!geometry.isVoid(place) && !(seenFrom && geometry.isCut(*seenFrom, place))) parts.push_back(place);
      }
  return parts;
}

double shareOfPairs(const Cell& a, const Cell& b, const Geometry& geometry, int n) {
  const std::vector<Place> ofA = countedParts(a, geometry, n), ofB = countedParts(b, geometry, n);
  if (ofA.empty() || ofB.empty()) return 0.0;
  long long seen = 0;
  for (const Place& p : ofA)
    for (const Place& q : ofB) seen += geometry.isCut(p, q) ? 0 : 1;
  const double share = static_cast<double>(seen) / (static_cast<double>(ofA.size()) * static_cast<double>(ofB.size()));
  return share < 1e-6 ? 0.0 : share > 1.0 - 1e-6 ? 1.0 : share;  // bond_decomposition.hpp
}

DecompositionRule uniform(int n) {
  DecompositionRule rule;
  rule.kind = DecompositionRule::Kind::Uniform;
  rule.partitions = n;
  return rule;
}

/// How many of the bonds of the cells are shared, and an EXPECT of each.
int expectCounts(const std::vector<Cell>& cells, const Geometry& geometry, int n, double reach) {
  const NearDiscontinuities near = geometry.near();
  InteractionShares shares(uniform(n));
  int nShared = 0;
  for (std::size_t i = 0; i < cells.size(); ++i)
    for (std::size_t j = i + 1; j < cells.size(); ++j) {
      if (lengthOf(minus(cells[i].center, cells[j].center)) > reach) continue;
      const double expected = shareOfPairs(cells[i], cells[j], geometry, n);
      const double share = shares.of({static_cast<int>(i), cells[i]}, {static_cast<int>(j), cells[j]}, near);
      EXPECT_DOUBLE_EQ(share, expected) << i << " " << j;
      nShared += expected > 0.0 && expected < 1.0 ? 1 : 0;
    }
  return nShared;
}

/// Cells in rows, moved at random as points of jittered meshes are.
std::vector<Cell> squares(int n, double jitter) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> move(-jitter, jitter);
  std::vector<Cell> cells;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) cells.push_back(square(i + move(random), j + move(random)));
  return cells;
}

// Numbers without a pattern, so that no pair of middles touches anything within rounding.
const Ellipsoid circle{{2.1327, 2.2713, 0.0}, {{1.2391, 0.0, 0.0}, {0.0, 1.2391, 0.0}}};
const Ellipsoid ellipse{{3.6171, 1.1237, 0.0}, {{0.8813, 0.3171, 0.0}, {-0.1171, 0.32545, 0.0}}};
const Ellipsoid small{{1.0173, 0.5219, 0.0}, {{0.0731, 0.0, 0.0}, {0.0, 0.0531, 0.0}}};

TEST(BondDecompositionPairs, BesideAHole) {
  Geometry geometry;
  geometry.addEllipsoid(circle);
  EXPECT_GT(expectCounts(squares(6, 0.0), geometry, 7, 3.5), 100);
  EXPECT_GT(expectCounts(squares(6, 0.3), geometry, 6, 3.5), 100);
}

TEST(BondDecompositionPairs, AsManyAsTheSourceTakes) {
  Geometry geometry;
  geometry.addEllipsoid(circle);
  EXPECT_GT(expectCounts({square(0.0, 2.0), square(2.0, 0.0), square(1.0, 1.0), square(1.0, 3.0)}, geometry, 20, 3.5),
            2);
}

TEST(BondDecompositionPairs, HolesThatOverlap) {
  Geometry geometry;
  geometry.addEllipsoid(circle);
  geometry.addEllipsoid(ellipse);
  geometry.addEllipsoid(small);
  EXPECT_GT(expectCounts(squares(6, 0.2), geometry, 6, 3.5), 100);
}

TEST(BondDecompositionPairs, ManyPores) {
  Geometry geometry;
  std::mt19937 random(2);
  std::uniform_real_distribution<double> place(-0.5, 4.5), half(0.05, 0.3), angle(0.0, 3.0);
  for (int k = 0; k < 40; ++k) {
    const double a = half(random), b = half(random), c = std::cos(angle(random)), s = std::sqrt(1.0 - c * c);
    geometry.addEllipsoid({{place(random), place(random), 0.0}, {{a * c, a * s, 0.0}, {-b * s, b * c, 0.0}}});
  }
  EXPECT_GT(expectCounts(squares(5, 0.1), geometry, 5, 3.5), 100);
}

TEST(BondDecompositionPairs, ACrackFromAPolygonIntoAHole) {
  Geometry geometry;
  geometry.addEllipsoid(circle);
  geometry.addPolygonalHole({{0.217, 3.911, 0.0}, {1.523, 3.713, 0.0}, {1.013, 4.117, 0.0}, {1.419, 4.813, 0.0}});
  geometry.addSegment({1.2171, 4.0313, 0.0}, {2.0519, 2.7131, 0.0});
  geometry.addSegment({3.0117, 3.5217, 0.0}, {4.6173, 2.5331, 0.0});
  EXPECT_GT(expectCounts(squares(6, 0.2), geometry, 6, 3.5), 100);
}

std::vector<Cell> cubes() {
  std::vector<Cell> cells;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      for (int k = 0; k < 2; ++k) cells.push_back(cube(i, j + 0.1 * k, k));
  return cells;
}

TEST(BondDecompositionPairs, PoresInSpace) {
  Geometry geometry;
  geometry.addEllipsoid(
      {{1.0713, 0.9371, 0.5137}, {{0.8171, 0.1113, 0.0}, {-0.0791, 0.5807, 0.0}, {0.0, 0.0, 0.4519}}});
  geometry.addEllipsoid({{0.2117, 1.7313, 0.1139}, {{0.2317, 0.0, 0.0}, {0.0, 0.2317, 0.0}, {0.0, 0.0, 0.2317}}});
  EXPECT_GT(expectCounts(cubes(), geometry, 4, 2.5), 60);
}

TEST(BondDecompositionPairs, CracksAndACylinderInSpace) {
  Geometry geometry;
  const Place center{0.9137, 1.1731, 0.5519}, normal{0.1171, -0.2113, 1.0};
  geometry.addFlat(diskScreen(center, normal, 0.8371), center, normal,
                   [=](const Place& x) { return lengthOf(minus(x, center)) < 0.8371; });
  const Place a{0.6171, 0.1937, -0.3}, b{0.7713, 1.8871, -0.2}, c{0.8119, 1.7771, 1.4};
  const Place across = crossed(minus(b, a), minus(c, a));
  geometry.addFlat(polygonScreen({a, b, c}), a, across, [=](const Place& x) {
    const auto isInside = [&](const Place& from, const Place& to) {
      return dot(crossed(minus(to, from), minus(x, from)), across) > 0.0;
    };
    return isInside(a, b) && isInside(b, c) && isInside(c, a);
  });
  geometry.addEllipsoid({{1.7713, 0.2137, 0.0}, {{0.4171, 0.0, 0.1013}, {0.0, 0.4291, 0.0}}});
  EXPECT_GT(expectCounts(cubes(), geometry, 4, 2.5), 60);
}

}  // namespace
