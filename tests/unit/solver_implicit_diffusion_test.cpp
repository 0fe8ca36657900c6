// Implicit diffusion along a chain, whose modes decay at known rates.
#include <gtest/gtest.h>

#include <cmath>

#include "../solver_scene.hpp"

namespace pd::test {
namespace {

constexpr int nPoints = 12;
const char* const heldEnds = "  Ends: {Type: Prescribed Concentration, Node Set: Ends Node Set, Value: 0.0}\n";

double eigenvalue(int mode) { return 4.0 * std::pow(std::sin(mode * M_PI / (2.0 * (nPoints - 1))), 2); }
double shape(int mode, double x) { return std::sin(mode * M_PI * x / (nPoints - 1)); }

/// Growth of a mode in one step, z = -eigenvalue * step (from the two stages by hand; Bank et al. (1985)).
double trBdf2Growth(double z) {
  const double gamma = 2.0 - std::sqrt(2.0), d = 0.5 * gamma;
  const double middle = (1.0 + d * z) / (1.0 - d * z);
  return (middle - (1.0 - gamma) * (1.0 - gamma)) / (gamma * (2.0 - gamma)) / (1.0 - d * z);
}

/// Test Springs whose diffusion has its tangent by formula: two runs get the same matrix to the last bit.
class SpringsWithTangent : public SpringMaterial {
 public:
  using SpringMaterial::SpringMaterial;
  void computeJacobian(const double, const int n, const int* owned, const int* list, DataManager& data,
                       SerialMatrix& jacobian, JacobianType) const override {
    for (int k = 0; k < n; ++k)
      for (int count = *list++; count > 0; --count) {
        const int i = data.getOverlapScalarPointMap()->GID(owned[k]), j = data.getOverlapScalarPointMap()->GID(*list++);
        jacobian.addValue(i, i, -1.0);
        jacobian.addValue(i, j, 1.0);
      }
  }
};
PD_REGISTER_MATERIAL(SpringsWithTangent, "Test Springs With Tangent", "Unit springs.")

class ImplicitDiffusion : public ::testing::Test {
 protected:
  Communicator comm{MPI_COMM_WORLD};
  Lattice chain{nPoints, 1, 1, 1.0};

