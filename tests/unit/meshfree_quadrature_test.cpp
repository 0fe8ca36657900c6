// Weights of neighbours that integrate quadratic fields exactly.
#include "meshfree_quadrature.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace {

using pd::kernels::DiffusionKernel;

constexpr double horizon = 0.3;
const double pi = std::acos(-1.0);

/// Points of a ball, those with x > cut left out.
std::vector<double> ball(double cut, int n, unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> uniform(-horizon, horizon);
  std::vector<double> xi;
  while (static_cast<int>(xi.size()) < 3 * n) {
    const double x = uniform(generator), y = uniform(generator), z = uniform(generator);
    if (x * x + y * y + z * z > horizon * horizon || x > cut) continue;
    xi.insert(xi.end(), {x, y, z});
  }
  return xi;
}

template <class Field>
double integral(const std::vector<double>& xi, const std::vector<double>& weights, DiffusionKernel kernel,
                Field field) {
  double sum = 0.0;
  for (std::size_t j = 0; j < weights.size(); ++j) {
    const double x = xi[3 * j], y = xi[3 * j + 1], z = xi[3 * j + 2];
    sum += weights[j] * pd::kernels::kernelValue(kernel, std::sqrt(x * x + y * y + z * z)) * field(x, y, z);
  }
  return sum;
}

}  // namespace

TEST(MeshfreeWeights, IntegrateQuadraticFieldsAlsoWherePointsAreMissing) {
  for (const auto& [kernel, power] : {std::pair{DiffusionKernel::InverseSquare, 2},
                                      std::pair{DiffusionKernel::Inverse, 1}, std::pair{DiffusionKernel::Constant, 0}})
    for (const double cut : {horizon, 0.0, -0.1}) {
      const std::vector<double> xi = ball(cut, 60, 3);
      const std::vector<double> weights = pd::kernels::meshfreeWeights(xi, horizon, kernel);
      ASSERT_EQ(weights.size(), 60u);
      // Integral of x^2 / r^power over the ball: 4 pi/3 of that of r^(4 - power) dr.
      const double second = 4.0 * pi / 3.0 * std::pow(horizon, 5 - power) / (5 - power);
      EXPECT_NEAR(integral(xi, weights, kernel, [](double x, double, double) { return x * x; }), second,
                  1e-12 * second);
      EXPECT_NEAR(integral(xi, weights, kernel, [](double, double, double z) { return 2 * z * z; }), 2 * second,
                  1e-11 * second);
      const auto odd = [](double x, double y, double z) { return horizon * (x - 2 * y) + x * y - y * z; };
      EXPECT_NEAR(integral(xi, weights, kernel, odd), 0.0, 1e-11 * second);
    }
}

TEST(MeshfreeWeights, AreEqualWhereThePointsAreAlike) {
  // The corners of a cube and the centres of its faces: by symmetry one weight each.
  std::vector<double> xi;
  for (const double x : {-0.1, 0.0, 0.1})
    for (const double y : {-0.1, 0.0, 0.1})
      for (const double z : {-0.1, 0.0, 0.1})
        if (x != 0.0 || y != 0.0 || z != 0.0) xi.insert(xi.end(), {x, y, z});
  const std::vector<double> weights = pd::kernels::meshfreeWeights(xi, horizon, DiffusionKernel::Inverse);
  ASSERT_EQ(weights.size(), 26u);
  const auto length = [&](std::size_t j) { return std::hypot(xi[3 * j], xi[3 * j + 1], xi[3 * j + 2]); };
  for (std::size_t j = 0; j < 26; ++j) {
    EXPECT_GT(weights[j], 0.0);
    for (std::size_t k = 0; k < j; ++k) {
      if (std::abs(length(j) - length(k)) > 1e-12) continue;
      EXPECT_NEAR(weights[j], weights[k], 1e-13);
    }
  }
}

TEST(MeshfreeWeights, NeighborsThatCannotDoItHaveNone) {
  EXPECT_TRUE(pd::kernels::meshfreeWeights(ball(horizon, 8, 1), horizon, DiffusionKernel::Inverse).empty());
  std::vector<double> plane = ball(horizon, 60, 1);
  for (std::size_t j = 2; j < plane.size(); j += 3) plane[j] = 0.0;
  EXPECT_TRUE(pd::kernels::meshfreeWeights(plane, horizon, DiffusionKernel::Inverse).empty());
}
