// Energies, reactions, strain, stress and J, against fields with known answers.
#include <gtest/gtest.h>

#include <cmath>

#include "../support/small_body.hpp"
#include "Peridigm_Material.hpp"

using namespace pdtest;
using PeridigmNS::FieldManager;
namespace PeridigmField = PeridigmNS::PeridigmField;

namespace {

constexpr double pi = 3.14159265358979323846;

/// Moduli as given, energy density = its density times the local number of the point plus one.
class SimpleMaterial : public PeridigmNS::Material {
 public:
  SimpleMaterial(double density, double bulkModulus, double shearModulus)
      : Material(Teuchos::ParameterList()), density_(density), bulk_(bulkModulus), shear_(shearModulus) {}
  std::string Name() const override { return "Simple"; }
  double Density() const override { return density_; }
  double BulkModulus() const override { return bulk_; }
  double ShearModulus() const override { return shear_; }
  std::vector<int> FieldIds() const override { return {}; }
  void computeStoredElasticEnergyDensity(const double, const int n, const int* owned, const int*,
                                         PeridigmNS::DataManager& data) const override {
    double* energy = nullptr;
    data.getData(FieldManager::self().getFieldId("Stored_Elastic_Energy_Density"), PeridigmField::STEP_NONE)
        ->ExtractView(&energy);
    for (int i = 0; i < n; ++i) energy[owned[i]] = density_ * (owned[i] + 1);
  }