  /// Largest error at time `end` against `expected` times the mode with which the run starts.
  double decayError(const std::string& parameters, int mode, double end, double expected) {
    SolverScene scene(comm, chain, heldEnds);
    const auto solver = scene.make("Diffusion", parameters);
    scene.start("Concentration", [&](double x, double) { return shape(mode, x); });
    scene.run(*solver, 0.0, end);
    return scene.error("Concentration", [&](double x) { return expected * shape(mode, x); });
  }
};

TEST_F(ImplicitDiffusion, StepsAreTheGrowthFactorsOfTheirMethods) {
  const double end = 40.0, z = -eigenvalue(1) * end / 10;
  for (const std::string solver : {"CG, Preconditioner: ILU", "CG, Preconditioner: Jacobi", "CG, Preconditioner: None",
                                   "CG, Preconditioner: Multigrid", "GMRES, Preconditioner: ILU", "Direct"}) {
    const std::string more = ", Sub Steps: 10, Linear Solver: " + solver + "}";
    EXPECT_LT(decayError("{Method: Implicit Euler" + more, 1, end, std::pow(1.0 - z, -10)), 1e-10) << solver;
    EXPECT_LT(decayError("{Method: TR-BDF2" + more, 1, end, std::pow(trBdf2Growth(z), 10)), 1e-10) << solver;
  }
}

TEST_F(ImplicitDiffusion, OrdersAreOneAndTwo) {
  const double end = 20.0, exact = std::exp(-eigenvalue(1) * end);
  const auto order = [&](const std::string& method, int n) {
    const auto error = [&](int steps) {
      return decayError("{Method: " + method + ", Sub Steps: " + std::to_string(steps) + "}", 1, end, exact);
    };
    return std::log2(error(n) / error(2 * n));
  };
  EXPECT_NEAR(order("Implicit Euler", 80), 1.0, 0.02);
  EXPECT_NEAR(order("TR-BDF2", 20), 2.0, 0.05);
}

TEST_F(ImplicitDiffusion, StiffModesDieInOneStep) {
  const double step = 1e6 / eigenvalue(nPoints - 2);
  EXPECT_LT(decayError("{Method: Implicit Euler}", nPoints - 2, step, 0.0), 2e-6);
  EXPECT_LT(decayError("{Method: TR-BDF2, Sub Steps: 1}", nPoints - 2, step, 0.0), 1e-5);
}

TEST_F(ImplicitDiffusion, SecondOrderHoldsForPrescribedValuesThatChange) {
  const std::string moving =
      "  Left: {Type: Prescribed Concentration, Node Set: Left Node Set, Value: \"sin(t)\"}\n"
      "  Right: {Type: Prescribed Concentration, Node Set: Right Node Set, Value: 0.0}\n";
  const auto middle = [&](int n) {
    SolverScene scene(comm, chain, moving);
    const auto solver = scene.make("Diffusion", "{Method: TR-BDF2, Sub Steps: " + std::to_string(n) + "}");
    scene.start("Concentration", [](double, double) { return 0.0; });
    scene.run(*solver, 0.0, 3.0);
    double value = 0.0;
    for (int i = 0; i < scene.model().nOwned(); ++i)
      if (scene.x(i) == 3.0) value = scene.model().field("Concentration")[i];
    return comm.sum(value);
  };
  const double coarse = middle(20), fine = middle(40), finest = middle(80);
  EXPECT_NEAR(std::log2((coarse - fine) / (fine - finest)), 2.0, 0.2);
}

TEST_F(ImplicitDiffusion, ErrorFollowsTheTolerance) {
  const double end = 30.0, exact = std::exp(-eigenvalue(1) * end);
  double before = 1.0;
  for (const std::string tolerance : {"1e-3", "1e-5", "1e-7"}) {
    const double error = decayError("{Method: TR-BDF2, Relative Tolerance: " + tolerance + "}", 1, end, exact);
    EXPECT_LT(error, 30.0 * std::stod(tolerance)) << tolerance;
    EXPECT_LT(error, 0.2 * before) << tolerance;
    before = error;
  }
}

TEST_F(ImplicitDiffusion, ConservesWhatNoEndTakesAway) {
  SolverScene scene(comm, Lattice{9, 7, 1, 1.5}, "");
  const auto solver = scene.make("Diffusion", "{Method: TR-BDF2, Sub Steps: 7}");
  scene.start("Concentration", [](double x, double y) { return x * x + y; });
  const auto mass = [&] {
    double sum = 0.0;
    for (const double value : scene.values("Concentration")) sum += value;
    return comm.sum(sum);
  };
  const double before = mass();
  scene.run(*solver, 0.0, 50.0);
  EXPECT_NEAR(mass(), before, 1e-9 * before);
  EXPECT_LT(scene.error("Concentration", [&](double) { return before / 63.0; }), 0.05 * before / 63.0)
      << "it has spread evenly";
}

TEST_F(ImplicitDiffusion, BondsThatBreakLaterCutIt) {
  SolverScene scene(comm, chain, heldEnds, "{Damage Model: Test Length, Greatest Length: 1000.0}");
  const auto solver = scene.make("Diffusion", "{Method: Implicit Euler, Sub Steps: 2}");
  scene.start("Concentration", [](double x, double) { return x > 5.5 ? 1.0 : 0.0; });
  scene.run(*solver, 0.0, 1e-9);  // the matrix is made
  PeridigmNS::Block& block = scene.model().blocks()->front();
  const auto isBroken = block.getData(FieldManager::self().getFieldId("Bond_Damage"), STEP_NP1);
  const int* list = block.getNeighborhoodData()->NeighborhoodList();
  int bond = 0;
  for (int i = 0; i < block.numPoints(); ++i)
    for (int count = *list++; count > 0; --count, ++bond)
      if ((scene.x(i) > 5.5) != (scene.x(*list++) > 5.5)) (*isBroken)[bond] = 1.0;
  for (double end = 1.0; end < 2.5; end += 1.0) {
    scene.run(*solver, end - 1.0, end);
    for (int i = 0; i < scene.model().nOwned(); ++i)
      if (scene.x(i) < 5.5) {
        EXPECT_NEAR(scene.model().field("Concentration")[i], 0.0, 1e-8);
      }
  }
}

TEST_F(ImplicitDiffusion, GoesOnBitForBitAfterARestart) {
  const std::string parameters = "{Method: TR-BDF2, Relative Tolerance: 1e-5, Load Steps: 6}";
  const auto initial = [](double x, double) { return shape(1, x) + shape(4, x); };
  const double third = 1.0 / 3.0;  // increments whose lengths differ by rounding
  const std::string material = "{Material Model: Test Springs With Tangent, Stiffness: 1.0}";
  SolverScene whole(comm, chain, heldEnds, "", material), restarted(comm, chain, heldEnds, "", material);
  const auto first = whole.make("Diffusion", parameters), second = restarted.make("Diffusion", parameters);
  whole.start("Concentration", initial);
  restarted.start("Concentration", initial);
  first->initialize(whole.simulation());
  second->initialize(restarted.simulation());
  for (int k = 0; k < 3; ++k) first->advance(whole.simulation(), k * third, (k + 1) * third - k * third);
  std::copy_n(whole.model().field("Concentration"), whole.model().nPoints(), restarted.model().field("Concentration"));
  second->setRestartState(first->restartState());
  for (int k = 3; k < 6; ++k) {
    first->advance(whole.simulation(), k * third, (k + 1) * third - k * third);
    second->advance(restarted.simulation(), k * third, (k + 1) * third - k * third);
  }
  EXPECT_EQ(whole.values("Concentration"), restarted.values("Concentration"));
}

TEST_F(ImplicitDiffusion, SaysThatItDoesNotConverge) {
  SolverScene scene(comm, Lattice{30, 20, 1, 1.5}, heldEnds);
  const auto solver =
      scene.make("Diffusion", "{Method: Implicit Euler, Preconditioner: None, Maximum Linear Iterations: 1}");
  scene.start("Concentration", [](double x, double y) { return std::sin(x * y); });
  try {
    scene.run(*solver, 0.0, 1e6);
    FAIL() << "no error";
  } catch (const RunError& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find("does not converge"), std::string::npos) << message;
    EXPECT_NE(message.find("shorter steps"), std::string::npos) << message;
  }
}

}  // namespace
}  // namespace pd::test
