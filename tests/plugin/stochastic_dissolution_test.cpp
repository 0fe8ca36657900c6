// Damage model Dissolution with rule Stochastic: what breaks follows from concentrations and seed alone, for any host.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "Peridigm_DamageModel.hpp"
#include "damage_run.hpp"
#include "plugins.hpp"

using namespace pdtest;

namespace {

constexpr double solidConcentration = 10.0, saturation = 2.0;
constexpr int nSteps = 8;

/// Metal with a hole of electrolyte (id % 11 == 0), dissolved unevenly by `load` from 0 to 1.
double concentrationOf(int id, double load) {
  if (id % 11 == 0) return 0.0;
  const double share = std::clamp(load * (1.1 + 0.6 * noise(id, 3)), 0.0, 1.0);
  return share == 1.0 ? saturation : solidConcentration - share * (solidConcentration - saturation);
}

/// A host of the model: ranks and blocks, fields, steps.
class DissolvingRun {
 public:
  explicit DissolvingRun(Layout layout, int seed = 1) : seed_(seed), scene_(sceneOf(sample())) {
    for (int rank = 0; rank < layout.nRanks; ++rank) {
      bodies_.push_back(bareBody(scene_, layout, rank));
      models_.emplace_back(bodies_.back()->blocks()->size());
    }
    recreate();
    for (const auto& body : bodies_) {
      body->allocate(models_.front().front()->FieldIds());
      for (int i = 0; i < body->nPoints(); ++i) {
        body->field("Solid_Concentration")[i] = body->globalId(i) % 11 == 0 ? 0.0 : solidConcentration;
        body->field("Saturation_Concentration")[i] = saturation;
      }
    }
    evaluate(0.0);
    updateState();
  }

  void recreate() {
    for (std::size_t r = 0; r < models_.size(); ++r)
      for (auto& model : models_[r]) model = pd::DamageModelRegistry::self().create("Dissolution", sample().parameters);
  }

  void evaluate(double load) {
    for (const auto& body : bodies_)
      for (int i = 0; i < body->nPoints(); ++i)
        body->field("Concentration")[i] = concentrationOf(body->globalId(i), load);
    for (std::size_t r = 0; r < bodies_.size(); ++r)
      for (std::size_t b = 0; b < models_[r].size(); ++b) {
        const auto list = bodies_[r]->block(b).getNeighborhoodData();
        models_[r][b]->computeDamage(0.1, list->NumOwnedPoints(), list->OwnedIDs(), list->NeighborhoodList(),
                                     *bodies_[r]->block(b).getDataManager());
      }
    copyToGhosts(bodies_, "Damage");
    copyToGhosts(bodies_, "Loose");
  }
  void updateState() {
    for (const auto& body : bodies_)
      for (PeridigmNS::Block& block : *body->blocks()) block.getDataManager()->updateState();
  }

  DamageState state() {
    DamageState state;
    state.damage.resize(scene_.points.size());
    for (const auto& body : bodies_)
      for (std::size_t b = 0; b < body->blocks()->size(); ++b) {
        const auto list = body->block(b).getNeighborhoodData();
        const int* entry = list->NeighborhoodList();
        const double* bondDamage = body->field("Bond_Damage", b);
        for (int i = 0; i < list->NumOwnedPoints(); ++i) {
          const int from = body->globalId(list->OwnedIDs()[i]);
          state.damage[static_cast<std::size_t>(from)] = body->field("Damage")[list->OwnedIDs()[i]];
          for (int n = *entry++; n > 0; --n) state.bonds[{from, body->globalId(*entry++)}] = *bondDamage++;
        }
      }
    return state;
  }
  SmallBody& body() { return *bodies_.front(); }

 private:
  Sample sample() const {
    Sample made{"StochasticDissolution", "Dissolution", 2, Teuchos::ParameterList()};
    made.parameters.set<std::string>("Rule", "Stochastic");
    made.parameters.set("Random Seed", seed_);
    return made;
  }

  int seed_;
  Scene scene_;
  std::vector<std::unique_ptr<SmallBody>> bodies_;
  std::vector<std::vector<Teuchos::RCP<PeridigmNS::DamageModel>>> models_;  ///< [rank][block]
};

double loadOf(int step) { return 0.4 * step / nSteps; }

std::vector<DamageState> history(Layout layout, bool recreates = false, int seed = 1) {
  DissolvingRun run(layout, seed);
  std::vector<DamageState> states;
  for (int k = 1; k <= nSteps; ++k) {
    if (recreates) run.recreate();
    run.evaluate(loadOf(k));
    states.push_back(run.state());
    run.updateState();
  }
  return states;
}

TEST(StochasticDissolution, BondsBreakForBothEndsAndForGood) {
  const std::vector<DamageState> states = history({});
  EXPECT_LT(states.front().nBroken(), states.back().nBroken());
  EXPECT_LT(states.back().nBroken(), static_cast<int>(states.back().bonds.size()));
  for (std::size_t k = 0; k < states.size(); ++k)
    for (const auto& [ends, damage] : states[k].bonds) {
      ASSERT_EQ(damage, states[k].bonds.at({ends.second, ends.first}));
      if (k > 0) {
        ASSERT_GE(damage, states[k - 1].bonds.at(ends));
      }
    }
}

TEST(StochasticDissolution, DamageIsTheShareOfBrokenBondsAndLiquidHasNone) {
  for (const double load : {0.0, 0.3, 0.9}) {
    DissolvingRun run({});
    run.evaluate(load);
    const DamageState state = run.state();
    std::vector<double> broken(state.damage.size()), all(state.damage.size());
    for (const auto& [ends, damage] : state.bonds) {
      broken[static_cast<std::size_t>(ends.first)] += damage;
      all[static_cast<std::size_t>(ends.first)] += 1.0;
    }
    int nLiquid = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
      const bool isLiquid = concentrationOf(static_cast<int>(i), load) <= saturation;
      EXPECT_EQ(isLiquid, state.damage[i] == 1.0) << "point " << i;
      EXPECT_NEAR(state.damage[i], broken[i] / all[i], 1.1e-12) << "point " << i;
      EXPECT_EQ(run.body().field("Loose")[i], broken[i] == all[i] && !isLiquid ? 1.0 : 0.0) << "point " << i;
      nLiquid += isLiquid ? 1 : 0;
    }
    if (load == 0.0) {
      EXPECT_EQ(nLiquid, 6);
    }
  }
}

