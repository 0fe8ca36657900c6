// Shares of bonds that cracks and voids leave: against exact integrals and random pairs of places.
#include "bond_decomposition.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

using namespace pd::decomposition;

namespace {

constexpr double pi = 3.14159265358979323846;

Cell square(double x, double y, double edge = 1.0) {
  return {{x, y, 0.0}, {Place{edge, 0.0, 0.0}, Place{0.0, edge, 0.0}, Place{}}, 2};
}

Cell cube(double x, double y, double z) {
  return {{x, y, z}, {Place{1.0, 0.0, 0.0}, Place{0.0, 1.0, 0.0}, Place{0.0, 0.0, 1.0}}, 3};
}

DecompositionRule uniform(int n) {
  DecompositionRule rule;
  rule.kind = DecompositionRule::Kind::Uniform;
  rule.partitions = n;
  return rule;
}

DecompositionRule adaptive(double tolerance) {
  DecompositionRule rule;
  rule.tolerance = tolerance;
  return rule;
}

/// Two squares side by side and a crack of the length a <= 1 along their common edge, from its end. Where a connection
/// crosses the edge at (1 - w) y_p + w y_q, w = x_p/(x_p + x_q) has the density 1/(2 (1 - w)^2) below 1/2, and so above
/// it mirrored; y_p and y_q are uniform.
double exactShare(double a) {
  const auto square = [](double x) { return x > 0.0 ? x * x : 0.0; };
  const auto crossesBelow = [&](double w) {
    return (square(a) - square(a - w) - square(a - 1.0 + w) + square(a - 1.0)) / (2.0 * w * (1.0 - w));
  };
  constexpr int n = 100000;
  double sum = 0.0;
  for (int k = 0; k < n; ++k) {
    const double w = 0.5 * (k + 0.5) / n;
    sum += 2.0 * crossesBelow(w) / (2.0 * (1.0 - w) * (1.0 - w)) * 0.5 / n;
  }
  return 1.0 - sum;
}

double besideCrack(double a, const DecompositionRule& rule, long long* nLines = nullptr) {
  const auto crack = segmentScreen({0.0, -1.0, 0.0}, {0.0, a, 0.0});
  return interactionShare(square(-0.5, 0.5), square(0.5, 0.5), {{crack.get()}, {}}, rule, nLines);
}

/// Liu & Bao, Aerospace 9 (2022) 641, Fig. 7, has errors within 0.5 % for n = 20: here of the whole bond. Of what is
/// left they are larger where that is little.
TEST(BondDecomposition, TwoNeighboursAsInTheSource) {
  for (double a = 0.0125; a < 1.0; a += 0.025) {
    EXPECT_NEAR(besideCrack(a, uniform(20)), exactShare(a), 0.005) << a;
    EXPECT_NEAR(besideCrack(a, uniform(40)), exactShare(a), 0.0025) << a;
  }
  EXPECT_EQ(besideCrack(1.0, uniform(20)), 0.0);
  EXPECT_EQ(besideCrack(-0.01, uniform(20)), 1.0);
}

/// No fibre is left at the mouth of a crack that begins at the face of the body, wherever rounding puts that.
TEST(BondDecomposition, ACrackMayBeginWhereCellsDo) {
  for (const double face : {0.0, 0.1, -0.3, 0.7}) {
    const double edge = 1e-3, x = face + 0.5 * edge, y = 0.02;
    const auto crack = segmentScreen({face, y, 0.0}, {face + 10.3 * edge, y, 0.0});
    for (int row = 0; row < 3; ++row)
      EXPECT_EQ(interactionShare(square(x, y - 0.5 * edge, edge), square(x + row * edge, y + 0.5 * edge, edge),
                                 {{crack.get()}, {}}, adaptive(1e-3)),
                0.0)
          << face << " " << row;
  }
  const auto flat = polygonScreen({{0.0, 0.0, 0.0}, {3.0, 0.0, 0.0}, {3.0, 0.0, 1.0}, {0.0, 0.0, 1.0}});
  EXPECT_EQ(interactionShare(cube(0.5, -0.5, 0.5), cube(1.5, 0.5, 0.5), {{flat.get()}, {}}, adaptive(1e-3)), 0.0);
}

TEST(BondDecomposition, ASegmentAlone) {
  for (double a = 0.0125; a < 1.0; a += 0.025) {
    long long nLines = 0;
    EXPECT_NEAR(besideCrack(a, adaptive(1e-3), &nLines), exactShare(a), 1e-3) << a;
    EXPECT_LT(nLines, 8000);  // of n = 20
    EXPECT_NEAR(besideCrack(a, adaptive(1e-5)), exactShare(a), 2e-5) << a;
  }
}

/// The same crack in two parts, as of a polyline: by lines.
TEST(BondDecomposition, AdaptiveLinesKeepToTheToleranceWithLessWork) {
  for (double a = 0.0125; a < 1.0; a += 0.025) {
    const auto first = segmentScreen({0.0, -1.0, 0.0}, {0.0, 0.5 * a, 0.0});
    const auto second = segmentScreen({0.0, 0.5 * a, 0.0}, {0.0, a, 0.0});
    long long nLines = 0;
    const double share = interactionShare(square(-0.5, 0.5), square(0.5, 0.5), {{first.get(), second.get()}, {}},
                                          adaptive(1e-3), &nLines);
    EXPECT_NEAR(share, exactShare(a), 1e-3) << a;
    EXPECT_LT(nLines, 8000);  // of n = 20
  }
}

/// Share of random pairs of places with material that see each other, and three of its standard deviations.
struct Sampled {
  double share, error;
};
Sampled sampled(const Cell& a, const Cell& b, const std::function<bool(const Place&)>& isVoid,
                const std::function<bool(const Place&, const Place&)>& meets) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> part(-0.5, 0.5);
  const auto place = [&](const Cell& cell) {
    Place p = cell.center;
    for (std::size_t k = 0; k < static_cast<std::size_t>(cell.dimension); ++k) p = plus(p, cell.edges[k], part(random));
    return p;
  };
  int all = 0, seen = 0;
  for (int n = 0; n < 200000; ++n) {
    const Place p = place(a), q = place(b);
    if (isVoid(p) || isVoid(q)) continue;
    ++all;
    seen += meets(p, q) ? 0 : 1;
  }
  const double share = static_cast<double>(seen) / all;
  return {share, 3.0 * std::sqrt(share * (1.0 - share) / all)};
}