 private:
  double density_, bulk_, shear_;
};

/// Three points on a line, volumes 1 2 3, the last in a block of its own with three times the density.
class Energies : public ::testing::Test {
 protected:
  Energies() : body(lattice(3, 1, 1, 1.0), options()) {
    body.block(0).setMaterialModel(Teuchos::rcp(new SimpleMaterial(10.0, 1.0, 1.0)));
    body.block(1).setMaterialModel(Teuchos::rcp(new SimpleMaterial(30.0, 1.0, 1.0)));
    body.addNodeSet("Last", {2});
    body.addNodeSet("First Two", {0, 1});
  }
  static BodyOptions options() {
    BodyOptions result;
    result.volumes = {1.0, 2.0, 3.0};
    result.blockOf = [](int id) { return id < 2 ? 1 : 2; };
    return result;
  }
  static Teuchos::ParameterList on(const char* nodeSet) {
    Teuchos::ParameterList result;
    result.set<std::string>("Node Set", nodeSet);
    return result;
  }
  SmallBody body;
};

TEST_F(Energies, StrainEnergyIsWhatTheMaterialsReport) {
  makeCompute(body, "Strain_Energy")->compute(body.blocks());
  EXPECT_DOUBLE_EQ(body.value("Strain_Energy"), 10.0 * 1.0 + 20.0 * 2.0 + 90.0 * 3.0);
  makeCompute(body, "Strain_Energy", on("First Two"))->compute(body.blocks());
  EXPECT_DOUBLE_EQ(body.value("Strain_Energy"), 50.0);
  makeCompute(body, "Stored_Elastic_Energy")->compute(body.blocks());
  EXPECT_DOUBLE_EQ(body.value("Stored_Elastic_Energy", 2), 270.0);
  makeCompute(body, "Stored_Elastic_Energy_Density")->compute(body.blocks());
  EXPECT_DOUBLE_EQ(body.value("Stored_Elastic_Energy_Density", 1), 20.0);
}

TEST_F(Energies, KineticEnergyOfEachPointAndOfAll) {
  const auto total = makeCompute(body, "Global_Kinetic_Energy");
  for (int i = 0; i < 3; ++i) {
    body.field("Velocity")[3 * i] = 3.0;
    body.field("Velocity")[3 * i + 1] = 4.0;
  }
  total->compute(body.blocks());
  EXPECT_DOUBLE_EQ(body.value("Global_Kinetic_Energy"), 12.5 * (10.0 + 20.0 + 90.0));
  makeCompute(body, "Kinetic_Energy")->compute(body.blocks());
  EXPECT_DOUBLE_EQ(body.value("Kinetic_Energy", 2), 12.5 * 90.0);
}

TEST_F(Energies, ForceAndAccelerationFollowFromTheForceDensity) {
  const auto force = makeCompute(body, "Force"), acceleration = makeCompute(body, "Acceleration");
  for (int i = 0; i < 9; ++i) {
    body.field("Force_Density")[i] = 60.0 * (i + 1);
    body.field("External_Force_Density")[i] = i == 8 ? 60.0 : 0.0;
  }
  force->compute(body.blocks());
  acceleration->compute(body.blocks());
  EXPECT_DOUBLE_EQ(body.field("Force")[5], 2.0 * 360.0);
  EXPECT_DOUBLE_EQ(body.field("Acceleration")[5], 36.0);
  EXPECT_DOUBLE_EQ(body.field("Acceleration")[8], 20.0);  // of the denser block
}

TEST_F(Energies, RadiusIsThatOfABallOfTheVolume) {
  makeCompute(body, "Radius")->compute(body.blocks());
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(4.0 / 3.0 * pi * std::pow(body.value("Radius", i), 3), i + 1.0, 1e-14);
}

TEST_F(Energies, ReactionBalancesTheInternalForceAndTheLoadsOfTheSet) {
  const auto compute = makeCompute(body, "Reaction_Force", on("First Two"));
  for (int i = 0; i < 3; ++i) {
    body.field("Force_Density")[3 * i + 1] = 10.0 * (i + 1);
    body.field("External_Force_Density")[3 * i + 1] = -4.0;
  }
  compute->compute(body.blocks());
  EXPECT_DOUBLE_EQ(body.value("Reaction_Force", 0), 0.0);
  EXPECT_DOUBLE_EQ(body.value("Reaction_Force", 1), -(10.0 + 40.0) + 4.0 * (1.0 + 2.0));
}

TEST_F(Energies, WorkOnASpringIsHalfForceTimesDisplacementInAnyNumberOfSteps) {
  const double stiffness = 8.0;
  for (const int steps : {1, 5}) {
    Teuchos::ParameterList parameters = on("Last");
    const std::string label = "Work_In_" + std::to_string(steps);
    parameters.set<std::string>("Output Label", label);
    const auto compute = makeCompute(body, "External_Work", parameters);
    for (int k = 1; k <= steps; ++k) {
      const double u = 0.5 * k / steps;
      body.field("Displacement")[6] = u;
      body.field("Force_Density")[6] = -stiffness * u;
      compute->compute(body.blocks());
    }
    compute->compute(body.blocks());  // the same state again adds nothing
    EXPECT_DOUBLE_EQ(body.value(label), 0.5 * stiffness * 0.25 * 3.0);
  }
}

/// As of grips whose displacement does not begin at zero: the body follows in the first load step.
TEST_F(Energies, WorkOnASpringThatIsDisplacedAtTheStartIsTheSame) {
  const double stiffness = 8.0;
  const auto compute = makeCompute(body, "External_Work", on("Last"));
  body.field("Displacement")[6] = 0.5;
  compute->compute(body.blocks());
  EXPECT_DOUBLE_EQ(body.value("External_Work"), 0.0);
  body.field("Force_Density")[6] = -stiffness * 0.5;
  compute->compute(body.blocks());
  EXPECT_DOUBLE_EQ(body.value("External_Work"), 0.5 * stiffness * 0.25 * 3.0);
}

TEST_F(Energies, BodyForceWorksAtPointsThatAreNotHeld) {
  Teuchos::ParameterList parameters;
  parameters.set("Node Sets", Teuchos::Array<std::string>(1, "Last"));
  const auto compute = makeCompute(body, "External_Work", parameters);
  for (int i = 0; i < 3; ++i) body.field("External_Force_Density")[3 * i] = 4.0;
  compute->compute(body.blocks());
  for (int i = 0; i < 3; ++i) body.field("Displacement")[3 * i] = 0.1;
  compute->compute(body.blocks());
  EXPECT_NEAR(body.value("External_Work"), 4.0 * 0.1 * (1.0 + 2.0), 1e-15);
}

/// x -> F x
std::function<Point(const Point&)> linear(const std::array<double, 9>& f) {
  return [f](const Point& x) {
    Point y{};
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) y[i] += f[3 * i + j] * x[j];
    return y;
  };
}

