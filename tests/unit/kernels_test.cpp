// The pieces that bond loops are made of, against plain loops.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "alive_bonds.hpp"
#include "bond_constants.hpp"
#include "diffusion_kernel.hpp"
#include "principal_direction.hpp"
#include "simd.hpp"

using namespace pd::kernels;

namespace {

TEST(Simd, InverseSquareRootIsGoodToRoundOff) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> exponent(-280.0, 280.0);
  double worst = 0.0;
  for (int repetition = 0; repetition < 20000; ++repetition) {
    const Vector x([&](auto) { return std::pow(10.0, exponent(random)); });
    const Vector y = inverseSquareRoot(x);
    for (std::size_t lane = 0; lane < lanes; ++lane)
      worst = std::max(worst, std::abs(y[lane] * std::sqrt(x[lane]) - 1.0));
  }
  EXPECT_LT(worst, 6e-16);
}

TEST(PrincipalDirection, IsThatOfTheLargestPart) {
  // sum of l_i u_i u_i^T with known, orthogonal u_i: the columns of a product of three turns.
  std::mt19937 random(3);
  std::uniform_real_distribution<double> angle(-3.0, 3.0), size(-1.0, 1.0);
  for (int repetition = 0; repetition < 500; ++repetition) {
    const double a = angle(random), b = angle(random), c = angle(random);
    const double u[3][3] = {
        {std::cos(a) * std::cos(b), std::sin(a) * std::cos(b), -std::sin(b)},
        {std::cos(a) * std::sin(b) * std::sin(c) - std::sin(a) * std::cos(c),
         std::sin(a) * std::sin(b) * std::sin(c) + std::cos(a) * std::cos(c), std::cos(b) * std::sin(c)},
        {std::cos(a) * std::sin(b) * std::cos(c) + std::sin(a) * std::sin(c),
         std::sin(a) * std::sin(b) * std::cos(c) - std::cos(a) * std::sin(c), std::cos(b) * std::cos(c)}};
    const double sizes[3] = {size(random), 1.5, size(random)};
    Matrix3<double> tensor{};
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t r = 0; r < 3; ++r)
        for (std::size_t s = 0; s < 3; ++s) tensor[3 * r + s] += sizes[i] * u[i][r] * u[i][s];
    const std::array<double, 3> found = principalDirection(tensor);
    EXPECT_NEAR(std::abs(found[0] * u[1][0] + found[1] * u[1][1] + found[2] * u[1][2]), 1.0, 1e-13);
  }
  EXPECT_EQ(principalDirection({1.0, 0.0, 0.0, 0.0, 2.0, 0.0, 0.0, 0.0, 0.0})[1], 1.0);
}

TEST(Simd, FourValuesOfAPointAreGatheredAndScattered) {
  constexpr int nPoints = 50;
  std::vector<double> values(8 * nPoints);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = std::sqrt(static_cast<double>(i));
  std::array<int, lanes> ids{};
  for (int lane = 0; lane < lanes; ++lane) ids[static_cast<std::size_t>(lane)] = (17 * lane + 5) % nPoints;
  ids[1] = ids[0];  // of two lanes, both count
  Vector gathered[4];
  gatherFour<8>(values.data() + 4, ids.data(), gathered);
  std::vector<double> sums(4 * nPoints, 1.0), expected = sums;
  scatterAddFour<4>(gathered, ids.data(), sums.data());
  for (std::size_t lane = 0; lane < lanes; ++lane)
    for (std::size_t c = 0; c < 4; ++c) {
      const auto point = static_cast<std::size_t>(ids[lane]);
      EXPECT_EQ(gathered[c][lane], values[8 * point + 4 + c]);
      expected[4 * point + c] += values[8 * point + 4 + c];
    }
  EXPECT_EQ(sums, expected);
}

/// Lists of 3 to 24 neighbours, most of them at common offsets.
struct RandomLists {
  std::vector<int> owned, list;
  explicit RandomLists(std::mt19937& random) {
    std::bernoulli_distribution isNeighbor(0.7);
    constexpr int nPoints = 60, reach = 12;
    for (int i = reach; i < nPoints - reach; ++i) {
      owned.push_back(i);
      const std::size_t head = list.size();
      list.push_back(0);
      for (int j = i - reach; j <= i + reach; ++j)
        if (j != i && (isNeighbor(random) || j < i - reach + 3)) list.push_back(j);
      list[head] = static_cast<int>(list.size() - head) - 1;
    }
  }
};

