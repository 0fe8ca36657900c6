// Adaptive dynamic relaxation of chains and plates of springs.
#include <gtest/gtest.h>

#include <cmath>

#include "../solver_scene.hpp"
#include "driver/solvers/absolute_row_sums.hpp"

namespace pd::test {
namespace {

constexpr int nPoints = 12;

std::string pull(const std::string& value) {
  return "  Left: {Type: Prescribed Displacement, Node Set: Left Node Set, Coordinate: x, Value: 0.0}\n"
         "  Right: {Type: Prescribed Displacement, Node Set: Right Node Set, Coordinate: x, Value: \"" +
         value + "\"}\n";
}

class RelaxationTest : public ::testing::Test {
 protected:
  Communicator comm{MPI_COMM_WORLD};
  Lattice chain{nPoints, 1, 1, 1.0};
};

TEST_F(RelaxationTest, RowSumsOfAChain) {
  SolverScene scene(comm, chain, pull("0"));
  scene.start("Displacement", [](double, double) { return 0.0; });
  AbsoluteRowSums rowSums(scene.model());
  scene.model().assembleJacobian(0.0, rowSums);
  const auto sums = rowSums.ownedSums();
  for (int i = 0; i < scene.model().nOwned(); ++i) {
    const double x = scene.x(i), expected = x == 0.0 || x == nPoints - 1 ? 2.0 : 4.0;
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(sums[3 * i + k], expected, 1e-6) << "x = " << x;
  }
  rowSums.putScalar(0.0);
  for (const double sum : rowSums.ownedSums()) EXPECT_EQ(sum, 0.0);
}

TEST_F(RelaxationTest, FindsTheExactEquilibriumOfAChain) {
  SolverScene scene(comm, chain, pull("0.11*t"));
  const auto solver = scene.make("Adaptive Dynamic Relaxation", "{Load Steps: 2, Relative Tolerance: 1e-9}");
  scene.start("Displacement", [](double, double) { return 0.0; });
  scene.run(*solver, 0.0, 1.0);
  EXPECT_LT(scene.error("Displacement", [](double x) { return 0.01 * x; }), 1e-9);
}

TEST_F(RelaxationTest, FindsTheExactEquilibriumUnderBodyForce) {
  // -u'' = q on the chain with held ends: u = q x (L - x) / 2 exactly, since second differences of parabolas are exact.
  SolverScene scene(comm, chain,
                    pull("0") +
                        "  Weight: {Type: Body Force, Node Set: All Node Set, Coordinate: x, Value: "
                        "1e-3}\n");
  const auto solver = scene.make("Adaptive Dynamic Relaxation", "{Relative Tolerance: 1e-9}");
  scene.start("Displacement", [](double, double) { return 0.0; });
  scene.run(*solver, 0.0, 1.0);
  EXPECT_LT(scene.error("Displacement", [](double x) { return 0.5e-3 * x * (nPoints - 1 - x); }), 1e-9);
}

TEST_F(RelaxationTest, HoldsTheThirdDirectionOfAPlate) {
  SolverScene scene(comm, Lattice{8, 5, 1, 1.5}, pull("0.07"));
  const auto solver = scene.make("Adaptive Dynamic Relaxation", "{Relative Tolerance: 1e-9}");
  scene.start("Displacement", [](double, double) { return 0.0; });
  for (int i = 0; i < scene.model().nPoints(); ++i) scene.model().field("Displacement")[3 * i + 2] = 1e-3 * i;
  scene.run(*solver, 0.0, 1.0);
  EXPECT_LT(scene.error("Displacement", [](double x) { return 0.01 * x; }), 1e-8);
  for (int i = 0; i < scene.model().nOwned(); ++i) EXPECT_EQ(scene.model().field("Displacement")[3 * i + 2], 1e-3 * i);
}

/// The same relaxation on plain arrays, from the formulas in the header.
std::vector<double> referenceRelaxation(int nIterations, double end) {
  std::vector<double> u(nPoints, 0.0), v(nPoints, 0.0), f(nPoints, 0.0), before(nPoints, 0.0);
  u.back() = end;
  const double mass = 0.25 * 1.21 * 4.0;
  for (int n = 0; n < nIterations; ++n) {
    double k = 0.0, m = 0.0;
    for (int i = 1; i + 1 < nPoints; ++i) {
      f[i] = (u[i + 1] - 2.0 * u[i] + u[i - 1]) / mass;
      k -= v[i] * (f[i] - before[i]);
      m += v[i] * v[i];
    }
    const double c = k > 0.0 && m > 0.0 ? std::min(1.9, 2.0 * std::sqrt(k / m)) : 0.0;
    for (int i = 1; i + 1 < nPoints; ++i) {
      v[i] = n == 0 ? 0.5 * f[i] : ((2.0 - c) * v[i] + 2.0 * f[i]) / (2.0 + c);
      before[i] = f[i];
    }
    for (int i = 1; i + 1 < nPoints; ++i) u[i] += v[i];
  }
  return u;
}

TEST_F(RelaxationTest, DampingIsOneGlobalNumber) {
  // A number per rank would change the path.
  SolverScene scene(comm, chain, pull("0.11"));
  const auto solver = scene.make("Adaptive Dynamic Relaxation", "{Iterations Per Load Step: 37}");
  scene.start("Displacement", [](double, double) { return 0.0; });
  scene.run(*solver, 0.0, 1.0);
  const auto expected = referenceRelaxation(37, 0.11);
  // The masses come from finite differences: 1e-7 of them.
  EXPECT_LT(scene.error("Displacement", [&](double x) { return expected[static_cast<std::size_t>(x)]; }), 1e-7);
}

TEST_F(RelaxationTest, MotionGoesOnFromLoadStepToLoadStep) {
  const auto displacements = [&](const std::string& parameters) {
    SolverScene scene(comm, chain, pull("0.11"));
    const auto solver = scene.make("Adaptive Dynamic Relaxation", parameters);
    scene.start("Displacement", [](double, double) { return 0.0; });
    scene.run(*solver, 0.0, 1.0);
    return scene.values("Displacement");
  };
  EXPECT_EQ(displacements("{Iterations Per Load Step: 30}"),
            displacements("{Load Steps: 30, Iterations Per Load Step: 1}"));
}

TEST_F(RelaxationTest, GoesOnBitIdenticallyFromItsRestartState) {
  const std::string parameters = "{Load Steps: 30, Iterations Per Load Step: 1}";
  SolverScene whole(comm, chain, pull("0.11*t")), halves(comm, chain, pull("0.11*t"));
  const auto one = whole.make("Adaptive Dynamic Relaxation", parameters),
             first = halves.make("Adaptive Dynamic Relaxation", parameters),
             second = halves.make("Adaptive Dynamic Relaxation", parameters);
  const auto initial = [](double, double) { return 0.0; };
  whole.start("Displacement", initial);
  halves.start("Displacement", initial);
  whole.advance(*one, 0.0, 30.0, 30);
  halves.advance(*first, 0.0, 10.0, 10);
  second->initialize(halves.simulation());
  second->setRestartState(first->restartState());
  halves.advance(*second, 10.0, 30.0, 20);
  EXPECT_EQ(whole.values("Displacement"), halves.values("Displacement"));
}

TEST_F(RelaxationTest, SaysWhenItDoesNotConverge) {
  SolverScene scene(comm, chain, pull("0.11"));
  const auto solver = scene.make("Adaptive Dynamic Relaxation", "{Relative Tolerance: 1e-9, Maximum Iterations: 5}");
  scene.start("Displacement", [](double, double) { return 0.0; });
  try {
    scene.run(*solver, 0.0, 1.0);
    FAIL() << "converged";
  } catch (const RunError& error) {
    EXPECT_NE(std::string(error.what()).find("after 5 iterations"), std::string::npos) << error.what();
  }
}

TEST_F(RelaxationTest, BondsBreakInEquilibriumOnly) {
  // In equilibrium every bond is 1 + 0.15 / 11 long, below the limit; on the way there the last one is 1.15 long.
  SolverScene scene(comm, chain, pull("0.15"), "{Damage Model: Test Length, Greatest Length: 1.02}");
  const auto solver = scene.make("Adaptive Dynamic Relaxation", "{Relative Tolerance: 1e-8}");
  scene.start("Displacement", [](double, double) { return 0.0; });
  // The initial state has been evaluated with the right end at rest.
  for (int i = 0; i < scene.model().nOwned(); ++i) ASSERT_EQ(scene.model().field("Damage")[i], 0.0);
  scene.run(*solver, 0.0, 1.0);
  EXPECT_EQ(scene.error("Damage", [](double) { return 0.0; }), 0.0);
  EXPECT_LT(scene.error("Displacement", [](double x) { return 0.15 / 11 * x; }), 1e-8);
}

TEST_F(RelaxationTest, RelaxesAgainUntilNoBondBreaks) {
  // Bonds are 1.01, 1.02 and 1.03 long in the equilibria of the three steps: all break in the last, none before.
  SolverScene scene(comm, chain, pull("0.33*t"), "{Damage Model: Test Length, Greatest Length: 1.025}");
  const auto solver = scene.make("Adaptive Dynamic Relaxation", "{Load Steps: 3, Relative Tolerance: 1e-8}");
  scene.start("Displacement", [](double, double) { return 0.0; });
  scene.run(*solver, 0.0, 1.0);
  EXPECT_EQ(scene.error("Damage", [](double) { return 1.0; }), 0.0);
  EXPECT_LT(scene.error("Force_Density", [](double) { return 0.0; }), 1e-12);
  EXPECT_NE(solver->summary().front().find(" 1 further rounds"), std::string::npos) << solver->summary().front();
}

}  // namespace
}  // namespace pd::test