double elementOf(SmallBody& body, const char* label, int point, int row, int column) {
  return body.value(label, 9 * point + 3 * row + column);
}

TEST(BondStrain, OfALinearFieldIsExactAtEveryPointWithAnyBondsBroken) {
  BodyOptions options;
  options.horizon = 1.8;
  options.blockOf = [](int id) { return id % 3; };
  SmallBody body(lattice(4, 4, 4, 1.0), options);
  body.deform(linear({1.01, 0.02, 0.0, 0.004, 0.98, 0.03, -0.006, 0.0, 1.005}));
  body.breakBonds([](const Point& a, const Point& b) { return (a[0] - 1.5) * (b[0] - 1.5) < 0.0; });
  makeCompute(body, "Bond_Strain")->compute(body.blocks());
  const double expected[3][3] = {{0.01, 0.012, -0.003}, {0.012, -0.02, 0.015}, {-0.003, 0.015, 0.005}};
  for (int p = 0; p < body.nOwned(); ++p)
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) EXPECT_NEAR(elementOf(body, "Bond_Strain", p, i, j), expected[i][j], 1e-13) << p;
}

TEST(DeformationGradient, OfALinearFieldIsExactAtEveryPoint) {
  BodyOptions options;
  options.horizon = 1.8;
  SmallBody body(lattice(4, 4, 4, 1.0), options);
  const std::array<double, 9> gradient{1.01, 0.02, 0.0, 0.004, 0.98, 0.03, -0.006, 0.0, 1.005};
  body.deform(linear(gradient));
  makeCompute(body, "Deformation_Gradient")->compute(body.blocks());
  for (int p = 0; p < body.nOwned(); ++p)
    for (int k = 0; k < 9; ++k)
      EXPECT_NEAR(body.value("Deformation_Gradient", 9 * p + k), gradient[static_cast<std::size_t>(k)], 1e-13) << p;
}

TEST(BondStrain, OfAPlaneBodyLeavesTheThirdAxisAlone) {
  BodyOptions options;
  options.horizon = 1.5e-6;
  SmallBody body(lattice(4, 4, 1, 1e-6), options);
  body.deform(linear({1.01, 0.02, 0.0, 0.0, 0.98, 0.0, 0.0, 0.0, 1.0}));
  makeCompute(body, "Bond_Strain")->compute(body.blocks());
  EXPECT_NEAR(elementOf(body, "Bond_Strain", 5, 0, 1), 0.01, 1e-13);
  for (int k = 0; k < 3; ++k) EXPECT_EQ(elementOf(body, "Bond_Strain", 5, 2, k), 0.0);
}

TEST(BondStrain, GreenLagrangeIgnoresRotation) {
  BodyOptions options;
  options.horizon = 1.5;
  SmallBody body(lattice(3, 3, 1, 1.0), options);
  const double c = std::cos(0.7), s = std::sin(0.7);
  body.deform(linear({c, -s, 0.0, s, c, 0.0, 0.0, 0.0, 1.0}));
  Teuchos::ParameterList parameters;
  parameters.set<std::string>("Strain Measure", "Green-Lagrange");
  makeCompute(body, "Bond_Strain", parameters)->compute(body.blocks());
  for (int k = 0; k < 9 * 9; ++k) EXPECT_NEAR(body.value("Bond_Strain", k), 0.0, 1e-14);
  makeCompute(body, "Bond_Strain")->compute(body.blocks());
  EXPECT_NEAR(elementOf(body, "Bond_Strain", 4, 0, 0), c - 1.0, 1e-14);
}

