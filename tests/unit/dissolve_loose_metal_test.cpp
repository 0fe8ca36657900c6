// Metal that hangs by no bond, and bonds of steps that are not taken.
#include "driver/solvers/corrosion/dissolve_loose_metal.hpp"

#include <gtest/gtest.h>
#include <mpi.h>

#include <algorithm>
#include <cmath>

#include "../model_plugins.hpp"
#include "../mpi/lattice.hpp"
#include "Peridigm_Field.hpp"

namespace pd::test {
namespace {

constexpr double solid = 100.0, saturation = 10.0;

/// A plate of metal with electrolyte in its first three columns.
class LooseMetalTest : public ::testing::Test {
 protected:
  LooseMetalTest() {
    for (int i = 0; i < model.nPoints(); ++i) concentration()[i] = x(i) < 2.5 ? 0.0 : solid;
    model.initialize();
    before.assign(concentration(), concentration() + model.nOwned());
  }

  double* concentration() { return model.field("Concentration"); }
  double x(int i) const { return model.discretization().x[3 * i]; }
  int id(int i) const { return model.discretization().globalIds[i]; }

  /// Takes the share(x, id) of what solid points can give, and lets bonds follow.
  template <class Share>
  void dissolve(Share share) {
    for (int i = 0; i < model.nOwned(); ++i)
      if (x(i) > 2.5) concentration()[i] = solid - (solid - saturation) * share(x(i), id(i));
    model.importGhosts("Concentration");
    model.evaluateDamage(1.0);
  }
  double metal() {
    double sum = 0.0;
    for (int i = 0; i < model.nOwned(); ++i) sum += model.field("Volume")[i] * concentration()[i];
    return comm.sum(sum);
  }
  std::vector<double> bonds() {
    double* values = nullptr;
    const auto data = (*model.blocks())[0].getData(PeridigmNS::FieldManager::self().getFieldId("Bond_Damage"),
                                                   PeridigmNS::PeridigmField::STEP_NP1);
    data->ExtractView(&values);
    return {values, values + data->MyLength()};
  }
  std::vector<double> values(const char* label) { return {model.field(label), model.field(label) + model.nOwned()}; }
  double total(const std::vector<double>& values) {
    double sum = 0.0;
    for (const double value : values) sum += value;
    return comm.sum(sum);
  }

  Communicator comm{MPI_COMM_WORLD};
  Deck deck = deckOf(
      "Materials: {Metal: {Material Model: Corrosion Dissolution, Diffusivity: 1.0, Solid Concentration: 100.0, "
      "Saturation Concentration: 10.0, Charge Number: 2.0, Current Density: \"1.0\", Plane Strain: true}}\n"
      "Damage Models: {Phases: {Damage Model: Dissolution, Rule: Stochastic, Random Seed: 2}}\n"
      "Blocks: {All: {Block Names: default, Material: Metal, Damage Model: Phases, Horizon: 3.0}}\n");
  Model model{deck, comm, Lattice{12, 9, 1, 3.0}.discretization(comm), {}};
  std::vector<double> before;
};

double nearlyAll(double x, int id) { return x < 3.5 && id / 12 % 2 == 0 ? 0.999 : x < 5.5 ? 0.3 : 0.0; }

TEST_F(LooseMetalTest, GoesFirstAtTheCostOfThoseAround) {
  dissolve(nearlyAll);
  const double metalBefore = metal();
  const std::vector<double> loose = values("Loose"), c = values("Concentration");
  ASSERT_GT(total(loose), 0.0);
  dissolveLooseMetalFirst(model, "Concentration", before, 1.0);
  EXPECT_NEAR(metal(), metalBefore, 1e-13 * metalBefore);
  for (int i = 0; i < model.nOwned(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    EXPECT_LE(concentration()[i], before[k]);
    if (loose[k] > 0.0) {
      // Points around it have given far more than 0.1 %.
      EXPECT_EQ(concentration()[i], saturation);
      EXPECT_EQ(model.field("Damage")[i], 1.0);
      EXPECT_EQ(model.field("Loose")[i], 0.0);
    } else {
      EXPECT_GE(concentration()[i], c[k]);
    }
    EXPECT_EQ(model.field("Dissolution_Demand")[i], 0.0);
  }
}

TEST_F(LooseMetalTest, TakesNoMoreThanTheStepTookFromThoseAround) {
  dissolve(nearlyAll);
  before = values("Concentration");
  // In the next step only a little goes, everywhere.
  for (int i = 0; i < model.nOwned(); ++i)
    if (x(i) > 2.5 && concentration()[i] > saturation && concentration()[i] < solid) concentration()[i] -= 1e-4;
  model.importGhosts("Concentration");
  const std::vector<double> loose = values("Loose");
  ASSERT_GT(total(loose), 0.0);
  const double metalBefore = metal();
  const std::vector<double> c = values("Concentration");
  dissolveLooseMetalFirst(model, "Concentration", before, 1.0);
  EXPECT_NEAR(metal(), metalBefore, 1e-13 * metalBefore);
  for (std::size_t i = 0; i < loose.size(); ++i) {
    const double now = concentration()[i];
    EXPECT_LE(now, before[i]);
    if (loose[i] > 0.0) {
      EXPECT_LT(now, c[i]);
      EXPECT_GT(now, saturation);  // 0.09 are left
    }
  }
}

TEST_F(LooseMetalTest, AStepThatIsTakenBackLeavesNothing) {
  dissolve([](double x, int) { return x < 5.5 ? 0.3 : 0.0; });
  model.acceptStep(1.0, 1.0);
  const std::vector<double> bondsBefore = bonds(), damage = values("Damage"), loose = values("Loose");
  const std::vector<double> c = values("Concentration");
  model.beginStep();
  for (int attempt = 0; attempt < 2; ++attempt) {
    dissolve([&](double x, int id) { return x < 3.5 ? 0.999 : x < 8.5 ? 0.6 + 0.01 * (id % (7 + attempt)) : 0.2; });
    ASSERT_GT(total(bonds()), total(bondsBefore));
    model.takeBackStep();
    EXPECT_EQ(bonds(), bondsBefore);
    EXPECT_EQ(values("Loose"), loose);
    EXPECT_EQ(values("Damage"), damage);
    EXPECT_EQ(values("Concentration"), c);
  }
  model.evaluateDamage(1.0);
  EXPECT_EQ(bonds(), bondsBefore);
  EXPECT_EQ(values("Damage"), damage);
}

}  // namespace
}  // namespace pd::test
