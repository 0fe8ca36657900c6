// The bare loops of the benchmark do the work that they are quoted for.
#include "../benchmark/yardstick.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace {

using pd_benchmark::BareBody;

std::array<double, 3> difference(const std::vector<double>& field, std::size_t i, std::size_t j) {
  return {field[3 * j] - field[3 * i], field[3 * j + 1] - field[3 * i + 1], field[3 * j + 2] - field[3 * i + 2]};
}

double length(const std::array<double, 3>& v) { return std::hypot(v[0], v[1], v[2]); }

/// Over all pairs, by the formula: the sum of V_j (l - l0) / l0 along the bonds, with V_j = 1 m3.
std::vector<double> forceOverAllPairs(const BareBody& body) {
  std::vector<double> force(3 * body.nPoints(), 0.0);
  for (std::size_t i = 0; i < body.nPoints(); ++i)
    for (std::size_t j = 0; j < body.nPoints(); ++j) {
      const auto reference = difference(body.reference(), i, j), current = difference(body.current(), i, j);
      if (i == j || length(reference) > 3.015) continue;
      const double stretch = length(current) / length(reference) - 1.0;
      for (std::size_t d = 0; d < 3; ++d) force[3 * i + d] += stretch * current[d] / length(current);
    }
  return force;
}

TEST(Yardstick, BothLoopsGiveTheForceOfAllPairs) {
  BareBody body(9);
  body.forceByList();
  body.forceByOffsets();
  body.forceByOffsets();  // overwrites what the first call has left
  const std::vector<double> expected = forceOverAllPairs(body);
  for (std::size_t i = 0; i < body.nPoints(); ++i)
    for (std::size_t d = 0; d < 3; ++d) {
      // Forces are of the order of 1e-3; each is a sum of 122 bonds or fewer, whose stretches lose three digits.
      EXPECT_NEAR(body.listForce()[3 * i + d], expected[3 * i + d], 1e-13) << i;
      EXPECT_NEAR(body.latticeForce()[d][i], expected[3 * i + d], 1e-13) << i;
    }
}

TEST(Yardstick, CountsEachDirectedBondOnce) {
  BareBody body(9);
  double nBonds = 0.0;
  for (std::size_t i = 0; i < body.nPoints(); ++i)
    for (std::size_t j = 0; j < body.nPoints(); ++j) {
      const double distance = length(difference(body.reference(), i, j));
      if (distance > 0.0 && distance < 3.015) nBonds += 1.0;
    }
  EXPECT_EQ(body.nBonds(), nBonds);
}

TEST(Yardstick, TriadAddsThreeTimesTheThird) {
  std::vector<double> a(3, 0.0);
  pd_benchmark::triad(a, {1.0, 2.0, 3.0}, {0.5, 0.0, -1.0});
  EXPECT_EQ(a, (std::vector<double>{2.5, 2.0, 0.0}));
}

}  // namespace