TEST(BondStrain, OfALoosePointIsZero) {
  SmallBody body(lattice(3, 1, 1, 1.0), {});
  body.deform(linear({1.1, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0}));
  body.breakBonds([](const Point& a, const Point& b) { return a[0] < 0.5 || b[0] < 0.5; });
  makeCompute(body, "Bond_Strain")->compute(body.blocks());
  for (int k = 0; k < 9; ++k) EXPECT_EQ(body.value("Bond_Strain", k), 0.0);
  EXPECT_NEAR(elementOf(body, "Bond_Strain", 1, 0, 0), 0.1, 1e-14);
}

TEST(BondStress, OfAPlateInTensionIsYoungsModulusTimesStrain) {
  const double young = 200.0, poisson = 0.3;
  const double bulk = young / (3.0 * (1.0 - 2.0 * poisson)), shear = young / (2.0 * (1.0 + poisson));
  BodyOptions options;
  options.horizon = 1.5;
  SmallBody body(lattice(3, 3, 1, 1.0), options);
  body.block().setMaterialModel(Teuchos::rcp(new SimpleMaterial(1.0, bulk, shear)));
  body.deform(linear({1.001, 0.0, 0.0, 0.0, 1.0 - 0.001 * poisson, 0.0, 0.0, 0.0, 1.0}));
  Teuchos::ParameterList parameters;
  parameters.set("Plane Stress", true);
  makeCompute(body, "Bond_Stress", parameters)->compute(body.blocks());
  EXPECT_NEAR(elementOf(body, "Bond_Stress", 4, 0, 0), 0.001 * young, 1e-12);
  EXPECT_NEAR(elementOf(body, "Bond_Stress", 4, 1, 1), 0.0, 1e-12);
  EXPECT_EQ(elementOf(body, "Bond_Stress", 4, 2, 2), 0.0);

  // Plane strain, laterally free: sigma_x = E/(1 - nu^2) eps for eps_y = -nu/(1 - nu) eps, sigma_z = nu sigma_x.
  body.deform(linear({1.001, 0.0, 0.0, 0.0, 1.0 - 0.001 * poisson / (1.0 - poisson), 0.0, 0.0, 0.0, 1.0}));
  makeCompute(body, "Bond_Stress")->compute(body.blocks());
  const double expected = 0.001 * young / (1.0 - poisson * poisson);
  EXPECT_NEAR(elementOf(body, "Bond_Stress", 4, 0, 0), expected, 1e-12);
  EXPECT_NEAR(elementOf(body, "Bond_Stress", 4, 1, 1), 0.0, 1e-12);
  EXPECT_NEAR(elementOf(body, "Bond_Stress", 4, 2, 2), poisson * expected, 1e-12);
}

/// The displacement of a mode I crack tip at the origin, with the crack along the negative x axis (Williams 1957).
std::function<Point(const Point&)> modeOneField(double stressIntensity, double shear, double kappa) {
  return [=](const Point& x) {
    const double r = std::hypot(x[0], x[1]), theta = std::atan2(x[1], x[0]);
    const double scale = stressIntensity / (2.0 * shear) * std::sqrt(r / (2.0 * pi)) * (kappa - std::cos(theta));
    return Point{x[0] + scale * std::cos(0.5 * theta), x[1] + scale * std::sin(0.5 * theta), x[2]};
  };
}