TEST(StochasticDissolution, APointThatHasLostAllBondsIsLooseUntilItIsDissolved) {
  DissolvingRun run({});
  // All but one point gone: nothing holds it.
  const int alone = 20;
  for (int i = 0; i < run.body().nPoints(); ++i) run.body().field("Damage")[i] = i == alone ? 0.0 : 1.0;
  run.evaluate(0.1);
  EXPECT_EQ(run.body().field("Loose")[alone], 1.0);
  EXPECT_LT(run.body().field("Damage")[alone], 1.0);
  EXPECT_GT(run.body().field("Damage")[alone], 1.0 - 1e-11);
  run.evaluate(10.0);
  EXPECT_EQ(run.body().field("Loose")[alone], 0.0);
  EXPECT_EQ(run.body().field("Damage")[alone], 1.0);
}

TEST(StochasticDissolution, MetalThatComesBackMendsNothing) {
  DissolvingRun run({});
  run.evaluate(loadOf(nSteps));
  const DamageState dissolved = run.state();
  run.updateState();
  run.evaluate(loadOf(1));
  EXPECT_TRUE(run.state() == dissolved);
}

TEST(StochasticDissolution, HistoryMakesNoDifference) {
  DissolvingRun run({});
  run.evaluate(loadOf(nSteps));
  EXPECT_TRUE(run.state() == history({}).back());
  run.evaluate(loadOf(nSteps));
  EXPECT_TRUE(run.state() == history({}).back());
}

TEST(StochasticDissolution, HasNoMemoryButFields) {
  const std::vector<DamageState> expected = history({});
  for (const BondSteps steps : {BondSteps::Shared, BondSteps::Copied, BondSteps::Swapped}) {
    Layout layout;
    layout.bondSteps = steps;
    for (const bool recreates : {false, true}) {
      const std::vector<DamageState> found = history(layout, recreates);
      for (std::size_t k = 0; k < expected.size(); ++k) EXPECT_TRUE(found[k] == expected[k]) << "step " << k + 1;
    }
  }
}

TEST(StochasticDissolution, AStateThatIsOverwrittenIsRead) {
  DissolvingRun run({});
  run.evaluate(loadOf(3));
  const DamageState before = run.state();
  const int nBonds = static_cast<int>(before.bonds.size());
  const std::vector<double> bonds(run.body().field("Bond_Damage"), run.body().field("Bond_Damage") + nBonds);
  run.evaluate(loadOf(nSteps));
  std::copy(bonds.begin(), bonds.end(), run.body().field("Bond_Damage"));
  std::copy(before.damage.begin(), before.damage.end(), run.body().field("Damage"));
  run.evaluate(loadOf(3));
  EXPECT_TRUE(run.state() == before);
  // The same concentrations as when bonds were last looked at.
  std::fill_n(run.body().field("Bond_Damage"), nBonds, 0.0);
  std::fill_n(run.body().field("Damage"), run.body().nPoints(), 0.0);
  run.evaluate(loadOf(3));
  EXPECT_TRUE(run.state() == before);
}

TEST(StochasticDissolution, BlocksAndRanksMakeNoDifference) {
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

TEST(StochasticDissolution, SeedsDiffer) {
  const DamageState one = history({}, false, 1).back(), other = history({}, false, 2).back();
  EXPECT_FALSE(one.bonds == other.bonds);
  // But hardly by how many bonds break: of n, each seen from two ends, four sigma of a binomial number at most.
  const double n = 0.5 * static_cast<double>(one.bonds.size());
  EXPECT_NEAR(one.nBroken(), other.nBroken(), 2.0 * 4.0 * std::sqrt(2.0 * 0.25 * n));
  EXPECT_LT(one.nBroken(), 0.9 * 2.0 * n);
}

TEST(StochasticDissolution, ParametersAreChecked) {
  const auto create = [](const char* rule, int seed) {
    Teuchos::ParameterList list;
    list.set<std::string>("Rule", rule);
    list.set("Random Seed", seed);
    return pd::DamageModelRegistry::self().create("Dissolution", list);
  };
  EXPECT_NO_THROW(create("Stochastic", 0));
  EXPECT_NO_THROW(create("Deterministic", 0));
  EXPECT_THROW(create("Random", 0), std::invalid_argument);
  EXPECT_THROW(create("Stochastic", -1), std::invalid_argument);
}

}  // namespace
