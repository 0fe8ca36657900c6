// Laws of bond life, and the trial that finds the growth coefficient, against numbers from elsewhere.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "../support/small_body.hpp"
#include "banded_cholesky.hpp"
#include "cycle_fields.hpp"
#include "growth_specimen.hpp"
#include "growth_strip.hpp"
#include "life_law.hpp"
#include "plugins.hpp"
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

/// K of ASTM E647 under a force of 1, in units of the spacing; W, and the length of the crack in it.
double standardIntensity(double width, double a) {
  return (2.0 + a) / std::pow(1.0 - a, 1.5) *
         (0.886 + 4.64 * a - 13.32 * a * a + 14.72 * a * a * a - 5.6 * std::pow(a, 4)) / std::sqrt(width);
}

TEST(GrowthSpecimen, HasTheIntensityOfTheStandard) {
  // Bonds are missing at free surfaces, so that the body is soft, and K 2 % large with this horizon.
  const double horizon = 3.0, width = 18.0, growth = 4.0;
  const auto bonds = square(horizon);
  GrowthSpecimen specimen(bonds, horizon, width, growth);
  const double modulus = planeStiffness(bonds).fractureModulus();
  const auto ratio = [&](double columns) {
    const double a = 0.5 + ((columns - 0.75 * growth * horizon) / horizon) / width;
    return specimen.strainUnit() * modulus * std::sqrt(horizon) / standardIntensity(width * horizon, a);
  };
  EXPECT_NEAR(ratio(0.0), 1.0, 0.04);
  EXPECT_NEAR(GrowthSpecimen(square(2.0), 2.0, 12.0, growth).strainUnit() *
                  planeStiffness(square(2.0)).fractureModulus() * std::sqrt(2.0) / standardIntensity(24.0, 0.25),
              1.0, 0.1);  // the coarsest that there is
  // K of a crack that has set energy free is that of a longer one.
  const double before = specimen.strainUnit();
  for (std::size_t b = 0; b < specimen.nBonds(); ++b)
    if (!specimen.isBroken(b) && specimen.stretch(b) > 0.8 * before) specimen.breakBond(b);
  EXPECT_GT(specimen.strainUnit(), before);
}

TEST(GrowthTrial, InASpecimenACrackGrowsAsInTheWholeOne) {
  // pdrun, with both halves of the specimen, pins, a surface correction and K by J, found growth by the factors of a
  // large body 0.915, 0.937, 0.937 of Paris' law.
  for (const auto& [exponent, part] : {std::pair{2.0, 0.915}, {3.0, 0.937}, {4.0, 0.937}}) {
    const GrowthTrialCase large{square(3.0), 3.0, exponent, 0.35};
    GrowthTrialCase inSpecimen = large;
    inSpecimen.specimenWidth = 40.0 / 2.25;
    EXPECT_NEAR(growthTrial(inSpecimen).factor / growthTrial(large).factor / part, 1.0, 0.03) << exponent;
  }
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
  for (const double exponent : {2.0, 2.05, 3.0, 4.0}) {
    const GrowthTrialCase trial{square(3.0), 3.0, exponent, 0.35};
    EXPECT_NEAR(thresholdTrial(trial).law.reading, 1.0, 0.15) << exponent;  // core bond of a grown crack: 1.1 to 1.25
    EXPECT_LT(thresholdTrial(trial).deviation, 0.1) << exponent;  // where bonds change the order in which they break
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

/// Lives of the bonds of a plate, each looked at in each step.
class PlainLives {
 public:
  static constexpr double initiation = 20.0, initiationExponent = 1.5, limit = 2e-3, growth = 30.0,
                          growthExponent = 2.0, criticalStretch = 0.03, growthDamage = 0.35, tolerance = 1e-3;

  PlainLives(const std::vector<pdtest::Point>& points, double horizon) : x_(points), damage_(points.size(), 0.0) {
    for (std::size_t i = 0; i < x_.size(); ++i)
      for (std::size_t j = 0; j < x_.size(); ++j)
        if (i != j && distance(x_[i], x_[j]) <= horizon * (1.0 + 1e-10)) lost_[{i, j}] = 0.0;
  }

  void pass(const std::vector<pdtest::Point>& y, double cycles, double range, double peak) {
    std::vector<char> isNear(x_.size(), 0);
    std::vector<double> all(x_.size(), 0.0), broken = all;
    left_ = rate_ = all;
    for (std::size_t i = 0; i < x_.size(); ++i) isNear[i] = damage_[i] >= growthDamage ? 1 : 0;
    for (const auto& [bond, lost] : lost_)
      if (damage_[bond.second] >= growthDamage) isNear[bond.first] = 1;
    for (auto& [bond, lost] : lost_) {
      const auto [i, j] = bond;
      const double stretch = distance(y[i], y[j]) / distance(x_[i], x_[j]) - 1.0, strain = range * stretch;
      const bool wasBroken = lost == 1.0;
      double rate = 0.0;
      if (stretch > 0.0) {
        if (isNear[i] != 0 || isNear[j] != 0)
          rate = growth * std::pow(strain, growthExponent);
        else if (strain > limit)
          rate = initiation * std::pow(strain - limit, initiationExponent);
      }
      if (!wasBroken) lost += cycles * rate;
      const bool isWorn = lost >= 1.0 - tolerance;
      if (isWorn || peak * stretch >= criticalStretch) {
        if (!wasBroken && isWorn) {
          left_[i] += 1.0 - lost;
          rate_[i] += rate;
        }
        lost = 1.0;
      }
      all[i] += 1.0;
      broken[i] += lost == 1.0 ? 1.0 : 0.0;
    }
    for (std::size_t i = 0; i < x_.size(); ++i) damage_[i] = broken[i] / all[i];
  }
  double lost(std::size_t i, std::size_t j) const { return lost_.at({i, j}); }
  double damage(std::size_t i) const { return damage_[i]; }
  double lifeLeft(std::size_t i) const { return left_[i]; }
  double rateOfFailed(std::size_t i) const { return rate_[i]; }

 private:
  static double distance(const pdtest::Point& a, const pdtest::Point& b) {
    return std::hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]);
  }
  std::vector<pdtest::Point> x_;
  std::map<std::pair<std::size_t, std::size_t>, double> lost_;
  std::vector<double> damage_, left_, rate_;
};

