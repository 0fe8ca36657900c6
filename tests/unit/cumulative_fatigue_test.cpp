// Strain-life relations, the element at a crack tip, and constants that scatter, against numbers from elsewhere.
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <vector>

#include "bond_normals.hpp"
#include "bond_thresholds.hpp"
#include "fatigue_element.hpp"
#include "life_scatter.hpp"
#include "strain_life.hpp"

namespace pd {
namespace {

using kernels::StrainLife;
using kernels::StrainMeasure;

// Ti-6Al-4V of Table 1 of the gas-pore paper (Materials 2022): E = 110 GPa, sigma_y = 988 MPa, r = 1.09 um.
const double modulus = 110e9, yieldStress = 988e6, elementLength = 1.09e-6;

StrainLife titanium(StrainMeasure measure = StrainMeasure::Amplitude) { return {measure, 1.94, -0.865, 0.00231}; }

TEST(StrainLife, LivesOfASmoothBarByTheAmplitudeForm) {
  // Stress amplitudes in MPa and lives, worked out by hand from eps_a - limit = eps_f' (2 N)^c.
  const std::vector<std::pair<double, double>> table{{260, 9.3e4}, {280, 1.68e4}, {300, 8684}, {315, 6262},
                                                     {350, 3705},  {400, 2281},   {500, 1247}, {600, 841}};
  for (const auto& [amplitude, life] : table)
    EXPECT_NEAR(1.0 / titanium().lossRate(2.0 * amplitude * 1e6 / modulus) / life, 1.0, 5e-3) << amplitude;
  EXPECT_EQ(titanium().lossRate(2.0 * 0.00231), 0.0);
}

TEST(StrainLife, IsItsOwnInverse) {
  for (const StrainMeasure measure : {StrainMeasure::Amplitude, StrainMeasure::Range})
    for (const double life : {1e2, 1e4, 1e6}) {
      const StrainLife law = titanium(measure);
      const bool isAmplitude = measure == StrainMeasure::Amplitude;
      const double strain = law.limit + law.ductility * std::pow((isAmplitude ? 2.0 : 1.0) * life, law.exponent);
      EXPECT_NEAR(1.0 / law.lossRate((isAmplitude ? 2.0 : 1.0) * strain) / life, 1.0, 1e-9) << life;
    }
}

TEST(StrainLife, NeubersRuleIsElasticUpToTwiceTheYieldStrain) {
  EXPECT_DOUBLE_EQ(kernels::neuberStrainRange(0.01, 0.009), 0.01);
  // d_sigma d_eps = E e^2 with d_sigma = 2 sigma_y
  EXPECT_DOUBLE_EQ(kernels::neuberStrainRange(0.03, 0.009), 0.03 * 0.03 / (2.0 * 0.009));
}

Teuchos::ParameterList plateOf(double horizon, double spacing) {
  Teuchos::ParameterList list;
  list.set("Element Length", elementLength);
  list.set("Yield Stress", yieldStress);
  list.set("Young's Modulus", modulus);
  list.set("Poisson's Ratio", 1.0 / 3.0);
  list.set("Plane Stress", true);
  list.set("Thickness", 1e-3);
  list.set("Horizon", horizon);
  list.set("Spacing", spacing);
  list.set("Growth Damage", 0.35);
  ParameterDeclarations declare;
  FatigueElement::declareParameters(declare);
  declare.real("Growth Damage", "1", "As in the damage model.");
  return declare.complete(list, "test");
}

TEST(FatigueElement, GrowthIsThatOfTheDerivedTable) {
  // da/dN in m at ranges of K in MPa sqrt(m), worked out by hand from r / N of the element.
  const std::vector<double> ranges{5, 8, 10, 15, 20, 30, 50};
  const std::vector<std::vector<double>> tables{{2.9e-9, 1.05e-8, 1.85e-8, 4.9e-8, 9.8e-8, 2.5e-7, 8.3e-7},
                                                {4.0e-9, 1.25e-8, 2.1e-8, 5.6e-8, 1.1e-7, 2.8e-7, 9.2e-7}};
  for (const StrainMeasure measure : {StrainMeasure::Amplitude, StrainMeasure::Range}) {
    const StrainLife life = titanium(measure);
    const FatigueElement element(plateOf(2e-3, 1e-3), life, "test");
    const std::vector<double>& table = tables[measure == StrainMeasure::Amplitude ? 0 : 1];
    for (std::size_t k = 0; k < ranges.size(); ++k)
      EXPECT_NEAR(element.growth(1e6 * ranges[k], life) / table[k], 1.0, 0.03) << ranges[k];  // two digits
  }
}

TEST(FatigueElement, ACrackOnALatticeGrowsAsTheElementFails) {
  const StrainLife life = titanium();
  for (const double specimenWidth : {0.0, 54e-3}) {
    Teuchos::ParameterList list = plateOf(3e-3, 1e-3);
    if (specimenWidth > 0.0) list.set("Specimen Width", specimenWidth);
    const FatigueElement element(list, life, "test");
    for (const double range : {8e6, 1e7, 1.5e7, 2e7, 3e7, 5e7, 1e8})
      EXPECT_NEAR(element.trialGrowth(range, life) / element.growth(range, life), 1.0, 0.06) << range;
    for (const double range : {1.8e6, 2e6, 3e6, 4e6, 5e6})  // it yields at 5.2, and has its limit at 1.33
      EXPECT_NEAR(element.trialGrowth(range, life) / element.growth(range, life), 1.0, 0.15) << range;
    EXPECT_EQ(element.trialGrowth(1.3e6, life), 0.0);
  }
}

TEST(FatigueElement, SaysFromWhichRangeBondsBesideTheTipExceedTheLimit) {
  // Williams' field of mode I in plane stress: the largest principal strain a horizon from the tip.
  const StrainLife life = titanium();
  const double horizon = 2e-3, poisson = 1.0 / 3.0;
  double largest = 0.0;
  for (double angle = 0.0; angle < 3.14; angle += 1e-3) {
    const double mean = std::cos(0.5 * angle), half = mean * std::sin(0.5 * angle);
    largest = std::max(largest, (mean + half - poisson * (mean - half)) / modulus);
  }
  const double range = life.limitOfRange() * std::sqrt(2.0 * M_PI * horizon) / largest;
  const std::string note = FatigueElement(plateOf(horizon, 1e-3), life, "test").note(life), before = "above about ";
  ASSERT_NE(note.find(before), std::string::npos) << note;
  EXPECT_NEAR(1e6 * std::stod(note.substr(note.find(before) + before.size())) / range, 1.0, 0.01);
}

TEST(BondNormals, AreThePublishedGenerator) {
  // Known answer of Philox 4x32 with ten rounds, counter and key 0, from the distribution of Random123 (kat_vectors).
  const double radius = std::sqrt(-2.0 * std::log((0x6627e8d5u + 0.5) / 4294967296.0));
  const double angle = 6.28318530717958647692 * (0xe169c58du + 0.5) / 4294967296.0;
  EXPECT_DOUBLE_EQ(kernels::bondNormals(0u, 0, 0)[0], radius * std::cos(angle));
  EXPECT_DOUBLE_EQ(kernels::bondNormals(0u, 0, 0)[1], radius * std::sin(angle));
}

TEST(BondNormals, BelongToTheBondFromEitherEndAndToItsMirrorImage) {
  constexpr int shift = 1000;
  for (int a = 0; a < 20; ++a)
    for (int b = 0; b < 20; ++b) {
      EXPECT_EQ(kernels::bondNormals(3u, a, b), kernels::bondNormals(3u, b, a));
      EXPECT_EQ(kernels::bondNormals(3u, a, b + shift, shift), kernels::bondNormals(3u, b, a + shift, shift));
      EXPECT_NE(kernels::bondNormals(3u, a, b), kernels::bondNormals(4u, a, b));
    }
  EXPECT_NE(kernels::bodyNormals(0u), kernels::bondNormals(0u, 0, 0));
}

TEST(BondNormals, AreStandardNormalAndIndependent) {
  constexpr int n = 40000;
  kernels::Normals mean{}, square{}, fourth{};
  double product = 0.0;
  for (int k = 0; k < n; ++k) {
    const kernels::Normals z = kernels::bondNormals(1u, k, k + 1);
    product += z[0] * z[1] / n;
    for (std::size_t d = 0; d < 4; ++d) {
      mean[d] += z[d] / n;
      square[d] += z[d] * z[d] / n;
      fourth[d] += std::pow(z[d], 4) / n;
    }
  }
  const double error = 4.0 / std::sqrt(n);  // four standard deviations of a mean
  EXPECT_NEAR(product, 0.0, error);
  for (std::size_t d = 0; d < 4; ++d) {
    EXPECT_NEAR(mean[d], 0.0, error);
    EXPECT_NEAR(square[d], 1.0, std::sqrt(2.0) * error);
    EXPECT_NEAR(fourth[d], 3.0, std::sqrt(96.0) * error);
  }
}

TEST(LifeScatter, LogarithmsHaveTheMedianAndTheDeviationOfTheDeck) {
  Teuchos::ParameterList list;
  list.set<std::string>("Scatter Between", "Bonds");
  list.set("Random Seed", 1);
  list.set("Scatter Of Limit", 0.1);
  list.set("Scatter Of Exponent", 0.02);
  const LifeScatter scatter(list, "test");
  constexpr int n = 10000;
  double limit = 0.0, limit2 = 0.0, exponent = 0.0;
  for (int k = 0; k < n; ++k) {
    const StrainLife own = scatter.ofBond(titanium(), k, k + 7, 0);
    EXPECT_EQ(own.ductility, titanium().ductility);
    limit += std::log(own.limit / titanium().limit) / n;
    limit2 += std::pow(std::log(own.limit / titanium().limit), 2) / n;
    exponent += std::log(own.exponent / titanium().exponent) / n;
  }
  EXPECT_NEAR(limit, 0.0, 4e-2 * 0.1);
  EXPECT_NEAR(std::sqrt(limit2), 0.1, 3e-2 * 0.1);
  EXPECT_NEAR(exponent, 0.0, 4e-2 * 0.02);
  EXPECT_EQ(scatter.ofSpecimen(titanium()).limit, titanium().limit);
}

}  // namespace
}  // namespace pd
