// The J-integral of bonds over a rectangle, on lattices of springs; what rectangles and rings of J are to lie in.
#include <gtest/gtest.h>

#include <cmath>

#include "../support/small_body.hpp"
#include "Peridigm_Material.hpp"
#include "bond_family.hpp"
#include "linear_bonds.hpp"
#include "run_notes.hpp"

using namespace pdtest;

namespace {

constexpr double young = 9.0, thickness = 0.5;  // of plane stress with a Poisson's ratio of 1/3

/// Constant micromodulus k_n = 9 E/(pi h horizon^3), whose bonds end at the horizon; or none at all.
class Springs : public PeridigmNS::Material, public pd::LinearBonds {
 public:
  Springs(SmallBody& body, double horizon) : Material(Teuchos::ParameterList()), body_(body), horizon_(horizon) {}
  std::string Name() const override { return "Springs"; }
  double Density() const override { return 1.0; }
  double BulkModulus() const override { return 1.0; }
  double ShearModulus() const override { return 1.0; }
  std::vector<int> FieldIds() const override { return {}; }
  bool hasSprings() const override { return horizon_ > 0.0; }
  pd::LinearSprings::Family springFamily() const override { return pd::LinearSprings::Family::None; }
  pd::LinearSprings springs(const pd::Call& call, PeridigmNS::DataManager&) const override {
    const double micromodulus = 9.0 * young / (M_PI * thickness * std::pow(horizon_, 3));
    pd::LinearSprings springs;
    pd::forEachBond(call, [&](int i, int j, std::size_t) {
      const Point &a = body_.point(i), &b = body_.point(j);
      const double length = std::hypot(a[0] - b[0], a[1] - b[1]);
      springs.along.push_back(0.5 * micromodulus * thickness * thickness / length);
    });
    return springs;
  }

 private:
  SmallBody& body_;
  double horizon_;
};

/// A square of spacing 1 with a crack from the left to (0, 0).
class NonlocalJ : public ::testing::Test {
 protected:
  NonlocalJ() : body(lattice(n, n, 1, 1.0, {0.5 - n / 2, 0.5 - n / 2, 0.0}), options()) {
    body.block().setMaterialModel(Teuchos::rcp(new Springs(body, horizon)));
    parameters.set("Thickness", thickness);
    rectangle(12.0, 12.0, 12.0);
  }
  static BodyOptions options() {
    BodyOptions result;
    result.horizon = horizon;
    result.volumes.assign(n * n, thickness);
    return result;
  }
  void rectangle(double ahead, double behind, double above) {
    parameters.set("Ahead", ahead);
    parameters.set("Behind", behind);
    parameters.set("Above", above);
  }
  double value() {
    makeCompute(body, "Nonlocal_J_Integral", parameters)->compute(body.blocks());
    return body.value("Nonlocal_J_Integral");
  }

