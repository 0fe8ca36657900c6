// Initial and boundary conditions on a row of seven points, x = 0 .. 6, of unit volume.
#include "driver/boundary/boundary_conditions.hpp"

#include <gtest/gtest.h>
#include <mpi.h>

#include <cmath>
#include <cstdio>

#include "../model_plugins.hpp"
#include "../mpi/lattice.hpp"
#include "driver/boundary/condition.hpp"
#include "driver/boundary/far_field.hpp"
#include "driver/model/simulation.hpp"

namespace pd::test {
namespace {

/// The smallest condition: it warms its points at each applyPrescribed(), and its one registration makes it known.
class Warming : public Condition {
 public:
  static void declareParameters(ParameterDeclarations& declare) {
    declareNodeSet(declare);
    declare.function("Value", "unit of the field", "What is added at a time.").required();
  }
  explicit Warming(const ConditionSection& section) : Condition(section, "Concentration", 1) {}
  void applyPrescribed(Model& model, double t) override {
    const std::vector<double>& given = evaluate(model.discretization(), t);
    for (std::size_t k = 0; k < given.size(); ++k) model.field(field())[points()[k]] += given[k];
  }
};
PD_REGISTER_CONDITION(Warming, "Test Warming", "Adds to a field")

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
    points.dimension = 2;  // a row of points of a plane
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
      "  Weight: {Type: Body Force, Node Set: Middle Node Set, Coordinate: x, Value: \"-9.81*x\"}\n"
      "  Load: {Type: Traction, Node Set: Right Node Set, Value: \"3*t\", Area: 4.0}\n"
      "  More: {Type: Body Force, Node Set: Right Node Set, Value: 1.0}\n");
  Model model = modelOf(deck);
  BoundaryConditions conditions(deck, model);
  EXPECT_TRUE(conditions.hasExternalForce());
  std::vector<double> force(21, 0.0);
  conditions.addExternalForce(2.0, force.data());
  EXPECT_DOUBLE_EQ(force[3 * 3], -9.81 * 3);
  // 6 N/m2 on 4 m2 by two points of 1 m3: 12 N/m3, and 1 N/m3 beside it.
  EXPECT_DOUBLE_EQ(force[3 * 5], 13.0);
  EXPECT_DOUBLE_EQ(force[3 * 6], 13.0);
  EXPECT_DOUBLE_EQ(force[3 * 4], 0.0);
}

TEST_F(BoundaryConditionsTest, FarFieldDrawsTheFluxOfTheWayToIt) {
  // Two points of 1 m3 on 0.5 m2: a layer of 4 m.
  const Deck deck = deckWith(
      "  Sea: {Type: Far Field Concentration, Node Set: Right Node Set, Value: \"2*t\", Distance: 6.0,"
      " Diffusivity: 3.0, Area: 0.5}\n");
  Model model = modelOf(deck);
  BoundaryConditions conditions(deck, model);
  const auto& sea = conditions.farField("Concentration", 4.0);
  ASSERT_EQ(sea.coefficient.size(), 7u);
  const double k = sea.coefficient[5], y = 4.0 * std::sqrt(k / 3.0);
  EXPECT_NEAR(3.0 / 4.0 * y * std::tanh(y), 3.0 / (6.0 + 4.0), 1e-14);
  const std::vector<double> coefficient = {0, 0, 0, 0, 0, k, k}, value = {0, 0, 0, 0, 0, 8.0, 8.0};
  EXPECT_EQ(sea.coefficient, coefficient);
  EXPECT_EQ(sea.value, value);
  EXPECT_EQ(conditions.farField("Concentration", 5.0).value[6], 10.0);
  EXPECT_TRUE(conditions.farField("Temperature", 4.0).coefficient.empty());
  // It prescribes nothing.
  EXPECT_EQ(conditions.valueIsPrescribed("Concentration"), std::vector<char>(7, 0));
  EXPECT_FALSE(conditions.prescribedValueDependsOnTime("Concentration"));
}

