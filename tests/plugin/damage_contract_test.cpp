// What every damage model must keep so that any host may call it. Each registered model is run with the parameter sets
// of samples.cpp, on fields that hold nothing but what it declares.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "Peridigm_Field.hpp"
#include "damage_run.hpp"
#include "plugins.hpp"

using namespace pdtest;
using PeridigmNS::FieldManager;
namespace PeridigmField = PeridigmNS::PeridigmField;

namespace {

constexpr int nSteps = 6;

class DamageContract : public ::testing::TestWithParam<Sample> {
 protected:
  Motion motionOf(int step) const { return pull(GetParam().dimension, 0.3 * step); }

  /// States at the end of each step of a history of loading.
  std::vector<DamageState> history(Layout layout) const {
    DamageRun run(GetParam(), layout);
    std::vector<DamageState> states;
    for (int k = 1; k <= nSteps; ++k) {
      run.evaluate(motionOf(k));
      states.push_back(run.state());
      run.updateState();
    }
    return states;
  }
};

TEST(DamageContract, EveryRegisteredModelHasSamples) {
  std::set<std::string> sampled;
  for (const Sample& sample : damageSamples()) sampled.insert(sample.plugin);
  for (const std::string& name : pd::DamageModelRegistry::self().names())
    EXPECT_TRUE(sampled.count(name) == 1 || name.find("Test ") == 0)
        << "add parameter sets of \"" << name << "\" to tests/plugin/samples.cpp";
}

TEST_P(DamageContract, BreaksSomeBondsStepByStepAndNeverMendsOne) {
  const std::vector<DamageState> states = history({});
  EXPECT_LT(states.front().nBroken(), states.back().nBroken());
  EXPECT_LT(states.back().nBroken(), static_cast<int>(states.back().bonds.size()));
  for (std::size_t k = 1; k < states.size(); ++k)
    for (const auto& [ends, damage] : states[k].bonds) EXPECT_GE(damage, states[k - 1].bonds.at(ends));
}

TEST_P(DamageContract, UnloadingKeepsTheState) {
  DamageRun run(GetParam(), {});
  run.evaluate(motionOf(nSteps));
  const DamageState loaded = run.state();
  run.updateState();
  for (int k = 0; k < 2; ++k) {
    run.evaluate(motionOf(0));
    EXPECT_TRUE(run.state() == loaded);
    run.updateState();
  }
}

TEST_P(DamageContract, ABondBreaksForBothOfItsEnds) {
  const DamageState state = history({}).back();
  for (const auto& [ends, damage] : state.bonds)
    EXPECT_EQ(damage, state.bonds.at({ends.second, ends.first})) << ends.first << " - " << ends.second;
}

TEST_P(DamageContract, DamageIsTheShareOfBrokenBondsFromTheStart) {
  DamageRun run(GetParam(), {});
  for (int k = 0; k <= 1; ++k) {
    const DamageState state = run.state();
    EXPECT_GT(state.nBroken(), 0);  // those that were cut
    std::vector<double> broken(state.damage.size()), all(state.damage.size());
    for (const auto& [ends, damage] : state.bonds) {
      broken[static_cast<std::size_t>(ends.first)] += damage;
      all[static_cast<std::size_t>(ends.first)] += 1.0;
    }
    for (std::size_t i = 0; i < all.size(); ++i) EXPECT_NEAR(state.damage[i], broken[i] / all[i], 1e-15);
    run.evaluate(motionOf(nSteps));
  }
}

TEST_P(DamageContract, InitializeIsIdempotent) {
  const DamageState expected = history({}).back();
  DamageRun run(GetParam(), {});
  run.initialize();
  for (int k = 1; k < nSteps; ++k) run.step(motionOf(k));
  run.evaluate(motionOf(nSteps));
  EXPECT_TRUE(run.state() == expected);
}

TEST_P(DamageContract, InitializeInTheMiddleOfARunKeepsTheState) {
  DamageRun run(GetParam(), {});
  run.step(motionOf(3));
  run.evaluate(motionOf(3));
  const DamageState before = run.state();
  run.initialize();
  EXPECT_TRUE(run.state() == before);
}

// Verlet in Peridigm makes every damage model anew in each step: its only memory is fields.
TEST_P(DamageContract, HasNoMemoryButFields) {
  const std::vector<DamageState> expected = history({});
  for (const BondSteps steps : {BondSteps::Shared, BondSteps::Copied, BondSteps::Swapped}) {
    Layout layout;
    layout.bondSteps = steps;
    DamageRun run(GetParam(), layout);
    for (int k = 1; k <= nSteps; ++k) {
      run.recreate();
      run.evaluate(motionOf(k));
      EXPECT_TRUE(run.state() == expected[static_cast<std::size_t>(k - 1)]) << "step " << k;
      run.updateState();
    }
  }
}

// A model may keep notes to save work (which bonds are far from breaking), but they must not be seen: jumps of load and
// of every field that it reads, the same state twice, protection switched on and off, a state read from a checkpoint.
TEST_P(DamageContract, NotesFromEarlierStepsAreNotSeen) {
  DamageRun kept(GetParam(), {}), renewed(GetParam(), {});
  const int noFailure = FieldManager::self().getFieldId(PeridigmField::NODE, PeridigmField::SCALAR,
                                                        PeridigmField::CONSTANT, "No_Failure");
  for (DamageRun* run : {&kept, &renewed}) run->body().allocate({noFailure});
  const DamageState start = kept.state();
  for (int k = 0; k < 30; ++k) {
    const double load = 0.9 + 0.9 * noise(k, 60);
    for (DamageRun* run : {&kept, &renewed}) {
      if (k % 10 == 9) run->setState(start);
      if (k % 3 == 1) run->fillScalars(60 + k, k % 6 == 1 ? 1.0 : 0.1);
      for (int i = 0; i < run->body().nPoints(); ++i)
        run->body().field("No_Failure")[i] = noise(run->body().globalId(i) + k / 4, 70) > 0.5 ? 1.0 : 0.0;
    }
    renewed.recreate();
    for (DamageRun* run : {&kept, &renewed}) run->evaluate(pull(GetParam().dimension, k % 5 == 0 ? 0.0 : load));
    ASSERT_TRUE(kept.state() == renewed.state()) << "step " << k;
    for (DamageRun* run : {&kept, &renewed}) run->updateState();
  }
  EXPECT_GT(kept.state().nBroken(), start.nBroken());
}

TEST_P(DamageContract, BondStorageMakesNoDifference) {
  const std::vector<DamageState> expected = history({});
  Layout layout;
  for (const BondSteps steps : {BondSteps::Copied, BondSteps::Swapped}) {
    layout.bondSteps = steps;
    const std::vector<DamageState> apart = history(layout);
    for (std::size_t k = 0; k < expected.size(); ++k) EXPECT_TRUE(apart[k] == expected[k]) << "step " << k + 1;
  }
}

TEST_P(DamageContract, BlocksAndRanksMakeNoDifference) {
  const std::vector<DamageState> expected = history({});
  for (const int nRanks : {1, 3})
    for (const int nBlocks : {1, 2}) {
      Layout layout;
      layout.nRanks = nRanks;
      layout.nBlocks = nBlocks;
      const std::vector<DamageState> split = history(layout);
      for (std::size_t k = 0; k < expected.size(); ++k)
        EXPECT_TRUE(split[k] == expected[k])
            << "step " << k + 1 << ", " << nRanks << " ranks, " << nBlocks << " blocks";
    }
}

TEST_P(DamageContract, EvaluatingTwiceIsEvaluatingOnce) {
  for (const BondSteps steps : {BondSteps::Shared, BondSteps::Copied, BondSteps::Swapped}) {
    if (steps == BondSteps::Shared && GetParam().seesItsStep) continue;
    Layout layout;
    layout.bondSteps = steps;
    const DamageState expected = history({}).front();
    DamageRun run(GetParam(), layout);
    run.evaluate(motionOf(1), 3);
    EXPECT_TRUE(run.state() == expected);
  }
}

TEST_P(DamageContract, RotationMakesNoDifference) {
  const DamageState expected = history({}).back();
  DamageRun run(GetParam(), {});
  const double c = std::cos(0.8), s = std::sin(0.8);
  for (int k = 1; k <= nSteps; ++k) {
    run.evaluate([&, motion = motionOf(k)](int id, const Point& x) {
      const Point y = motion(id, x);
      return Point{c * y[0] - s * y[1] + 2.0, s * y[0] + c * y[1], y[2]};
    });
    if (k == nSteps) {
      EXPECT_TRUE(run.state() == expected);
    }
    run.updateState();
  }
}

TEST_P(DamageContract, BondsOfProtectedPointsDoNotBreak) {
  DamageRun run(GetParam(), {});
  const DamageState start = run.state();
  run.body().allocate({FieldManager::self().getFieldId(PeridigmField::NODE, PeridigmField::SCALAR,
                                                       PeridigmField::CONSTANT, "No_Failure")});
  const auto isProtected = [](int id) { return id % 8 < 4; };
  for (int i = 0; i < run.body().nPoints(); ++i)
    run.body().field("No_Failure")[i] = isProtected(run.body().globalId(i)) ? 1.0 : 0.0;
  run.evaluate(motionOf(nSteps));
  int nElsewhere = 0;
  for (const auto& [ends, damage] : run.state().bonds) {
    if (isProtected(ends.first) || isProtected(ends.second)) {
      EXPECT_EQ(damage, start.bonds.at(ends));
    } else {
      nElsewhere += damage > start.bonds.at(ends) ? 1 : 0;
    }
  }
  EXPECT_GT(nElsewhere, 0);
}

std::string titleOf(const ::testing::TestParamInfo<Sample>& info) { return info.param.title; }
std::vector<Sample> samplesThatBreakBonds() {
  std::vector<Sample> samples = damageSamples();
  const auto breaksNone = [](const Sample& sample) { return !sample.breaksBonds; };
  samples.erase(std::remove_if(samples.begin(), samples.end(), breaksNone), samples.end());
  return samples;
}

INSTANTIATE_TEST_SUITE_P(DamageModels, DamageContract, ::testing::ValuesIn(samplesThatBreakBonds()), titleOf);

// Peridigm calls no precompute() of damage models: one that needs neighbours' results serves itself where all points
// are its own, and says what is amiss elsewhere.
TEST(NodalEnergyUnderPeridigm, NeedsNoPrecomputeOnOneRankAndSaysSoOnMore) {
  const std::vector<Sample> samples = damageSamples();
  const Sample sample =
      *std::find_if(samples.begin(), samples.end(), [](const Sample& one) { return one.plugin == "Nodal Energy"; });
  DamageRun whole(sample, {}), called(sample, {});
  called.evaluate(pull(sample.dimension, 1.8));
  whole.callsPrecompute = false;
  whole.evaluate(pull(sample.dimension, 1.8));
  EXPECT_GT(called.state().nBroken(), 0);
  EXPECT_TRUE(whole.state() == called.state());
  Layout layout;
  layout.nRanks = 3;
  DamageRun split(sample, layout);
  split.callsPrecompute = false;
  EXPECT_THROW(split.evaluate(pull(sample.dimension, 1.8)), std::runtime_error);
}

// A model that turns points from solid to liquid: by their concentrations alone, never back, and with no bond broken.
TEST(PhaseContract, DissolutionFollowsTheConcentrationAndIsForGood) {
  const Sample sample{"Dissolution", "Dissolution", 2, Teuchos::ParameterList()};
  const Scene scene = sceneOf(sample);
  const auto body = bareBody(scene, {}, 0);
  const auto model = pd::DamageModelRegistry::self().create("Dissolution", sample.parameters);
  body->allocate(model->FieldIds());
  double *damage = body->field("Damage"), *concentration = body->field("Concentration");
  for (int i = 0; i < body->nPoints(); ++i) {
    body->field("Solid_Concentration")[i] = i % 5 == 0 ? 0.0 : 10.0;
    body->field("Saturation_Concentration")[i] = 2.0;
    concentration[i] = i % 3 == 0 ? 2.0 : 8.0;
  }
  const auto points = body->block().getNeighborhoodData();
  const auto evaluate = [&] {
    model->computeDamage(0.1, points->NumOwnedPoints(), points->OwnedIDs(), points->NeighborhoodList(),
                         *body->block().getDataManager());
  };
  evaluate();
  for (int i = 0; i < body->nPoints(); ++i)
    EXPECT_DOUBLE_EQ(damage[i], i % 5 == 0 || i % 3 == 0 ? 1.0 : 0.25) << "point " << i;
  std::fill(concentration, concentration + body->nPoints(), 6.0);
  evaluate();
  for (int i = 0; i < body->nPoints(); ++i)
    EXPECT_DOUBLE_EQ(damage[i], i % 5 == 0 || i % 3 == 0 ? 1.0 : 0.5) << "point " << i;
}

}  // namespace