/// Whether a fine walk from p to q comes to a place that is void.
bool walksInto(const std::function<bool(const Place&)>& isVoid, const Place& p, const Place& q) {
  for (int k = 1; k < 100; ++k)
    if (isVoid(plus(p, minus(q, p), k / 100.0))) return true;
  return false;
}

bool segmentsCross(const Place& p, const Place& q, const Place& a, const Place& b) {
  const auto turn = [](const Place& u, const Place& v, const Place& w) {
    return crossed(minus(v, u), minus(w, u))[2] > 0.0;
  };
  return turn(p, q, a) != turn(p, q, b) && turn(a, b, p) != turn(a, b, q);
}

TEST(BondDecomposition, CrackThatEndsInAPoreBesideAPolygon) {
  const Cell a = square(-0.5, 0.5), b = square(1.5, 1.5);
  const Ellipsoid ellipse{{0.1, 0.6, 0.0}, {{0.3, 0.1, 0.0}, {-0.05, 0.15, 0.0}}};
  const std::vector<Place> corners{{1.2, 0.7, 0.0}, {1.8, 1.1, 0.0}, {1.3, 1.2, 0.0}, {1.4, 1.0, 0.0}};
  const auto hole = ellipsoidVoid(ellipse);
  const auto surface = ellipsoidScreen(ellipse);
  const auto polygon = polygonVoid(corners);
  const Place tip{0.6, 1.4, 0.0};
  const auto crack = segmentScreen({0.1, 0.6, 0.0}, tip);
  NearDiscontinuities near{{surface.get(), crack.get()}, {hole.get(), polygon.get()}};
  std::vector<std::unique_ptr<Screen>> edges;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    edges.push_back(segmentScreen(corners[k], corners[(k + 1) % corners.size()]));
    near.screens.push_back(edges.back().get());
  }
  const auto isVoid = [&](const Place& p) { return hole->contains(p) || polygon->contains(p); };
  const Sampled expected = sampled(a, b, isVoid, [&](const Place& p, const Place& q) {
    return segmentsCross(p, q, {0.1, 0.6, 0.0}, tip) || walksInto(isVoid, p, q);
  });
  EXPECT_GT(expected.share, 0.05);
  EXPECT_LT(expected.share, 0.8);
  EXPECT_NEAR(interactionShare(a, b, near, adaptive(1e-3)), expected.share, 2e-3 + expected.error);
  EXPECT_NEAR(interactionShare(a, b, near, uniform(20)), expected.share, 5e-3 + expected.error);
}