TEST(AliveBonds, AreReadFromBondDamageWhereDamageHasChanged) {
  std::mt19937 random(2);
  std::bernoulli_distribution breaks(0.3), changes(0.5);
  for (int repetition = 0; repetition < 20; ++repetition) {
    const RandomLists lists(random);
    const ChunkedNeighborhood neighborhood(static_cast<int>(lists.owned.size()), lists.owned.data(), lists.list.data());
    AliveBonds alive(neighborhood);
    std::vector<double> bondDamage(neighborhood.nBonds(), 0.0), damage(60, 0.0), seen = bondDamage;
    for (int step = 1; step <= 3; ++step) {
      std::size_t bond = 0, at = 0;
      for (const int i : lists.owned) {
        const bool isReported = changes(random);
        if (isReported) damage[static_cast<std::size_t>(i)] += 1.0;
        for (int n = lists.list[at]; n > 0; --n, ++bond) {
          if (breaks(random)) bondDamage[bond] = 1.0;
          if (isReported) seen[bond] = bondDamage[bond];
        }
        at += static_cast<std::size_t>(lists.list[at]) + 1;
      }
      EXPECT_TRUE(alive.refresh(neighborhood, bondDamage.data(), damage.data()));
      for (const Chunk& chunk : neighborhood.chunks())
        for (int lane = 0; lane < chunk.nLanes; ++lane)
          neighborhood.forEachBond(chunk, lane, [&](int k, std::size_t b) {
            ASSERT_EQ((alive.of(chunk)[k] >> lane) & 1, seen[b] < 1.0 ? 1 : 0) << "step " << step << ", bond " << b;
          });
      for (const Chunk& chunk : neighborhood.chunks())
        for (int k = 0; k < chunk.nNeighbors; ++k) ASSERT_EQ(alive.of(chunk)[k] & ~neighborhood.present(chunk)[k], 0);
    }
    bondDamage[7] = 0.5;
    EXPECT_FALSE(alive.refresh(neighborhood, bondDamage.data(), nullptr)) << "a bond that is damaged in part";
  }
}

/// Chunks in the middle are alike, and summed side by side; those at the ends, and one of other weights, are not.
TEST(FluxDivergence, OfChunksThatAreAlikeIsThatOfAPlainLoop) {
  constexpr int nPoints = 150, reach = 3;
  std::vector<int> owned, list;
  for (int i = 0; i < nPoints; ++i) {
    owned.push_back(i);
    const std::size_t head = list.size();
    list.push_back(0);
    for (int j = std::max(0, i - reach); j <= std::min(nPoints - 1, i + reach); ++j)
      if (j != i) list.push_back(j);
    list[head] = static_cast<int>(list.size() - head) - 1;
  }
  const auto weightOf = [](int i, int j) { return (i / 8 == 7 ? 2.0 : 1.0) / (1.0 + std::abs(i - j)); };
  const ChunkedNeighborhood neighborhood(nPoints, owned.data(), list.data());
  const BondConstants weights(neighborhood, 1,
                              [&](int i, int j, std::size_t, double* value) { *value = weightOf(i, j); });
  std::vector<double> concentration(nPoints + 2 * lanes), rate(concentration.size(), 0.5);
  std::mt19937 random(3);
  for (double& value : concentration) value = std::uniform_real_distribution<double>(0.0, 1.0)(random);
  // `lanes` values before the first and past the last point may be read.
  const double* c = concentration.data() + lanes;
  double* found = rate.data() + lanes;
  addFluxDivergence(neighborhood, weights, nullptr, c, found);
  std::vector<std::size_t> all, none;
  for (std::size_t chunk = 0; chunk < neighborhood.chunks().size(); ++chunk) all.push_back(chunk);
  addFluxDivergence(neighborhood, weights, nullptr, c, found, &all);
  addFluxDivergence(neighborhood, weights, nullptr, c, found, &none);
  for (int i = 0; i < nPoints; ++i) {
    double sum = 0.0;
    for (int j = std::max(0, i - reach); j <= std::min(nPoints - 1, i + reach); ++j)
      sum += i == j ? 0.0 : weightOf(i, j) * (c[j] - c[i]);
    EXPECT_NEAR(found[i], 0.5 + 2.0 * sum, 1e-14) << i;
  }
}

}  // namespace