/// A square with a crack from the left to (3, 0), under a mode I field of intensity 0.01.
class JOfModeOne : public ::testing::TestWithParam<bool> {
 protected:
  JOfModeOne() : body(lattice(n, n, 1, 1.0, {-29.5, -29.5, 0.0}), options()) {
    const double young = 200.0, poisson = 0.3;
    const double bulk = young / (3.0 * (1.0 - 2.0 * poisson)), shear = young / (2.0 * (1.0 + poisson));
    const bool isPlaneStress = GetParam();
    const double kappa = isPlaneStress ? (3.0 - poisson) / (1.0 + poisson) : 3.0 - 4.0 * poisson;
    energyReleaseRate = 1e-4 / (isPlaneStress ? young : young / (1.0 - poisson * poisson));
    body.block().setMaterialModel(Teuchos::rcp(new SimpleMaterial(1.0, bulk, shear)));
    displaced = [field = modeOneField(0.01, shear, kappa)](const Point& x) {
      const Point y = field({x[0] - 3.0, x[1], x[2]});
      return Point{y[0] + 3.0, y[1], y[2]};
    };
    body.deform(displaced);
    body.breakBonds([](const Point& a, const Point& b) {
      return a[1] * b[1] < 0.0 && a[0] + a[1] / (a[1] - b[1]) * (b[0] - a[0]) < 3.0;
    });
    parameters.set("Plane Stress", isPlaneStress);
    parameters.set("Thickness", thickness);
    parameters.set("Inner Radius", 8.0);
    parameters.set("Outer Radius", 16.0);
  }
  static BodyOptions options() {
    BodyOptions result;
    result.horizon = 1.5;
    result.volumes.assign(n * n, thickness);
    return result;
  }
  double ratio() {
    makeCompute(body, "J_Integral", parameters)->compute(body.blocks());
    return body.value("J_Integral") / energyReleaseRate;
  }

  static constexpr int n = 60;
  static constexpr double thickness = 0.5;
  SmallBody body;
  std::function<Point(const Point&)> displaced;
  Teuchos::ParameterList parameters;
  double energyReleaseRate;
};

// The strains are central differences over 1.5 spacings: second order, (1.5/8)^2 / 3 = 1 % at the inner radius.
TEST_P(JOfModeOne, IsTheEnergyReleaseRateOnEveryRing) {
  parameters.set("Tip X", 3.0);
  EXPECT_NEAR(ratio(), 1.0, 0.01);
  parameters.set("Inner Radius", 16.0);
  parameters.set("Outer Radius", 26.0);
  EXPECT_NEAR(ratio(), 1.0, 0.01);
}

TEST_P(JOfModeOne, FollowsATipThatAFieldReports) {
  body.allocate({FieldManager::self().getFieldId(PeridigmField::GLOBAL, PeridigmField::VECTOR, PeridigmField::CONSTANT,
                                                 "Some_Tip")});
  body.field("Some_Tip")[0] = 3.0;
  parameters.set<std::string>("Tip Field", "Some_Tip");
  EXPECT_NEAR(ratio(), 1.0, 0.01);
}

TEST_P(JOfModeOne, RefusesAnEmptyRingAndATipFieldOfPoints) {
  parameters.set<std::string>("Tip Field", "Volume");
  EXPECT_THROW(ratio(), std::invalid_argument);
  parameters.remove("Tip Field");
  parameters.set("Outer Radius", 7.0);
  EXPECT_THROW(ratio(), std::invalid_argument);
}

INSTANTIATE_TEST_SUITE_P(Planes, JOfModeOne, ::testing::Bool());

/// The displacement of a mode II tip, as above: positive where the upper face moves along x over the lower one.
Point modeTwo(double x, double y, double stressIntensity, double shear, double kappa) {
  const double r = std::hypot(x, y), theta = std::atan2(y, x);
  const double scale = stressIntensity / (2.0 * shear) * std::sqrt(r / (2.0 * pi));
  return {scale * std::sin(0.5 * theta) * (kappa + 2.0 + std::cos(theta)),
          -scale * std::cos(0.5 * theta) * (kappa - 2.0 + std::cos(theta)), 0.0};
}

TEST_P(JOfModeOne, ModesAreToldApart) {
  const double young = 200.0, poisson = 0.3, shear = young / (2.0 * (1.0 + poisson));
  const double kappa = GetParam() ? (3.0 - poisson) / (1.0 + poisson) : 3.0 - 4.0 * poisson;
  const auto modeOne = modeOneField(0.01, shear, kappa);
  body.deform([&](const Point& x) {
    const Point one = modeOne({x[0] - 3.0, x[1], x[2]}), two = modeTwo(x[0] - 3.0, x[1], -0.004, shear, kappa);
    return Point{one[0] + two[0] + 3.0, one[1] + two[1], x[2]};
  });
  parameters.set("Tip X", 3.0);
  makeCompute(body, "Stress_Intensity", parameters)->compute(body.blocks());
  EXPECT_NEAR(body.field("Stress_Intensity")[0] / 0.01, 1.0, 0.01);
  EXPECT_NEAR(body.field("Stress_Intensity")[1] / -0.004, 1.0, 0.015);
}