TEST(BondDecomposition, VoidsAreAsThinAsTheyAreHoweverTheyAreTurned) {
  constexpr double spacing = 1e-3, c = 0.8, s = 0.6, length = 2e-3;
  for (const double half : {0.9e-9, 1.1e-9}) {
    const Place along{c * length, s * length, 0.0}, across{-s * half, c * half, 0.0}, normal{0.0, 0.0, length};
    const auto at = [&](double u, double v) { return plus(plus({0.01, 0.01, 0.0}, along, u), across, v); };
    for (const Ellipsoid& shape :
         {Ellipsoid{{0.01, 0.01, 0.0}, {along, across}}, Ellipsoid{{0.01, 0.01, 0.0}, {along, across, normal}},
          Ellipsoid{{0.01, 0.01, 0.0}, {across, normal}}})
      EXPECT_EQ(complaintOfVoid(*ellipsoidVoid(shape), spacing).empty(), half > 1e-9);
    EXPECT_NEAR(ellipsoidVoid({{}, {along, across}})->inradius(), half, 1e-9 * half);
    // Slender, a polygon counts for twice that, and a bent one, too.
    EXPECT_NEAR(polygonVoid({at(-1, -1), at(1, -1), at(1, 1), at(-1, 1)})->inradius(), 2.0 * half, 1e-5 * half);
  }
  const double a = 1e-4, w = 1e-10;
  const auto bent = polygonVoid({{0, 0, 0}, {a, 0, 0}, {a, w, 0}, {w, w, 0}, {w, a, 0}, {0, a, 0}});
  EXPECT_NEAR(bent->inradius(), w, 1e-5 * w);
  EXPECT_FALSE(complaintOfVoid(*bent, spacing).empty());
  EXPECT_NEAR(polygonVoid({{0, 0, 0}, {6, 0, 0}, {6, 6, 0}, {0, 6, 0}})->inradius(), 3.0, 1e-12);
}

TEST(BondDecomposition, FormsInSpace) {
  const Cell a = cube(0.0, 0.0, 0.0), b = cube(1.0, 1.0, 1.0);
  const Ellipsoid ball{{0.6, 0.3, 0.4}, {{0.3, 0.0, 0.0}, {0.0, 0.2, 0.0}, {0.0, 0.0, 0.4}}};
  const auto pore = ellipsoidVoid(ball);
  const auto surface = ellipsoidScreen(ball);
  const auto isPore = [&](const Place& p) { return pore->contains(p); };
  const Sampled past = sampled(a, b, isPore, [&](const Place& p, const Place& q) { return walksInto(isPore, p, q); });
  EXPECT_NEAR(interactionShare(a, b, {{surface.get()}, {pore.get()}}, adaptive(1e-3)), past.share, 3e-3 + past.error);

  const auto isNowhere = [](const Place&) { return false; };
  const auto meetsPlane = [](const Place& p, const Place& q, const std::function<bool(const Place&)>& covers) {
    const double s = (0.55 - p[2]) / (q[2] - p[2]);
    return s > 0.0 && s < 1.0 && covers(plus(p, minus(q, p), s));
  };
  const auto disk = diskScreen({0.4, 0.5, 0.55}, {0.0, 0.0, -2.0}, 0.45);
  const Sampled pastDisk = sampled(a, b, isNowhere, [&](const Place& p, const Place& q) {
    return meetsPlane(p, q, [](const Place& x) { return std::hypot(x[0] - 0.4, x[1] - 0.5) < 0.45; });
  });
  EXPECT_NEAR(interactionShare(a, b, {{disk.get()}, {}}, adaptive(1e-3)), pastDisk.share, 6e-3 + pastDisk.error);
  const auto triangle = polygonScreen({{0.0, 0.0, 0.55}, {1.2, 0.1, 0.55}, {0.3, 0.9, 0.55}});
  const auto isLeft = [](const Place& x, double ax, double ay, double bx, double by) {
    return (bx - ax) * (x[1] - ay) - (by - ay) * (x[0] - ax) > 0.0;
  };
  const Sampled pastTriangle = sampled(a, b, isNowhere, [&](const Place& p, const Place& q) {
    return meetsPlane(p, q, [&](const Place& x) {
      return isLeft(x, 0.0, 0.0, 1.2, 0.1) && isLeft(x, 1.2, 0.1, 0.3, 0.9) && isLeft(x, 0.3, 0.9, 0.0, 0.0);
    });
  });
  EXPECT_NEAR(interactionShare(a, b, {{triangle.get()}, {}}, adaptive(1e-3)), pastTriangle.share,
              3e-3 + pastTriangle.error);
  EXPECT_NEAR(1.0 - solidShare(cube(0.6, 0.3, 0.4), {pore.get()}), 4.0 / 3.0 * pi * 0.3 * 0.2 * 0.4, 5e-4);
}

