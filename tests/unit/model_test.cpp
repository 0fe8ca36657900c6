// Model: plug-ins from the deck, fields, evaluations over blocks.
#include "driver/model/model.hpp"

#include <gtest/gtest.h>
#include <mpi.h>

#include <cmath>

#include "../model_plugins.hpp"
#include "../mpi/lattice.hpp"
#include "Peridigm_InfluenceFunction.hpp"
#include "driver/model/collective.hpp"

namespace pd::test {
namespace {

class ModelTest : public ::testing::Test {
 protected:
  Communicator comm{MPI_COMM_WORLD};

  /// A row of points 0 .. n-1 of unit spacing and volume; points from `border` on are block_2 where that is given.
  Discretization row(int n, int border = -1) const {
    Discretization points = Lattice{n, 1, 1, 1.0}.discretization(comm);
    if (border < 0) return points;
    for (int i = 0; i < n; ++i) points.blockId[i] = i < border ? 1 : 2;
    points.blockNumbers = {1, 2};
    return points;
  }
  static std::string errorOf(const std::function<void()>& work) {
    try {
      work();
    } catch (const DeckError& error) {
      return error.what();
    }
    return "no error";
  }
};

TEST_F(ModelTest, ForceIsTheSecondDifferenceOfAQuadraticDisplacement) {
  const Deck deck = deckOf(plateText());
  Model model(deck, comm, row(7), {});
  model.initialize();
  double* u = model.field("Displacement");
  for (int i = 0; i < 7; ++i) u[3 * i] = i * i;
  model.updateCoordinates();
  model.evaluateForce(0.0);
  const double* force = model.field("Force_Density");
  for (int i = 1; i < 6; ++i) EXPECT_DOUBLE_EQ(force[3 * i], 2.0) << i;  // (i+1)^2 - 2 i^2 + (i-1)^2
  EXPECT_DOUBLE_EQ(force[0], 1.0);
  EXPECT_DOUBLE_EQ(model.field("Coordinates")[3 * 6], 6.0 + 36.0);
}

TEST_F(ModelTest, BlocksAddUp) {
  const Deck deck = deckOf(plateText());
  Model model(deck, comm, row(6, 3), {});
  model.initialize();
  double* u = model.field("Displacement");
  double* c = model.field("Concentration");
  for (int i = 0; i < 6; ++i) u[3 * i] = c[i] = i * i;
  model.updateCoordinates();
  model.evaluateForce(0.0);
  model.evaluateFluxDivergence(0.0, "Concentration_Flux_Divergence");
  const double* force = model.field("Force_Density");
  const double* flux = model.field("Concentration_Flux_Divergence");
  // Bonds: 0-1, 1-2 of stiffness 1; 2-3 of 1.5; 3-4, 4-5 of 2. Differences of i^2: 1, 3, 5, 7, 9.
  const double expected[] = {1.0, 2.0, 1.5 * 5 - 3, 2 * 7 - 1.5 * 5, 4.0, -18.0};
  for (int i = 0; i < 6; ++i) {
    EXPECT_DOUBLE_EQ(force[3 * i], expected[i]) << i;
    EXPECT_DOUBLE_EQ(flux[i], expected[i]) << i;
    // What a compute sees through either block.
    for (PeridigmNS::Block& block : *model.blocks()) {
      const int id = FieldManager::self().getFieldId("Force_Density");
      EXPECT_DOUBLE_EQ((*block.getData(id, STEP_NP1))[3 * i], expected[i]) << i;
    }
  }
}

TEST_F(ModelTest, AllocatesOnlyWhatIsAskedFor) {
  const Deck deck = deckOf(
      "Materials: {Springs: {Material Model: Test Springs, Stiffness: 1.0, Mechanics: false}}\n"
      "Blocks: {All: {Block Names: default, Material: Springs, Horizon: 1.0}}\n");
  Model model(deck, comm, row(4), {});
  EXPECT_FALSE(model.hasMechanics());
  EXPECT_FALSE(model.hasField("Displacement"));
  EXPECT_FALSE(model.hasField("Block_Id"));
  EXPECT_FALSE(model.hasField("Damage"));
  EXPECT_FALSE(model.hasField("Bond_Damage"));  // no point field
  EXPECT_TRUE(model.hasField("Concentration"));
  EXPECT_THROW(model.field("Displacement"), std::invalid_argument);
  model.allocateFields({FieldManager::self().getFieldId(ELEMENT, SCALAR, CONSTANT, "Block_Id"),
                        FieldManager::self().getFieldId(ELEMENT, SCALAR, CONSTANT, "Element_Id"),
                        FieldManager::self().getFieldId(ELEMENT, SCALAR, CONSTANT, "Horizon")});
  for (int i = 0; i < 4; ++i) {
    EXPECT_EQ(model.field("Block_Id")[i], 1.0);
    EXPECT_EQ(model.field("Element_Id")[i], i + 1.0);
    EXPECT_EQ(model.field("Horizon")[i], 1.0);
    EXPECT_EQ(model.field("Volume")[i], 1.0);
    EXPECT_EQ(model.field("Model_Coordinates")[3 * i], i);
  }
}

TEST_F(ModelTest, PrecomputeRunsForForcesAndForMaterialsWithoutMechanics) {
  const Deck deck = deckOf(
      "Materials:\n"
      "  Both: {Material Model: Test Springs, Stiffness: 1.0}\n"
      "  Fluxes: {Material Model: Test Springs, Stiffness: 1.0, Mechanics: false}\n"
      "Blocks:\n"
      "  First: {Block Names: block_1, Material: Both, Horizon: 1.0}\n"
      "  Second: {Block Names: block_2, Material: Fluxes, Horizon: 1.0}\n");
  Model model(deck, comm, row(4, 2), {});
  const auto count = [&](int block) {
    return dynamic_cast<const SpringMaterial&>(*(*model.blocks())[block].getMaterialModel()).nPrecomputes;
  };
  model.evaluateFluxDivergence(0.0, "Concentration_Flux_Divergence");
  EXPECT_EQ(count(0), 0);
  EXPECT_EQ(count(1), 1);
  model.evaluateForce(0.0);
  EXPECT_EQ(count(0), 1);
  EXPECT_EQ(count(1), 2);
}

TEST_F(ModelTest, HostKeysAreInjected) {
  const Deck deck = deckOf(plateText());
  Model model(deck, comm, row(4, 2), {});
  const auto& parameters = dynamic_cast<const SpringMaterial&>(*(*model.blocks())[1].getMaterialModel()).parameters;
  EXPECT_DOUBLE_EQ(parameters.get<double>("Horizon"), 1.0);
  EXPECT_DOUBLE_EQ(parameters.get<double>("Stiffness"), 2.0);
  EXPECT_DOUBLE_EQ(parameters.get<double>("Finite Difference Probe Length"), 1.0e-6);  // 1e-6 of the shortest bond
}

TEST_F(ModelTest, DamageComesFromTheDamageModel) {
  const Deck deck = deckOf(plateText(", Damage Model: Length"));
  Model model(deck, comm, row(6, 3), {});
  model.initialize();
  for (int i = 0; i < 6; ++i) EXPECT_EQ(model.field("Damage")[i], 0.0);
  for (int i = 4; i < 6; ++i) model.field("Displacement")[3 * i] = 0.6;  // bond 3-4 becomes 1.6 long
  model.updateCoordinates();
  model.evaluateDamage(0.0);
  const double expected[] = {0.0, 0.0, 0.0, 0.5, 0.5, 0.0};
  for (int i = 0; i < 6; ++i) EXPECT_DOUBLE_EQ(model.field("Damage")[i], expected[i]) << i;
  model.evaluateForce(0.0);
  for (int i = 0; i < 6; ++i) EXPECT_DOUBLE_EQ(model.field("Force_Density")[3 * i], 0.0) << i;
}

TEST_F(ModelTest, CutBondsCountInDamage) {
  for (const std::string more : {"", ", Damage Model: Length"}) {
    const Deck deck = deckOf("Discretization: {Bond Filters: {}}\n" + plateText(more));
    Discretization points = row(4);
    // Bonds 0-1 | 1-0 1-2 | 2-1 2-3 | 3-2
    points.bondIsCut = {0, 0, 1, 1, 0, 0};
    const int damage = FieldManager::self().getFieldId(ELEMENT, SCALAR, TWO_STEP, "Damage");
    Model model(deck, comm, points, {damage});
    model.initialize();
    const double expected[] = {0.0, 0.5, 0.5, 0.0};
    for (int i = 0; i < 4; ++i) EXPECT_DOUBLE_EQ(model.field("Damage")[i], expected[i]) << i;
    for (int i = 0; i < 4; ++i) model.field("Displacement")[3 * i] = i < 2 ? 0.0 : 1.0;
    model.updateCoordinates();
    model.evaluateForce(0.0);
    for (int i = 0; i < 4; ++i) EXPECT_DOUBLE_EQ(model.field("Force_Density")[3 * i], 0.0) << i;
  }
}

TEST_F(ModelTest, CutBondsNeedAPluginThatKnowsThem) {
  const Deck deck = deckOf(
      "Discretization: {Bond Filters: {}}\n"
      "Materials: {Springs: {Material Model: Test Springs, Stiffness: 1.0, Breakable: false}}\n"
      "Blocks: {All: {Block Names: default, Material: Springs, Horizon: 1.0}}\n");
  Discretization points = row(4);
  points.bondIsCut = {0, 0, 1, 1, 0, 0};
  const std::string error = errorOf([&] { Model model(deck, comm, points, {}); });
  EXPECT_NE(error.find("give the block a damage model or set `Count In Damage: false`"), std::string::npos) << error;
}

TEST_F(ModelTest, TwoStepFieldsKeepTheLastStep) {
  const Deck deck = deckOf(plateText());
  Model model(deck, comm, row(4), {});
  model.initialize();
  double* c = model.field("Concentration");
  EXPECT_EQ(model.fieldAtN("Concentration")[2], 0.0);
  c[2] = 5.0;
  EXPECT_EQ(model.fieldAtN("Concentration")[2], 0.0);
  model.adoptState();
  EXPECT_EQ(model.fieldAtN("Concentration")[2], 5.0);
  EXPECT_EQ(c[2], 5.0);
}

TEST_F(ModelTest, BlocksWithoutMaterialAndRefusingPluginsAreAllReported) {
  const Deck deck = deckOf(
      "Materials: {Springs: {Material Model: Test Springs, Stiffness: 1.0, Refuse: true}}\n"
      "Blocks: {All: {Block Names: block_1, Material: Springs, Horizon: 1.0}}\n");
  const std::string error = errorOf([&] { Model model(deck, comm, row(4, 2), {}); });
  EXPECT_NE(error.find("test.yaml:1:13: this stiffness is refused"), std::string::npos) << error;
  EXPECT_NE(error.find("block_2 of the mesh has no material"), std::string::npos) << error;
}

TEST_F(ModelTest, NonFiniteValuesStopTheRunWithTheirPlace) {
  const Deck deck = deckOf(plateText());
  Model model(deck, comm, row(4), {});
  EXPECT_NO_THROW(model.requireFinite("Concentration", 7));
  model.field("Concentration")[2] = std::nan("");
  try {
    model.requireFinite("Concentration", 7);
    FAIL();
  } catch (const RunError& error) {
    EXPECT_NE(std::string(error.what()).find("step 7: field \"Concentration\" is not finite at point 3 (x = 2,"),
              std::string::npos)
        << error.what();
  }
}

TEST_F(ModelTest, InfluenceFunctionIsSetBeforePluginsAreMade) {
  const Deck deck = deckOf("Discretization: {Influence Function: 1.0 - zeta/horizon}\n" + plateText());
  Model model(deck, comm, row(4), {});
  EXPECT_DOUBLE_EQ(InfluenceFunction::self().getInfluenceFunction()(0.5, 2.0), 0.75);
  Model another(deckOf(plateText()), comm, row(4), {});
  EXPECT_DOUBLE_EQ(InfluenceFunction::self().getInfluenceFunction()(0.5, 2.0), 1.0);
}

TEST_F(ModelTest, CountsBondUpdates) {
  const Deck deck = deckOf(plateText(", Damage Model: Length"));
  Model model(deck, comm, row(6, 3), {});
  model.evaluateForce(0.0);
  model.evaluateForce(0.0);
  EXPECT_EQ(model.timers().phases().at("force").bondUpdates, 20);  // 10 directed bonds
  EXPECT_GE(model.bondBytes(), 10 * (2 * sizeof(int) + sizeof(double)));
}

TEST_F(ModelTest, CollectiveErrorsKeepTheirKind) {
  EXPECT_THROW(collectively(comm, [] { throw DeckError("a"); }), DeckError);
  EXPECT_THROW(collectively(comm, [] { throw std::invalid_argument("a"); }), DeckError);
  EXPECT_THROW(collectively(comm, [] { throw std::runtime_error("a"); }), RunError);
  EXPECT_NO_THROW(collectively(comm, [] {}));
}

}  // namespace
}  // namespace pd::test
