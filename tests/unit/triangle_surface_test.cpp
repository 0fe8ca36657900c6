// Closed surfaces of triangles as voids: against the ellipsoids that they stand for, and random pairs of places.
#include "triangle_surface.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

#include "bond_decomposition.hpp"

using namespace pd::decomposition;

namespace {

constexpr double pi = 3.14159265358979323846;

Cell cube(double x, double y, double z) {
  return {{x, y, z}, {Place{1.0, 0.0, 0.0}, Place{0.0, 1.0, 0.0}, Place{0.0, 0.0, 1.0}}, 3};
}

double volumeOf(const TriangleSurface& surface) {
  double volume = 0.0;
  for (const auto& t : surface.triangles)
    volume += dot(surface.vertices[t[0]], crossed(surface.vertices[t[1]], surface.vertices[t[2]])) / 6.0;
  return volume;
}

/// An icosahedron whose triangles are cut in four `times` times, on the unit ball.
TriangleSurface dividedIcosahedron(int times) {
  const double g = 0.5 * (1.0 + std::sqrt(5.0));
  TriangleSurface s;
  for (const double a : {-1.0, 1.0})
    for (const double b : {-g, g}) {
      s.vertices.push_back({0.0, a, b});
      s.vertices.push_back({a, b, 0.0});
      s.vertices.push_back({b, 0.0, a});
    }
  for (std::size_t i = 0; i < 12; ++i)  // edges are 2 long
    for (std::size_t j = i + 1; j < 12; ++j)
      for (std::size_t k = j + 1; k < 12; ++k) {
        const auto isEdge = [&](std::size_t u, std::size_t v) {
          return lengthOf(minus(s.vertices[u], s.vertices[v])) < 2.1;
        };
        if (!isEdge(i, j) || !isEdge(j, k) || !isEdge(k, i)) continue;
        const bool isOut = dot(s.vertices[i], crossed(s.vertices[j], s.vertices[k])) > 0.0;
        s.triangles.push_back(isOut ? std::array<std::size_t, 3>{i, j, k} : std::array<std::size_t, 3>{i, k, j});
      }
  for (int n = 0; n < times; ++n) {
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> middles;
    const auto middle = [&](std::size_t a, std::size_t b) {
      const auto [it, isNew] = middles.emplace(std::minmax(a, b), s.vertices.size());
      if (isNew) s.vertices.push_back(plus(plus({}, s.vertices[a], 0.5), s.vertices[b], 0.5));
      return it->second;
    };
    std::vector<std::array<std::size_t, 3>> finer;
    for (const auto& [a, b, c] : s.triangles) {
      const std::size_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      for (const std::array<std::size_t, 3>& t :
           {std::array<std::size_t, 3>{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}})
        finer.push_back(t);
    }
    s.triangles = finer;
  }
  for (Place& v : s.vertices) v = plus({}, v, 1.0 / lengthOf(v));
  return s;
}

/// Of the volume of the ellipsoid with half axes along x, y and z.
TriangleSurface ellipsoidSurface(const Place& center, const Place& half, int times) {
  TriangleSurface s = dividedIcosahedron(times);
  const double factor = std::cbrt(4.0 / 3.0 * pi / volumeOf(s));
  for (Place& v : s.vertices)
    for (std::size_t d = 0; d < 3; ++d) v[d] = center[d] + factor * half[d] * v[d];
  return s;
}

/// A prism over an L: the cube from 0 to 1 without its upper right quarter.
TriangleSurface corner() {
  const std::vector<std::array<double, 2>> outline{{0, 0}, {1, 0}, {1, 0.4}, {0.4, 0.4}, {0.4, 1}, {0, 1}};
  TriangleSurface s;
  for (const double z : {0.0, 1.0})
    for (const auto& p : outline) s.vertices.push_back({p[0], p[1], z});
  for (std::size_t k = 0; k < 6; ++k) {
    const std::size_t next = (k + 1) % 6;
    s.triangles.push_back({k, next, next + 6});
    s.triangles.push_back({k, next + 6, k + 6});
  }
  for (const auto& [a, b, c] : std::vector<std::array<std::size_t, 3>>{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}}) {
    s.triangles.push_back({a, c, b});
    s.triangles.push_back({a + 6, b + 6, c + 6});
  }
  return s;
}