/// Mean over many uniform partitions, whose errors differ in sign.
double byManyPartitions(const Cell& a, const Cell& b, const NearDiscontinuities& near, int from, int to, int step) {
  double sum = 0.0;
  int count = 0;
  for (int n = from; n <= to; n += step, ++count) sum += interactionShare(a, b, near, uniform(n));
  return sum / count;
}

/// Screens and voids of several forms.
struct Forms {
  std::vector<std::unique_ptr<Screen>> screens;
  std::vector<std::unique_ptr<Void>> voids;
  void addEllipsoid(const Ellipsoid& shape) {
    screens.push_back(ellipsoidScreen(shape));
    voids.push_back(ellipsoidVoid(shape));
  }
  void addPolygon(const std::vector<Place>& corners) {
    voids.push_back(polygonVoid(corners));
    for (std::size_t k = 0; k < corners.size(); ++k)
      screens.push_back(segmentScreen(corners[k], corners[(k + 1) % corners.size()]));
  }
  NearDiscontinuities near() const {
    NearDiscontinuities all;
    for (const auto& screen : screens) all.screens.push_back(screen.get());
    for (const auto& v : voids) all.voids.push_back(v.get());
    return all;
  }
};

/// The adaptive rule of every kth bond, as parts of whole bonds between whole cells.
void expectTolerance(const std::vector<Cell>& cells, const Forms& forms, int every, int from, int to, int step,
                     double most) {
  const NearDiscontinuities near = forms.near();
  std::vector<double> solid;
  for (const Cell& cell : cells) solid.push_back(solidShare(cell, near.voids));
  int number = 0, nShared = 0;
  double squares = 0.0;
  for (std::size_t i = 0; i < cells.size(); ++i)
    for (std::size_t j = i + 1; j < cells.size(); ++j) {
      if (lengthOf(minus(cells[i].center, cells[j].center)) > 2.3 || solid[i] * solid[j] == 0.0) continue;
      const double share = interactionShare(cells[i], cells[j], near, adaptive(1e-3));
      if (share == 0.0 || share == 1.0 || ++number % every != 0) continue;
      const double expected = byManyPartitions(cells[i], cells[j], near, from, to, step);
      const double error = solid[i] * solid[j] * (share - expected);
      EXPECT_LT(std::abs(error), most) << i << " " << j;
      squares += error * error;
      ++nShared;
    }
  EXPECT_GT(nShared, 10);
  EXPECT_LT(std::sqrt(squares / nShared), 0.4 * most);
}

std::vector<Cell> jittered(int n, double jitter) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> move(-jitter, jitter);
  std::vector<Cell> cells;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) cells.push_back(square(i + move(random), j + move(random)));
  return cells;
}

TEST(BondDecomposition, TheAdaptiveRuleKeepsToItsTolerance) {
  for (const double jitter : {0.0, 0.3}) {
    Forms rim, pores, polygon;
    rim.addEllipsoid({{2.61, 2.37, 0.0}, {{1.9, 0.0, 0.0}, {0.0, 1.9, 0.0}}});
    std::mt19937 random(2);
    std::uniform_real_distribution<double> place(0.0, 5.0), size(0.02, 0.4);
    for (int k = 0; k < 15; ++k) {
      const double radius = size(random);
      pores.addEllipsoid({{place(random), place(random), 0.0}, {{radius, 0.0, 0.0}, {0.0, radius, 0.0}}});
    }
    polygon.addPolygon({{0.217, 1.911, 0.0}, {2.523, 1.713, 0.0}, {2.013, 3.117, 0.0}, {3.419, 4.813, 0.0}});
    for (const Forms* forms : {&rim, &pores, &polygon})
      expectTolerance(jittered(6, jitter), *forms, 3, 32, 64, 4, 2e-3);
  }
}

