// The contract of steps: NP1 follows from N and dt, however often a call is repeated, however points are split and
// fields are stored, and whatever was tried and taken back. Every field that a plug-in declares is looked at.
#include <gtest/gtest.h>

#include <cmath>

#include "bond_damage_model.hpp"
#include "bond_family.hpp"
#include "plugins.hpp"
#include "step_listener.hpp"
#include "step_run.hpp"

namespace pdtest {
namespace {

using pd::FieldHandle;
using PeridigmNS::DataManager;

/// Takes rate |s|^2 dt of a bond's life; a bond without life is broken. Counts accepted steps.
class Life : public pd::BondDamageModel, public pd::StepListener {
 public:
  struct Fields : BondDamageModel::Fields {
    FieldHandle x = reads(pd::fields::modelCoordinates()), y = reads(pd::fields::coordinates());
    FieldHandle life = writes(pd::fields::bondScalar("Test_Lost_Life", "1", "Share of the life that is gone."));
    FieldHandle steps = writes(pd::fields::pointScalar("Test_Accepted_Steps", "1", "How many."));
  };
  static void declareParameters(pd::ParameterDeclarations& declare) {
    declare.real("Rate", "1/s", "Of loss at a stretch of 1.").required();
  }
  explicit Life(const Teuchos::ParameterList& list) : BondDamageModel(list), rate_(list.get<double>("Rate")) {}

  std::string Name() const override { return "Test Life"; }
  const Fields& fields() const override { return fields_; }
  void worsen(double dt, const pd::Call& call, DataManager& data) const override {
    watch_.look(*this, call, data, fields_.life.before(data), dt);
    const double *x = fields_.x.of(data), *y = fields_.y.of(data), *before = before_(data);
    double *life = fields_.life.of(data), *bondDamage = fields_.bondDamage.of(data);
    pd::forEachBond(call, [&](int i, int j, std::size_t bond) {
      const double length = pd::ReferenceBond(x, i, j).length;
      const double stretch = pd::ReferenceBond(y, i, j).length / length - 1.0;
      life[bond] = before[bond] + rate_ * stretch * stretch * dt;
      if (life[bond] >= 1.0) bondDamage[bond] = 1.0;
    });
    pd::countBrokenBonds(call, bondDamage, fields_.damage.of(data));
  }
  void stepAccepted(const pd::Call& call, DataManager& data, double, double) const override {
    for (int p = 0; p < call.nOwned; ++p) fields_.steps.of(data)[call.ownedIds[p]] += 1.0;
  }

 protected:
  virtual const double* before_(DataManager& data) const { return fields_.life.before(data); }
  Fields fields_;

 private:
  double rate_;
  mutable pd::StepWatch watch_;
};
PD_REGISTER_DAMAGE_MODEL(Life, "Test Life", "Bonds that tire.")

/// The mistake that the contract is there to find: each call takes from what the last call has left.
class AccumulatingLife : public Life {
 public:
  using Life::Life;
  const double* before_(DataManager& data) const override { return fields_.life.of(data); }
};
PD_REGISTER_DAMAGE_MODEL(AccumulatingLife, "Test Accumulating Life", "Bonds that tire with every call.")

/// Another one: what is not in fields is gone when a host makes the model anew, or goes back.
class RememberingLife : public Life {
 public:
  using Life::Life;
  void worsen(double dt, const pd::Call& call, DataManager& data) const override {
    total_ += dt;
    Life::worsen(total_, call, data);
  }

 private:
  mutable double total_ = 0.0;
};
PD_REGISTER_DAMAGE_MODEL(RememberingLife, "Test Remembering Life", "Bonds that tire faster and faster.")

Sample lifeSample(const std::string& plugin) {
  Sample sample{"Life", plugin, 2, Teuchos::ParameterList()};
  sample.parameters.set("Rate", 4000.0);
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
