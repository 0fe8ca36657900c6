// Operators and rates of a flow, chunk by chunk, against plain loops.
#include "flow_kernel.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace pd::kernels;

namespace {

/// Points of a plane, row after row, each with its neighbours within two rows and columns, or with four of them chosen
/// at random.
struct Body {
  int nx = 21, ny = 9, width;
  std::vector<int> points, list;
  std::vector<double> weights;

  Body(int itsWidth, bool isLattice, bool isUniform) : width(itsWidth) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> weight(-1.0, 1.0);
    std::uniform_int_distribution<int> anyPoint(0, nx * ny - 1);
    std::vector<double> ofOffset(25 * static_cast<std::size_t>(width));
    for (double& value : ofOffset) value = weight(random);
    for (int i = 0; i < nx * ny; ++i) {
      points.push_back(i);
      const std::size_t count = list.size();
      list.push_back(0);
      for (int k = 0; k < 25; ++k) {
        const int x = i % nx + k % 5 - 2, y = i / nx + k / 5 - 2;
        if (k == 12 || x < 0 || x >= nx || y < 0 || y >= ny) continue;
        if (!isLattice && k % 6 != 0) continue;
        list.push_back(isLattice ? y * nx + x : anyPoint(random));
        ++list[count];
        for (int c = 0; c < width; ++c)
          weights.push_back(isUniform ? ofOffset[static_cast<std::size_t>(width * k + c)] : weight(random));
      }
      std::sort(list.begin() + static_cast<std::ptrdiff_t>(count) + 1, list.end());
    }
  }

  /// visit(i, j, weights of the bond)
  template <class Visit>
  void forEachBond(const Visit& visit) const {
    const double* w = weights.data();
    std::size_t at = 0;
    for (const int i : points)
      for (int left = list[at++]; left > 0; --left, w += width) visit(i, list[at++], w);
  }
};

FlowState randomState(int nPoints) {
  FlowState state;
  state.velocity.zero(nPoints, 2);
  state.pressure.zero(nPoints, 1);
  std::mt19937 random(9);
  std::uniform_real_distribution<double> value(-1.0, 1.0);
  for (int i = 0; i < nPoints; ++i) {
    state.velocity[0][i] = value(random);
    state.velocity[1][i] = value(random);
    state.pressure[0][i] = value(random);
  }
  return state;
}

FlowOperators zeroOperators(int nPoints) {
  FlowOperators result;
  for (PointArrays* arrays :
       {&result.convection, &result.viscous, &result.pressureGradient, &result.divergence, &result.smoothing})
    arrays->zero(nPoints, 2);
  return result;
}

class FlowKernel : public testing::TestWithParam<std::tuple<bool, bool>> {};

TEST_P(FlowKernel, ViscosityIsTheSumOverBonds) {
  const auto [isLattice, isUniform] = GetParam();
  for (const FlowWeights kind : {FlowWeights::Scalar, FlowWeights::Matrix}) {
    const bool isScalar = kind == FlowWeights::Scalar;
    const Body body(isScalar ? 1 : 4, isLattice, isUniform);
    const FlowStencils stencils(body.points, body.list, body.weights, body.width);
    EXPECT_EQ(stencils.uniformShare() > 0.5, isLattice && isUniform);
    const int n = static_cast<int>(body.points.size());
    const FlowState state = randomState(n);
    FlowOperators found = zeroOperators(n);
    applyViscosity(stencils, kind, 2, state, found);
    std::vector<double> expected(static_cast<std::size_t>(2 * n), 0.0);
    body.forEachBond([&](int i, int j, const double* w) {
      for (int a = 0; a < 2; ++a)
        for (int b = 0; b < 2; ++b) {
          const double weight = isScalar ? (a == b ? w[0] : 0.0) : w[2 * a + b];
          expected[static_cast<std::size_t>(2 * i + a)] += weight * (state.velocity[b][j] - state.velocity[b][i]);
        }
    });
    for (int i = 0; i < n; ++i)
      for (int a = 0; a < 2; ++a)
        ASSERT_NEAR(found.viscous[a][i], expected[static_cast<std::size_t>(2 * i + a)], 1e-12) << i;
  }
}

