// Laws of bond life, and the trial that finds the growth coefficient, against numbers from elsewhere.
#include <gtest/gtest.h>

#include <cmath>

#include "banded_cholesky.hpp"
#include "growth_strip.hpp"
#include "life_law.hpp"
#include "threshold_trial.hpp"

namespace pd {
namespace {

using kernels::LifeLaw;

TEST(LifeLaw, PowerOfWhatExceedsTheLimit) {
  const LifeLaw law = LifeLaw::power(426.0, 2.77, 1.86e-3);
  EXPECT_DOUBLE_EQ(law.rate(4.0e-3), 426.0 * std::pow(2.14e-3, 2.77));
  EXPECT_EQ(law.rate(1.86e-3), 0.0);
  EXPECT_EQ(LifeLaw().rate(1.0), 0.0);
  const LifeLaw factored = LifeLaw::power(1.0, 2.0, 1e-3, {{2.0, 8.0}, {3.0, 12.0}});  // log-log between the rows
  EXPECT_NEAR(factored.rate(4e-3) / (6.0 * 9e-6), 1.0, 1e-12);
  EXPECT_NEAR(factored.rate(1.5e-3) / (3.0 * 0.25e-6), 1.0, 1e-12);
  EXPECT_NEAR(factored.rate(9e-3) / (12.0 * 64e-6), 1.0, 1e-12);
}

TEST(LifeLaw, TableIsMetAtItsRowsAndIsAPowerBetweenAndBeyondThem) {
  const LifeLaw law = LifeLaw::table({1e3, 1e5, 1e6}, {1e-2, 4e-3, 2e-3}, 1e-3);
  EXPECT_NEAR(1.0 / law.rate(1e-2), 1e3, 1e-9 * 1e3);
  EXPECT_NEAR(1.0 / law.rate(4e-3), 1e5, 1e-9 * 1e5);
  EXPECT_NEAR(1.0 / law.rate(2e-3), 1e6, 1e-9 * 1e6);
  EXPECT_NEAR(1.0 / law.rate(std::sqrt(1e-2 * 4e-3)), 1e4, 1e-8 * 1e4);  // half way in logarithms
  EXPECT_NEAR(law.rate(1.5e-3) / law.rate(2e-3), std::pow(0.75, 1.0 / std::log10(2.0)), 1e-12);
  EXPECT_EQ(law.rate(0.99e-3), 0.0);
  EXPECT_THROW(LifeLaw::table({1e3, 1e2}, {1e-2, 4e-3}, 0.0), std::invalid_argument);
  EXPECT_THROW(LifeLaw::table({1e3, 1e4}, {1e-3, 4e-3}, 0.0), std::invalid_argument);
}

TEST(BandedCholesky, SolvesASecondDifference) {
  BandedCholesky matrix(50, 3);
  for (int i = 0; i < 50; ++i) {
    matrix.add(i, i, 2.0);
    if (i > 0) matrix.add(i, i - 1, -1.0);
  }
  matrix.factor();
  std::vector<double> x(50, 1.0);
  matrix.solve(x);
  for (int i = 0; i < 50; ++i) EXPECT_NEAR(x[static_cast<std::size_t>(i)], 0.5 * (i + 1) * (50 - i), 1e-9);
  BandedCholesky singular(2, 1);
  singular.add(0, 0, 1.0);
  singular.add(1, 1, 1.0);
  singular.add(0, 1, 1.0);
  EXPECT_THROW(singular.factor(), std::runtime_error);
}

/// A lattice of constant micromodulus, shares falling linearly beyond the horizon.
std::vector<LatticeBond> square(double horizon) {
  std::vector<LatticeBond> bonds;
  const int reach = static_cast<int>(horizon) + 1;
  for (int x = -reach; x <= reach; ++x)
    for (int y = -reach; y <= reach; ++y) {
      const double length = std::hypot(x, y), share = std::min(1.0, horizon + 0.5 - length);
      if ((x != 0 || y != 0) && share > 0.0) bonds.push_back({x, y, length, share * length, 1.0});
    }
  return bonds;
}

TEST(GrowthStrip, HoldsWhatAPlateThatIsStrainedAlongOneAxisHolds) {
  // Far ahead of the crack nothing moves along x: energy per length = 1/2 C11 strain^2 height, C11 of the lattice. The
  // strain is that between the grips' inner rows, but for what the coarser rows beside them do (a horizon in height).
  const double horizon = 3.0, height = 16.0;
  const auto bonds = square(horizon);
  double c11 = 0.0;
  for (const LatticeBond& bond : bonds) c11 += 0.5 * bond.stiffness * std::pow(bond.y / bond.length, 4);
  const GrowthStrip strip(bonds, horizon, height, 1.0);
  const double energy = std::pow(strip.strainUnit(), 2) * horizon * planeStiffness(bonds).fractureModulus();
  const double plate = 0.5 * c11 * 4.0 / (height * horizon);
  EXPECT_NEAR(energy / plate, 1.0, 0.05);
}

TEST(GrowthStrip, WhatIsBrokenCountsNotInWhichOrder) {
  const auto bonds = square(3.0);
  GrowthStrip one(bonds, 3.0, 4.0, 2.0), other(bonds, 3.0, 4.0, 2.0);
  EXPECT_EQ(one.nColumnsOpen(), 0);
  std::vector<std::size_t> most;
  while (most.size() < 12) {
    std::size_t next = 0;
    for (std::size_t b = 0; b < one.nBonds(); ++b)
      if (one.isBroken(next) || (!one.isBroken(b) && one.stretch(b) > one.stretch(next))) next = b;
    EXPECT_GT(one.stretch(next), 0.5 * one.strainUnit());  // the tip concentrates strain
    one.breakBond(next);
    most.push_back(next);
  }
  for (std::size_t k = most.size(); k > 0; --k) other.breakBond(most[k - 1]);
  for (std::size_t b = 0; b < one.nBonds(); ++b) {
    EXPECT_EQ(one.isBroken(b), other.isBroken(b));
    if (one.isBroken(b)) continue;
    EXPECT_NEAR(one.stretch(b), other.stretch(b), 1e-9 * one.strainUnit());
  }
}

TEST(GrowthTrial, FactorsOfThePrototype) {
  // An independent prototype (another body, another solver) found 0.295, 0.207, 0.160 for M = 2, 3, 4 within 5 %; here
  // 0.304, 0.212, 0.168.
  for (const auto& [exponent, factor] : {std::pair{2.0, 0.295}, {3.0, 0.207}, {4.0, 0.160}})
    EXPECT_NEAR(growthTrial({square(3.0), 3.0, exponent, 0.35}).factor / factor, 1.0, 0.06) << exponent;
}

/// Growth in the strips where bonds lose what the law of the threshold says, over C (dK - dK_th)^M; dK in parts of
/// dK_th.
double thresholdGrowth(const GrowthTrialCase& trial, double range, TrialBody body) {
  const BondLaw& bonds = thresholdTrial(trial).law;
  const LifeLaw law =
      LifeLaw::power(std::pow(bonds.reading, -trial.exponent), trial.exponent, bonds.reading, bonds.factor);
  const double growth = trialGrowth(
      trial, [&](double strain) { return law.rate(range * strain); }, body);
  return growth / std::pow(std::abs(range - 1.0), trial.exponent);
}

TEST(ThresholdTrial, ACrackGrowsByWhatTheRangeOfKExceedsTheThresholdBy) {
  for (const double exponent : {2.05, 3.0, 4.0}) {
    const GrowthTrialCase trial{square(3.0), 3.0, exponent, 0.35};
    EXPECT_NEAR(thresholdTrial(trial).law.reading, 1.0, 0.15) << exponent;  // core bond of a grown crack: 1.1 to 1.25
    EXPECT_LT(thresholdTrial(trial).deviation, 0.12) << exponent;  // where bonds change the order in which they break
    for (const double range : {1.1, 1.16, 1.55, 1.7, 2.0, 2.6, 5.0, 10.0, 20.0, 50.0})  // not those of the fit
      EXPECT_NEAR(thresholdGrowth(trial, range, TrialBody::Large), 1.0, 0.04) << exponent << ", " << range;
    EXPECT_EQ(thresholdGrowth(trial, 0.98, TrialBody::Strip), 0.0);
  }
}

TEST(ThresholdTrial, IsThatOfAPowerFarAbove) {
  const GrowthTrialCase trial{square(3.0), 3.0, 3.0, 0.35};
  const BondLaw& bonds = thresholdTrial(trial).law;
  const double coefficient = bonds.factor.at(1e3) * std::pow(bonds.reading, -3.0);
  EXPECT_NEAR(coefficient * growthTrial(trial).factor, 1.0, 1e-12);
}

}  // namespace
}  // namespace pd
