// What a flow carries from one end of a bond to the other.
#include "advection.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace pd::kernels;

TEST(Advection, LimitedValueIsTheMeanOfEndsWhereTheSlopeIsConstant) {
  EXPECT_DOUBLE_EQ(limitedValue(1.0, 2.0, 3.0).value, 2.5);
  EXPECT_DOUBLE_EQ(limitedValue(3.0, 2.0, 1.0).value, 1.5);
}

TEST(Advection, ExtremesAreCarriedAsTheyAre) {
  EXPECT_EQ(limitedValue(1.0, 2.0, 1.5).value, 2.0);
  EXPECT_EQ(limitedValue(1.0, 1.0, 1.5).value, 1.0);
  EXPECT_EQ(limitedValue(1.0, 1.0, 1.0).value, 1.0);
}

// By p of what is behind and q of what is ahead, both from 0 to 1: then no value passes those around it.
TEST(Advection, LimitedValueIsBoundedByBothSlopes) {
  for (const double behind : {1e-12, 0.1, 1.0, 7.0})
    for (const double ahead : {1e-9, 0.3, 1.0, 50.0}) {
      const double more = limitedValue(5.0 - behind, 5.0, 5.0 + ahead).value - 5.0;
      EXPECT_GE(more, 0.0);
      EXPECT_LE(more, std::min(behind, ahead) * (1.0 + 1e-12) + 1e-15);
    }
}

TEST(Advection, DerivativesAreThoseOfTheValue) {
  const double step = 1e-6;
  for (const double far : {0.2, 1.7})
    for (const double downwind : {2.5, 0.4}) {
      const CarriedValue value = limitedValue(far, 1.0, downwind);
      const auto difference = [&](double a, double b, double c) {
        return (limitedValue(far + a, 1.0 + b, downwind + c).value -
                limitedValue(far - a, 1.0 - b, downwind - c).value) /
               (2.0 * step);
      };
      EXPECT_NEAR(value.byFar, difference(step, 0.0, 0.0), 1e-8);
      EXPECT_NEAR(value.byUpwind, difference(0.0, step, 0.0), 1e-8);
      EXPECT_NEAR(value.byDownwind, difference(0.0, 0.0, step), 1e-8);
    }
}

TEST(Advection, UpwindShare) {
  EXPECT_EQ(upwindBiasedValue(1.0, 3.0, 1.0).value, 1.0);
  EXPECT_EQ(upwindBiasedValue(1.0, 3.0, 0.0).value, 2.0);
  const CarriedValue value = upwindBiasedValue(1.0, 3.0, 0.8);
  EXPECT_DOUBLE_EQ(value.value, 1.2);
  EXPECT_DOUBLE_EQ(value.byUpwind + value.byDownwind, 1.0);
}