TEST_F(BoundaryConditionsTest, FarFieldsAddUp) {
  const char* const format =
      "  %s: {Type: Far Field Concentration, Node Set: %s, Value: %s, Distance: 6.0, Diffusivity: 3.0, Area: 0.5}\n";
  char sea[200], spring[200];
  std::snprintf(sea, sizeof sea, format, "Sea", "Right Node Set", "1.0");
  std::snprintf(spring, sizeof spring, format, "Spring", "Right Node Set", "4.0");
  const Deck deck = deckWith(std::string(sea) + spring);
  Model model = modelOf(deck);
  BoundaryConditions conditions(deck, model);
  const auto& both = conditions.farField("Concentration", 2.0);
  EXPECT_DOUBLE_EQ(both.coefficient[6], 2.0 * exchangeRate(3.0, 6.0, 4.0));
  EXPECT_DOUBLE_EQ(both.value[6], 2.5);
}

TEST(FarField, ExchangeOfALayer) {
  // Far away, D/(h l); at no distance, y tanh y = 1 at y = 1.19967864 (Abramowitz & Stegun, table 4.20).
  EXPECT_NEAR(exchangeRate(2.0, 1e6, 1.0), 2.0 / 1e6, 1e-11);
  EXPECT_NEAR(exchangeRate(2.0, 0.0, 0.5), 2.0 * std::pow(1.19967864 / 0.5, 2), 1e-6);
  // The steady state of a bar of 10 at C = 1 at one end, that goes on for `distance` past a layer of 2, by differences.
  for (const double distance : {0.0, 1.0, 30.0}) {
    constexpr int n = 24000;
    const double length = 12.0, dx = length / n, k = exchangeRate(0.7, distance, 2.0);
    // Thomas' algorithm for -D C'' + k C = 0 in cells, no flux through the end.
    std::vector<double> above(n), right(n);
    for (int i = 0; i < n; ++i) {
      const double sink = (i + 0.5) * dx > 10.0 ? k * dx * dx / 0.7 : 0.0;
      const double below = i == 0 ? 2.0 : 1.0, next = i + 1 == n ? 0.0 : 1.0;  // half a cell from the fixed end
      const auto at = static_cast<std::size_t>(i);
      const double diagonal = below + next + sink - (i == 0 ? 0.0 : above[at - 1]);
      above[at] = next / diagonal;
      right[at] = (i == 0 ? 2.0 : right[at - 1]) / diagonal;
    }
    double first = 0.0;
    for (std::size_t i = n; i-- > 0;) first = right[i] + above[i] * first;
    const double flux = 0.7 * (1.0 - first) / (0.5 * dx);
    EXPECT_NEAR(flux, 0.7 / (12.0 + distance), 1e-6) << distance;
  }
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

/// What conditions keep beside the fields is as before a step that is taken back, however often.
TEST_F(BoundaryConditionsTest, AStepThatIsTakenBackLeavesNoTrace) {
  const Deck deck = deckWith(
      "  Push: {Type: Initial Velocity, Node Set: Left Node Set, Value: 9.0}\n"
      "  Pull: {Type: Prescribed Displacement, Node Set: Right Node Set, Coordinate: x, Value: \"0.5*t^2\"}\n"
      "  Faces: {Type: Saturated Crack Faces, Field: Concentration, Value: \"1 + x + t\", Threshold: 0.4}\n");
  Model model = modelOf(deck);
  BoundaryConditions conditions(deck, model);
  Output output(deck, comm, true);
  Simulation simulation{model, conditions, output};
  conditions.applyPrescribed(2.0);
  model.field("Damage")[2] = 0.5;
  ASSERT_EQ(conditions.updateDamageSources(), 1);
  model.adoptState();
  const std::vector<char> mask = conditions.valueIsPrescribed("Concentration");
  simulation.beginStep();
  for (int attempt = 0; attempt < 2; ++attempt) {
    conditions.applyPrescribed(6.0);
    model.field("Damage")[3] = 0.5;
    ASSERT_EQ(conditions.updateDamageSources(), 1);
    ASSERT_EQ(model.field("Concentration")[3], 1.0 + 3.0 + 6.0);
    simulation.takeBackStep();
    EXPECT_EQ(conditions.valueIsPrescribed("Concentration"), mask);
    EXPECT_EQ(model.field("Concentration_Source")[3], 0.0);
    EXPECT_EQ(model.field("Concentration_Source")[2], 1.0);
    EXPECT_EQ(model.field("Concentration")[3], 0.0);
    EXPECT_EQ(model.field("Concentration")[2], 1.0 + 2.0 + 2.0);
  }
  // Sources take the time of the step, and the mean velocity is that since its start.
  conditions.applyPrescribed(4.0);
  EXPECT_DOUBLE_EQ(model.field("Velocity")[3 * 6], (8.0 - 2.0) / 2.0);
  EXPECT_EQ(model.field("Concentration")[3], 0.0);
  EXPECT_EQ(model.field("Concentration")[2], 1.0 + 2.0 + 4.0);
}

TEST_F(BoundaryConditionsTest, TakenBackPeridigmsDisplacementsKeepTheirOffset) {
  const Deck deck = deckWith(
      "  Shift: {Type: Initial Displacement, Node Set: Left Node Set, Value: 0.25}\n"
      "  Ramp: {Type: Prescribed Displacement, Node Set: Left Node Set, Value: \"if(t < "
      "5){value=t;}else{value=5;}\"}\n",
      true);
  Model model = modelOf(deck);
  BoundaryConditions conditions(deck, model);
  conditions.applyInitial();
  conditions.applyPrescribed(2.0);
  conditions.applyPrescribed(5.0);
  conditions.beginStep();
  conditions.applyPrescribed(6.0);  // the value does not change: it holds from now on
  EXPECT_DOUBLE_EQ(model.field("Displacement")[0], 5.0);
  conditions.takeBackStep();
  conditions.applyPrescribed(4.0);
  EXPECT_DOUBLE_EQ(model.field("Displacement")[0], 4.0 + (0.25 - 2.0));
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

TEST_F(BoundaryConditionsTest, ConflictingInitialValuesNameBothConditions) {
  const std::string conditions =
      "  Everywhere: {Type: Initial Concentration, Node Set: Left Node Set, Value: 2.0}\n"
      "  Some: {Type: Initial Value, Field: Concentration, Node Set: Middle Node Set, Value: \"1 + x + t\"}\n";
  const std::string error = errorOf(deckWith(conditions));  // 4 at x = 1, where t = 2
  EXPECT_NE(error.find("test.yaml:12:3: conditions \"Everywhere\" and \"Some\" start from different values of the same "
                       "Concentration where their node sets overlap"),
            std::string::npos)
      << error;

  const Deck peridigm = deckWith(conditions, true);
  Model model = modelOf(peridigm);
  BoundaryConditions last(peridigm, model);
  last.applyInitial();
  EXPECT_DOUBLE_EQ(model.field("Concentration")[0], 2.0);
  EXPECT_DOUBLE_EQ(model.field("Concentration")[1], 4.0);
}

TEST_F(BoundaryConditionsTest, InitialValuesMayOverlapWhereTheyAgree) {
  // Two texts, 1 both at x = 1; an initial and a prescribed value are no conflict either.
  EXPECT_EQ(errorOf(deckWith("  A: {Type: Initial Concentration, Node Set: Left Node Set, Value: 1.0}\n"
                             "  B: {Type: Initial Concentration, Node Set: Middle Node Set, Value: \"x\"}\n"
                             "  C: {Type: Prescribed Concentration, Node Set: Middle Node Set, Value: 7.0}\n")),
            "no error");
}

TEST_F(BoundaryConditionsTest, ANewConditionNeedsNothingButItsRegistration) {
  const Deck deck = deckWith("  Warm: {Type: Test Warming, Node Set: Left Node Set, Value: \"x*t\"}\n");
  Model model = modelOf(deck);
  BoundaryConditions conditions(deck, model);
  conditions.applyPrescribed(2.0);
  conditions.applyPrescribedValue("Concentration", 3.0);
  EXPECT_DOUBLE_EQ(model.field("Concentration")[1], 5.0);
  EXPECT_EQ(conditions.valueIsPrescribed("Concentration"), std::vector<char>(7, 0));
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