// On a lip, by one bond, hangs a point that has gone astray; nobody else sees it.
TEST_P(JOfModeOne, PassesOverPointsThatHaveNearlyComeLoose) {
  parameters.set("Tip X", 3.0);
  const double sound = ratio();
  const Point loose{-8.5, 0.5, 0.0}, neighbor{-7.5, 0.5, 0.0};
  body.breakBonds([&](const Point& a, const Point& b) { return (a == loose && b != neighbor) || b == loose; });
  body.deform([&](const Point& x) { return x == loose ? Point{x[0] + 0.01, x[1] + 0.01, 0.0} : displaced(x); });
  EXPECT_NEAR(ratio(), sound, 0.005);
}

// The same tip, turned: the ring knows the direction of the crack from the field beside the tip's.
TEST_P(JOfModeOne, FollowsTheDirectionThatATipReports) {
  const double young = 200.0, poisson = 0.3, shear = young / (2.0 * (1.0 + poisson));
  const double kappa = GetParam() ? (3.0 - poisson) / (1.0 + poisson) : 3.0 - 4.0 * poisson;
  const double c = std::cos(0.6), s = std::sin(0.6);
  const auto modeOne = modeOneField(0.01, shear, kappa);
  SmallBody turned(lattice(n, n, 1, 1.0, {-29.5, -29.5, 0.0}), options());
  const double bulk = young / (3.0 * (1.0 - 2.0 * poisson));
  turned.block().setMaterialModel(Teuchos::rcp(new SimpleMaterial(1.0, bulk, shear)));
  const auto seen = [=](const Point& x) {
    return Point{c * (x[0] - 3.0) + s * (x[1] - 2.0), c * (x[1] - 2.0) - s * (x[0] - 3.0), 0.0};
  };
  turned.deform([&](const Point& x) {
    const Point at = seen(x), one = modeOne(at), two = modeTwo(at[0], at[1], -0.004, shear, kappa);
    return Point{3.0 + c * (one[0] + two[0]) - s * (one[1] + two[1]),
                 2.0 + s * (one[0] + two[0]) + c * (one[1] + two[1]), x[2]};
  });
  turned.breakBonds([&](const Point& p, const Point& q) {
    const Point a = seen(p), b = seen(q);
    return a[1] * b[1] < 0.0 && a[0] + a[1] / (a[1] - b[1]) * (b[0] - a[0]) < 0.0;
  });
  for (const char* label : {"Some_Tip", "Some_Tip_Direction"})
    turned.allocate({FieldManager::self().getFieldId(PeridigmField::GLOBAL, PeridigmField::VECTOR,
                                                     PeridigmField::CONSTANT, label)});
  turned.field("Some_Tip")[0] = 3.0;
  turned.field("Some_Tip")[1] = 2.0;
  turned.field("Some_Tip_Direction")[0] = c;
  turned.field("Some_Tip_Direction")[1] = s;
  parameters.set<std::string>("Tip Field", "Some_Tip");
  makeCompute(turned, "Stress_Intensity", parameters)->compute(turned.blocks());
  EXPECT_NEAR(turned.field("Stress_Intensity")[0] / 0.01, 1.0, 0.01);
  EXPECT_NEAR(turned.field("Stress_Intensity")[1] / -0.004, 1.0, 0.025);
  makeCompute(turned, "J_Integral", parameters)->compute(turned.blocks());
  EXPECT_NEAR(turned.value("J_Integral") / (energyReleaseRate * 1.16), 1.0, 0.01);  // K_I^2 + K_II^2
  // A direction of the deck goes before: along x this is another integral.
  parameters.set("Direction X", 1.0);
  makeCompute(turned, "J_Integral", parameters)->compute(turned.blocks());
  EXPECT_LT(turned.value("J_Integral"), 0.98 * energyReleaseRate * 1.16);
}

}  // namespace
