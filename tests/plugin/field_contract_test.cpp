// The contract of tables of fields: a plug-in's table says all that it uses, in what unit, with what meaning, and it
// writes what its table says and nothing else.
#include <gtest/gtest.h>

#include "bond_damage_model.hpp"
#include "field_run.hpp"
#include "plugins.hpp"

namespace pdtest {
namespace {

/// Mistakes that the contract is there to find: positions that move, a step before that changes, and a field that is
/// declared in one place only.
class MeddlingModel : public pd::BondDamageModel {
 public:
  struct Fields : BondDamageModel::Fields {
    pd::FieldHandle coordinates = reads(pd::fields::coordinates());
    pd::FieldHandle history = writes(pd::fields::bondScalar("Test_History", "1", "Of nothing."));
  };
  static void declareParameters(pd::ParameterDeclarations&) {}
  using BondDamageModel::BondDamageModel;
  std::string Name() const override { return "Test Meddling Model"; }
  const Fields& fields() const override { return fields_; }
  std::vector<int> FieldIds() const override {
    std::vector<int> ids = fields_.ids();
    ids.push_back(pd::fields::velocity().id());
    return ids;
  }
  void worsen(double, const pd::Call&, PeridigmNS::DataManager& data) const override {
    fields_.coordinates.of(data)[0] += 0.1;
    fields_.history.before(data)[0] += 0.1;
  }

 private:
  Fields fields_;
};
PD_REGISTER_DAMAGE_MODEL(MeddlingModel, "Test Meddling Model", "Shifts points.")

/// A compute that changes what it looks at, and forgets its result.
class Meddler : public PeridigmNS::Compute, public pd::FieldUser {
 public:
  struct Fields : pd::FieldTable {
    pd::FieldHandle volume = reads(pd::fields::volume());
    pd::FieldHandle result = writes(pd::fields::globalScalar("Test_Meddler", "", "No sentence"));
  };
  static void declareParameters(pd::ParameterDeclarations&) {}
  using Compute::Compute;
  const Fields& fields() const override { return fields_; }
  std::vector<int> FieldIds() const override { return fields_.ids(); }
  int compute(Teuchos::RCP<std::vector<PeridigmNS::Block>> blocks) const override {
    fields_.volume.of(*blocks->front().getDataManager())[3] *= 2.0;
    return 0;
  }

 private:
  Fields fields_;
};
PD_REGISTER_COMPUTE(Meddler, "Test Meddler", "Changes volumes.")

void expectAll(const std::string& broken, std::initializer_list<const char*> parts) {
  for (const char* part : parts) EXPECT_NE(broken.find(part), std::string::npos) << part << "\n" << broken;
}

template <class Registry>
void expectWholeTables() {
  for (const std::string& name : Registry::self().names()) {
    const auto& plugin = *Registry::self().find(name);
    if (name.find("Test") == 0 || !plugin.partsKey.empty()) continue;  // one that is made of parts has theirs
    EXPECT_EQ(gapsIn(plugin.fields()), "") << name;
  }
}

TEST(FieldContract, EveryPluginSaysWhatItUsesBeforeItIsMade) {
  expectWholeTables<pd::MaterialRegistry>();
  expectWholeTables<pd::DamageModelRegistry>();
  expectWholeTables<pd::ComputeRegistry>();
}

class MaterialFields : public ::testing::TestWithParam<Sample> {};
TEST_P(MaterialFields, KeepTheContract) { EXPECT_EQ(brokenFieldContract(GetParam(), PluginKind::Material), ""); }

class DamageFields : public ::testing::TestWithParam<Sample> {};
TEST_P(DamageFields, KeepTheContract) { EXPECT_EQ(brokenFieldContract(GetParam(), PluginKind::DamageModel), ""); }

class ComputeFields : public ::testing::TestWithParam<ComputeSample> {};
TEST_P(ComputeFields, KeepTheContract) { EXPECT_EQ(brokenFieldContract(GetParam()), ""); }

std::string titleOf(const ::testing::TestParamInfo<Sample>& info) { return info.param.title; }
std::vector<Sample> allDamageSamples() {
  std::vector<Sample> samples = damageSamples();
  Sample stochastic{"StochasticDissolution", "Dissolution", 2, Teuchos::ParameterList()};
  stochastic.parameters.set<std::string>("Rule", "Stochastic");
  samples.push_back(stochastic);
  return samples;
}
INSTANTIATE_TEST_SUITE_P(Materials, MaterialFields, ::testing::ValuesIn(materialSamples()), titleOf);
INSTANTIATE_TEST_SUITE_P(DamageModels, DamageFields, ::testing::ValuesIn(allDamageSamples()), titleOf);
INSTANTIATE_TEST_SUITE_P(Computes, ComputeFields, ::testing::ValuesIn(computeSamples()),
                         [](const ::testing::TestParamInfo<ComputeSample>& info) { return info.param.plugin; });

TEST(FieldContract, CatchesAModelThatMeddles) {
  const Sample sample{"Meddling", "Test Meddling Model", 2, Teuchos::ParameterList()};
  expectAll(brokenFieldContract(sample, PluginKind::DamageModel),
            {"writes Coordinates, which its table does not say", "writes Test_History of the step before",
             "FieldIds(): ", " Velocity"});
}

TEST(FieldContract, CatchesAComputeThatMeddlesAndSaysLittle) {
  expectAll(brokenFieldContract(ComputeSample{"Test Meddler", Teuchos::ParameterList()}),
            {"writes Volume, which its table does not say", "does not write Test_Meddler, as its table says",
             "Test_Meddler without a unit", "Test_Meddler without a sentence"});
}

}  // namespace
}  // namespace pdtest