/// Screens and the void of one surface, and what of them is near.
struct Pore {
  std::vector<std::unique_ptr<Screen>> screens;
  std::unique_ptr<Void> hole;
  NearDiscontinuities near;
  explicit Pore(const TriangleSurface& surface) : screens(surfaceScreens(surface)), hole(surfaceVoid(surface)) {
    for (const auto& screen : screens) near.screens.push_back(screen.get());
    near.voids.push_back(hole.get());
  }
};

TEST(TriangleSurface, OfAnEllipsoidHasItsShares) {
  const Place center{0.55, 0.35, 0.4};
  for (const Place& half : {Place{0.3, 0.3, 0.3}, Place{0.45, 0.2, 0.3}, Place{0.02, 0.03, 0.01}}) {
    const Pore pore(ellipsoidSurface(center, half, 3));
    EXPECT_EQ(pore.screens.size(), 1u);  // it is convex
    const Ellipsoid shape{center, {{half[0], 0.0, 0.0}, {0.0, half[1], 0.0}, {0.0, 0.0, half[2]}}};
    const auto screen = ellipsoidScreen(shape);
    const auto hole = ellipsoidVoid(shape);
    for (const Cell& b : {cube(1.0, 1.0, 1.0), cube(1.0, 0.0, 0.0), cube(2.0, 1.0, 1.0), cube(0.0, 0.0, 1.0)}) {
      const double expected = interactionShare(cube(0.0, 0.0, 0.0), b, {{screen.get()}, {hole.get()}}, {});
      EXPECT_NEAR(interactionShare(cube(0.0, 0.0, 0.0), b, pore.near, {}), expected, 2e-3) << half[0];
    }
    EXPECT_NEAR(1.0 - solidShare(cube(0.5, 0.5, 0.5), pore.near.voids),
                1.0 - solidShare(cube(0.5, 0.5, 0.5), {hole.get()}),
                2e-3 * 4.0 / 3.0 * pi * half[0] * half[1] * half[2]);
  }
}

TEST(TriangleSurface, KnowsHowThinItIs) {
  EXPECT_NEAR(surfaceVoid(ellipsoidSurface({1.0, 2.0, 3.0}, {0.3, 0.3, 0.3}, 3))->inradius(), 0.3, 2e-3);
  EXPECT_NEAR(surfaceVoid(corner())->inradius(), 3.0 * 0.64 / 5.28, 1e-12);  // 3 V/A
}

TEST(TriangleSurface, ContainsWhatIsInside) {
  const Pore pore(ellipsoidSurface({0.5, 0.5, 0.5}, {0.5, 0.3, 0.4}, 3)), ell(corner());
  std::mt19937 random(1);
  std::uniform_real_distribution<double> part(-0.1, 1.1);
  int nDifferent = 0;
  for (int n = 0; n < 20000; ++n) {
    const Place p{part(random), part(random), part(random)};
    const double x = (p[0] - 0.5) / 0.5, y = (p[1] - 0.5) / 0.3, z = (p[2] - 0.5) / 0.4;
    nDifferent += pore.hole->contains(p) != (x * x + y * y + z * z < 1.0) ? 1 : 0;
    const bool isInCorner =
        std::min({p[0], p[1], p[2]}) > 0.0 && std::max({p[0], p[1], p[2]}) < 1.0 && (p[0] < 0.4 || p[1] < 0.4);
    EXPECT_EQ(ell.hole->contains(p), isInCorner);
  }
  EXPECT_LT(nDifferent, 60);  // between the triangles and the ellipsoid: 0.4 % of its volume
  // Lines through vertices and edges, and along faces, pass through a surface an even number of times.
  std::vector<Range> ranges;
  for (const double y : {0.0, 0.2, 0.4, 0.7, 1.0})
    for (const double z : {0.0, 0.5, 1.0}) ell.hole->addWithin({-1.0, y, z}, {3.0, 0.0, 0.0}, ranges);
  for (const double x : {0.0, 0.1, 0.4, 0.7}) ell.hole->addWithin({x, -1.0, x}, {0.3, 3.0, 0.3}, ranges);
  for (const Range& range : ranges) EXPECT_LT(range.high - range.low, 0.34);
  ranges.clear();
  ell.hole->addWithin({-1.0, 0.2, 0.5}, {4.0, 0.0, 0.0}, ranges);
  ASSERT_EQ(ranges.size(), 1u);
  EXPECT_NEAR(ranges[0].low, 0.25, 1e-12);
  EXPECT_NEAR(ranges[0].high, 0.5, 1e-12);
}