TEST(BondDecomposition, TheAdaptiveRuleInSpaceIsNearItsTolerance) {
  Forms ball, cylinder, disk;
  ball.addEllipsoid({{1.2, 0.9, 0.8}, {{0.8, 0.0, 0.0}, {0.0, 0.7, 0.1}, {0.0, -0.1, 0.7}}});
  cylinder.addEllipsoid({{1.2, 0.9, 0.0}, {{0.7, 0.0, 0.0}, {0.0, 0.7, 0.0}}});
  disk.screens.push_back(diskScreen({1.1, 0.9, 0.55}, {0.1, 0.2, 1.0}, 1.1));
  std::vector<Cell> cells;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      for (int k = 0; k < 3; ++k) cells.push_back(cube(i, j, k));
  for (const Forms* forms : {&ball, &cylinder, &disk}) expectTolerance(cells, *forms, 9, 17, 21, 4, 4e-3);
}

/// A crack through points, which then are on the side of its normal; along the bond; along the edge of cells; through
/// cells.
TEST(BondDecomposition, CracksAlongBondsThroughPointsAndOnEdges) {
  const auto through = segmentScreen({-5.0, 0.0, 0.0}, {5.0, 0.0, 0.0});
  const auto onEdge = segmentScreen({-5.0, 0.5, 0.0}, {5.0, 0.5, 0.0});
  const auto inside = segmentScreen({-5.0, 0.3, 0.0}, {5.0, 0.2, 0.0});
  for (const DecompositionRule& rule : {uniform(20), adaptive(1e-3)}) {
    const auto share = [&](const std::unique_ptr<Screen>& crack, const Cell& a, const Cell& b) {
      return interactionShare(a, b, {{crack.get()}, {}}, rule);
    };
    EXPECT_EQ(share(through, square(0.0, 0.0), square(1.0, 0.0)), 1.0);
    EXPECT_EQ(share(through, square(0.0, 0.0), square(0.0, 1.0)), 1.0);
    EXPECT_EQ(share(through, square(0.0, -1.0), square(0.0, 0.0)), 0.0);
    EXPECT_EQ(share(onEdge, square(0.0, 0.0), square(1.0, 0.0)), 1.0);
    EXPECT_EQ(share(onEdge, square(0.0, 0.0), square(1.0, 1.0)), 0.0);
    EXPECT_EQ(share(inside, square(0.0, 0.0), square(1.0, 0.0)), 1.0);
    EXPECT_EQ(share(inside, square(0.0, 0.0), square(1.0, 1.0)), 0.0);
  }
}

/// Where a crack ends in a cell, places that its point does not see do not count.
TEST(BondDecomposition, ACellIsOnTheSideOfItsPoint) {
  const Place start{-2.0, 0.3, 0.0}, tip{0.9, 0.2, 0.0};
  const auto crack = segmentScreen(start, tip);
  const Cell a = square(0.0, 0.0), b = square(1.0, 1.0), c = square(1.0, 0.0);
  const auto meets = [&](const Place& p, const Place& q) { return segmentsCross(p, q, start, tip); };
  for (const Cell& other : {b, c}) {
    const auto isBehind = [&](const Place& p) {
      const Cell& own = std::max(std::abs(p[0] - a.center[0]), std::abs(p[1] - a.center[1])) < 0.5 ? a : other;
      return meets(own.center, p);
    };
    const Sampled expected = sampled(a, other, isBehind, meets);
    const NearDiscontinuities near{{crack.get()}, {}};
    EXPECT_NEAR(interactionShare(a, other, near, adaptive(1e-3)), expected.share, 2e-3 + expected.error);
    EXPECT_NEAR(interactionShare(other, a, near, adaptive(1e-3)), expected.share, 2e-3 + expected.error);
    EXPECT_NEAR(interactionShare(a, other, near, uniform(20)), expected.share, 5e-3 + expected.error);
  }
}

