// The numerical parts of solvers that need no model: Runge-Kutta coefficients and limits, Lanczos and Arnoldi
// iteration.
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "driver/solvers/diffusion/stabilized_scheme.hpp"
#include "driver/solvers/flow/flow_time_step.hpp"
#include "driver/solvers/lanczos.hpp"
#include "driver/solvers/solver.hpp"

namespace pd {
namespace {

struct FamilyCase {
  StabilizedFamily family;
  int nStages;
};

class StabilizedSchemeTest : public ::testing::TestWithParam<FamilyCase> {
 protected:
  /// What one step of h = 1 makes of y' = z y + g(t), y(0) = y0.
  static double step(const StabilizedScheme& scheme, double z, double y0, double (*g)(double)) {
    const auto f = [&](double t, double y) { return z * y + g(t); };
    double older = y0, y = y0, time = 0.0;
    const double f0 = f(0.0, y0);
    for (const StabilizedStage& stage : scheme.stages) {
      const double next = stage.mu * y + stage.nu * older + (1.0 - stage.mu - stage.nu) * y0 +
                          stage.muTilde * f(time, y) + stage.gammaTilde * f0;
      older = y;
      y = next;
      time = stage.c;
    }
    return y;
  }
  static double zero(double) { return 0.0; }
};

TEST_P(StabilizedSchemeTest, StabilityPolynomialStaysWithinOneUpToTheLimitAndLeavesItBeyond) {
  const StabilizedScheme scheme = stabilizedScheme(GetParam().family, GetParam().nStages);
  for (int k = 0; k <= 2000; ++k) {
    const double z = -scheme.stability * k / 2000.0;
    ASSERT_LE(std::abs(step(scheme, z, 1.0, zero)), 1.0 + 1e-11) << "z = " << z;
  }
  // Odd polynomials end at 1 - 2 b > -1, a little inside: they leave the interval some way beyond.
  EXPECT_GT(std::abs(step(scheme, -1.5 * scheme.stability, 1.0, zero)), 1.05);
}

TEST_P(StabilizedSchemeTest, AgreesWithTheExponentialToSecondOrder) {
  const StabilizedScheme scheme = stabilizedScheme(GetParam().family, GetParam().nStages);
  // (P(z) - 1 - z - z^2/2) / z^3 tends to a constant below 1/6 (the error of leaving the cubic term out).
  for (const double z : {-1e-2, -1e-3}) {
    const double rest = (step(scheme, z, 1.0, zero) - 1.0 - z - 0.5 * z * z) / (z * z * z);
    EXPECT_GT(rest, -1e-3);
    EXPECT_LT(rest, 1.0 / 6.0);
  }
}

TEST_P(StabilizedSchemeTest, IntegratesTimeDependentRatesToSecondOrder) {
  const StabilizedScheme scheme = stabilizedScheme(GetParam().family, GetParam().nStages);
  EXPECT_NEAR(scheme.stages.back().c, 1.0, 1e-12);
  EXPECT_NEAR(step(scheme, 0.0, 0.0, [](double) { return 1.0; }), 1.0, 1e-12);
  EXPECT_NEAR(step(scheme, 0.0, 0.0, [](double t) { return 2.0 * t; }), 1.0, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(
    Families, StabilizedSchemeTest,
    ::testing::Values(FamilyCase{StabilizedFamily::Chebyshev, 2}, FamilyCase{StabilizedFamily::Chebyshev, 3},
                      FamilyCase{StabilizedFamily::Chebyshev, 10}, FamilyCase{StabilizedFamily::Chebyshev, 199},
                      FamilyCase{StabilizedFamily::Legendre, 3}, FamilyCase{StabilizedFamily::Legendre, 5},
                      FamilyCase{StabilizedFamily::Legendre, 11}, FamilyCase{StabilizedFamily::Legendre, 199}));

TEST(StabilizedScheme, LimitsAreThoseOfThePapers) {
  // Meyer et al. (2014): (s^2 + s - 2) / 2. Sommeijer et al. (1998): about 2/3 (s^2 - 1)(1 - 2/15 eps), eps = 2/13.
  EXPECT_DOUBLE_EQ(stabilizedScheme(StabilizedFamily::Legendre, 9).stability, 44.0);
  EXPECT_NEAR(stabilizedScheme(StabilizedFamily::Chebyshev, 20).stability, 2.0 / 3.0 * 399.0 * (1.0 - 4.0 / 195.0),
              0.01 * 266.0);
}

TEST(StabilizedScheme, TakesTheLeastStagesThatAreStable) {
  for (const auto family : {StabilizedFamily::Chebyshev, StabilizedFamily::Legendre}) {
    const int step = family == StabilizedFamily::Legendre ? 2 : 1, least = family == StabilizedFamily::Legendre ? 3 : 2;
    for (const double stiffness : {0.0, 0.5, 1.9, 4.9, 5.1, 44.0, 44.1, 300.0, 2.0e4}) {
      const int nStages = requiredStages(family, stiffness);
      EXPECT_GE(stabilizedScheme(family, nStages).stability, stiffness);
      if (nStages > least) {
        EXPECT_LT(stabilizedScheme(family, nStages - step).stability, stiffness);
      }
    }
  }
}

TEST(Lanczos, BracketsTheLargestEigenvalueOfAChain) {
  // Second difference over n points with fixed ends: 4 sin^2(n pi / (2 (n + 1))).
  constexpr int n = 200;
  SelfAdjointOperator op;
  op.dot = [](const double* a, const double* b) { return std::inner_product(a, a + n, b, 0.0); };
  op.apply = [](const double* x, double* y) {
    for (int i = 0; i < n; ++i) y[i] = 2.0 * x[i] - (i > 0 ? x[i - 1] : 0.0) - (i + 1 < n ? x[i + 1] : 0.0);
  };
  std::vector<int> ids(n);
  std::iota(ids.begin(), ids.end(), 0);
  const double exact = 4.0 * std::pow(std::sin(n * M_PI / (2.0 * (n + 1))), 2);
  const auto result = largestEigenvalue(op, randomPointValues(ids, n, 1), 1e-3, 200);
  EXPECT_LT(result.iterations, 100);
  EXPECT_LE(result.value, exact * (1.0 + 1e-12));
  EXPECT_GE(result.upperBound, exact * (1.0 - 1e-6));
  EXPECT_LE(result.upperBound - result.value, 1e-3 * exact);
}

TEST(Lanczos, EndsInAnInvariantSubspaceAndWithNoStart) {
  SelfAdjointOperator op;
  op.dot = [](const double* a, const double* b) { return a[0] * b[0] + a[1] * b[1]; };
  op.apply = [](const double* x, double* y) {
    y[0] = 3.0 * x[0];
    y[1] = 7.0 * x[1];
  };
  EXPECT_NEAR(largestEigenvalue(op, {1.0, 1.0}, 1e-12, 50).value, 7.0, 1e-12);
  EXPECT_EQ(largestEigenvalue(op, {0.0, 0.0}, 1e-12, 50).upperBound, 0.0);
}

TEST(Lanczos, StartDependsOnGlobalIdsAlone) {
  const auto one = randomPointValues({5, 9, 2}, 3, 2), other = randomPointValues({2, 5}, 2, 2);
  EXPECT_EQ(one[0], other[2]);
  EXPECT_EQ(one[1], other[3]);
  EXPECT_EQ(one[4], other[0]);
  EXPECT_NE(one[0], one[1]);
  for (const double value : one) EXPECT_LE(std::abs(value), 1.0);
}

TEST(Solvers, SayOfEachFieldItsUnitAndMeaning) {
  ASSERT_GE(SolverRegistry::self().names().size(), 7u);
  for (const std::string& name : SolverRegistry::self().names()) {
    const FieldTable table = SolverRegistry::self().find(name)->fields();
    EXPECT_FALSE(table.uses().empty()) << name;
    for (const FieldUse& use : table.uses()) {
      EXPECT_FALSE(use.field.unit.empty()) << name << " " << use.field.label;
      EXPECT_FALSE(use.field.meaning.empty()) << name << " " << use.field.label;
    }
  }
}

TEST(RungeKuttaLimitTest, IsThatOfTheClassicMethod) {
  // On the negative axis the real root of 24 + 12 z + 4 z^2 + z^3, on the imaginary one sqrt(8).
  EXPECT_NEAR(rungeKuttaLimit({-1.0, 0.0}), 2.78529356, 1e-6);
  EXPECT_NEAR(rungeKuttaLimit({0.0, 2.0}), std::sqrt(2.0), 1e-6);
  EXPECT_NEAR(rungeKuttaLimit({0.0, -2.0}), std::sqrt(2.0), 1e-6);
  EXPECT_EQ(rungeKuttaLimit(0.0), HUGE_VAL);
  const std::complex<double> lambda(-3.0, 4.0);
  for (const double share : {0.999, 1.001}) {
    const std::complex<double> z = share * rungeKuttaLimit(lambda) * lambda;
    EXPECT_EQ(std::abs(1.0 + z + z * z / 2.0 + z * z * z / 6.0 + z * z * z * z / 24.0) > 1.0, share > 1.0);
  }
}

}  // namespace
}  // namespace pd
