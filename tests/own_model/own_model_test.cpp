// The plug-ins of materials/YOUR_OWN_MODEL.md, called by hand on a few points.
#include <gtest/gtest.h>

#include "plugins.hpp"
#include "tests/support/small_body.hpp"

namespace pdtest {
namespace {

constexpr double dt = 0.1;

/// Points at 0, 1, 3 m along x, all of them neighbours, that a stretch of 1/4 has moved.
class ThreePoints : public ::testing::Test {
 protected:
  ThreePoints() : body({{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {3.0, 0.0, 0.0}}, options()) {}
  static BodyOptions options() {
    BodyOptions result;
    result.horizon = 3.0;
    result.volumes = {2.0, 3.0, 5.0};
    result.isBare = true;
    result.bondSteps = BondSteps::Copied;
    return result;
  }
  void stretch() {
    body.deform([](const Point& x) { return Point{1.25 * x[0], x[1], x[2]}; });
  }
  template <class Call>
  void call(const Call& work) {
    const auto points = body.block().getNeighborhoodData();
    work(points->NumOwnedPoints(), points->OwnedIDs(), points->NeighborhoodList(), *body.block().getDataManager());
  }
  SmallBody body;
};

class Tiring : public ThreePoints {
 protected:
  Tiring() {
    Teuchos::ParameterList list;
    list.set("Rate", 40.0);  // 40 (1/4)^2 0.1 = 1/4: a bond lasts for four steps
    model = pd::DamageModelRegistry::self().create("Tiring Bonds", list);
    body.allocate(model->FieldIds());
    stretch();
  }
  void evaluate() {
    call([&](int n, const int* owned, const int* bonds, PeridigmNS::DataManager& data) {
      model->computeDamage(dt, n, owned, bonds, data);
    });
  }
  void accept() { body.block().getDataManager()->updateState(); }
  Teuchos::RCP<PeridigmNS::DamageModel> model;
};

TEST_F(Tiring, AStepCountsOnceAndALifeOfFourStepsEndsWithTheFourth) {
  for (int step = 1; step <= 4; ++step) {
    for (int repeated = 0; repeated < 3; ++repeated) evaluate();
    for (int bond = 0; bond < 6; ++bond) EXPECT_DOUBLE_EQ(body.field("Lost_Life")[bond], 0.25 * step);
    for (int i = 0; i < 3; ++i) EXPECT_EQ(body.field("Damage")[i], step == 4 ? 1.0 : 0.0);
    accept();
  }
}

TEST_F(Tiring, AComputeSeesTheMostTiredBond) {
  evaluate();
  body.field("Lost_Life")[4] = 0.6;
  makeCompute(body, "Most_Lost_Life")->compute(body.blocks());
  EXPECT_EQ(body.value("Most_Lost_Life"), 0.6);
}

TEST_F(ThreePoints, SpringsPullByStretchAndVolume) {
  Teuchos::ParameterList list;
  list.set("Density", 1.0);
  list.set("Micromodulus", 8.0);
  list.set("Horizon", 3.0);
  const auto springs = pd::MaterialRegistry::self().create("Springs", list);
  body.allocate(springs->FieldIds());
  stretch();
  call([&](int n, const int* owned, const int* bonds, PeridigmNS::DataManager& data) {
    springs->computeForce(dt, n, owned, bonds, data);
  });
  // c s = 2 N/m6 times the volumes to the right less those to the left.
  const double expected[] = {2.0 * (3.0 + 5.0), 2.0 * (5.0 - 2.0), -2.0 * (2.0 + 3.0)};
  for (int i = 0; i < 3; ++i) {
    EXPECT_DOUBLE_EQ(body.field("Force_Density")[3 * i], expected[i]);
    EXPECT_EQ(body.field("Force_Density")[3 * i + 1], 0.0);
  }
}

}  // namespace
}  // namespace pdtest