TEST(TriangleSurface, ThatIsNotConvexHidesByItsTriangles) {
  const Pore pore(corner());
  EXPECT_EQ(pore.screens.size(), 20u);
  std::mt19937 random(2);
  std::uniform_real_distribution<double> part(-0.5, 0.5);
  const auto placeOf = [&](const Cell& cell) {
    return plus(cell.center, Place{part(random), part(random), part(random)});
  };
  // Cells whose points are outside of the void see all of their own material; the surface is flush with their faces.
  for (const auto& [a, b] :
       {std::pair(cube(-0.5, 0.5, 0.5), cube(1.5, 0.5, 0.5)), std::pair(cube(0.5, 1.5, 0.5), cube(1.5, 0.5, 0.5)),
        std::pair(cube(0.5, 0.5, -0.5), cube(1.5, 1.5, 0.5)), std::pair(cube(-0.5, 1.5, 0.5), cube(1.5, 1.5, 1.5))}) {
    int seen = 0;
    constexpr int n = 20000;
    for (int k = 0; k < n; ++k) {
      const Place p = placeOf(a), q = placeOf(b);
      bool isHidden = false;
      for (int step = 1; step < 200 && !isHidden; ++step)
        isHidden = pore.hole->contains(plus(p, minus(q, p), step / 200.0));
      seen += isHidden ? 0 : 1;
    }
    const double expected = static_cast<double>(seen) / n;
    const double error = 3.0 * std::sqrt(expected * (1.0 - expected) / n);
    EXPECT_NEAR(interactionShare(a, b, pore.near, {}), expected, 6e-3 + error);
  }
}

/// Of all parallel lines, as seen from a place; from 1 to 0 where nothing is.
std::vector<Range> hiddenBy(const Screen& screen, const Place& place, const Lines& lines) {
  std::vector<double> from(lines.size()), to(lines.size());
  screen.hide(place, lines, from.data(), to.data());
  std::vector<Range> ranges;
  for (std::size_t r = 0; r < lines.size(); ++r)
    ranges.push_back(from[r] < to[r] ? Range{from[r], to[r]} : Range{1.0, 0.0});
  return ranges;
}

TEST(TriangleSurface, NarrowedToTwoCellsHidesTheSameToTheLastDigit) {
  const Pore pore(ellipsoidSurface({0.55, 0.35, 0.4}, {0.45, 0.2, 0.3}, 3));
  const Screen& whole = *pore.screens.front();
  std::mt19937 random(3);
  std::uniform_real_distribution<double> part(-0.5, 0.5);
  int nHidden = 0;
  for (const auto& [a, b] :
       {std::pair(cube(-1.0, 0.0, 0.0), cube(2.0, 1.0, 1.0)), std::pair(cube(0.0, 0.0, 0.0), cube(1.0, 1.0, 0.0)),
        std::pair(cube(0.5, 0.4, 0.4), cube(1.5, 0.4, 0.4)), std::pair(cube(1.0, 0.0, 0.0), cube(0.0, 1.0, 0.0))}) {
    const auto narrowed = whole.narrowed(a, b);
    ASSERT_NE(narrowed, nullptr);
    const Lines lines = linesOf(LineGrid(b, 1, 4));
    for (int k = 0; k < 2000; ++k) {
      const Place place = plus(a.center, Place{part(random), part(random), part(random)});
      const std::vector<Range> expected = hiddenBy(whole, place, lines), found = hiddenBy(*narrowed, place, lines);
      for (std::size_t r = 0; r < lines.size(); ++r) {
        ASSERT_EQ(found[r].low, expected[r].low);
        ASSERT_EQ(found[r].high, expected[r].high);
        nHidden += expected[r].low < expected[r].high ? 1 : 0;
      }
    }
  }
  EXPECT_GT(nHidden, 10000);
}

}  // namespace
