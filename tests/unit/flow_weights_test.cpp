// Constants and weights of the nonlocal operators of flow.
#include "flow_weights.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "exact_weights.hpp"

using namespace pd::kernels;

namespace {

constexpr double pi = 3.14159265358979323846;

using Place = std::array<double, 3>;

/// All bonds of a square or cubic lattice of spacing 1 within `horizon`; `jitter`: how far ends are moved at most.
BondEnds latticeBonds(int dimension, double horizon, double jitter = 0.0) {
  BondEnds ends;
  ends.dimension = dimension;
  std::mt19937 random(7);
  std::uniform_real_distribution<double> shift(-jitter, jitter);
  const int m = static_cast<int>(horizon);
  for (int z = dimension == 3 ? -m : 0; z <= (dimension == 3 ? m : 0); ++z)
    for (int y = -m; y <= m; ++y)
      for (int x = -m; x <= m; ++x) {
        const double square = x * x + y * y + z * z;
        if (square == 0.0 || square > horizon * horizon) continue;
        const Place xi{x + shift(random), y + shift(random), z + shift(random)};
        ends.add(xi.data(), 1.0);
      }
  return ends;
}

double ballVolume(int dimension, double horizon) {
  return dimension == 2 ? pi * horizon * horizon : 4.0 / 3.0 * pi * horizon * horizon * horizon;
}

/// alpha/V_H sum K (v' - v)/|xi|^2 at the origin, in which v is zero.
template <class Velocity>
Place integralOver(const BondEnds& ends, double horizon, ViscousKernel kernel, const Velocity& velocity) {
  Place sum{};
  const auto dimension = static_cast<std::size_t>(ends.dimension);
  for (std::size_t k = 0; k < ends.count(); ++k) {
    Place xi{};
    double square = 0.0;
    for (std::size_t a = 0; a < dimension; ++a) {
      xi[a] = ends.xi[dimension * k + a];
      square += xi[a] * xi[a];
    }
    const std::array<double, 9> share = ends.viscousShare(k, kernel);
    const Place v = velocity(xi);
    for (std::size_t a = 0; a < dimension; ++a)
      for (std::size_t b = 0; b < dimension; ++b)
        sum[a] += viscousConstant(ends.dimension, kernel) / ballVolume(ends.dimension, horizon) * share[3 * a + b] *
                  v[b] / square;
  }
  return sum;
}

TEST(ViscousConstant, IsThatOfFlowsWithoutDivergence) {
  EXPECT_DOUBLE_EQ(viscousConstant(2, ViscousKernel::Transverse), 16.0 / 3.0);
  EXPECT_DOUBLE_EQ(viscousConstant(3, ViscousKernel::Transverse), 15.0 / 2.0);
  for (const int dimension : {2, 3})
    for (const ViscousKernel kernel : {ViscousKernel::Laplacian, ViscousKernel::Transverse}) {
      // Sums over lattices come near the integrals as their points become many.
      const double horizon = dimension == 2 ? 40.5 : 12.5;
      const BondEnds ends = latticeBonds(dimension, horizon);
      const auto shear = [](const Place& x) { return Place{0.5 * x[1] * x[1], 0.0, 0.0}; };
      const auto stagnation = [](const Place& x) { return Place{0.5 * x[0] * x[0], -x[0] * x[1], 0.0}; };
      EXPECT_NEAR(integralOver(ends, horizon, kernel, shear)[0], 1.0, 0.01) << dimension;
      EXPECT_NEAR(integralOver(ends, horizon, kernel, stagnation)[0], 1.0, 0.01) << dimension;
      EXPECT_NEAR(integralOver(ends, horizon, kernel, stagnation)[1], 0.0, 0.01) << dimension;
    }
}

TEST(ViscousConstant, TheTransverseKernelSeesDivergenceToo) {
  // lap v - 2/(d+1) grad div v, both 1 along x.
  const auto stretch = [](const Place& x) { return Place{0.5 * x[0] * x[0], 0.0, 0.0}; };
  EXPECT_NEAR(integralOver(latticeBonds(2, 40.5), 40.5, ViscousKernel::Transverse, stretch)[0], 1.0 / 3.0, 0.01);
  EXPECT_NEAR(integralOver(latticeBonds(3, 12.5), 12.5, ViscousKernel::Transverse, stretch)[0], 1.0 / 2.0, 0.01);
}

/// A family of which bonds that would cross x + 0.3 y = 0.61 end there.
BondEnds cutFamily(int dimension, double horizon, double jitter) {
  BondEnds whole = latticeBonds(dimension, horizon, jitter), cut;
  cut.dimension = dimension;
  const auto d = static_cast<std::size_t>(dimension);
  for (std::size_t k = 0; k < whole.count(); ++k) {
    Place xi{};
    for (std::size_t a = 0; a < d; ++a) xi[a] = whole.xi[d * k + a];
    const double reach = xi[0] + 0.3 * xi[1];
    if (reach > 0.61)
      for (double& component : xi) component *= 0.61 / reach;
    cut.add(xi.data(), 1.0);
  }
  return cut;
}

double quadratic(const double* x, int dimension) {
  const double z = dimension == 3 ? x[2] : 0.0;
  return 0.7 * x[0] - 0.4 * x[1] + 0.2 * z + 1.5 * x[0] * x[0] - 0.6 * x[0] * x[1] + 0.8 * x[1] * x[1] - 0.3 * z * z +
         0.5 * x[1] * z;
}

TEST(FlowWeights, AreExactForQuadraticFieldsWhereverBondsEnd) {
  for (const int dimension : {2, 3})
    for (const double jitter : {0.0, 0.3}) {
      const auto d = static_cast<std::size_t>(dimension);
      const BondEnds ends = cutFamily(dimension, 3.015, jitter);
      const auto valueAt = [&](std::size_t k) { return quadratic(&ends.xi[d * k], dimension); };
      const std::vector<double> viscous = viscousWeights(ends, ballVolume(dimension, 3.015), ViscousKernel::Laplacian);
      ASSERT_EQ(viscous.size(), ends.count());
      double laplacian = 0.0;
      for (std::size_t k = 0; k < ends.count(); ++k) laplacian += viscous[k] * valueAt(k);
      EXPECT_NEAR(laplacian, 3.0 + 1.6 - (dimension == 3 ? 0.6 : 0.0), 1e-7);

      const std::vector<double> gradient = gradientWeights(ends);
      ASSERT_EQ(gradient.size(), d * ends.count());
      const Place exact{0.7, -0.4, 0.2};
      for (std::size_t a = 0; a < d; ++a) {
        double sum = 0.0;
        for (std::size_t k = 0; k < ends.count(); ++k) sum += gradient[d * k + a] * valueAt(k);
        EXPECT_NEAR(sum, exact[a], 1e-7);
      }
      const Place place{0.4, -0.7, dimension == 3 ? 0.3 : 0.0};
      const std::vector<double> interpolation = interpolationWeights(ends, place.data(), 2);
      double value = 0.0;
      for (std::size_t k = 0; k < ends.count(); ++k) value += interpolation[k] * valueAt(k);
      EXPECT_NEAR(value, quadratic(place.data(), dimension), 1e-7);
    }
}

TEST(FlowWeights, OfALatticeAreNearTheKernelAndPositive) {
  const BondEnds ends = latticeBonds(2, 3.015);
  const double alpha = viscousConstant(2, ViscousKernel::Laplacian) / ballVolume(2, 3.015);
  const std::vector<double> weights = viscousWeights(ends, ballVolume(2, 3.015), ViscousKernel::Laplacian);
  for (std::size_t k = 0; k < ends.count(); ++k) {
    const double *xi = &ends.xi[2 * k], square = xi[0] * xi[0] + xi[1] * xi[1];
    // 28 points in a circle of 28.6 spacings squared.
    EXPECT_NEAR(weights[k] * square / alpha, 1.0, 0.1);
    EXPECT_GT(weights[k], 0.0);
  }
}

TEST(FlowWeights, PointsOnALineGiveNoMoreThanTheirDirection) {
  BondEnds ends;
  for (const double x : {-2.0, -1.0, 1.0, 2.0}) {
    const Place xi{x, 0.0, 0.0};
    ends.add(xi.data(), 1.0);
  }
  EXPECT_TRUE(viscousWeights(ends, 10.0, ViscousKernel::Laplacian).empty());
  EXPECT_TRUE(gradientWeights(ends).empty());
  const std::vector<double> linear = linearGradientWeights(ends);
  double along = 0.0;
  for (std::size_t k = 0; k < ends.count(); ++k) {
    along += linear[2 * k] * ends.xi[2 * k];
    EXPECT_EQ(linear[2 * k + 1], 0.0);
  }
  EXPECT_NEAR(along, 1.0, 1e-9);
}

TEST(PressureSmoothing, IsAboutTheLaplacianWithoutItsGradients) {
  for (const int dimension : {2, 3}) {
    const BondEnds ends = latticeBonds(dimension, 1.5);
    double sum = 0.0;
    for (std::size_t k = 0; k < ends.count(); ++k) {
      const double* xi = &ends.xi[static_cast<std::size_t>(dimension) * k];
      double square = 0.0;
      for (int a = 0; a < dimension; ++a) square += xi[a] * xi[a];
      sum += pressureSmoothing(dimension, 1.0, std::sqrt(square)) * xi[0] * xi[0];
    }
    EXPECT_NEAR(sum, 2.0, 1e-12);
  }
}

}  // namespace