  static constexpr int n = 60;
  static constexpr double horizon = 4.001;
  SmallBody body;
  Teuchos::ParameterList parameters;
};

TEST_F(NonlocalJ, IsNothingWithoutACrack) {
  // Uniform strain and rotation: what goes in on one side comes out on the other, wherever the sides are.
  body.deform([](const Point& x) { return Point{1.0002 * x[0] + 3e-4 * x[1], 2e-4 * x[0] + 0.9995 * x[1], x[2]}; });
  const double energyDensity = 1e-7 * young;
  for (const double ahead : {9.0, 12.3, 15.5}) {
    rectangle(ahead, 11.2, 8.9);
    parameters.set("Below", 14.0);
    EXPECT_NEAR(value() / (energyDensity * 10.0), 0.0, 1e-6);
  }
}

TEST_F(NonlocalJ, IsTheEnergyReleaseRateOverAnyRectangle) {
  // Williams' field of mode I. E' of this lattice is 8.65, 4 % less than that of the integrals, and with it the energy
  // that goes with displacements.
  const double poisson = 1.0 / 3.0, shear = young / (2.0 * (1.0 + poisson)), kappa = (3.0 - poisson) / (1.0 + poisson);
  const double intensity = 0.01;
  body.deform([=](const Point& x) {
    const double r = std::hypot(x[0], x[1]), t = std::atan2(x[1], x[0]);
    const double scale = intensity / (2.0 * shear) * std::sqrt(r / (2.0 * M_PI)) * (kappa - std::cos(t));
    return Point{x[0] + scale * std::cos(0.5 * t), x[1] + scale * std::sin(0.5 * t), x[2]};
  });
  body.breakBonds([](const Point& a, const Point& b) {
    return a[1] * b[1] < 0.0 && a[0] + a[1] / (a[1] - b[1]) * (b[0] - a[0]) < 0.0;
  });
  const double energyReleaseRate = intensity * intensity / young, first = value();
  EXPECT_NEAR(first / energyReleaseRate, 1.0, 0.05);
  for (const auto& [ahead, behind, above] : {std::array<double, 3>{16.0, 9.0, 12.0}, {10.3, 15.7, 18.2}}) {
    rectangle(ahead, behind, above);
    EXPECT_NEAR(value() / first, 1.0, 0.015);
  }
}

/// What the compute notes of a body in a square from -30 to 30 without the points of `isGone`, with the crack to the
/// tip along x.
std::string noteOf(const char* className, double horizon, Teuchos::ParameterList parameters,
                   const std::function<bool(const Point&)>& isGone, double angle, Point tip) {
  std::vector<Point> points;
  const double c = std::cos(angle), s = std::sin(angle);
  for (const Point& p : lattice(90, 90, 1, 1.0, {-44.4, -44.7, 0.0})) {
    const Point turned{c * p[0] - s * p[1], s * p[0] + c * p[1], 0.0};
    if (std::max(std::abs(turned[0]), std::abs(turned[1])) < 30.0 && !isGone(turned)) points.push_back(turned);
  }
  BodyOptions options;
  options.horizon = horizon;
  options.volumes.assign(points.size(), thickness);
  SmallBody body(points, options);
  body.block().setMaterialModel(Teuchos::rcp(new Springs(body, options.horizon)));
  parameters.set("Thickness", thickness);
  parameters.set("Tip X", tip[0]);
  parameters.set("Tip Y", tip[1]);
  const auto compute = makeCompute(body, className, parameters);
  compute->compute(body.blocks());
  const std::vector<std::string> notes = dynamic_cast<const pd::RunNotes&>(*compute).runNotes();
  return notes.empty() ? "" : notes.front();
}

/// `sides`: ahead, behind and above of the rectangle.
std::string noteOf(const std::function<bool(const Point&)>& isGone, std::array<double, 3> sides, double angle = 0.0,
                   Point tip = {0.0, 0.0, 0.0}) {
  Teuchos::ParameterList parameters;
  parameters.set("Ahead", sides[0]);
  parameters.set("Behind", sides[1]);
  parameters.set("Above", sides[2]);
  return noteOf("Nonlocal_J_Integral", 3.015, parameters, isGone, angle, tip);
}

TEST(RectangleOfJ, IsToBeFilledByTheBody) {
  const auto nothing = [](const Point&) { return false; };
  const auto hole = [](const Point& x) { return std::hypot(x[0] - 10.0, x[1] - 8.0) < 5.0; };
  const auto notch = [](const Point& x) { return x[0] < -5.0 && std::abs(x[1]) < 4.0; };
  for (const double angle : {0.0, 0.35}) {
    EXPECT_EQ(noteOf(nothing, {16.0, 16.0, 16.0}, angle), "");
    // Beyond the sides of the body along the crack there is nothing to add.
    EXPECT_EQ(noteOf(nothing, {16.0, 16.0, 45.0}, angle), "");
    EXPECT_EQ(noteOf(notch, {16.0, 20.0, 16.0}, angle), "");
    EXPECT_NE(noteOf(nothing, {40.0, 16.0, 16.0}, angle), "");
    EXPECT_NE(noteOf(nothing, {16.0, 40.0, 16.0}, angle), "");
    EXPECT_NE(noteOf(nothing, {16.0, 16.0, 16.0}, angle, {20.0, 0.0, 0.0}), "");
    EXPECT_NE(noteOf(hole, {18.0, 16.0, 16.0}, angle), "");
    EXPECT_EQ(noteOf(hole, {4.0, 16.0, 16.0}, angle), "");
  }
}

TEST(RingOfJ, IsToBeFilledByTheBody) {
  const auto noteOfRing = [](double inner, double outer, const std::function<bool(const Point&)>& isGone, double angle,
                             Point tip = {0.0, 0.0, 0.0}) {
    Teuchos::ParameterList parameters;
    parameters.set("Inner Radius", inner);
    parameters.set("Outer Radius", outer);
    return noteOf("J_Integral", 1.5, parameters, isGone, angle, tip);
  };
  const auto nothing = [](const Point&) { return false; };
  const auto hole = [](const Point& x) { return std::hypot(x[0] - 10.0, x[1] - 8.0) < 5.0; };
  const auto notch = [](const Point& x) { return x[0] < -5.0 && std::abs(x[1]) < 4.0; };
  const auto strip = [](const Point& x) { return std::abs(x[1]) > 10.0; };
  EXPECT_EQ(noteOfRing(6.0, 9.0, nothing, 0.0), "");
  const double angle = 0.35;
  EXPECT_EQ(noteOfRing(8.0, 16.0, nothing, angle), "");
  EXPECT_EQ(noteOfRing(6.0, 9.0, nothing, angle), "");
  EXPECT_EQ(noteOfRing(8.0, 16.0, strip, angle), "");
  EXPECT_EQ(noteOfRing(10.0, 20.0, notch, angle), "");
  EXPECT_NE(noteOfRing(8.0, 16.0, nothing, angle, {20.0, 0.0, 0.0}), "");
  EXPECT_NE(noteOfRing(8.0, 16.0, nothing, angle, {-20.0, 0.0, 0.0}), "");
  EXPECT_NE(noteOfRing(10.0, 18.0, hole, angle), "");
  EXPECT_EQ(noteOfRing(4.0, 7.0, hole, angle), "");
}

TEST_F(NonlocalJ, NeedsSpringsInAPlane) {
  SmallBody solid(lattice(4, 4, 2, 1.0), BodyOptions());
  solid.block().setMaterialModel(Teuchos::rcp(new Springs(solid, horizon)));
  EXPECT_THROW(makeCompute(solid, "Nonlocal_J_Integral", parameters), std::invalid_argument);
  body.block().setMaterialModel(Teuchos::rcp(new Springs(body, 0.0)));
  EXPECT_THROW(value(), std::invalid_argument);
}

}  // namespace
