// The trial of uniform corrosion that finds what the bonds of a wide interface kernel must carry.
#include "../../materials/corrosion/trial_calibration.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "../../materials/corrosion/transport_weights.hpp"

namespace pd {
namespace {

using kernels::VolumeCorrection;
constexpr double pi = 3.14159265358979323846;

TEST(TrialCalibrationTest, PlaneFrontIsThatOfTheFirstMoment) {
  // A layer loses the sum over all its distances d to the front of the bonds that reach further than d, which is the
  // first moment, whatever the kernel: the speed in closed form, which the trial shares nothing with.
  for (int dimension = 1; dimension <= 3; ++dimension)
    for (const double horizon : {1.5, 3.0, 3.015, 4.0, 5.0})
      for (const bool isBox : {false, true})
        for (const auto rule : {VolumeCorrection::RampBeyondHorizon, VolumeCorrection::None}) {
          const TrialCase trial{dimension, horizon, isBox, rule, false};
          const TrialResult& result = trialCalibration(trial);
          EXPECT_NEAR(result.dissolvability * result.firstMoment, 1.0, 1e-9) << trial.description();
        }
}

TEST(TrialCalibrationTest, FirstMomentsAreThoseOfTheBonds) {
  // m = 1.5, ramp from 1 to 2: neighbours along an axis count wholly, those at sqrt(2) by 2 - sqrt(2), at sqrt(3) by
  // 2 - sqrt(3); with a box all of them are at 1.
  const double second = (2.0 - std::sqrt(2.0)) / 2.0, third = (2.0 - std::sqrt(3.0)) / 3.0;
  const auto moment = [](int dimension, bool isBox) {
    return trialCalibration({dimension, 1.5, isBox, VolumeCorrection::RampBeyondHorizon, false}).firstMoment;
  };
  EXPECT_NEAR(moment(1, false), 1.0, 1e-14);
  EXPECT_NEAR(moment(2, false), 1.0 + 2.0 * second, 1e-14);
  EXPECT_NEAR(moment(3, false), 1.0 + 4.0 * second + 4.0 * third, 1e-14);
  EXPECT_NEAR(moment(1, true), 1.0, 1e-14);
  EXPECT_NEAR(moment(2, true), 3.0, 1e-14);
  EXPECT_NEAR(moment(3, true), 9.0, 1e-14);
}

TEST(TrialCalibrationTest, TendsToTheContinuum) {
  // Integral of x/|xi|^2 over a half neighbourhood: 2 delta, pi delta^2/2.
  const auto ratio = [](int dimension, double horizon) {
    const double k =
        trialCalibration({dimension, horizon, false, VolumeCorrection::RampBeyondHorizon, false}).dissolvability;
    return k * (dimension == 2 ? 2.0 * horizon : 0.5 * pi * horizon * horizon);
  };
  for (const int dimension : {2, 3}) {
    EXPECT_NEAR(ratio(dimension, 12.0), 1.0, 0.08) << dimension;
    EXPECT_LT(std::abs(ratio(dimension, 12.0) - 1.0), 0.6 * std::abs(ratio(dimension, 6.0) - 1.0)) << dimension;
  }
}

TEST(TrialCalibrationTest, RandomBondsMakeAFrontFaster) {
  // Of a line nothing can slant; elsewhere a rough front is longer than a plane one, and by more with fewer bonds.
  for (int dimension = 1; dimension <= 3; ++dimension) {
    double before = 0.0;
    for (const double horizon : {3.0, 4.0}) {
      const TrialResult& result =
          trialCalibration({dimension, horizon, false, VolumeCorrection::RampBeyondHorizon, true});
      const double k = result.dissolvability * result.firstMoment;
      EXPECT_GT(k, dimension == 1 ? 0.999 : 0.97) << dimension << ", " << horizon;
      EXPECT_LT(k, dimension == 1 ? 1.001 : 0.9999) << dimension << ", " << horizon;
      EXPECT_GE(k, before - 1e-3);
      EXPECT_GT(result.spacings, 10.0);
      before = k;
    }
  }
}

TEST(TrialCalibrationTest, RunsOnceACase) {
  const TrialCase plane{2, 3.0, false, VolumeCorrection::RampBeyondHorizon, true};
  EXPECT_EQ(&trialCalibration(plane), &trialCalibration(plane));
  TrialCase other = plane;
  other.breaksBondsAtRandom = false;
  EXPECT_NE(&trialCalibration(plane), &trialCalibration(other));
}

TEST(TrialCalibrationTest, RefusesWhatHasNoFront) {
  EXPECT_THROW(trialCalibration({2, 0.4, false, VolumeCorrection::RampBeyondHorizon, false}), std::invalid_argument);
  EXPECT_THROW(trialCalibration({2, 4.0, false, VolumeCorrection::EveryNeighbor, false}), std::invalid_argument);
}

Teuchos::ParameterList trialList(double ratio, bool hasAxes) {
  Teuchos::ParameterList list;
  list.set("Diffusivity", 1e-9);
  list.set("Interface Kernel", std::string("Trial Calibration"));
  list.set("Plane Strain", true);
  list.set("Thickness", 0.5);
  list.set("Horizon", 4.0 * ratio);
  if (hasAxes) list.set("Horizon Axes", Teuchos::Array<double>(Teuchos::tuple(4.0 * ratio, 4.0)));
  return list;
}

TransportWeights trialWeights(const Teuchos::ParameterList& list) {
  ParameterDeclarations declarations;
  TransportWeights::declareParameters(declarations);
  return {declarations.complete(list, "a test"), "a test"};
}

TEST(TrialCalibrationTest, BondsPassTheFluxOfAPlaneFront) {
  for (const double ratio : {1.0, 5.0, 25.0})
    for (const bool breaksBonds : {false, true}) {
      TransportWeights weights = trialWeights(trialList(ratio, ratio != 1.0));
      const double volume = 0.5 * ratio;
      EXPECT_TRUE(weights.trialOutcome().empty());
      weights.fitToGrid(volume);
      weights.calibrateByTrial(breaksBonds);
      EXPECT_NE(weights.trialOutcome().find("2D, ball of 4 spacings"), std::string::npos) << weights.trialOutcome();
      const TrialResult& trial = trialCalibration({2, 4.0, false, VolumeCorrection::RampBeyondHorizon, breaksBonds});
      double passed[2] = {};
      for (int a = -5; a <= 5; ++a)
        for (int b = -5; b <= 5; ++b) {
          const double x[6] = {0.0, 0.0, 0.0, ratio * a, double(b), 0.0};
          if (a == 0 && b == 0) continue;
          const auto bond = weights.bond(x, 0, 1);
          const double flux = weights.dissolution(bond, volume, volume) * volume;
          passed[0] += 0.5 * flux * std::abs(ratio * a);
          passed[1] += 0.5 * flux * std::abs(b);
          if (ratio == 1.0) {
            const double r = std::hypot(a, b);
            const double share = std::min(std::max(4.5 - r, 0.0), 1.0);
            EXPECT_NEAR(flux, trial.dissolvability * share / (r * r), 1e-12);
          }
        }
      for (const double value : passed) EXPECT_NEAR(value, trial.dissolvability * trial.firstMoment, 1e-12) << ratio;
    }
}

TEST(TrialCalibrationTest, RefusesWhatDoesNotGoWithIt) {
  Teuchos::ParameterList list = trialList(1.0, false);
  list.set("Dissolution Range", 1.5);
  EXPECT_THROW(trialWeights(list), std::invalid_argument);
  list = trialList(1.0, false);
  list.set("Volume Correction", std::string("Every Neighbor"));
  EXPECT_THROW(trialWeights(list), std::invalid_argument);

  TransportWeights weights = trialWeights(trialList(1.0, false));
  weights.fitToGrid(0.5);
  weights.calibrateByTrial(false);
  const double x[6] = {0.0, 0.0, 0.0, 1.0, 0.0, 0.0}, alike[2] = {0.5, 0.5}, uneven[2] = {0.5, 0.6};
  const int neighbor = 1;
  EXPECT_NO_THROW(weights.checkGrid(x, alike, 0, &neighbor, 1));
  EXPECT_THROW(weights.checkGrid(x, uneven, 0, &neighbor, 1), std::invalid_argument);
  weights.fitToGrid(1e4);
  EXPECT_THROW(weights.calibrateByTrial(false), std::invalid_argument);  // the horizon is 0.03 spacings
}

}  // namespace
}  // namespace pd
