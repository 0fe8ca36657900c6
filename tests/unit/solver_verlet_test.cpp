// Explicit dynamics of a chain, whose discrete solution is known exactly.
#include <gtest/gtest.h>

#include <cmath>

#include "../solver_scene.hpp"

namespace pd::test {
namespace {

constexpr int nPoints = 12;
const char* const heldEnds =
    "  Ends: {Type: Prescribed Displacement, Node Set: Ends Node Set, Coordinate: x, Value: 0.0}\n";

double frequency(int mode) { return 2.0 * std::sin(mode * M_PI / (2.0 * (nPoints - 1))); }
double shape(int mode, double x) { return std::sin(mode * M_PI * x / (nPoints - 1)); }

class VerletTest : public ::testing::Test {
 protected:
  Communicator comm{MPI_COMM_WORLD};
  Lattice chain{nPoints, 1, 1, 1.0};
  double critical = 2.0 / frequency(nPoints - 2);

  static std::string fixed(double step, const std::string& more = "") {
    char text[64];
    std::snprintf(text, sizeof text, "{Fixed dt: %.17g", step);
    return text + more + "}";
  }
};

TEST_F(VerletTest, CriticalStepIsTwoOverTheHighestFrequency) {
  SolverScene scene(comm, chain, heldEnds);
  const auto solver = scene.make("Verlet", "{Safety Factor: 1.0}");
  scene.start("Displacement", [](double, double) { return 0.0; });
  solver->initialize(scene.simulation());
  const double end = 1.0e6, estimate = end / solver->numberOfIncrements(scene.simulation(), 0.0, end);
  EXPECT_LE(estimate, critical * (1.0 + 1e-5));
  EXPECT_GE(estimate, critical * (1.0 - 1e-3));
  EXPECT_EQ(scene.error("Displacement", [](double) { return 0.0; }), 0.0) << "the probe leaves no trace";
}

TEST_F(VerletTest, IsStableJustBelowTheLimitAndBlowsUpJustAbove) {
  const auto largest = [&](double factor) {
    SolverScene scene(comm, chain, heldEnds);
    const auto solver = scene.make("Verlet", fixed(factor * critical, ", Allow Unstable Step: true"));
    scene.start("Displacement", [](double x, double) { return 1e-3 * shape(nPoints - 2, x) + 1e-3 * shape(2, x); });
    scene.run(*solver, 0.0, 1000 * factor * critical);
    return scene.error("Displacement", [](double) { return 0.0; });
  };
  EXPECT_LT(largest(0.999), 2.1e-3);
  EXPECT_GT(largest(1.001), 1.0);  // grows by 1 + sqrt(8e-3) a step
}

TEST_F(VerletTest, CriticalStepOfAPlateIsThatOfTheLattice) {
  // Bond-based plane stress on a square lattice with horizon 3: 2 / omega_max = 1.864 spacings over sqrt(E / rho), from
  // the lattice's dispersion relation. Free edges lower the frequencies of a finite plate a little.
  const Lattice lattice{20, 20, 1, 3.0};
  const std::string material =
      "{Material Model: PDHE, Density: 1.0, Young's Modulus: 1.0, Poisson's Ratio: 0.3333333333333333, "
      "Plane Stress: true, Volume Correction: None}";
  const auto largest = [&](double step) {
    SolverScene scene(comm, lattice, "", "", material);
    const auto solver = scene.make("Verlet", fixed(step, ", Allow Unstable Step: true"));
    scene.start("Displacement", [](double x, double y) { return 1e-6 * std::sin(17.0 * x + 29.0 * y * y); });
    scene.run(*solver, 0.0, 300 * step);
    return scene.error("Displacement", [](double) { return 0.0; });
  };
  SolverScene scene(comm, lattice, "", "", material);
  const auto solver = scene.make("Verlet", "{Safety Factor: 1.0}");
  scene.start("Displacement", [](double, double) { return 0.0; });
  solver->initialize(scene.simulation());
  const double end = 1.0e6, estimate = end / solver->numberOfIncrements(scene.simulation(), 0.0, end);
  EXPECT_GT(estimate, 1.864);
  EXPECT_LT(estimate, 1.864 * 1.01);
  EXPECT_LT(largest(0.99 * estimate), 1e-4);
  EXPECT_GT(largest(1.01 * estimate), 1e3);  // the fastest mode alone grows by a factor 1.33 a step
}

TEST_F(VerletTest, RefusesAStepAboveTheLimitUnlessAllowed) {
  const auto start = [&](const std::string& parameters) {
    SolverScene scene(comm, chain, heldEnds);
    const auto solver = scene.make("Verlet", parameters);
    scene.start("Displacement", [](double, double) { return 0.0; });
    solver->initialize(scene.simulation());
  };
  EXPECT_NO_THROW(start(fixed(0.999 * critical)));
  EXPECT_THROW(start(fixed(1.001 * critical)), RunError);
  EXPECT_NO_THROW(start(fixed(1.001 * critical, ", Allow Unstable Step: true")));
  EXPECT_THROW(start("{Safety Factor: 1.1}"), RunError);
}

TEST_F(VerletTest, AModeSwingsAtTheDiscreteFrequency) {
  // Central differences: sin(omega' dt / 2) = omega dt / 2, amplitude constant.
  const int mode = 3, n = 500;
  const double step = 0.7, discrete = 2.0 / step * std::asin(0.5 * step * frequency(mode));
  SolverScene scene(comm, chain, heldEnds);
  const auto solver = scene.make("Verlet", fixed(step));
  scene.start("Displacement", [&](double x, double) { return 1e-3 * shape(mode, x); });
  EXPECT_EQ(scene.run(*solver, 0.0, n * step), n);
  EXPECT_LT(
      scene.error("Displacement", [&](double x) { return 1e-3 * std::cos(discrete * n * step) * shape(mode, x); }),
      1e-12);
}

TEST_F(VerletTest, DampingFollowsItsThreeTermRecursion) {
  // (1 + g) u_{n+1} = (2 - w^2 dt^2) u_n - (1 - g) u_{n-1}, g = c dt / 2.
  const int mode = 2, n = 100;
  const double step = 0.5, damping = 0.3, g = 0.5 * damping * step, w2 = std::pow(frequency(mode) * step, 2);
  double before = 1e-3, now = before * (1.0 - 0.5 * w2);
  for (int k = 1; k < n; ++k) {
    const double next = ((2.0 - w2) * now - (1.0 - g) * before) / (1.0 + g);
    before = now;
    now = next;
  }
  SolverScene scene(comm, chain, heldEnds);
  const auto solver = scene.make("Verlet", fixed(step, ", Damping: 0.3"));
  scene.start("Displacement", [&](double x, double) { return 1e-3 * shape(mode, x); });
  scene.run(*solver, 0.0, n * step);
  EXPECT_LT(scene.error("Displacement", [&](double x) { return now * shape(mode, x); }), 1e-14);
}

TEST_F(VerletTest, AFreeBodyFallsAsItShould) {
  SolverScene scene(comm, Lattice{4, 3, 1, 1.5},
                    "  Weight: {Type: Body Force, Node Set: All Node Set, Coordinate: x, Value: 0.02}\n");
  const auto solver = scene.make("Verlet", fixed(0.1));
  scene.start("Displacement", [](double, double) { return 0.0; });
  scene.run(*solver, 0.0, 10.0);
  EXPECT_LT(scene.error("Displacement", [](double) { return 0.5 * 0.02 * 100.0; }), 1e-12);
  EXPECT_LT(scene.error("Velocity", [](double) { return 0.02 * 10.0; }), 1e-12);
}

TEST_F(VerletTest, PeridigmsCriticalStepComesFromTheBulkModulus) {
  // Inner points of the chain: sum of c V / |xi| = 2 c with c = 18 K / (pi delta^4) = 18 / pi.
  SolverScene scene(comm, chain, heldEnds);
  const auto solver = scene.make("Verlet", "{Critical Step: Bulk Modulus}");
  scene.start("Displacement", [](double, double) { return 0.0; });
  solver->initialize(scene.simulation());
  const double end = 1.0e6, estimate = end / solver->numberOfIncrements(scene.simulation(), 0.0, end);
  const double expected = std::sqrt(2.0 / (2.0 * 18.0 / M_PI));
  EXPECT_NEAR(estimate, expected, 1e-5);
  EXPECT_DOUBLE_EQ(solver->incrementEnd(10, solver->numberOfIncrements(scene.simulation(), 0.0, 4.5), 0.0, 4.5),
                   10.0 * expected)
      << "the step is kept";
  EXPECT_EQ(solver->numberOfIncrements(scene.simulation(), 0.0, 10.5 * expected), 10);
  EXPECT_EQ(solver->numberOfIncrements(scene.simulation(), 0.0, 0.5 * expected), 0) << "as there, no step is made";
}

TEST_F(VerletTest, GoesOnBitIdenticallyFromItsRestartState) {
  SolverScene whole(comm, chain, heldEnds), halves(comm, chain, heldEnds);
  const auto one = whole.make("Verlet", fixed(0.5)), first = halves.make("Verlet", fixed(0.5)),
             second = halves.make("Verlet", fixed(0.5));
  const auto initial = [](double x, double) { return 1e-3 * shape(1, x) + 1e-3 * shape(5, x); };
  whole.start("Displacement", initial);
  halves.start("Displacement", initial);
  EXPECT_EQ(whole.run(*one, 0.0, 10.0), 20);
  first->initialize(halves.simulation());
  halves.advance(*first, 0.0, 4.0, 8);
  second->initialize(halves.simulation());
  second->setRestartState(first->restartState());
  halves.advance(*second, 4.0, 10.0, 12);
  EXPECT_EQ(whole.values("Displacement"), halves.values("Displacement"));
  EXPECT_EQ(whole.values("Velocity"), halves.values("Velocity"));
}

}  // namespace
}  // namespace pd::test
