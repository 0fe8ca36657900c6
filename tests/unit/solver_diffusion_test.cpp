// Diffusion along a chain, whose modes decay at known rates.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "../solver_scene.hpp"

namespace pd::test {
namespace {

constexpr int nPoints = 12;
const char* const heldEnds = "  Ends: {Type: Prescribed Concentration, Node Set: Ends Node Set, Value: 0.0}\n";

double eigenvalue(int mode) { return 4.0 * std::pow(std::sin(mode * M_PI / (2.0 * (nPoints - 1))), 2); }
double shape(int mode, double x) { return std::sin(mode * M_PI * x / (nPoints - 1)); }

class DiffusionTest : public ::testing::Test {
 protected:
  Communicator comm{MPI_COMM_WORLD};
  Lattice chain{nPoints, 1, 1, 1.0};

  /// Largest error at time `end` against `expected` of a run that starts from the first mode.
  double decayError(const std::string& parameters, double end, double expected) {
    SolverScene scene(comm, chain, heldEnds);
    const auto solver = scene.make("Diffusion", parameters);
    scene.start("Concentration", [](double x, double) { return shape(1, x); });
    scene.run(*solver, 0.0, end);
    return scene.error("Concentration", [&](double x) { return expected * shape(1, x); });
  }
  std::string errorOf(const std::string& parameters, double end) {
    SolverScene scene(comm, chain, heldEnds);
    const auto solver = scene.make("Diffusion", parameters);
    scene.start("Concentration", [](double x, double) { return shape(nPoints - 2, x); });
    try {
      scene.run(*solver, 0.0, end);
    } catch (const RunError& error) {
      return error.what();
    }
    return "";
  }
};

TEST_F(DiffusionTest, EulerIsThePowerOfItsAmplification) {
  const double end = 20.0;
  EXPECT_LT(decayError("{Method: Euler, Sub Steps: 100}", end, std::pow(1.0 - eigenvalue(1) * end / 100, 100)), 1e-13);
  EXPECT_LT(
      decayError("{Method: Euler, Time Step: 0.21, Load Steps: 2}", end, std::pow(1.0 - eigenvalue(1) * end / 96, 96)),
      1e-13)
      << "each of two increments of 10 s is cut into 48 steps of less than 0.21 s";
}

TEST_F(DiffusionTest, OrdersAreOneAndTwo) {
  const double end = 20.0, exact = std::exp(-eigenvalue(1) * end);
  const auto order = [&](const std::string& method, int n) {
    const auto error = [&](int steps) {
      return decayError("{Method: " + method + ", Sub Steps: " + std::to_string(steps) + "}", end, exact);
    };
    return std::log2(error(n) / error(2 * n));
  };
  EXPECT_NEAR(order("Euler", 160), 1.0, 0.02);
  EXPECT_NEAR(order("RKC", 20), 2.0, 0.1);
  EXPECT_NEAR(order("RKL", 20), 2.0, 0.1);
}

/// The chain with c = sin t at its left end and 0 at its right one, by the classical Runge-Kutta method on plain arrays
/// with steps that make its error negligible; the value at x = 3.
double drivenChain(double end) {
  const int nSteps = 3000;
  const double h = end / nSteps;
  using Values = std::array<double, nPoints>;
  const auto rate = [](double t, Values c) {
    Values result{};
    c.front() = std::sin(t);
    for (std::size_t i = 1; i + 1 < nPoints; ++i) result[i] = c[i + 1] - 2.0 * c[i] + c[i - 1];
    return result;
  };
  const auto moved = [](Values c, const Values& k, double step) {
    for (std::size_t i = 0; i < nPoints; ++i) c[i] += step * k[i];
    return c;
  };
  Values c{};
  for (int n = 0; n < nSteps; ++n) {
    const double t = n * h;
    const Values k1 = rate(t, c), k2 = rate(t + 0.5 * h, moved(c, k1, 0.5 * h)),
                 k3 = rate(t + 0.5 * h, moved(c, k2, 0.5 * h)), k4 = rate(t + h, moved(c, k3, h));
    for (std::size_t i = 0; i < nPoints; ++i) c[i] += h / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]);
  }
  return c[3];
}

TEST_F(DiffusionTest, SecondOrderHoldsForPrescribedValuesThatChange) {
  const std::string moving =
      "  Left: {Type: Prescribed Concentration, Node Set: Left Node Set, Value: \"sin(t)\"}\n"
      "  Right: {Type: Prescribed Concentration, Node Set: Right Node Set, Value: 0.0}\n";
  const auto middle = [&](const std::string& method, int n) {
    SolverScene scene(comm, chain, moving);
    const auto solver = scene.make("Diffusion", "{Method: " + method + ", Sub Steps: " + std::to_string(n) + "}");
    scene.start("Concentration", [](double, double) { return 0.0; });
    scene.run(*solver, 0.0, 3.0);
    double value = 0.0;
    for (int i = 0; i < scene.model().nOwned(); ++i)
      if (scene.x(i) == 3.0) value = scene.model().field("Concentration")[i];
    return comm.sum(value);
  };
  const double reference = drivenChain(3.0);
  for (const std::string method : {"RKC", "RKL"}) {
    const double coarse = std::abs(middle(method, 8) - reference), fine = std::abs(middle(method, 16) - reference);
    EXPECT_NEAR(std::log2(coarse / fine), 2.0, 0.35) << method;
    EXPECT_LT(fine, 2e-3) << method;
  }
}

