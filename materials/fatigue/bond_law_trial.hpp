// What bonds near a crack tip must lose so that the crack grows by a law that is no power of the range of K.
#ifndef PD_BOND_LAW_TRIAL_HPP
#define PD_BOND_LAW_TRIAL_HPP

#include <functional>

#include "growth_trial.hpp"
#include "life_law.hpp"

namespace pd {

/// g: wanted growth over the range x of K, in a unit of its own; 0 where the crack is to stand.
using GrowthLaw = std::function<double(double)>;

/// A bond of the strain range e reads the range x = e E' sqrt(delta) / k and loses chi(x) g(x) of its life in a cycle.
/// All bonds near the tip have a part in growth, each with a reading of its own, so that the law of bonds bends more
/// sharply than that of the crack: chi makes up for it.
struct BondLaw {
  double reading = 1.0;         ///< k
  kernels::FactorTable factor;  ///< chi over x
};

/// Growth in a body at a range of K, in horizons a cycle, over g there.
double growthRatio(const GrowthTrialCase& trial, const GrowthLaw& wanted, const BondLaw& law, double range,
                   TrialBody body);

/// Corrects each factor for part of the deviation at its range, as if the others were right, and so that bonds lose
/// more at larger ranges. Bonds break in another order with each law: to be repeated. Returns the largest deviation
/// before, a logarithm.
double improve(const GrowthTrialCase& trial, const GrowthLaw& wanted, BondLaw& law, TrialBody body,
               double correctedPart);

/// The same of deviations half-way between the ranges, too, which holds together what the order in which bonds break
/// sets apart: twice the trials. Bonds may lose less than at a smaller range, since growth that bends sharply is no sum
/// over bonds whose losses all rise.
double improveBetween(const GrowthTrialCase& trial, const GrowthLaw& wanted, BondLaw& law, TrialBody body,
                      double correctedPart);

}  // namespace pd

#endif
