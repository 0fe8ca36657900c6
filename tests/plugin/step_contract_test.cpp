// The contract of steps: NP1 follows from N and dt, however often a call is repeated, however points are split and
// fields are stored, and whatever was tried and taken back. Every field that a plug-in declares is looked at.
#include <gtest/gtest.h>

#include <cmath>

#include "../support/life_damage.hpp"
#include "step_run.hpp"

namespace pdtest {
namespace {

using PeridigmNS::DataManager;

/// The mistake that the contract is there to find: each call takes from what the last call has left.
class AccumulatingLife : public Life {
 public:
  using Life::Life;
  const double* lifeToStartFrom(DataManager& data) const override { return fields_.life.of(data); }
};
PD_REGISTER_DAMAGE_MODEL(AccumulatingLife, "Test Accumulating Life", "Bonds that tire with every call.")

/// Another one: what is not in fields is gone when a host makes the model anew, or goes back.
class RememberingLife : public Life {
 public:
  using Life::Life;
  const double* lifeToStartFrom(DataManager& data) const override {
    if (life_.empty()) life_.assign(static_cast<std::size_t>(fields_.life.length(data)), 0.0);
    for (double& life : life_) life += 0.01;
    return life_.data();
  }

 private:
  mutable std::vector<double> life_;
};
PD_REGISTER_DAMAGE_MODEL(RememberingLife, "Test Remembering Life", "Bonds that tire in secret.")

Sample lifeSample(const std::string& plugin) {
  Sample sample{"Life", plugin, 2, Teuchos::ParameterList()};
  sample.parameters.set("Loss", 400.0);
  return sample;
}

class MaterialSteps : public ::testing::TestWithParam<Sample> {};
TEST_P(MaterialSteps, KeepTheContract) { EXPECT_EQ(brokenStepContract(GetParam(), PluginKind::Material), ""); }

class DamageSteps : public ::testing::TestWithParam<Sample> {};
TEST_P(DamageSteps, KeepTheContract) { EXPECT_EQ(brokenStepContract(GetParam(), PluginKind::DamageModel), ""); }

std::string titleOf(const ::testing::TestParamInfo<Sample>& info) { return info.param.title; }
std::vector<Sample> allDamageSamples() {
  std::vector<Sample> samples = damageSamples();
  Sample stochastic{"StochasticDissolution", "Dissolution", 2, Teuchos::ParameterList()};
  stochastic.parameters.set<std::string>("Rule", "Stochastic");
  stochastic.parameters.set("Random Seed", 3);
  samples.push_back(stochastic);
  samples.push_back(lifeSample("Test Life"));
  return samples;
}
INSTANTIATE_TEST_SUITE_P(Materials, MaterialSteps, ::testing::ValuesIn(materialSamples()), titleOf);
INSTANTIATE_TEST_SUITE_P(DamageModels, DamageSteps, ::testing::ValuesIn(allDamageSamples()), titleOf);

TEST(StepContract, CatchesAModelThatAccumulatesCalls) {
  const std::string broken = brokenStepContract(lifeSample("Test Accumulating Life"), PluginKind::DamageModel);
  for (const char* what : {"evaluated often, step 1", "stored otherwise, step 2", "Test_Lost_Life by"})
    EXPECT_NE(broken.find(what), std::string::npos) << what << "\n" << broken;
}

TEST(StepContract, CatchesAModelWithAMemoryOfItsOwn) {
  const std::string broken = brokenStepContract(lifeSample("Test Remembering Life"), PluginKind::DamageModel);
  for (const char* what : {"evaluated often", "taken back", "restarted", "made anew"})
    EXPECT_NE(broken.find(what), std::string::npos) << what << "\n" << broken;
}

TEST(StepContract, LifeGoesByStepsAndAcceptedStepsAreCounted) {
  for (const BondSteps steps : {BondSteps::Shared, BondSteps::Copied, BondSteps::Swapped}) {
    Layout layout;
    layout.bondSteps = steps;
    StepRun run(lifeSample("Test Life"), PluginKind::DamageModel, layout);
    run.load(0.3);
    run.evaluate();
    const FieldState once = run.state();
    run.accept();
    for (int k = 2; k <= 4; ++k) run.step(0.3);
    run.load(0.3);
    run.evaluate();
    const FieldState fiveTimes = run.state();
    for (const auto& [ends, life] : once.bonds.at("Test_Lost_Life"))
      EXPECT_NEAR(fiveTimes.bonds.at("Test_Lost_Life").at(ends), 5.0 * life, 1e-12 * life);
    for (const double count : fiveTimes.points.at("Test_Accepted_Steps")) EXPECT_EQ(count, 4.0);
  }
}

}  // namespace
}  // namespace pdtest
