// Crack tip, length and area on bodies whose damage is set by hand.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

#include "../support/small_body.hpp"

using namespace pdtest;
using PeridigmNS::FieldManager;
namespace PeridigmField = PeridigmNS::PeridigmField;

namespace {

int damageField() {
  return FieldManager::self().getFieldId(PeridigmField::ELEMENT, PeridigmField::SCALAR, PeridigmField::TWO_STEP,
                                         "Damage");
}

/// 6 x 4 points, spacing 1, from (0, -1.5): a crack along y = 0 lies between the two middle rows. Two blocks, one
/// above the other.
class Crack : public ::testing::Test {
 protected:
  Crack() : body(lattice(6, 4, 1, 1.0, {0.0, -1.5, 0.0}), options()) { body.allocate({damageField()}); }
  static BodyOptions options() {
    BodyOptions result;
    result.horizon = 1.5;
    result.blockOf = [](int id) { return id < 12 ? 1 : 2; };
    return result;
  }
  void setDamage(int column, double value) {
    for (const int row : {1, 2}) body.field("Damage")[6 * row + column] = value;
  }
  Point tip(const Teuchos::ParameterList& parameters = Teuchos::ParameterList()) {
    makeCompute(body, "Crack_Tip", parameters)->compute(body.blocks());
    const double* x = body.field("Crack_Tip");
    return {x[0], x[1], x[2]};
  }
  double length(const Teuchos::ParameterList& parameters = Teuchos::ParameterList()) {
    makeCompute(body, "Crack_Length", parameters)->compute(body.blocks());
    return body.value("Crack_Length");
  }
  SmallBody body;
};

TEST_F(Crack, TipLiesWhereDamageFallsThroughTheThresholdOnThePlaneBetweenTheLips) {
  setDamage(0, 0.5);
  setDamage(1, 0.5);
  setDamage(2, 0.46);
  setDamage(3, 0.06);
  const Point x = tip();
  EXPECT_NEAR(x[0], 2.0 + (0.46 - 0.36) / (0.46 - 0.06), 1e-12);
  EXPECT_NEAR(x[1], 0.0, 1e-12);
  EXPECT_EQ(x[2], 0.0);
  EXPECT_NEAR(length(), 2.25, 1e-12);
}

TEST_F(Crack, WithoutInterpolationTheTipIsThePoint) {
  setDamage(2, 0.46);
  Teuchos::ParameterList parameters;
  parameters.set("Interpolate", false);
  EXPECT_EQ(tip(parameters)[0], 2.0);
}

TEST_F(Crack, AnIntactBodyHasItsTipAtTheStart) {
  setDamage(2, 0.35);
  Teuchos::ParameterList parameters;
  parameters.set("Start X", -0.5);
  EXPECT_EQ(tip(parameters)[0], -0.5);
  EXPECT_EQ(length(parameters), 0.0);
}

TEST_F(Crack, LooksAlongItsDirectionAndInItsRegionOnly) {
  setDamage(2, 0.46);
  setDamage(4, 0.46);
  Teuchos::ParameterList parameters;
  parameters.set("Interpolate", false);
  parameters.set("Direction X", -2.0);
  EXPECT_EQ(tip(parameters)[0], 2.0);

  body.addNodeSet("Left Half", {0, 1, 2, 6, 7, 8, 12, 13, 14, 18, 19, 20});
  parameters.set("Direction X", 1.0);
  EXPECT_EQ(tip(parameters)[0], 4.0);
  parameters.set<std::string>("Node Set", "Left Half");
  EXPECT_EQ(tip(parameters)[0], 2.0);

  Teuchos::ParameterList ofBlock;
  ofBlock.set("Interpolate", false);
  ofBlock.set<std::string>("Block", "block_2");
  EXPECT_EQ(tip(ofBlock)[1], 0.5);
}

TEST_F(Crack, StraightDistanceOfAKinkedCrack) {
  for (const int id : {1, 6 + 2, 12 + 3, 18 + 4}) body.field("Damage")[id] = 1.0;  // from (1, -1.5) to (4, 1.5)
  Teuchos::ParameterList parameters;
  parameters.set("Interpolate", false);
  parameters.set("Start X", 1.0);
  parameters.set("Start Y", -2.5);
  EXPECT_DOUBLE_EQ(length(parameters), 3.0);
  parameters.set<std::string>("Measure", "Distance");
  EXPECT_DOUBLE_EQ(length(parameters), 5.0);
}

/// A plate with a notch from the left, 60 degrees wide, whose root is at the origin; points 1 apart.
class VNotch : public ::testing::Test {
 protected:
  VNotch() : body(plate(), options()) {
    body.allocate({damageField()});
    parameters.set("Start X", 0.0);
    parameters.set("Start Y", 0.0);
  }
  static std::vector<Point> plate() {
    std::vector<Point> points;
    for (const Point& x : lattice(17, 12, 1, 1.0, {-8.0, -5.5, 0.0}))
      if (std::abs(x[1]) > -x[0] / std::sqrt(3.0)) points.push_back(x);
    return points;
  }
  static BodyOptions options() {
    BodyOptions result;
    result.horizon = 1.5;
    return result;
  }
  void damage(double x, double y, double value = 0.5) {
    for (int i = 0; i < body.nPoints(); ++i)
      if (body.point(i)[0] == x && body.point(i)[1] == y) body.field("Damage")[i] = value;
  }
  Point tip() {
    makeCompute(body, "Crack_Tip", parameters)->compute(body.blocks());
    const double* x = body.field("Crack_Tip");
    return {x[0], x[1], x[2]};
  }
  SmallBody body;
  Teuchos::ParameterList parameters;
};

TEST_F(VNotch, DamageOnAFlankIsNoCrack) {
  damage(-5.0, 3.5);
  EXPECT_EQ(tip(), (Point{0.0, 0.0, 0.0}));
  damage(7.0, 5.5);  // nor is damage far ahead, at a pin
  EXPECT_EQ(tip(), (Point{0.0, 0.0, 0.0}));
}

TEST_F(VNotch, FollowsWhatHangsTogetherWithItsRoot) {
  damage(5.0, -0.5);
  for (const double x : {0.0, 1.0, 2.0})
    for (const double y : {-0.5, 0.5}) damage(x, y);
  EXPECT_NEAR(tip()[0], 5.0 + 0.14 / 0.5, 1e-12);  // on the line of the crack, connected or not
  damage(5.0, -0.5, 0.0);
  damage(5.0, -2.5);
  EXPECT_NEAR(tip()[0], 2.0 + 0.14 / 0.5, 1e-12);
  EXPECT_EQ(tip()[1], 0.0);
  damage(3.0, -1.5);
  EXPECT_NEAR(tip()[0], 3.0 + 0.14 / 0.5, 1e-12);
  EXPECT_EQ(tip()[1], -1.5);
  damage(4.0, -2.5);
  EXPECT_NEAR(tip()[0], 5.0 + 0.14 / 0.5, 1e-12);
  EXPECT_EQ(tip()[1], -2.5);
}

TEST_F(VNotch, NeverGoesBackWhileNothingHeals) {
  std::mt19937 random(3);
  double before = 0.0;
  for (int step = 0; step < 2000; ++step) {
    double& value = body.field("Damage")[random() % static_cast<unsigned>(body.nPoints())];
    value += (1.0 - value) * 0.01 * static_cast<double>(random() % 60);
    const double now = tip()[0];
    ASSERT_GE(now, before - 1e-12) << step;
    before = now;
  }
  EXPECT_EQ(before, 8.0);
}

/// Points 1 apart, damaged by the bonds that a curve cuts.
class CurvedCrack : public ::testing::Test {
 protected:
  using Cut = std::function<bool(const Point& a, const Point& b)>;
  CurvedCrack() : body(lattice(60, 60, 1, 1.0, {-19.5, -19.5, 0.0}), options()) {
    body.allocate({damageField()});
    for (const char* key : {"Start X", "Start Y"}) parameters.set(key, 0.0);
    parameters.set<std::string>("Path", "Curved");
    parameters.set("Threshold", 0.2);  // where bonds are half cut the tip is
  }
  static BodyOptions options() {
    BodyOptions result;
    result.horizon = 3.015;
    return result;
  }
  void cut(const Cut& crosses) {
    for (int i = 0; i < body.nPoints(); ++i) {
      double nCut = 0.0, n = 0.0;
      for (int j = 0; j < body.nPoints(); ++j) {
        const Point &a = body.point(i), &b = body.point(j);
        if (i == j || std::hypot(a[0] - b[0], a[1] - b[1]) > 3.015) continue;
        n += 1.0;
        nCut += crosses(a, b) ? 1.0 : 0.0;
      }
      body.field("Damage")[i] = nCut / n;
    }
  }
  /// From there by so much at an angle to x.
  static Cut line(Point from, double angle, double length) {
    const double c = std::cos(angle), s = std::sin(angle);
    return [=](const Point& a, const Point& b) {
      const double across[2] = {c * (a[1] - from[1]) - s * (a[0] - from[0]),
                                c * (b[1] - from[1]) - s * (b[0] - from[0])};
      const double along[2] = {c * (a[0] - from[0]) + s * (a[1] - from[1]),
                               c * (b[0] - from[0]) + s * (b[1] - from[1])};
      if (across[0] * across[1] >= 0.0) return false;
      const double at = along[0] + across[0] / (across[0] - across[1]) * (along[1] - along[0]);
      return at > 0.0 && at < length;
    };
  }
  /// The way keeps to the inner side of a turn, a strip of three or four rows of points, and the end of the crack lags
  /// behind its tip: both grow with the angle that it turns by.
  void expectTip(const Point& tip, double angle, double length, double turn = 0.0) {
    makeCompute(body, "Crack_Tip", parameters)->compute(body.blocks());
    makeCompute(body, "Crack_Length", parameters)->compute(body.blocks());
    const double *x = body.field("Crack_Tip"), *direction = body.field("Crack_Tip_Direction");
    EXPECT_NEAR(x[0], tip[0], 0.6);
    EXPECT_NEAR(x[1], tip[1], 0.6);
    EXPECT_NEAR(std::remainder(std::atan2(direction[1], direction[0]) - angle, 2.0 * pi), 0.0, 0.06 + 0.05 * turn);
    EXPECT_NEAR(body.value("Crack_Length"), length, 0.6 + 0.015 * length + 1.2 * turn);
  }
  static constexpr double pi = 3.14159265358979323846;
  SmallBody body;
  Teuchos::ParameterList parameters;
};

TEST_F(CurvedCrack, IsFollowedAtAnyAngle) {
  for (const double degrees : {0.0, 10.0, 20.0, 45.0, 80.0}) {
    SCOPED_TRACE(degrees);
    const double angle = degrees * pi / 180.0;
    cut(line({0.0, 0.0, 0.0}, angle, 25.3));
    expectTip({25.3 * std::cos(angle), 25.3 * std::sin(angle), 0.0}, angle, 25.3);
  }
}

TEST_F(CurvedCrack, IsFollowedAroundMoreThanHalfACircle) {
  const double radius = 12.2, last = 1.2 * pi;  // of the circle around (0, radius), from its lowest point on
  cut([=](const Point& a, const Point& b) {
    const double here = std::hypot(a[0], a[1] - radius) - radius, there = std::hypot(b[0], b[1] - radius) - radius;
    if (here * there >= 0.0) return false;
    const double share = here / (here - there);
    const double angle = std::atan2(a[0] + share * (b[0] - a[0]), radius - a[1] - share * (b[1] - a[1]));
    return std::remainder(angle - 0.5 * last, 2.0 * pi) > -0.5 * last &&
           std::remainder(angle - 0.5 * last, 2.0 * pi) < 0.5 * last;
  });
  parameters.set("Direction X", 0.0);  // what is left of the start is behind it otherwise
  parameters.set("Direction Y", 1.0);
  const double lag = 3.0 / radius;  // the direction is that of the last two horizons
  expectTip({radius * std::sin(last), radius * (1.0 - std::cos(last)), 0.0}, last - lag, radius * last, last);
}

TEST_F(CurvedCrack, IsNothingBehindItsStart) {
  cut(line({-18.0, 0.0, 0.0}, 0.0, 25.0));
  expectTip({7.0, 0.0, 0.0}, 0.0, 7.0);
}

TEST_F(CurvedCrack, KinksAndGoesOnFromItsStart) {
  const Cut first = line({0.0, 0.0, 0.0}, 0.0, 15.0), second = line({15.0, 0.0, 0.0}, pi / 3.0, 12.0);
  cut([&](const Point& a, const Point& b) { return first(a, b) || second(a, b); });
  expectTip({21.0, 6.0 * std::sqrt(3.0), 0.0}, pi / 3.0, 27.0, pi / 3.0);
}

TEST_F(CurvedCrack, AnIntactBodyHasItsTipAtTheStartAndDamageElsewhereIsNoCrack) {
  cut(line({8.0, 0.0, 0.0}, 0.0, 5.0));
  makeCompute(body, "Crack_Tip", parameters)->compute(body.blocks());
  EXPECT_EQ(body.field("Crack_Tip")[0], 0.0);
  EXPECT_EQ(body.field("Crack_Tip_Direction")[0], 1.0);
  makeCompute(body, "Crack_Length", parameters)->compute(body.blocks());
  EXPECT_EQ(body.value("Crack_Length"), 0.0);
}

TEST_F(CurvedCrack, NeedsAStart) {
  parameters.remove("Start Y");
  EXPECT_THROW(makeCompute(body, "Crack_Tip", parameters), std::invalid_argument);
  parameters.set<std::string>("Path", "Straight");
  parameters.set<std::string>("Measure", "Along Path");
  EXPECT_THROW(makeCompute(body, "Crack_Length", parameters), std::invalid_argument);
}

TEST_F(Crack, ZeroDirectionIsRefused) {
  Teuchos::ParameterList parameters;
  parameters.set("Direction Y", 0.0);
  EXPECT_THROW(tip(parameters), std::invalid_argument);
}

TEST(BrokenBonds, CountsEachBondOnceOverAllBlocks) {
  BodyOptions options;
  options.blockOf = [](int id) { return id < 3 ? 1 : 2; };
  SmallBody body(lattice(3, 2, 1, 1.0), options);
  const auto compute = makeCompute(body, "Broken_Bonds");
  compute->compute(body.blocks());
  EXPECT_EQ(body.value("Broken_Bonds"), 0.0);
  body.breakBonds([](const Point& a, const Point& b) { return a[1] != b[1]; });
  compute->compute(body.blocks());
  EXPECT_EQ(body.value("Broken_Bonds"), 3.0);
}

/// Breaks the bonds of a lattice with spacing 1 that pass the plane `axis` = 0.5 within a window of `width`.
void cut(SmallBody& body, std::size_t axis, double start, double width) {
  body.breakBonds([=](const Point& a, const Point& b) {
    if ((a[axis] - 0.5) * (b[axis] - 0.5) >= 0.0) return false;
    const double share = (0.5 - a[axis]) / (b[axis] - a[axis]);
    for (std::size_t k = 0; k < axis; ++k) {
      const double crossing = a[k] + share * (b[k] - a[k]);
      if (crossing < start || crossing >= start + width) return false;
    }
    return true;
  });
}

// Area of a cut along a row of a square lattice, over its length: G/G0 along the grid at m = 3.015 for full neighbour
// areas (1.006) and for neighbour areas that ramp to the horizon plus half a spacing (1.030).
class PlaneCrackArea : public ::testing::TestWithParam<std::pair<double, double>> {};

TEST_P(PlaneCrackArea, PerLengthIsTheFractureEnergyRatioOfTheLattice) {
  const auto [longestBond, expected] = GetParam();
  const double thickness = 0.25;
  BodyOptions options;
  options.horizon = longestBond;
  options.volumes.assign(16 * 8, thickness);
  SmallBody body(lattice(16, 8, 1, 1.0, {0.0, -3.0, 0.0}), options);
  Teuchos::ParameterList parameters;
  parameters.set("Horizon", 3.015);
  parameters.set("Thickness", thickness);
  const auto compute = makeCompute(body, "Crack_Area", parameters);
  compute->compute(body.blocks());
  EXPECT_EQ(body.value("Crack_Area"), 0.0);
  cut(body, 1, 4.87, 5.0);
  compute->compute(body.blocks());
  EXPECT_NEAR(body.value("Crack_Area") / (5.0 * thickness), expected, 1e-3);
}

INSTANTIATE_TEST_SUITE_P(VolumeAlgorithms, PlaneCrackArea,
                         ::testing::Values(std::make_pair(3.015, 1.006), std::make_pair(3.515, 1.030)));

TEST(CrackArea, OfASolidIsTheSumOverCrossingBonds) {
  const double horizon = 2.01;
  BodyOptions options;
  options.horizon = horizon;
  SmallBody body(lattice(9, 9, 6, 1.0, {0.0, 0.0, -2.0}), options);
  Teuchos::ParameterList parameters;
  parameters.set("Horizon", horizon);
  const auto compute = makeCompute(body, "Crack_Area", parameters);
  cut(body, 2, 2.9, 3.0);
  compute->compute(body.blocks());
  // A bond that rises by r crosses r planes of a column: independent sum over the stencil.
  double perArea = 0.0;
  for (int p = -2; p <= 2; ++p)
    for (int q = -2; q <= 2; ++q)
      for (int r = 1; r <= 2; ++r)
        if (std::hypot(p, q, r) <= horizon) perArea += r * std::hypot(p, q, r);
  const double pi = 3.14159265358979323846;
  EXPECT_NEAR(body.value("Crack_Area"), 9.0 * perArea / (pi * std::pow(horizon, 5) / 5.0), 1e-12);
}

}  // namespace