/// Strain that is largest in the middle of the lower edge, and moves the plate away at times.
pdtest::Point pulled(const pdtest::Point& x, int step) {
  const double load = 8e-3 * (1.0 + 0.8 * std::sin(0.9 * step)), away = step % 7 == 5 ? 0.3 : 0.0;
  return {x[0] + load * (x[0] - 6.0) * std::exp(-0.5 * (std::pow(0.5 * (x[0] - 6.0), 2) + x[1])) + away, x[1], x[2]};
}

TEST(RemainingLife, BondsThatAreNotLookedAtWouldNotHaveChanged) {
  const std::vector<pdtest::Point> points = pdtest::lattice(13, 9, 1, 1.0);
  constexpr double horizon = 2.1;
  Teuchos::ParameterList list;
  list.set("Initiation Coefficient", PlainLives::initiation);
  list.set("Initiation Exponent", PlainLives::initiationExponent);
  list.set("Fatigue Limit", PlainLives::limit);
  list.set("Growth Coefficient", PlainLives::growth);
  list.set("Growth Exponent", PlainLives::growthExponent);
  list.set("Critical Stretch", PlainLives::criticalStretch);
  for (const pdtest::BondSteps steps :
       {pdtest::BondSteps::Shared, pdtest::BondSteps::Copied, pdtest::BondSteps::Swapped}) {
    pdtest::BodyOptions options;
    options.horizon = horizon;
    options.bondSteps = steps;
    pdtest::SmallBody body(points, options);
    const auto model = DamageModelRegistry::self().create("Remaining Life", list);
    body.allocate(model->FieldIds());
    for (const auto& description : {fields::cycleIncrement(), fields::loadRange(), fields::peakLoad()})
      body.allocate({description.id()});
    auto& data = *body.block().getDataManager();
    const auto owned = body.block().getNeighborhoodData();
    const int n = owned->NumOwnedPoints();
    model->initialize(0.0, n, owned->OwnedIDs(), owned->NeighborhoodList(), data);
    PlainLives plain(points, horizon);
    for (int step = 0; step < 40; ++step) {
      const double cycles = step % 3 == 0 ? 0.0 : 40.0, range = 0.9, peak = 1.0 + 0.05 * step;
      body.deform([step](const pdtest::Point& x) { return pulled(x, step); });
      *body.field("Load_Range") = range;
      *body.field("Peak_Load") = peak;
      for (const double tried : {3.0 * cycles, cycles}) {                     // what is found last counts
        if (tried != cycles && steps == pdtest::BondSteps::Shared) continue;  // what breaks stays so
        *body.field("Cycle_Increment") = tried;
        model->precompute(tried, n, owned->OwnedIDs(), owned->NeighborhoodList(), data);
        model->computeDamage(tried, n, owned->OwnedIDs(), owned->NeighborhoodList(), data);
      }
      std::vector<pdtest::Point> places;
      for (const pdtest::Point& x : points) places.push_back(pulled(x, step));
      plain.pass(places, cycles, range, peak);
      const double *lost = body.field("Lost_Life"), *damage = body.field("Damage");
      const double *left = body.field("Life_Left"), *rate = body.field("Rate_Of_Failed");
      const int* entry = owned->NeighborhoodList();
      for (int p = 0; p < n; ++p) {
        const auto i = static_cast<std::size_t>(owned->OwnedIDs()[p]);
        EXPECT_DOUBLE_EQ(damage[i], plain.damage(i)) << step;
        EXPECT_NEAR(left[i], plain.lifeLeft(i), 1e-11) << step;
        EXPECT_NEAR(rate[i], plain.rateOfFailed(i), 1e-14) << step;
        for (int count = *entry++; count > 0; --count, ++entry, ++lost)
          EXPECT_NEAR(*lost, plain.lost(i, static_cast<std::size_t>(*entry)), 1e-11) << step;
      }
      data.updateState();
    }
    const double* damage = body.field("Damage");
    const auto nWhole = std::count(damage, damage + n, 0.0);
    EXPECT_GT(nWhole, n / 4);  // or nothing is left out
    EXPECT_LT(nWhole, n - 5);
  }
}

}  // namespace
}  // namespace pd
