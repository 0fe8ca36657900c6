// QuasiStatic on bodies of bars whose equilibria are known.
#include "driver/solvers/quasi_static.hpp"

#include <gtest/gtest.h>
#include <mpi.h>

#include "../bar_scene.hpp"
#include "../support/scene_files.hpp"

namespace pd::test {
namespace {

const Communicator& world() {
  static const Communicator comm(MPI_COMM_WORLD);
  return comm;
}

Teuchos::ParameterList settings(const std::string& linearSolver = "Direct",
                                const std::string& preconditioner = "Jacobi") {
  Teuchos::ParameterList list;
  list.set("Linear Solver", linearSolver);
  list.set("Preconditioner", preconditioner);
  list.set("Relative Tolerance", 1e-10);
  return list;
}

const NodeSets ends = {{"Left Node Set", [](const auto& x) { return x[0] < 0.5; }},
                       {"Right Node Set", [](const auto& x) { return x[0] > 9.5; }}};

std::string pull(double length) {
  return "  Hold: {Type: Prescribed Displacement, Node Set: Left Node Set, Coordinate: x, Value: 0.0}\n"
         "  Pull: {Type: Prescribed Displacement, Node Set: Right Node Set, Coordinate: x, Value: \"t*" +
         std::to_string(length) + "\"}\n";
}

Discretization chain(int n = 11) {
  Discretization points = Lattice{n, 1, 1, 1.0}.discretization(world());
  addNodeSets(points, ends);
  return points;
}

struct Tangent {
  bool isProbed;
  const char* linearSolver;
  const char* preconditioner;
};

class Chain : public ::testing::TestWithParam<Tangent> {};

TEST_P(Chain, StretchesUniformly) {
  const Tangent tangent = GetParam();
  Scene scene(barDeck(1000.0, 0.0, pull(0.1), tangent.isProbed), world(), chain(), "QuasiStatic",
              settings(tangent.linearSolver, tangent.preconditioner));
  scene.run(4);
  for (int i = 0; i < 11; ++i) EXPECT_NEAR(scene.displacement()[3 * i], 0.01 * i, 1e-12) << i;
  EXPECT_NEAR(scene.model.field("Force_Density")[0], 10.0, 1e-8);  // c s with s = 0.01
  EXPECT_NEAR(scene.model.field("Force_Density")[30], -10.0, 1e-8);
  // The first load step finds the equilibrium (and may correct its round-off); the others are predicted from it.
  EXPECT_LE(scene.model.timers().phases().at("linear solve").calls, 2);
}

INSTANTIATE_TEST_SUITE_P(LinearSolvers, Chain,
                         ::testing::Values(Tangent{false, "Direct", "None"}, Tangent{true, "Direct", "None"},
                                           Tangent{false, "CG", "Jacobi"}, Tangent{true, "CG", "Block Jacobi"},
                                           Tangent{false, "CG", "ILU"}, Tangent{false, "CG", "Multigrid"},
                                           Tangent{false, "GMRES", "ILU"}));

/// There places are rounded to 1e-8, which no tolerance can ask to be better balanced.
TEST(QuasiStatic, StretchesFarFromWhereItWasMade) {
  const std::string far = "{Type: Prescribed Displacement, Coordinate: x, Node Set: ";
  Scene scene(barDeck(1000.0, 0.0,
                      "  Hold: " + far + "Left Node Set, Value: \"1e8*t\"}\n" + "  Pull: " + far +
                          "Right Node Set, Value: \"1e8*t + 0.1*t\"}\n"),
              world(), chain(), "QuasiStatic", settings());
  scene.run(2);
  const double* displacement = scene.displacement();
  for (int i = 0; i < 11; ++i) EXPECT_NEAR(displacement[3 * i] - displacement[0], 0.01 * i, 1e-6) << i;
}

TEST(QuasiStatic, SolvesAStiffnessJumpOfAThousand) {
  Discretization points = chain();
  // Bonds at or beyond point 5 join volumes of 1000 and 1000 or 1: with equal forces c V_i V_j s the stretches follow.
  for (int i = 6; i < 11; ++i) points.volume[static_cast<std::size_t>(i)] = std::sqrt(1000.0);
  Scene scene(barDeck(1000.0, 0.0, pull(0.1)), world(), points, "QuasiStatic", settings("CG", "Jacobi"));
  scene.run(1);
  std::vector<double> compliance;
  double sum = 0.0;
  for (std::size_t i = 0; i + 1 < 11; ++i) compliance.push_back(1.0 / (points.volume[i] * points.volume[i + 1]));
  for (const double c : compliance) sum += c;
  double expected = 0.0;
  for (int i = 0; i < 10; ++i) {
    EXPECT_NEAR(scene.displacement()[3 * i], expected, 1e-10);
    expected += 0.1 * compliance[static_cast<std::size_t>(i)] / sum;
  }
}

TEST(QuasiStatic, ABodyForceIsCarriedToItsSupport) {
  Scene scene(barDeck(1000.0, 0.0,
                      "  Hold: {Type: Prescribed Displacement, Node Set: Left Node Set, Coordinate: x, Value: 0.0}\n"
                      "  Load: {Type: Body Force, Node Set: Right Node Set, Coordinate: x, Value: 5.0}\n"),
              world(), chain(), "QuasiStatic", settings());
  scene.run(1);
  for (int i = 0; i < 11; ++i) EXPECT_NEAR(scene.displacement()[3 * i], 0.005 * i, 1e-12) << i;
}

const NodeSets rim = {
    {"Rim Node Set", [](const auto& x) { return x[0] < 1.5 || x[0] > 9.5 || x[1] < 1.5 || x[1] > 6.5; }}};

std::string shear(double amount) {
  return "  X: {Type: Prescribed Displacement, Node Set: Rim Node Set, Coordinate: x, Value: \"t*" +
         std::to_string(amount) +
         "*y\"}\n"
         "  Y: {Type: Prescribed Displacement, Node Set: Rim Node Set, Coordinate: y, Value: 0.0}\n";
}

Discretization plate() {
  Discretization points = Lattice{12, 9, 1, 1.5}.discretization(world());
  addNodeSets(points, rim);
  return points;
}

class Plate : public ::testing::TestWithParam<bool> {};

/// In an affine deformation of a lattice the bars of opposite directions balance, however large it is.
TEST_P(Plate, FollowsALargeShearOfItsRim) {
  Scene scene(barDeck(1000.0, 0.0, shear(0.4), GetParam()), world(), plate(), "QuasiStatic",
              settings("CG", "Multigrid"));
  scene.run(2);
  const auto& x = scene.model.discretization().x;
  for (std::size_t i = 0; i < 108; ++i) {
    EXPECT_NEAR(scene.displacement()[3 * i], 0.4 * x[3 * i + 1], 1e-8);
    EXPECT_NEAR(scene.displacement()[3 * i + 1], 0.0, 1e-8);
    EXPECT_EQ(scene.displacement()[3 * i + 2], 0.0);
  }
}
INSTANTIATE_TEST_SUITE_P(AnalyticAndProbed, Plate, ::testing::Bool());

TEST(QuasiStatic, AWeakBondBreaksAndLeavesTwoHalvesWithoutForce) {
  Discretization points = chain();
  points.volume[4] = points.volume[5] = 0.5;  // the bond between them stretches most
  Scene scene(barDeck(1000.0, 0.02, pull(0.2)), world(), points, "QuasiStatic", settings());
  scene.run(4);
  for (int i = 0; i < 11; ++i) {
    EXPECT_NEAR(scene.displacement()[3 * i], i < 5 ? 0.0 : 0.2, 1e-9) << i;
    EXPECT_NEAR(scene.model.field("Force_Density")[3 * i], 0.0, 1e-6) << i;
    EXPECT_EQ(scene.model.field("Damage")[i], i == 4 || i == 5 ? 0.5 : 0.0) << i;
  }
}

TEST(QuasiStatic, AFragmentThatNothingHoldsStaysAndRelaxes) {
  Discretization points = chain();
  points.volume[3] = points.volume[4] = points.volume[7] = points.volume[8] = 0.5;
  Scene scene(barDeck(1000.0, 0.02, pull(0.2)), world(), points, "QuasiStatic", settings());
  scene.run(5);
  for (int i = 0; i < 11; ++i) EXPECT_NEAR(scene.model.field("Force_Density")[3 * i], 0.0, 1e-6) << i;
  for (int i = 5; i < 8; ++i)
    EXPECT_NEAR(scene.displacement()[3 * i], scene.displacement()[3 * 4], 1e-9) << "the fragment is without stress";
  EXPECT_NEAR(scene.displacement()[3 * 3], 0.0, 1e-9);
  EXPECT_NEAR(scene.displacement()[3 * 8], 0.2, 1e-9);
}

TEST(QuasiStatic, PointsThatLoseEveryBondStayWhereTheyAre) {
  // A uniform chain: all bonds exceed their limit at once.
  Scene scene(barDeck(1000.0, 0.02, pull(0.3)), world(), chain(), "QuasiStatic", settings());
  scene.run(4, 0, 3);  // breaks in the third step: stretch 0.0225
  for (int i = 0; i < 11; ++i) {
    EXPECT_NEAR(scene.displacement()[3 * i], 0.0225 * i, 1e-9) << i;
    EXPECT_EQ(scene.model.field("Damage")[i], 1.0);
    EXPECT_EQ(scene.model.field("Force_Density")[3 * i], 0.0);
  }
  scene.run(4, 3, 4);  // and the run goes on
  EXPECT_NEAR(scene.displacement()[3 * 5], 0.1125, 1e-9);
  EXPECT_NEAR(scene.displacement()[3 * 10], 0.3, 1e-15);
}

TEST(QuasiStatic, APointOnOneBondAndAFreeFragmentLeaveAPlateSolvable) {
  Discretization points = plate();
  points.bondIsCut.assign(static_cast<std::size_t>(points.nBonds()), 0);
  const auto isInFragment = [&](int i) {
    const double* x = &points.x[static_cast<std::size_t>(3 * i)];
    return x[0] > 3.5 && x[0] < 6.5 && x[1] > 2.5 && x[1] < 5.5;
  };
  const int hanging = 4 * 12 + 8;  // at (8, 4): keeps its bond to (9, 4) alone
  std::size_t bond = 0;
  const int* list = points.neighborhoodList.data();
  for (int i = 0; i < points.nOwned; ++i)
    for (int count = *list++; count > 0; --count, ++bond) {
      const int j = *list++;
      const bool isHanging = (i == hanging && j != hanging + 1) || (j == hanging && i != hanging + 1);
      if (isInFragment(i) != isInFragment(j) || isHanging) points.bondIsCut[bond] = 1;
    }
  Scene scene(barDeck(1000.0, 0.0, shear(0.05)), world(), points, "QuasiStatic", settings("CG", "Jacobi"));
  scene.run(2);
  const double* u = scene.displacement();
  for (int i = 0; i < points.nOwned; ++i) {
    if (isInFragment(i)) {
      EXPECT_NEAR(u[3 * i], 0.0, 1e-12);
    }
  }
  // The bond carries nothing in equilibrium: the point is at its length from its neighbour.
  const double* y = scene.model.field("Coordinates");
  EXPECT_NEAR(std::hypot(y[3 * hanging] - y[3 * (hanging + 1)], y[3 * hanging + 1] - y[3 * (hanging + 1) + 1]), 1.0,
              1e-6);
}

TEST(LooseParts, CountWhatIsMissingInEachDimension) {
  struct Case {
    Lattice lattice;
    int heldAxes;  // on the face x = 0
    int missing;
  };
  // A line held nowhere; a plane held in x on an edge (y is free); a solid held in x on a face (y, z and the rotation
  // about x are free); a solid held in x and y there (z is free).
  for (const Case& c : {Case{{5, 1, 1, 1.0}, 0, 1}, Case{{4, 4, 1, 1.5}, 1, 1}, Case{{4, 4, 1, 1.5}, 0, 3},
                        Case{{3, 3, 3, 1.5}, 1, 3}, Case{{3, 3, 3, 1.5}, 2, 1}, Case{{3, 3, 3, 1.5}, 0, 6}}) {
    const Discretization points = c.lattice.discretization(world());
    const Deck deck = deckOf(barDeck(1.0, 0.0, "  A Node Set: 1\n"));
    Model model(deck, world(), points, {});
    std::vector<char> isPrescribed(static_cast<std::size_t>(3 * points.nOwned), 0);
    for (int i = 0; i < points.nOwned; ++i)
      for (int axis = 0; axis < 3; ++axis)
        isPrescribed[static_cast<std::size_t>(3 * i + axis)] =
            axis >= points.dimension || (points.x[static_cast<std::size_t>(3 * i)] == 0.0 && axis < c.heldAxes);
    const HeldInPlace held = findLooseParts(model, isPrescribed);
    EXPECT_EQ(
        std::count(held.isHeld.begin(), held.isHeld.end(), 1) - std::count(isPrescribed.begin(), isPrescribed.end(), 1),
        c.missing);
    EXPECT_EQ(held.parts.size(), 1U);
    EXPECT_EQ(held.nPointsOfParts(), points.nGlobal);
    EXPECT_EQ(held.nPointsWithoutBonds, 0);
  }
}

/// What a body without prescribed displacements lacks beside planes of symmetry.
HeldInPlace supportsOf(const std::string& mesh, const std::string& discretization, const std::string& horizon) {
  const pd_test::SceneFiles files("supports", MPI_COMM_WORLD);
  files.write("mesh.txt", mesh);
  const Discretization points =
      readDiscretization(Deck::read(files.write("deck.yaml", pd_test::deckText(horizon, discretization))), world());
  const Deck deck = deckOf(barDeck(1.0, 0.0, "  A Node Set: 1\n"));
  Model model(deck, world(), points, {});
  std::vector<char> isPrescribed(static_cast<std::size_t>(3 * points.nOwned), 0);
  for (std::size_t i = 0; i < isPrescribed.size(); ++i) isPrescribed[i] = static_cast<int>(i % 3) >= points.dimension;
  HeldInPlace held = findLooseParts(model, isPrescribed);
  for (std::size_t i = 0; i < isPrescribed.size(); ++i) held.isHeld[i] = held.isHeld[i] != isPrescribed[i];
  return held;
}

long long heldIn(const HeldInPlace& held) { return std::count(held.isHeld.begin(), held.isHeld.end(), 1); }

const std::string left = "    Left: {Point: [-0.5, 0, 0], Normal: [1, 0, 0]}\n",
                  below = "    Below: {Point: [0, -0.5, 0], Normal: [0, 1, 0]}\n",
                  back = "    Back: {Point: [0, 0, -0.5], Normal: [0, 0, 1]}\n";

TEST(LooseParts, PlanesOfSymmetryHoldWhatTheyMirror) {
  struct Case {
    std::string mesh, planes;
    int missing;
  };
  const std::string line = pd_test::latticeMesh(4, 1, 1), plane = pd_test::latticeMesh(4, 3, 1),
                    solid = pd_test::latticeMesh(3, 3, 3);
  // A line: nothing is free. A plane: y with one plane, nothing with two. A solid: y, z and the rotation about x with
  // one plane, z with two, nothing with three.
  for (const Case& c : {Case{line, left, 0}, Case{plane, left, 1}, Case{plane, left + below, 0}, Case{solid, left, 3},
                        Case{solid, left + below, 1}, Case{solid, left + below + back, 0}}) {
    const HeldInPlace held = supportsOf(c.mesh, "  Symmetry:\n" + c.planes, "1.5");
    EXPECT_EQ(heldIn(held), c.missing) << c.planes;
    EXPECT_EQ(held.parts.size(), c.missing > 0 ? 1U : 0U);
    EXPECT_EQ(held.nPointsWithoutBonds, 0);
  }
}

TEST(LooseParts, APointMayHangOnItsImageAlone) {
  const HeldInPlace held = supportsOf("0 0 0 1 1\n5 0 0 1 1\n6 0 0 1 1\n", "  Symmetry:\n" + left, "1.5");
  EXPECT_EQ(held.nPointsWithoutBonds, 0);
  EXPECT_EQ(held.parts.size(), 1U);  // the other two
  EXPECT_EQ(held.nPointsOfParts(), 2);
  EXPECT_EQ(heldIn(held), 1);
}

TEST(LooseParts, APartMayCrossAPlaneByHalves) {
  // Two points, one above the other, beside x = 0. Cuts leave the bonds from each to the other's image alone: in the
  // whole body two bars that cross, free to move in three ways as each other's mirror images.
  const auto cut = [](const std::string& name, const std::string& normal, double x, double y,
                      const std::string& bottom) {
    return "    " + name + ": {Type: Rectangular_Plane, Side_Length: 2.0, Bottom_Length: 0.4, Lower_Left_Corner_X: " +
           std::to_string(x) + ", Lower_Left_Corner_Y: " + std::to_string(y) + ", Lower_Left_Corner_Z: " + bottom +
           normal + "}\n";
  };
  const std::string acrossY =
      ", Normal_X: 0, Normal_Y: 1, Normal_Z: 0, Bottom_Unit_Vector_X: 1, Bottom_Unit_Vector_Y: 0, "
      "Bottom_Unit_Vector_Z: 0";
  const std::string acrossX =
      ", Normal_X: 1, Normal_Y: 0, Normal_Z: 0, Bottom_Unit_Vector_X: 0, Bottom_Unit_Vector_Y: 1, "
      "Bottom_Unit_Vector_Z: 0";
  const HeldInPlace held =
      supportsOf("0 0 0 1 1\n0 1 0 1 1\n",
                 "  Symmetry:\n" + left + "  Bond Filters:\n" + cut("A", acrossY, -0.2, 0.5, "-1.0") +
                     cut("B", acrossX, -0.5, -0.2, "1.0") + cut("C", acrossX, -0.5, 0.8, "1.0"),
                 "1.5");
  EXPECT_EQ(held.nPointsWithoutBonds, 0);
  EXPECT_EQ(held.parts.size(), 1U);
  EXPECT_EQ(held.nPointsOfParts(), 2);
  EXPECT_EQ(heldIn(held), 3);
}

/// Forces of so many N along `axis` on both ends.
std::string forces(const char* axis, double left, double right) {
  const auto force = [&](const std::string& side, double value) {
    return "  " + side + ": {Type: Force, Node Set: " + side + " Node Set, Coordinate: " + axis +
           ", Value: " + std::to_string(value) + "}\n";
  };
  return force("Left", left) + force("Right", right);
}

/// What QuasiStatic says to the loads; empty where it solves them.
std::string complaint(const Discretization& points, const std::string& conditions) {
  Scene scene(barDeck(1000.0, 0.0, conditions), world(), points, "QuasiStatic", settings());
  try {
    scene.run(1);
  } catch (const RunError& error) {
    return error.what();
  }
  return "";
}

TEST(QuasiStatic, RefusesLoadsThatNothingHolds) {
  Discretization plate = Lattice{11, 3, 1, 1.5}.discretization(world());
  addNodeSets(plate, ends);
  const auto says = [](const std::string& message, const std::string& part) {
    return message.find(part) != std::string::npos;
  };
  // A chain that is pulled at one end, and at both.
  EXPECT_PRED2(says, complaint(chain(), forces("x", 0.0, 5.0)), "a force of (5, 0, 0) N on a part of 11 points");
  Scene balanced(barDeck(1000.0, 0.0, forces("x", -5.0, 5.0)), world(), chain(), "QuasiStatic", settings());
  balanced.run(1);
  for (int i = 0; i < 10; ++i)  // c s = 5
    EXPECT_NEAR(balanced.displacement()[3 * i + 3] - balanced.displacement()[3 * i], 0.005, 1e-10) << i;
  // A couple of forces 10 m apart turns the plate; held in x on the left it cannot turn, but moves up.
  const std::string held =
      "  Hold: {Type: Prescribed Displacement, Node Set: Left Node Set, Coordinate: x, Value: 0}\n";
  EXPECT_PRED2(says, complaint(plate, forces("y", -5.0, 5.0)),
               "displacement carries a moment of (0, 0, 50) N m on a part of 33");
  EXPECT_EQ(complaint(plate, held + forces("y", -5.0, 5.0)), "");
  EXPECT_PRED2(says, complaint(plate, held + forces("y", 2.0, 5.0)),
               "displacement carries a force of (0, 7, 0) N on a part of 33");
  // Points without bonds.
  Discretization dust = chain();
  dust.bondIsCut.assign(static_cast<std::size_t>(dust.nBonds()), 1);
  EXPECT_PRED2(says, complaint(dust, forces("x", -5.0, 5.0)), "forces of 10 N in all on points without bonds");
}

TEST(QuasiStatic, SaysWhyItStops) {
  Teuchos::ParameterList list = settings();
  list.set("Maximum Solver Iterations", 1);
  list.set("Maximum Load Step Reductions", 0);
  Scene scene(barDeck(1000.0, 0.0, shear(0.4)), world(), plate(), "QuasiStatic", list);
  // A shear of 0.4 is far from linear: the first guess and one iteration are not enough.
  try {
    scene.run(1);
    FAIL() << "no error";
  } catch (const RunError& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find("load step 1 (t = 1 s): no equilibrium: the iterations are used up"), std::string::npos)
        << message;
    EXPECT_NE(message.find("Maximum Solver Iterations"), std::string::npos) << message;
  }
}

TEST(QuasiStatic, HalvesALoadStepThatIsTooLong) {
  Teuchos::ParameterList list = settings();
  list.set("Maximum Solver Iterations", 1);
  list.set("Relative Tolerance", 1e-7);
  Scene scene(barDeck(1000.0, 0.0, shear(0.4)), world(), plate(), "QuasiStatic", list);
  scene.run(1);
  const auto& x = scene.model.discretization().x;
  for (std::size_t i = 0; i < 108; ++i) EXPECT_NEAR(scene.displacement()[3 * i], 0.4 * x[3 * i + 1], 1e-4);
  EXPECT_EQ(scene.solver->summary()[1].find("0 load steps halved"), std::string::npos) << scene.solver->summary()[1];
}

TEST(QuasiStatic, EndsItsLoadStepsAtGivenTimes) {
  Teuchos::ParameterList list = settings();
  list.set("Time Steps", "0.0 0.1 0.4 1.0");
  Scene scene(barDeck(1000.0, 0.0, pull(0.1)), world(), chain(), "QuasiStatic", list);
  EXPECT_EQ(scene.solver->numberOfIncrements(scene.simulation(), 0.0, 1.0), 3);
  EXPECT_THROW(scene.solver->numberOfIncrements(scene.simulation(), 0.0, 2.0), RunError);
  scene.run(3, 0, 2);
  EXPECT_NEAR(scene.displacement()[30], 0.04, 1e-14);
  list.set("Time Steps", "0.0 0.5 0.4");
  EXPECT_THROW(QuasiStatic{list}, std::invalid_argument);
}

TEST(QuasiStatic, TakesPeridigmsNames) {
  Teuchos::ParameterList list;
  list.set("Number of Load Steps", 3);
  list.set("Belos Linear Solver", "BlockGMRES");
  list.set("Belos Maximum Iterations", 100);
  list.set("Belos Relative Tolerance", 1e-9);
  list.set("Absolute Tolerance", 1e-6);
  list.set("Damped Newton Diagonal Scale Factor", 1.0001);
  list.set("Damped Newton Diagonal Shift Factor", 0.00001);
  Scene scene(barDeck(1000.0, 0.0, pull(0.1)), world(), chain(), "QuasiStatic", list);
  EXPECT_EQ(scene.solver->numberOfIncrements(scene.simulation(), 0.0, 1.0), 3);
  scene.run(3);
  // 1e-6 N of a stiffness of 1000 N/m over ten bars.
  for (int i = 0; i < 11; ++i) EXPECT_NEAR(scene.displacement()[3 * i], 0.01 * i, 1e-7) << i;
}

/// Point fields and bond fields as a checkpoint carries them.
void copyFields(Scene& from, Scene& to) {
  auto& fields = FieldManager::self();
  for (const std::string& label : fields.getFieldLabels()) {
    const int id = fields.getFieldId(label);
    for (const Step step : {STEP_NONE, STEP_N, STEP_NP1}) {
      auto a = from.model.blocks()->front().getDataManager(), b = to.model.blocks()->front().getDataManager();
      if (a->hasData(id, step)) *b->getData(id, step) = *a->getData(id, step);
    }
  }
}

TEST(QuasiStatic, GoesOnBitForBitAfterARestart) {
  Discretization points = plate();
  points.volume[50] = 0.3;  // not affine
  const std::string deck = barDeck(1000.0, 0.12, shear(0.3));
  Scene whole(deck, world(), points, "QuasiStatic", settings("CG", "Multigrid"));
  whole.run(6, 0, 3);
  Scene restarted(deck, world(), points, "QuasiStatic", settings("CG", "Multigrid"));
  copyFields(whole, restarted);
  restarted.solver->setRestartState(whole.solver->restartState());
  whole.run(6, 3, 6);
  restarted.run(6, 3, 6);
  bool hasBroken = false;
  for (int i = 0; i < 108; ++i) {
    hasBroken = hasBroken || whole.model.field("Damage")[i] > 0.0;
    EXPECT_EQ(whole.model.field("Damage")[i], restarted.model.field("Damage")[i]);
    for (int c = 0; c < 3; ++c) EXPECT_EQ(whole.displacement()[3 * i + c], restarted.displacement()[3 * i + c]);
  }
  EXPECT_TRUE(hasBroken);
}

}  // namespace
}  // namespace pd::test
