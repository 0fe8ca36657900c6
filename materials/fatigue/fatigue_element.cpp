#include "fatigue_element.hpp"

#include <cmath>
#include <sstream>
#include <stdexcept>

namespace pd {

void FatigueElement::declareParameters(ParameterDeclarations& declare) {
  declare
      .real("Element Length", "m",
            "r of the fatigue element block: growth of a crack while the element at its tip fails. Without it bonds "
            "beside cracks have the lives of all others.")
      .positive();
  declare.real("Yield Stress", "Pa", "Cyclic, without hardening: of the element at the tip of a crack.").positive();
  GrowthLattice::declareParameters(declare);
  declare.needs("Element Length", {"Yield Stress"});
  declare.needs("Element Length", GrowthLattice::neededKeys());
  declare.needs("Specimen Width", {"Element Length"});
  declare.needs("Yield Stress", {"Element Length"});
}

FatigueElement::FatigueElement(const Teuchos::ParameterList& params, const kernels::StrainLife& life,
                               const std::string& owner)
    : lattice_(params, owner, "leave out Element Length, for bodies in which no crack grows"),
      length_(params.get<double>("Element Length")),
      yieldStrain_(params.get<double>("Yield Stress") / params.get<double>("Young's Modulus")) {
  constexpr double pi = 3.14159265358979323846;
  elasticStrain_ = 1.0 / (params.get<double>("Young's Modulus") * std::sqrt(2.0 * pi * length_));
  if (life.limitOfRange() >= 2.0 * yieldStrain_)
    throw std::invalid_argument(owner + ": the material yields below its Strain Limit; look at both");
  const GrowthTrialCase trial = lattice_.trial(life.power());
  constexpr double mostSpacings = 4.5;  // the hundred trials of more take an hour
  if (trial.horizon > mostSpacings)
    throw std::invalid_argument(owner + ": Horizon over Spacing is " + std::to_string(trial.horizon) +
                                "; the trials that find how a crack grows by elements take 2 to 4.5. Choose others, or "
                                "leave out Element Length, for bodies in which no crack grows");
  bonds_ = elementTrial({trial, life.limitOfRange() / (2.0 * yieldStrain_)});
}

double FatigueElement::lossRate(double bondStrainRange, const kernels::StrainLife& life) const {
  const double elasticRange = elasticStrain_ * bondStrainRange / (bonds_.law.reading * lattice_.strainAt(1.0));
  const double ofElement = life.lossRate(kernels::neuberStrainRange(elasticRange, yieldStrain_));
  if (ofElement == 0.0) return 0.0;
  return length_ / lattice_.horizon() * bonds_.law.factor.at(elasticRange / (2.0 * yieldStrain_)) * ofElement;
}

double FatigueElement::growth(double intensityRange, const kernels::StrainLife& life) const {
  return length_ * life.lossRate(kernels::neuberStrainRange(elasticStrain_ * intensityRange, yieldStrain_));
}

double FatigueElement::trialGrowth(double intensityRange, const kernels::StrainLife& life) const {
  const double unit = lattice_.strainAt(intensityRange);
  const auto ofStrain = [&](double strain) { return lossRate(strain * unit, life); };
  return lattice_.horizon() * pd::trialGrowth(lattice_.trial(life.power()), ofStrain, TrialBody::Large);
}

/// dK of mode I at which the largest principal strain a horizon from the tip, in plane stress with a Poisson's ratio of
/// 1/3 at 73 degrees, is the limit: cos(a) ((1 - nu) + (1 + nu) sin(a)) K/(E sqrt(2 pi r)), a half of that angle.
double FatigueElement::rangeOfWings(const kernels::StrainLife& life) const {
  constexpr double largestOfAngles = 1.17;
  return life.limitOfRange() / (largestOfAngles * elasticStrain_ * std::sqrt(length_ / lattice_.horizon()));
}

std::string FatigueElement::note(const kernels::StrainLife& life) const {
  std::ostringstream text;
  text.precision(4);
  text << "Cumulative Fatigue: growth by r/N of elements of r = " << length_ << " m, in trials with " << lattice_.text()
       << " to " << 100.0 * bonds_.deviationAboveYield << " % where they yield and to "
       << 100.0 * bonds_.deviationBelowYield << " % where they do not"
       << "; a bond near a tip reads dK = e E' delta^0.5 / k, k = " << bonds_.law.reading;
  if (life.limit > 0.0)
    text << "; a crack stands below dK = " << 1e-6 * life.limitOfRange() / elasticStrain_
         << " MPa m^0.5, and above about " << 1e-6 * rangeOfWings(life)
         << " bonds a horizon beside its tip exceed the Strain Limit, and break in wings along its path in time";
  else
    text << "; without a Strain Limit bonds beside the path of a crack lose life, too, and break in wings along it in "
            "time";
  text << "; predicted da/dN at dK = 5, 10, 20, 50 MPa m^0.5: ";
  for (const double range : {5.0, 10.0, 20.0, 50.0})
    text << growth(1e6 * range, life) << (range < 50.0 ? ", " : " m/cycle");
  return text.str();
}

}  // namespace pd