/// A slit through the points of a row parts the body: the cells of the row all hold on to one of its faces only.
TEST(BondDecomposition, AVoidThroughAPointLeavesOneSide) {
  for (const double turn : {0.0, 0.3, 0.5 * pi, -0.7})
    for (const double shift : {0.0, 0.01, 0.03, -0.03}) {
      const Place along{std::cos(turn), std::sin(turn), 0.0}, across{-std::sin(turn), std::cos(turn), 0.0};
      const Place middle = plus({}, across, shift);
      const std::vector<Place> corners{
          plus(plus(middle, along, -9.0), across, -0.033), plus(plus(middle, along, 9.0), across, -0.033),
          plus(plus(middle, along, 9.0), across, 0.033), plus(plus(middle, along, -9.0), across, 0.033)};
      NearDiscontinuities near;
      std::vector<std::unique_ptr<Screen>> sides;
      for (std::size_t k = 0; k < 4; ++k) sides.push_back(segmentScreen(corners[k], corners[(k + 1) % 4]));
      for (const auto& side : sides) near.screens.push_back(side.get());
      const auto slit = polygonVoid(corners);
      near.voids.push_back(slit.get());
      const auto at = [&](double s, double h) {
        return square(s * along[0] + h * across[0], s * along[1] + h * across[1]);
      };
      for (const DecompositionRule& rule : {uniform(20), adaptive(1e-3)}) {
        const double up = interactionShare(at(0.0, 0.0), at(0.0, 1.5), near, rule),
                     down = interactionShare(at(0.0, 0.0), at(0.0, -1.5), near, rule);
        EXPECT_EQ(std::min(up, down), 0.0) << turn << " " << shift;
        EXPECT_GT(std::max(up, down), 0.95) << turn << " " << shift;
        EXPECT_GT(interactionShare(at(0.0, 0.0), at(1.5, 0.0), near, rule), 0.95) << turn << " " << shift;
        EXPECT_EQ(interactionShare(at(0.0, 1.5), at(0.3, -1.5), near, rule), 0.0);
      }
    }
}

/// Where two slits cross in a point its cell holds on to one of the four corners only.
TEST(BondDecomposition, SlitsThatCrossInAPointLeaveOneCorner) {
  for (const double turn : {0.0, 0.3, -0.7}) {
    const auto at = [&](double s, double h) {
      return Place{s * std::cos(turn) - h * std::sin(turn), s * std::sin(turn) + h * std::cos(turn), 0.0};
    };
    Forms slits;
    slits.addPolygon({at(-9.0, -0.033), at(9.0, -0.033), at(9.0, 0.033), at(-9.0, 0.033)});
    slits.addPolygon({at(-0.033, -9.0), at(0.033, -9.0), at(0.033, 9.0), at(-0.033, 9.0)});
    const NearDiscontinuities near = slits.near();
    for (const DecompositionRule& rule : {uniform(20), adaptive(1e-3)}) {
      int nHeld = 0;
      for (const double s : {-1.1, 1.1})
        for (const double h : {-1.1, 1.1}) {
          const Place other = at(s, h);
          const double share = interactionShare(square(0.0, 0.0), square(other[0], other[1]), near, rule);
          EXPECT_TRUE(share == 0.0 || share > 0.95) << turn;
          nHeld += share > 0.0 ? 1 : 0;
        }
      EXPECT_EQ(nHeld, 1) << turn;
    }
  }
}

TEST(BondDecomposition, GapsInSpaceThatCrossAtAPointLeaveOneQuarter) {
  Forms gaps;
  gaps.addEllipsoid({{}, {{0.0, 0.0, 0.04}, {90.0, 0.0, 0.0}, {0.0, 90.0, 0.0}}});
  gaps.addEllipsoid({{}, {{0.0, 0.0, 90.0}, {90.0, 0.0, 0.0}, {0.0, 0.04, 0.0}}});
  int nHeld = 0;
  for (const int y : {-1, 1})
    for (const int z : {-1, 1})
      nHeld += interactionShare(cube(0, 0, 0), cube(1, y, z), gaps.near(), uniform(4)) > 0.0 ? 1 : 0;
  EXPECT_EQ(nHeld, 1);
  EXPECT_GT(interactionShare(cube(0, 0, 0), cube(2, 0, 0), gaps.near(), uniform(4)), 0.9);
}