TEST_F(DiffusionTest, EulerRefusesStepsAboveTheTrueLimit) {
  const double limit = 2.0 / eigenvalue(nPoints - 2);
  EXPECT_EQ(errorOf("{Method: Euler, Sub Steps: 1}", 0.998 * limit), "");
  const std::string message = errorOf("{Method: Euler, Sub Steps: 1}", 1.001 * limit);
  EXPECT_NE(message.find("stability limit"), std::string::npos) << message;
  EXPECT_NE(message.find("at least 2 sub-steps"), std::string::npos) << message;
  EXPECT_EQ(errorOf("{Method: Euler, Sub Steps: 1, Allow Unstable Step: true}", 1.001 * limit), "");
}

TEST_F(DiffusionTest, EulerIsBoundedJustBelowTheLimitAndGrowsJustAbove) {
  const double limit = 2.0 / eigenvalue(nPoints - 2);
  const auto largest = [&](double factor) {
    SolverScene scene(comm, chain, heldEnds);
    const auto solver = scene.make("Diffusion", "{Method: Euler, Sub Steps: 2000, Allow Unstable Step: true}");
    scene.start("Concentration", [](double x, double) { return shape(nPoints - 2, x); });
    scene.run(*solver, 0.0, 2000 * factor * limit);
    return scene.error("Concentration", [](double) { return 0.0; });
  };
  EXPECT_LT(largest(0.995), 1.0);
  EXPECT_GT(largest(1.005), 1000.0);  // (1.01)^2000
}

TEST_F(DiffusionTest, WithoutAStepEulerStaysBelowTheLimit) {
  const double end = 100.0;
  const int n = static_cast<int>(std::ceil(end / (0.5 * 2.0 / eigenvalue(nPoints - 2))));
  // One step of freedom: the limit is known to 1e-3.
  const double error = std::min(
      decayError("{Method: Euler, Safety Factor: 0.5}", end, std::pow(1.0 - eigenvalue(1) * end / n, n)),
      decayError("{Method: Euler, Safety Factor: 0.5}", end, std::pow(1.0 - eigenvalue(1) * end / (n + 1), n + 1)));
  EXPECT_LT(error, 1e-12);
}

TEST_F(DiffusionTest, ErrorFollowsTheTolerance) {
  const double end = 30.0, exact = std::exp(-eigenvalue(1) * end);
  for (const std::string method : {"RKC", "RKL"}) {
    double before = 1.0;
    for (const std::string tolerance : {"1e-3", "1e-5", "1e-7"}) {
      const double error = decayError("{Method: " + method + ", Relative Tolerance: " + tolerance + "}", end, exact);
      EXPECT_LT(error, 50.0 * std::stod(tolerance)) << method;  // local errors of some tens of steps add up
      EXPECT_LT(error, 0.3 * before) << method;
      before = error;
    }
  }
}

TEST_F(DiffusionTest, RoughFieldsDecayWithoutGrowth) {
  for (const std::string method : {"RKC", "RKL"}) {
    SolverScene scene(comm, chain, heldEnds);
    const auto solver = scene.make("Diffusion", "{Method: " + method + ", Sub Steps: 1}");
    scene.start("Concentration", [](double x, double) { return shape(nPoints - 2, x); });
    scene.run(*solver, 0.0, 1000.0);  // 2000 times Euler's limit in one step
    EXPECT_LT(scene.error("Concentration", [](double) { return 0.0; }), 1.0) << method;
  }
}

TEST_F(DiffusionTest, AnInsulatedBodyKeepsItsContent) {
  for (const std::string parameters : {"{Method: Euler}", "{Method: RKL}", "{Method: RKC}"}) {
    SolverScene scene(comm, Lattice{6, 5, 1, 1.5}, "");
    const auto solver = scene.make("Diffusion", parameters);
    scene.start("Concentration", [](double x, double y) { return x < 2.0 && y < 2.0 ? 1.0 : 0.0; });
    scene.run(*solver, 0.0, 2.0);
    const auto values = scene.values("Concentration");
    double sum = 0.0;
    for (const double value : values) sum += value;
    EXPECT_NEAR(comm.sum(sum), 4.0, 1e-12) << parameters;
  }
}

TEST_F(DiffusionTest, GoesOnBitIdenticallyFromItsRestartState) {
  const std::string parameters = "{Method: RKL, Relative Tolerance: 1e-5, Load Steps: 10}";
  SolverScene whole(comm, chain, heldEnds), halves(comm, chain, heldEnds);
  const auto one = whole.make("Diffusion", parameters), first = halves.make("Diffusion", parameters),
             second = halves.make("Diffusion", parameters);
  const auto initial = [](double x, double) { return shape(1, x) + shape(5, x); };
  whole.start("Concentration", initial);
  halves.start("Concentration", initial);
  whole.run(*one, 0.0, 10.0);
  first->initialize(halves.simulation());
  halves.advance(*first, 0.0, 4.0, 4);
  second->initialize(halves.simulation());
  second->setRestartState(first->restartState());
  halves.advance(*second, 4.0, 10.0, 6);
  EXPECT_EQ(whole.values("Concentration"), halves.values("Concentration"));
}

TEST_F(DiffusionTest, RefusesKeysOfOtherMethods) {
  SolverScene scene(comm, chain, heldEnds);
  try {
    scene.make("Diffusion", "{Method: Euler, Relative Tolerance: 1e-4}");
    FAIL() << "accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("\"Relative Tolerance\" has no meaning with Method: Euler"),
              std::string::npos)
        << error.what();
  }
  EXPECT_NO_THROW(scene.make("Diffusion", "{Method: Euler, Sub Steps: 3}"));
}

TEST_F(DiffusionTest, NamesAFieldThatNoMaterialDiffuses) {
  SolverScene scene(comm, chain, "");
  const auto solver = scene.make("Diffusion", "{Field: Temperature}");
  scene.start("Concentration", [](double, double) { return 0.0; });
  EXPECT_THROW(scene.run(*solver, 0.0, 1.0), RunError);
}

}  // namespace
}  // namespace pd::test
