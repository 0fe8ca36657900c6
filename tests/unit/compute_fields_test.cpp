// Computes that reduce or transform fields, against values worked out by hand.
#include <gtest/gtest.h>

#include <string>

#include "../support/small_body.hpp"
#include "plugins.hpp"

using namespace pdtest;
using PeridigmNS::FieldManager;
namespace PeridigmField = PeridigmNS::PeridigmField;

namespace {

int scalarField(const char* label) {
  return FieldManager::self().getFieldId(PeridigmField::NODE, PeridigmField::SCALAR, PeridigmField::TWO_STEP, label);
}
int vectorField(const char* label) {
  return FieldManager::self().getFieldId(PeridigmField::NODE, PeridigmField::VECTOR, PeridigmField::TWO_STEP, label);
}

/// Four points on a line, the first two in block 1, the others in block 2; volumes 1 2 3 4.
/// Concentration -1 5 2 1e-12; Displacement of point i (i, -i, 2).
class FieldComputes : public ::testing::Test {
 protected:
  FieldComputes() : body(lattice(4, 1, 1, 1.0), options()) {
    body.allocate({scalarField("Concentration"), vectorField("Displacement")});
    const double concentration[] = {-1.0, 5.0, 2.0, 1e-12};
    for (int i = 0; i < 4; ++i) {
      body.field("Concentration")[i] = concentration[i];
      body.field("Displacement")[3 * i] = i;
      body.field("Displacement")[3 * i + 1] = -i;
      body.field("Displacement")[3 * i + 2] = 2.0;
    }
    body.addNodeSet("Ends", {0, 3});
    body.addNodeSet("Nobody", {});
  }
  static BodyOptions options() {
    BodyOptions result;
    result.volumes = {1.0, 2.0, 3.0, 4.0};
    result.blockOf = [](int id) { return id < 2 ? 1 : 2; };
    return result;
  }
  /// Makes the compute, runs it, gives its result.
  double run(const std::string& name, Teuchos::ParameterList parameters, int component = 0) {
    if (!parameters.isParameter("Output Label")) parameters.set<std::string>("Output Label", "Result_Of_" + name);
    makeCompute(body, name, parameters)->compute(body.blocks());
    return body.value(parameters.get<std::string>("Output Label"), component);
  }
  static Teuchos::ParameterList list(std::initializer_list<std::pair<const char*, const char*>> texts = {}) {
    Teuchos::ParameterList result;
    for (const auto& [key, value] : texts) result.set<std::string>(key, value);
    return result;
  }
  /// What the compute says about wrong parameters.
  std::string complaint(const std::string& name, const Teuchos::ParameterList& parameters) {
    try {
      makeCompute(body, name, parameters);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "no complaint";
  }

  SmallBody body;
};

TEST_F(FieldComputes, BlockDataTakesMinimumMaximumAndSumOfItsBlockAlone) {
  auto parameters = list({{"Variable", "Concentration"}, {"Calculation Type", "Sum"}, {"Block", "block_1"}});
  EXPECT_DOUBLE_EQ(run("Block_Data", parameters), 4.0);
  parameters.set<std::string>("Calculation Type", "Minimum");
  EXPECT_DOUBLE_EQ(run("Block_Data", parameters), -1.0);
  parameters.set<std::string>("Block", "block_2");
  parameters.set<std::string>("Calculation Type", "Maximum");
  EXPECT_DOUBLE_EQ(run("Block_Data", parameters), 2.0);
}

TEST_F(FieldComputes, BlockDataOfAVectorIsTakenByComponentAndMayBeNegative) {
  auto parameters = list({{"Variable", "Displacement"},
                          {"Calculation Type", "Maximum"},
                          {"Block", "block_2"},
                          {"Output Label", "Largest_Displacement"}});
  EXPECT_DOUBLE_EQ(run("Block_Data", parameters, 0), 3.0);
  EXPECT_DOUBLE_EQ(run("Block_Data", parameters, 1), -2.0);
  EXPECT_DOUBLE_EQ(run("Block_Data", parameters, 2), 2.0);
}

TEST_F(FieldComputes, NodeSetDataRunsOverBlocks) {
  auto parameters = list({{"Variable", "Displacement"},
                          {"Calculation Type", "Sum"},
                          {"Node Set", "Ends"},
                          {"Output Label", "Sum_Over_Ends"}});
  EXPECT_DOUBLE_EQ(run("Node_Set_Data", parameters, 0), 3.0);
  EXPECT_DOUBLE_EQ(run("Node_Set_Data", parameters, 1), -3.0);
  EXPECT_DOUBLE_EQ(run("Node_Set_Data", parameters, 2), 4.0);
}

TEST_F(FieldComputes, NearestPointDataTakesTheLowerIdOfTwoAtTheSameDistance) {
  auto parameters = list({{"Variable", "Concentration"}});
  for (const char* axis : {"Y", "Z"}) parameters.set(axis, 0.0);
  parameters.set("X", 1.5);
  EXPECT_DOUBLE_EQ(run("Nearest_Point_Data", parameters), 5.0);
  parameters.set("X", 2);  // an integer will do
  EXPECT_DOUBLE_EQ(run("Nearest_Point_Data", parameters), 2.0);
}

TEST_F(FieldComputes, MeanWeighsByVolumeOrAllAlike) {
  auto parameters = list({{"Variable", "Concentration"}});
  EXPECT_NEAR(run("Field_Mean", parameters), (-1.0 + 10.0 + 6.0) / 10.0, 1e-11);
  parameters.set<std::string>("Weights", "Equal");
  EXPECT_NEAR(run("Field_Mean", parameters), 6.0 / 4.0, 1e-11);
  parameters.set("Ignore Below", 1e-10);
  EXPECT_DOUBLE_EQ(run("Field_Mean", parameters), 3.5);
  parameters.set<std::string>("Block", "block_2");
  EXPECT_DOUBLE_EQ(run("Field_Mean", parameters), 2.0);
}

TEST_F(FieldComputes, MeanOfAComponentAndOfTheMagnitude) {
  auto parameters = list({{"Variable", "Displacement"}, {"Component", "Y"}, {"Weights", "Equal"}});
  EXPECT_DOUBLE_EQ(run("Field_Mean", parameters), -1.5);
  parameters.set<std::string>("Component", "Magnitude");
  parameters.set<std::string>("Node Set", "Ends");
  EXPECT_DOUBLE_EQ(run("Field_Mean", parameters), (2.0 + std::sqrt(22.0)) / 2.0);
}

TEST_F(FieldComputes, IntegralAndExtremes) {
  auto parameters = list({{"Variable", "Concentration"}, {"Node Set", "Ends"}});
  EXPECT_NEAR(run("Field_Integral", parameters), -1.0 + 4e-12, 1e-15);
  EXPECT_DOUBLE_EQ(run("Field_Minimum", parameters), -1.0);
  EXPECT_DOUBLE_EQ(run("Field_Maximum", parameters), 1e-12);
  parameters.set("Ignore Below", -0.5);
  EXPECT_DOUBLE_EQ(run("Field_Minimum", parameters), 1e-12);
}

TEST_F(FieldComputes, ARegionWithoutPointsGivesZero) {
  const auto parameters = list({{"Variable", "Concentration"}, {"Node Set", "Nobody"}});
  for (const char* name : {"Field_Mean", "Field_Integral", "Field_Minimum", "Field_Maximum"})
    EXPECT_EQ(run(name, parameters), 0.0) << name;
}

TEST_F(FieldComputes, CoverageIsClampedToZeroAndOne) {
  auto parameters = list({{"Output Label", "Hydrogen_Coverage"}});
  parameters.set("Saturation Concentration", 4.0);
  makeCompute(body, "Coverage", parameters)->compute(body.blocks());
  const double expected[] = {0.0, 1.0, 0.5, 2.5e-13};
  for (int i = 0; i < 4; ++i) EXPECT_DOUBLE_EQ(body.value("Hydrogen_Coverage", i), expected[i]) << i;
}

TEST_F(FieldComputes, TheNameOfTheComputeMayStandInItsParameters) {
  EXPECT_NO_THROW(makeCompute(body, "Number_Of_Neighbors", list({{"Compute Class", "Number_Of_Neighbors"}})));
}

TEST_F(FieldComputes, ParametersMayBeNull) {
  EXPECT_NO_THROW(
      pd::ComputeRegistry::self().create("Crack_Tip", Teuchos::null, Teuchos::rcp(new SerialComm), body.globalData()));
}

TEST_F(FieldComputes, WrongNamesAreExplained) {
  EXPECT_EQ(complaint("Field_Mean", list({{"Variable", "Concentration"}, {"Node Set", "End"}})),
            "no node set \"End\" (there are: Ends, Nobody); did you mean \"Ends\"?");
  EXPECT_EQ(complaint("Field_Mean", list({{"Variable", "Concentration"}, {"Block", "block_7"}})),
            "no block \"block_7\" (there are: block_1, block_2); did you mean \"block_1\"?");
  EXPECT_NE(complaint("Field_Mean", list({{"Variable", "Unheard_Of"}})).find("no field \"Unheard_Of\""),
            std::string::npos);
  // A usual field that no plug-in of the run uses.
  EXPECT_NE(complaint("Field_Mean", list({{"Variable", "Temperature"}})).find("Temperature"), std::string::npos);
}

TEST_F(FieldComputes, AllMistakesAreReportedAtOnce) {
  const std::string message =
      complaint("Block_Data", list({{"Blok", "block_1"}, {"Calculation Type", "Mean"}, {"Variable", "Concentration"}}));
  EXPECT_NE(message.find("did you mean \"Block\"?"), std::string::npos) << message;
  EXPECT_NE(message.find("\"Mean\" is not allowed"), std::string::npos) << message;
  EXPECT_NE(message.find("\"Output Label\" is required"), std::string::npos) << message;
}

TEST(NumberOfNeighbors, OfALatticeInTwoBlocks) {
  BodyOptions options;
  options.blockOf = [](int id) { return id % 2; };
  SmallBody body(lattice(3, 3, 1, 1.0), options);
  makeCompute(body, "Number_Of_Neighbors")->compute(body.blocks());
  const double expected[] = {2, 3, 2, 3, 4, 3, 2, 3, 2};
  for (int i = 0; i < 9; ++i) EXPECT_EQ(body.value("Number_Of_Neighbors", i), expected[i]) << i;
}

/// Four points in a row, the last in a block of its own: bonds 0-1, 1-0, 1-2, 2-1, 2-3, 3-2 in their order.
class BondFieldMean : public ::testing::Test {
 protected:
  BondFieldMean() : body(lattice(4, 1, 1, 1.0), options()) {
    life = pd::fields::bondScalar("Test_Life_Left", "kg", "Unit as in no other test.").id();
    const std::vector<double> ofFirst{0.1, 0.2, 0.6, 0.3, 0.5};
    body.block(0).getDataManager()->allocateData({life});
    for (int k = 0; k < 5; ++k) (*body.block(0).getData(life, PeridigmField::STEP_NP1))[k] = ofFirst[k];
    parameters.set<std::string>("Variable", "Test_Life_Left");
  }
  static BodyOptions options() {
    BodyOptions result;
    result.blockOf = [](int id) { return id < 3 ? 1 : 2; };
    return result;
  }
  std::vector<double> points() {
    const auto compute = makeCompute(body, "Bond_Field_Mean", parameters);
    compute->compute(body.blocks());
    const double* values = body.field("Bond_Field_Mean");
    return {values, values + 4};
  }
  SmallBody body;
  int life;
  Teuchos::ParameterList parameters;
};

TEST_F(BondFieldMean, TakesMeanMinimumOrMaximumOfEachPointsBonds) {
  EXPECT_EQ(points(), (std::vector<double>{0.1, 0.4, 0.4, 0.0})) << "the second block does not keep the field";
  body.block(1).getDataManager()->allocateData({life});
  (*body.block(1).getData(life, PeridigmField::STEP_NP1))[0] = 0.7;
  EXPECT_EQ(points(), (std::vector<double>{0.1, 0.4, 0.4, 0.7}));
  parameters.set<std::string>("Calculation Type", "Minimum");
  EXPECT_EQ(points(), (std::vector<double>{0.1, 0.2, 0.3, 0.7}));
  parameters.set<std::string>("Calculation Type", "Maximum");
  EXPECT_EQ(points(), (std::vector<double>{0.1, 0.6, 0.5, 0.7}));
}

TEST_F(BondFieldMean, HasTheUnitOfItsVariable) {
  points();
  EXPECT_EQ(pd::fields::unitOf("Bond_Field_Mean"), "kg");
}

TEST_F(BondFieldMean, RefusesFieldsOfPointsAndWhatNobodyKeeps) {
  const auto complaint = [&](const char* variable) {
    parameters.set<std::string>("Variable", variable);
    try {
      points();
    } catch (const std::invalid_argument& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_NE(complaint("Volume").find("must be a field of bonds, which \"Volume\" is not"), std::string::npos);
  EXPECT_NE(complaint("Test_Nothing").find("Test_Nothing"), std::string::npos);
  pd::fields::bondScalar("Test_Nobodys_Bonds", "1", "Registered and not allocated.").id();
  EXPECT_NE(complaint("Test_Nobodys_Bonds").find("no plug-in of this run uses"), std::string::npos);
}

TEST(FieldUnits, OfResultsFollowFromTheVariable) {
  SmallBody body(lattice(2, 1, 1, 1.0), {});
  body.allocate({pd::fields::displacement().id(), pd::fields::storedEnergyDensity().id(),
                 pd::fields::steppedScalar("Test_Pressure", "Pa", "Of a test.").id(), scalarField("Temperature")});
  const auto unitOf = [&](const char* compute, const char* variable) {
    Teuchos::ParameterList parameters;
    const std::string label = std::string("Test_Unit_Of_") + compute + variable;
    parameters.set<std::string>("Variable", variable);
    parameters.set<std::string>("Output Label", label);
    makeCompute(body, compute, parameters);
    return pd::fields::unitOf(label);
  };
  EXPECT_EQ(unitOf("Field_Mean", "Displacement"), "m");
  EXPECT_EQ(unitOf("Field_Maximum", "Test_Pressure"), "Pa");
  EXPECT_EQ(unitOf("Field_Integral", "Stored_Elastic_Energy_Density"), "J");
  EXPECT_EQ(unitOf("Field_Integral", "Test_Pressure"), "Pa m3");
  // Which unit a concentration has, only the deck knows.
  body.allocate({pd::fields::diffusingScalar("Concentration").id()});
  EXPECT_EQ(unitOf("Field_Mean", "Concentration"), "");
  EXPECT_EQ(unitOf("Field_Integral", "Concentration"), "");
}

TEST(FieldVariable, IsNotBroughtToLifeByWhatWouldUseIt) {
  // A material asks for it where a damage model brings it: that alone is no damage.
  struct Wish : pd::FieldTable {
    pd::FieldHandle wished = readsIfThere(pd::fields::steppedScalar("Test_Wished_For", "1", "Of a test."));
  } wish;
  SmallBody body(lattice(2, 1, 1, 1.0), {});
  Teuchos::ParameterList parameters;
  parameters.set<std::string>("Variable", "Test_Wished_For");
  EXPECT_THROW(makeCompute(body, "Field_Mean", parameters), std::invalid_argument);
  body.allocate({wish.wished.id()});
  EXPECT_NO_THROW(makeCompute(body, "Field_Mean", parameters));
}

TEST(Computes, EveryOneIsDocumentedAndNamedAfterItsResult) {
  for (const std::string& name : pd::ComputeRegistry::self().names()) {
    const auto* entry = pd::ComputeRegistry::self().find(name);
    EXPECT_FALSE(entry->brief.empty()) << name;
    const pd::ParameterDeclarations declarations = entry->declare();
    for (const auto& parameter : declarations.parameters()) EXPECT_FALSE(parameter.meaning.empty()) << name;
    const pd::Parameter* label = declarations.find("Output Label");
    if (label == nullptr || label->isRequired) continue;
    EXPECT_EQ(label->defaultText(), name);
  }
}

}  // namespace