TEST(BondDecomposition, AGapInSpaceThroughAPointLeavesOneSide) {
  const Ellipsoid shape{{}, {{0.0, 0.0, 0.04}, {90.0, 0.0, 0.0}, {0.0, 90.0, 0.0}}};
  const auto screen = ellipsoidScreen(shape);
  const auto gap = ellipsoidVoid(shape);
  const NearDiscontinuities near{{screen.get()}, {gap.get()}};
  EXPECT_GT(interactionShare(cube(0, 0, 0), cube(0, 1, 1), near, uniform(4)), 0.9);
  EXPECT_EQ(interactionShare(cube(0, 0, 0), cube(0, 1, -1), near, uniform(4)), 0.0);
  EXPECT_GT(interactionShare(cube(0, 0, 0), cube(2, 0, 0), near, uniform(4)), 0.9);
}

/// A pore at a point, whose material hangs together around it, hides none of it, in the cell or beside it: of the
/// larger one the cell has four corners.
TEST(BondDecomposition, APoreAtAPointLeavesAllSides) {
  for (const double radius : {0.3, 0.55}) {
    Forms pore;
    pore.addEllipsoid({{0.02, 0.01, 0.0}, {{radius, 0.0, 0.0}, {0.0, radius, 0.0}}});
    for (const auto& [x, y] : {std::pair(1.0, 0.0), std::pair(-1.0, 0.0), std::pair(0.0, 1.0), std::pair(0.0, -1.0)})
      EXPECT_GT(interactionShare(square(0, 0), square(x, y), pore.near(), adaptive(1e-3)), 0.3) << radius;
  }
}

TEST(BondDecomposition, RulesForTips) {
  const auto crack = segmentScreen({-5.0, 0.5, 0.0}, {0.3, 0.5, 0.0});
  const auto share = [&](double x, DecompositionRule::Kind kind) {
    DecompositionRule rule;
    rule.kind = kind;
    return interactionShare(square(0.0, 0.0), square(x, 1.0), {{crack.get()}, {}}, rule);
  };
  using Kind = DecompositionRule::Kind;
  for (const Kind kind : {Kind::Both, Kind::Either, Kind::Intersection}) EXPECT_EQ(share(-1.0, kind), 0.0);
  EXPECT_EQ(share(0.5, Kind::Intersection), 0.0);  // crosses at 0.25
  EXPECT_EQ(share(1.0, Kind::Intersection), 1.0);  // at 0.5
  EXPECT_EQ(share(0.5, Kind::Both), 1.0);
  EXPECT_EQ(share(1.0, Kind::Either), 0.0);
}

TEST(BondDecomposition, APoreOnTheMiddleOfABond) {
  // Where it is exactly there, and where it is not quite.
  const Cell a = square(-0.5, 0.0), b = square(0.5, 0.0);
  const auto share = [&](double y) {
    const Ellipsoid circle{{0.0, y, 0.0}, {{0.2, 0.0, 0.0}, {0.0, 0.2, 0.0}}};
    const auto screen = ellipsoidScreen(circle);
    const auto hole = ellipsoidVoid(circle);
    return interactionShare(a, b, {{screen.get()}, {hole.get()}}, adaptive(1e-3));
  };
  EXPECT_NEAR(share(0.0), share(1e-9), 1e-6);
  EXPECT_LT(share(0.0), 0.9);
}

TEST(BondDecomposition, PoresTakeTheirVolume) {
  const auto disc = [](double x, double y, double radius) {
    return ellipsoidVoid({{x, y, 0.0}, {{radius, 0.0, 0.0}, {0.0, radius, 0.0}}});
  };
  const auto taken = [](const std::vector<const Void*>& voids) { return 1.0 - solidShare(square(0.0, 0.0), voids); };
  for (const double radius : {0.002, 0.01, 0.2}) {
    const double area = pi * radius * radius;
    const auto whole = disc(0.0237, 0.0411, radius), half = disc(0.1237, 0.5, radius),
               quarter = disc(-0.5, 0.5, radius);
    EXPECT_NEAR(taken({whole.get()}), area, 1e-4 * area);
    EXPECT_NEAR(taken({half.get()}), 0.5 * area, 1e-3 * area);
    EXPECT_NEAR(taken({quarter.get()}), 0.25 * area, 1e-3 * area);
    // Two that overlap take their union: circles a radius apart.
    const auto beside = disc(0.0237 + radius, 0.0411, radius);
    EXPECT_NEAR(taken({whole.get(), beside.get()}), (4.0 / 3.0 * pi + 0.5 * std::sqrt(3.0)) * radius * radius,
                2e-3 * area);
    EXPECT_NEAR(taken({whole.get(), whole.get()}), area, 1e-4 * area);
  }
}

}  // namespace
