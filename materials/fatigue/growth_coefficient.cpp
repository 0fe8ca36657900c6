#include "growth_coefficient.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace pd {

void GrowthCoefficient::declareParameters(ParameterDeclarations& declare) {
  declare
      .real("Paris Coefficient", "m",
            "C of Paris' law: growth of a crack in a cycle of dK = 1 MPa m^0.5, in place of the Growth Coefficient, "
            "which "
            "a trial on the lattice then finds.")
      .positive();
  declare.real("Paris Exponent", "1", "M of da/dN = C dK^M.").atLeast(1.0).atMost(12.0);
  declare
      .real("Paris Threshold", "1",
            "dK_th of da/dN = C (dK - dK_th)^M, in MPa m^0.5: a crack stands below it. The bonds' law that makes it is "
            "found by further trials, which take some hundred times as long as the one for C.")
      .positive();
  GrowthLattice::declareParameters(declare);
  declare.needs("Paris Coefficient", {"Paris Exponent"});
  declare.needs("Paris Coefficient", GrowthLattice::neededKeys());
  declare.needs("Specimen Width", {"Paris Coefficient"});
  for (const char* key : {"Paris Exponent", "Paris Threshold"}) declare.needs(key, {"Paris Coefficient"});
}

GrowthCoefficient::GrowthCoefficient(const Teuchos::ParameterList& params, const std::string& owner)
    : lattice_(params, owner, "give Growth Coefficient and Growth Exponent in place of Paris Coefficient"),
      paris_(params.get<double>("Paris Coefficient")),
      exponent_(params.get<double>("Paris Exponent")) {
  const GrowthTrialCase trial = lattice_.trial(exponent_);
  result_ = growthTrial(trial);
  if (params.isParameter("Paris Threshold")) {
    thresholdRange_ = 1e6 * params.get<double>("Paris Threshold");
    threshold_ = thresholdTrial(trial);
    requireThresholdIsMet(owner);
  }
  // A = C (E' sqrt(delta))^M / (B delta), C in Pa sqrt(m)
  const double logCore = -std::log(lattice_.strainAt(1e6));
  coefficient_ = std::exp(std::log(paris_) + exponent_ * logCore - std::log(result_.factor * lattice_.horizon()));
}

void GrowthCoefficient::requireThresholdIsMet(const std::string& owner) const {
  constexpr double most = 0.25;
  if (threshold_.deviation <= most) return;
  std::ostringstream text;
  text.precision(2);
  text << owner << ": with \"Paris Exponent\" " << exponent_
       << " no law of bonds makes the growth C (dK - dK_th)^M: the best one is off by " << 100.0 * threshold_.deviation
       << " %. Exponents from 2 to 6 are met; others do without \"Paris Threshold\"";
  throw std::invalid_argument(text.str());
}

kernels::LifeLaw GrowthCoefficient::law() const {
  if (thresholdRange_ == 0.0) return kernels::LifeLaw::power(coefficient_, exponent_, 0.0);
  // The share of the horizon that the crack grows by, at the range of K that a bond reads, times chi.
  const double strainPerUnit = threshold_.law.reading * lattice_.strainAt(1e6);
  const double coefficient = paris_ / lattice_.horizon() * std::pow(strainPerUnit, -exponent_);
  return kernels::LifeLaw::power(coefficient, exponent_, limit(), threshold_.law.factor);
}

double GrowthCoefficient::limit() const { return threshold_.law.reading * lattice_.strainAt(thresholdRange_); }

/// da/dN at a range of K in Pa sqrt(m).
double GrowthCoefficient::predicted(double range) const {
  return paris_ * std::pow(1e-6 * std::max(range - thresholdRange_, 0.0), exponent_);
}

std::vector<std::string> GrowthCoefficient::notes() const {
  std::ostringstream text;
  text.precision(4);
  text << "Remaining Life: growth coefficient A2 = " << coefficient_ << ", exponent " << exponent_
       << ", from da/dN = " << paris_ << " m (dK / MPa m^0.5)^" << exponent_ << " by da/dN = B A2 delta (dK / (E' "
       << "delta^0.5))^M, B = " << result_.factor << " (trial with " << result_.nBroken << " bonds, " << lattice_.text()
       << ")";
  if (thresholdRange_ > 0.0)
    text << "; dK - dK_th in place of dK, dK_th = " << 1e-6 * thresholdRange_ << " MPa m^0.5, by a limit of " << limit()
         << " of bonds' strain ranges and factors of what is above it: within " << 100.0 * threshold_.deviation
         << " % of that growth in trials from 1.08 to 12 dK_th";
  text << "; predicted da/dN at dK = 10, 20, 40 MPa m^0.5: ";
  for (const double range : {10.0, 20.0, 40.0}) text << predicted(1e6 * range) << (range < 40.0 ? ", " : " m/cycle");
  return {text.str()};
}

}  // namespace pd
