// Initial and boundary conditions on a row of seven points, x = 0 .. 6, of unit volume.
#include "driver/boundary/boundary_conditions.hpp"

#include <gtest/gtest.h>
#include <mpi.h>

#include "../model_plugins.hpp"
#include "../mpi/lattice.hpp"

namespace pd::test {
namespace {

class BoundaryConditionsTest : public ::testing::Test {
 protected:
  Communicator comm{MPI_COMM_WORLD};

  static Deck deckWith(const std::string& conditions, bool isPeridigm = false) {
    std::string text = plateText(", Damage Model: Length") + "Solver: {Initial Time: 2.0, Final Time: 10.0}\n" +
                       "Boundary Conditions:\n" + conditions;
    if (isPeridigm) {
      std::string indented = "Peridigm:\n  ";
      for (const char c : text) indented += c == '\n' ? std::string("\n  ") : std::string(1, c);
      text = indented + "\n";
    }
    return deckOf(text);
  }
  Model modelOf(const Deck& deck) const {
    Discretization points = Lattice{7, 1, 1, 1.0}.discretization(comm);
    points.nodeSets = {{"Left Node Set", {0, 1}}, {"Right Node Set", {5, 6}}, {"Middle Node Set", {1, 2, 3}}};
    return Model(deck, comm, points, {});
  }
  std::string errorOf(const Deck& deck) const {
    Model model = modelOf(deck);
    try {
      BoundaryConditions conditions(deck, model);
    } catch (const DeckError& error) {
      return error.what();
    }
    return "no error";
  }
};

TEST_F(BoundaryConditionsTest, InitialValuesAreThoseOfTheInitialTime) {
  const Deck deck = deckWith(
      "  Shift: {Type: Initial Displacement, Node Set: Left Node Set, Coordinate: y, Value: 0.25}\n"
      "  Push: {Type: Initial Velocity, Node Set: Right Node Set, Value: \"x + t\"}\n"
      "  Charge: {Type: Initial Value, Field: Concentration, Node Set: middle node_set, Value: \"2*x\"}\n");
  Model model = modelOf(deck);
  BoundaryConditions conditions(deck, model);
  conditions.applyInitial();
  EXPECT_DOUBLE_EQ(model.field("Displacement")[3 * 1 + 1], 0.25);
  EXPECT_DOUBLE_EQ(model.field("Displacement")[3 * 2 + 1], 0.0);
  EXPECT_DOUBLE_EQ(model.field("Velocity")[3 * 6], 8.0);
  EXPECT_DOUBLE_EQ(model.field("Concentration")[3], 6.0);
  EXPECT_DOUBLE_EQ(model.field("Concentration")[4], 0.0);
  EXPECT_FALSE(conditions.hasExternalForce());
  for (const char mask : conditions.displacementIsPrescribed()) EXPECT_EQ(mask, 0);
}

TEST_F(BoundaryConditionsTest, PrescribedDisplacementFollowsTimeAndGivesItsVelocity) {
  const Deck deck = deckWith(
      "  Push: {Type: Initial Velocity, Node Set: Left Node Set, Value: 9.0}\n"
      "  Pull: {Type: Prescribed Displacement, Node Set: Right Node Set, Coordinate: x, Value: \"0.5*t^2\"}\n"
      "  Slide: {Type: Prescribed Displacement, Node Set: Right Node Set, Coordinate: y,"
      " Value: {Table: [[0, 0], [4, 2]]}}\n");
  Model model = modelOf(deck);
  BoundaryConditions conditions(deck, model);
  conditions.applyInitial();
  conditions.applyPrescribed(2.0);
  EXPECT_DOUBLE_EQ(model.field("Displacement")[3 * 5], 2.0);
  EXPECT_DOUBLE_EQ(model.field("Displacement")[3 * 5 + 1], 1.0);
  EXPECT_DOUBLE_EQ(model.field("Velocity")[3 * 5], 0.0);
  conditions.applyPrescribed(3.0);
  EXPECT_DOUBLE_EQ(model.field("Displacement")[3 * 6], 4.5);
  EXPECT_DOUBLE_EQ(model.field("Displacement")[3 * 6 + 1], 1.5);
  EXPECT_DOUBLE_EQ(model.field("Velocity")[3 * 6], 2.5);
  conditions.applyPrescribed(3.0);  // a second call for the same time changes nothing
  EXPECT_DOUBLE_EQ(model.field("Velocity")[3 * 6], 2.5);
  EXPECT_DOUBLE_EQ(model.field("Velocity")[3 * 0], 9.0);
  const std::vector<char>& mask = conditions.displacementIsPrescribed();
  EXPECT_TRUE(mask[3 * 5] && mask[3 * 5 + 1] && mask[3 * 6]);
  EXPECT_FALSE(mask[3 * 5 + 2] || mask[3 * 4]);

  // A restart at t = 3 goes on with the same velocity.
  BoundaryConditions resumed(deck, model);
  resumed.resume(3.0);
  resumed.applyPrescribed(5.0);
  EXPECT_DOUBLE_EQ(model.field("Velocity")[3 * 6], (12.5 - 4.5) / 2.0);
}

TEST_F(BoundaryConditionsTest, PrescribedValuesAreSetByField) {
  const Deck deck = deckWith(
      "  Inlet: {Type: Prescribed Concentration, Node Set: Left Node Set, Value: \"1 + t\"}\n"
      "  Outlet: {Type: Prescribed Value, Field: Concentration, Node Set: Right Node Set, Value: 0.5}\n");
  Model model = modelOf(deck);
  BoundaryConditions conditions(deck, model);
  EXPECT_TRUE(conditions.prescribedValueDependsOnTime("Concentration"));
  EXPECT_FALSE(conditions.prescribedValueDependsOnTime("Temperature"));
  conditions.applyPrescribedValue("Concentration", 4.0);
  const double expected[] = {5.0, 5.0, 0.0, 0.0, 0.0, 0.5, 0.5};
  for (int i = 0; i < 7; ++i) EXPECT_DOUBLE_EQ(model.field("Concentration")[i], expected[i]) << i;
  const std::vector<char> mask = {1, 1, 0, 0, 0, 1, 1};
  EXPECT_EQ(conditions.valueIsPrescribed("Concentration"), mask);
  EXPECT_EQ(conditions.valueIsPrescribed("Temperature"), std::vector<char>(7, 0));
}

TEST_F(BoundaryConditionsTest, ForcesAddUp) {
  const Deck deck = deckWith(
      "  Weight: {Type: Body Force, Node Set: Middle Node Set, Coordinate: y, Value: \"-9.81*x\"}\n"
      "  Load: {Type: Traction, Node Set: Right Node Set, Value: \"3*t\", Area: 4.0}\n"
      "  More: {Type: Body Force, Node Set: Right Node Set, Value: 1.0}\n");
  Model model = modelOf(deck);
  BoundaryConditions conditions(deck, model);
  EXPECT_TRUE(conditions.hasExternalForce());
  std::vector<double> force(21, 0.0);
  conditions.addExternalForce(2.0, force.data());
  EXPECT_DOUBLE_EQ(force[3 * 3 + 1], -9.81 * 3);
  // 6 N/m2 on 4 m2 by two points of 1 m3: 12 N/m3, and 1 N/m3 beside it.
  EXPECT_DOUBLE_EQ(force[3 * 5], 13.0);
  EXPECT_DOUBLE_EQ(force[3 * 6], 13.0);
  EXPECT_DOUBLE_EQ(force[3 * 4], 0.0);
}

TEST_F(BoundaryConditionsTest, DamagedPointsBecomeSourcesForGood) {
  const Deck deck = deckWith(
      "  Inlet: {Type: Prescribed Concentration, Node Set: Left Node Set, Value: 3.0}\n"
      "  Faces: {Type: Saturated Crack Faces, Field: Concentration, Value: \"1 + x\", Threshold: 0.4}\n");
  Model model = modelOf(deck);
  BoundaryConditions conditions(deck, model);
  conditions.applyPrescribed(2.0);
  EXPECT_EQ(conditions.updateDamageSources(), 0);
  double* damage = model.field("Damage");
  damage[0] = damage[3] = damage[4] = 0.5;
  damage[5] = 0.4;                                 // not above the threshold
  EXPECT_EQ(conditions.updateDamageSources(), 2);  // point 0 is prescribed already
  EXPECT_EQ(conditions.updateDamageSources(), 0);
  damage[3] = 0.0;
  model.field("Concentration")[3] = 0.0;
  conditions.applyPrescribed(3.0);
  const double expected[] = {3.0, 3.0, 0.0, 4.0, 5.0, 0.0, 0.0};
  for (int i = 0; i < 7; ++i) EXPECT_DOUBLE_EQ(model.field("Concentration")[i], expected[i]) << i;
  const std::vector<char> mask = {1, 1, 0, 1, 1, 0, 0};
  EXPECT_EQ(conditions.valueIsPrescribed("Concentration"), mask);
  EXPECT_EQ(model.field("Concentration_Source")[3], 1.0);

  BoundaryConditions resumed(deck, model);
  resumed.resume(3.0);
  EXPECT_EQ(resumed.valueIsPrescribed("Concentration"), mask);
}

TEST_F(BoundaryConditionsTest, ConflictingPrescriptionsNameBothConditions) {
  const std::string conditions =
      "  Hold: {Type: Prescribed Displacement, Node Set: Left Node Set, Value: 0.0}\n"
      "  Pull: {Type: Prescribed Displacement, Node Set: Middle Node Set, Value: 1.0}\n";
  const std::string error = errorOf(deckWith(conditions));
  EXPECT_NE(error.find("conditions \"Hold\" and \"Pull\" prescribe different values of the same Displacement "
                       "component x"),
            std::string::npos)
      << error;
  EXPECT_NE(error.find("test.yaml:12:3: "), std::string::npos) << error;

  // Peridigm lets the later one hold.
  const Deck peridigm = deckWith(conditions, true);
  Model model = modelOf(peridigm);
  BoundaryConditions last(peridigm, model);
  last.applyPrescribed(2.0);
  last.applyPrescribed(3.0);
  EXPECT_DOUBLE_EQ(model.field("Displacement")[3 * 1], 1.0);
}

/// Peridigm adds to the displacement what the value changes in a step; where that is nothing, the value itself holds.
TEST_F(BoundaryConditionsTest, PeridigmsDisplacementsGoByIncrements) {
  const char* const conditions =
      "  Shift: {Type: Initial Displacement, Node Set: Left Node Set, Value: 0.25}\n"
      "  Ramp: {Type: Prescribed Displacement, Node Set: Left Node Set, Value: \"if(t < 5){value=t;}else{value=5;}\"}\n"
      "  Hold: {Type: Prescribed Displacement, Node Set: Right Node Set, Value: 0.5}\n";
  const Deck deck = deckWith(conditions, true);
  Model model = modelOf(deck);
  BoundaryConditions applied(deck, model);
  const double *ramp = model.field("Displacement"), *hold = model.field("Displacement") + 3 * 5;
  applied.applyInitial();
  applied.applyPrescribed(2.0);
  EXPECT_DOUBLE_EQ(ramp[0], 0.25);
  EXPECT_DOUBLE_EQ(hold[0], 0.0);
  applied.applyPrescribed(2.0);  // the same time again changes nothing
  EXPECT_DOUBLE_EQ(ramp[0], 0.25);
  applied.applyPrescribed(4.0);
  EXPECT_DOUBLE_EQ(ramp[0], 0.25 + 2.0);
  EXPECT_DOUBLE_EQ(hold[0], 0.5);
  applied.applyPrescribed(5.0);
  EXPECT_DOUBLE_EQ(ramp[0], 0.25 + 3.0);

  // A restart finds the displacements and goes on in the same way.
  BoundaryConditions resumed(deck, model);
  resumed.resume(4.5);
  resumed.applyPrescribed(5.0);
  EXPECT_DOUBLE_EQ(ramp[0], 0.25 + 3.5);
  resumed.applyPrescribed(6.0);
  EXPECT_DOUBLE_EQ(ramp[0], 5.0);

  const Deck own = deckWith(conditions);
  Model ours = modelOf(own);
  BoundaryConditions plain(own, ours);
  plain.applyInitial();
  plain.applyPrescribed(2.0);
  EXPECT_DOUBLE_EQ(ours.field("Displacement")[0], 2.0);
}

TEST_F(BoundaryConditionsTest, OverlapIsNoConflictWhereValuesOrComponentsAgree) {
  EXPECT_EQ(errorOf(deckWith("  Hold: {Type: Prescribed Displacement, Node Set: Left Node Set, Value: 0}\n"
                             "  Keep: {Type: Prescribed Displacement, Node Set: Middle Node Set, Value: \"0.0\"}\n"
                             "  Pull: {Type: Prescribed Displacement, Node Set: Middle Node Set, Coordinate: y, "
                             "Value: \"t\"}\n"
                             "  Same: {Type: Prescribed Displacement, Node Set: Left Node Set, Coordinate: y, "
                             "Value: \"t\"}\n")),
            "no error");
}

TEST_F(BoundaryConditionsTest, EveryWrongConditionIsReported) {
  const std::string error =
      errorOf(deckWith("  A: {Type: Prescribed Value, Field: Saltiness, Node Set: Left Node Set, Value: 1.0}\n"
                       "  B: {Type: Prescribed Concentration, Node Set: Top Node Set, Value: 1.0}\n"
                       "  C: {Type: Prescribed Value, Field: Coordinates, Node Set: Left Node Set, Value: 1.0}\n"
                       "  D: {Type: No Failure, Node Set: Left Node Set}\n"));
  EXPECT_NE(error.find("condition \"A\" acts on the field \"Saltiness\", which no material"), std::string::npos)
      << error;
  EXPECT_NE(error.find("no node set \"Top Node Set\" (node sets: \"Left Node Set\""), std::string::npos) << error;
  EXPECT_NE(error.find("field \"Coordinates\" has 3 values a point"), std::string::npos) << error;
  EXPECT_NE(error.find("condition \"D\" acts on the field \"No_Failure\""), std::string::npos) << error;
}

}  // namespace
}  // namespace pd::test
