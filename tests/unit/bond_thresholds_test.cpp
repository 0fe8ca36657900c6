// Random numbers of bonds: what they are, and that thresholds break bonds as the step-wise rule does.
#include "bond_thresholds.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <random>
#include <vector>

namespace pd::kernels {
namespace {

TEST(BondThresholdsTest, AreThePublishedGenerator) {
  // Known answers of Philox 2x32 with ten rounds, from the distribution of Random123 (kat_vectors).
  const BondThresholds zero = bondThresholds(0u, 0, 0);
  EXPECT_DOUBLE_EQ(zero.ofFirst, (0xff1dae59u + 0.5) / 4294967296.0);
}

TEST(BondThresholdsTest, BelongToTheEndsWhicheverComesFirst) {
  for (int a = 0; a < 50; ++a)
    for (int b = 0; b < 50; ++b) {
      if (a == b) continue;
      const BondThresholds one = bondThresholds(7u, a, b), other = bondThresholds(7u, b, a);
      EXPECT_EQ(one.ofFirst, other.ofSecond);
      EXPECT_EQ(one.ofSecond, other.ofFirst);
      EXPECT_NE(one.ofFirst, one.ofSecond);
      EXPECT_NE(one.ofFirst, bondThresholds(8u, a, b).ofFirst);
    }
}

TEST(BondThresholdsTest, BondsThatMirrorEachOtherHaveTheSameNumbers) {
  constexpr int shift = 1000;  // of the ids of images
  for (int a = 0; a < 30; ++a)
    for (int b = 0; b < 30; ++b) {
      // The bond from a to the image of b, and from b to the image of a.
      const BondThresholds one = bondThresholds(7u, a, b + shift, shift),
                           other = bondThresholds(7u, b, a + shift, shift);
      EXPECT_EQ(std::min(one.ofFirst, one.ofSecond), std::min(other.ofFirst, other.ofSecond));
      EXPECT_NE(one.ofFirst, bondThresholds(7u, a, b + 1, 0).ofFirst);
      if (a == b) continue;
      EXPECT_EQ(one.ofFirst, other.ofSecond);
      EXPECT_EQ(one.ofSecond, other.ofFirst);
      EXPECT_EQ(bondThresholds(7u, a, b, 0).ofFirst, bondThresholds(7u, a, b).ofFirst);
    }
}

TEST(BondThresholdsTest, AreUniformAndIndependent) {
  constexpr int n = 400;  // all pairs of neighbours in number, as in a small body
  double sum = 0.0, squares = 0.0, acrossEnds = 0.0, acrossSeeds = 0.0, acrossIds = 0.0;
  std::array<int, 20> bins{};
  int count = 0;
  for (int a = 0; a < n; ++a)
    for (int b = a + 1; b < n; ++b) {
      const BondThresholds t = bondThresholds(3u, a, b);
      ASSERT_GT(t.ofFirst, 0.0);
      ASSERT_LT(t.ofFirst, 1.0);
      const double u = t.ofFirst - 0.5;
      sum += u;
      squares += u * u;
      acrossEnds += u * (t.ofSecond - 0.5);
      acrossSeeds += u * (bondThresholds(4u, a, b).ofFirst - 0.5);
      acrossIds += u * (bondThresholds(3u, a, b + 1).ofFirst - 0.5);
      ++bins[static_cast<std::size_t>(20.0 * t.ofFirst)];
      ++count;
    }
  // Of a uniform variable: mean 1/2, variance 1/12 (of which the variance is 1/180), products 1/144. Four sigma.
  const double root = std::sqrt(static_cast<double>(count));
  EXPECT_LT(std::abs(sum / count), 4.0 / std::sqrt(12.0) / root);
  EXPECT_NEAR(squares / count, 1.0 / 12.0, 4.0 / std::sqrt(180.0) / root);
  for (const double product : {acrossEnds, acrossSeeds, acrossIds})
    EXPECT_LT(std::abs(product / count), 4.0 / 12.0 / root);
  double chiSquare = 0.0;
  for (const int bin : bins) chiSquare += std::pow(bin - count / 20.0, 2) / (count / 20.0);
  EXPECT_LT(chiSquare, 43.8);  // 19 degrees of freedom, 0.1 %
}

// Points that dissolve alone, with bonds to points that do not.
constexpr int nBondsOfPoint = 28, nDissolving = 20000;
using Rises = std::vector<double>;  ///< d_c after each step

/// Shares of broken bonds at two of the steps, of every point.
struct Shares {
  std::vector<double> early, late;
};

Shares byThresholds(std::uint32_t seed, const Rises& rises, std::size_t early) {
  Shares shares;
  for (int p = 0; p < nDissolving; ++p) {
    int broken[2] = {};
    for (int k = 0; k < nBondsOfPoint; ++k) {
      const double threshold = bondThresholds(seed, p, nDissolving + p * nBondsOfPoint + k).ofFirst;
      broken[0] += rises[early] > threshold ? 1 : 0;
      broken[1] += rises.back() > threshold ? 1 : 0;
    }
    shares.early.push_back(static_cast<double>(broken[0]) / nBondsOfPoint);
    shares.late.push_back(static_cast<double>(broken[1]) / nBondsOfPoint);
  }
  return shares;
}

/// Each unbroken bond breaks with probability(d_c before, d_c after) in each step.
Shares byStepwiseRule(const Rises& rises, std::size_t early, const std::function<double(double, double)>& probability) {
  std::mt19937_64 generator(12345);
  std::uniform_real_distribution<double> uniform;
  Shares shares;
  for (int p = 0; p < nDissolving; ++p) {
    int left = nBondsOfPoint;
    double before = 0.0;
    for (std::size_t n = 0; n < rises.size(); ++n) {
      const int tried = left;
      for (int k = 0; k < tried; ++k) left -= uniform(generator) < probability(before, rises[n]) ? 1 : 0;
      before = rises[n];
      if (n == early) shares.early.push_back(1.0 - static_cast<double>(left) / nBondsOfPoint);
    }
    shares.late.push_back(1.0 - static_cast<double>(left) / nBondsOfPoint);
  }
  return shares;
}

double mean(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

double covariance(const std::vector<double>& a, const std::vector<double>& b) {
  const double meanA = mean(a), meanB = mean(b);
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - meanA) * (b[i] - meanB);
  return sum / static_cast<double>(a.size());
}

TEST(BondThresholdsTest, BreakBondsAsTheStepwiseRuleDoes) {
  // Steps from 0.001 to 0.3, one after the other.
  const Rises rises = {0.001, 0.05, 0.06, 0.3, 0.35, 0.65, 0.66, 0.9};
  constexpr std::size_t early = 3;
  const double first = rises[early], last = rises.back();
  const Shares thresholds = byThresholds(5u, rises, early);
  const Shares stepwise =
      byStepwiseRule(rises, early, [](double before, double after) { return (after - before) / (1.0 - before); });
  // Binomial numbers of broken bonds: variance d(1 - d)/n, and between two times d_1(1 - d_2)/n.
  const auto variance = [](double a, double b) { return a * (1.0 - b) / nBondsOfPoint; };
  const double root = std::sqrt(static_cast<double>(nDissolving));
  for (const Shares* shares : {&thresholds, &stepwise}) {
    EXPECT_NEAR(mean(shares->early), first, 4.0 * std::sqrt(variance(first, first)) / root);
    EXPECT_NEAR(mean(shares->late), last, 4.0 * std::sqrt(variance(last, last)) / root);
    // Of a nearly normal variable: the sample variance has a relative standard deviation of sqrt(2/n).
    EXPECT_NEAR(covariance(shares->early, shares->early) / variance(first, first), 1.0, 5.0 * std::sqrt(2.0) / root);
    EXPECT_NEAR(covariance(shares->late, shares->late) / variance(last, last), 1.0, 5.0 * std::sqrt(2.0) / root);
    const double correlation = std::sqrt(variance(first, last) / variance(last, first));
    EXPECT_NEAR(covariance(shares->early, shares->late) / variance(first, last), 1.0, 5.0 / correlation / root);
  }
}

TEST(BondThresholdsTest, AreTheLimitOfTheRuleWithTheDamageAfterTheStep) {
  // Divided by what is left after the step, as the paper prints it, the probability is a little larger: with equal
  // steps s the share that outlives d_c is (1 - d_c - s)/(1 - s), a product that telescopes.
  for (const double step : {0.1, 0.02, 0.005}) {
    Rises rises;
    for (int n = 1; n * step < 0.5 + 1e-9; ++n) rises.push_back(n * step);
    const Shares shares =
        byStepwiseRule(rises, 0, [](double before, double after) { return (after - before) / (1.0 - after); });
    const double expected = 1.0 - (1.0 - 0.5 - step) / (1.0 - step);
    const double sigma = std::sqrt(expected * (1.0 - expected) / nBondsOfPoint / nDissolving);
    EXPECT_NEAR(mean(shares.late), expected, 4.0 * sigma) << step;
    EXPECT_NEAR(expected, 0.5, 0.6 * step) << step;
  }
}

}  // namespace
}  // namespace pd::kernels