TEST_P(FlowKernel, GradientsAreSumsOverBonds) {
  const auto [isLattice, isUniform] = GetParam();
  for (const FlowWeights kind : {FlowWeights::Scalar, FlowWeights::Matrix}) {
    const bool isScalar = kind == FlowWeights::Scalar;
    const Body body(isScalar ? 4 : 6, isLattice, isUniform);
    const FlowStencils stencils(body.points, body.list, body.weights, body.width);
    const int n = static_cast<int>(body.points.size());
    const FlowState state = randomState(n);
    FlowOperators found = zeroOperators(n);
    applyGradients(stencils, kind, 2, state, found);
    std::vector<std::array<double, 4>> gradient(body.points.size());
    std::vector<std::array<double, 2>> ofPressure(body.points.size());
    body.forEachBond([&](int i, int j, const double* w) {
      const auto p = static_cast<std::size_t>(i);
      for (std::size_t b = 0; b < 2; ++b) {
        for (std::size_t a = 0; a < 2; ++a) {
          const int component = static_cast<int>(a);
          gradient[p][2 * a + b] +=
              w[isScalar ? b : 2 * a + b] * (state.velocity[component][j] - state.velocity[component][i]);
        }
        ofPressure[p][b] += w[(isScalar ? 2 : 4) + b] * (state.pressure[0][j] - state.pressure[0][i]);
      }
    });
    for (int i = 0; i < n; ++i) {
      const auto& g = gradient[static_cast<std::size_t>(i)];
      for (int a = 0; a < 2; ++a) {
        const auto row = static_cast<std::size_t>(2 * a);
        ASSERT_NEAR(found.convection[a][i], state.velocity[0][i] * g[row] + state.velocity[1][i] * g[row + 1], 1e-12);
        ASSERT_NEAR(found.pressureGradient[a][i], ofPressure[static_cast<std::size_t>(i)][static_cast<std::size_t>(a)],
                    1e-12);
      }
      ASSERT_NEAR(found.divergence[0][i], g[0] + g[3], 1e-12);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Bodies, FlowKernel,
                         testing::Values(std::tuple(true, true), std::tuple(true, false), std::tuple(false, false)));

TEST(TaitFluid, DensityIsThatOfItsEquation) {
  for (const int exponent : {1, 2, 7}) {
    const TaitFluid fluid{1000.0, 1e-3, 20.0, exponent};
    for (const double x : {-0.5, -0.1, 0.0, 1e-9, 0.1, 0.5}) {
      const double pressure = x * 1000.0 * 400.0 / exponent;
      EXPECT_NEAR(fluid.densityAt(pressure) / (1000.0 * std::pow(1.0 + x, 1.0 / exponent)), 1.0, 1e-13) << x;
      EXPECT_NEAR(fluid.bulkModulus(pressure), 4e5 * (1.0 + x), 1e-6);
    }
    EXPECT_TRUE(std::isnan(fluid.densityAt(1.01 * fluid.leastPressure())));
  }
}

TEST(TaitFluid, RatesKeepMassAndMomentum) {
  // d rho/dt = -rho div v - v.grad rho + rho tau S p with rho' = rho/K, and Newton's law.
  const TaitFluid fluid{2.0, 0.3, 5.0, 7};
  const int n = 11;
  FlowState state = randomState(n), rates = randomState(n);
  FlowOperators operators = zeroOperators(n);
  PointArrays force, tau, found;
  found.zero(n, 1);
  force.zero(n, 3);
  tau.zero(n, 1);
  for (int i = 0; i < n; ++i) {
    for (int a = 0; a < 2; ++a) {
      operators.convection[a][i] = 0.1 * i + a;
      operators.viscous[a][i] = 0.2 * i - a;
      operators.pressureGradient[a][i] = 1.0 + 0.3 * i * a;
      force[a][i] = 0.7 * a;
    }
    operators.divergence[0][i] = 0.05 * i;
    operators.smoothing[0][i] = 2.0 - i;
    tau[0][i] = 0.01;
  }
  flowRates(fluid, 2, n, state, operators, force, tau, rates, found);
  for (int i = 0; i < n; ++i) {
    const double pressure = state.pressure[0][i], density = fluid.densityAt(pressure);
    EXPECT_NEAR(found[0][i], density, 1e-13);
    const double compliance = density / fluid.bulkModulus(pressure);
    double change = density * (0.01 * operators.smoothing[0][i] - operators.divergence[0][i]);
    for (int a = 0; a < 2; ++a) {
      change -= state.velocity[a][i] * compliance * operators.pressureGradient[a][i];
      const double stress = 0.3 * operators.viscous[a][i] - operators.pressureGradient[a][i] + force[a][i];
      EXPECT_NEAR(rates.velocity[a][i], stress / density - operators.convection[a][i], 1e-13);
    }
    EXPECT_NEAR(compliance * rates.pressure[0][i], change, 1e-12);
  }
}

}  // namespace
