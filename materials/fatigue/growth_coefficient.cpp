#include "growth_coefficient.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>
#include <stdexcept>

#include "Peridigm_InfluenceFunction.hpp"

namespace pd {

namespace {

constexpr double mostPointsPerHorizon = 6.5;  // the trial of more takes minutes

}  // namespace

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
            "found "
            "by further trials, which take ten times as long as the one for C.")
      .positive();
  declare.real("Spacing", "m", "Distance between points, for the trial.").positive();
  declare.real("Young's Modulus", "Pa", "As in the material, for the trial.").positive();
  declare.real("Poisson's Ratio", "1", "As in the material, for the trial.").strictlyBetween(-1.0, 0.5);
  BondFamily::declareParameters(declare);
  declare.needs("Paris Coefficient", {"Paris Exponent", "Spacing", "Young's Modulus", "Poisson's Ratio", "Horizon"});
  for (const char* key : {"Paris Exponent", "Paris Threshold"}) declare.needs(key, {"Paris Coefficient"});
}

GrowthCoefficient::GrowthCoefficient(const Teuchos::ParameterList& params, const std::string& owner)
    : family_(params, owner), spacing_(params.get<double>("Spacing")), paris_(params.get<double>("Paris Coefficient")) {
  trial_.horizon = family_.horizon / spacing_;
  trial_.exponent = params.get<double>("Paris Exponent");
  trial_.growthDamage = params.get<double>("Growth Damage");
  if (family_.dimension() == 1)
    throw std::invalid_argument(owner + ": a bar has no crack that grows; leave out Paris Coefficient");
  if (trial_.horizon < 2.0 || trial_.horizon > mostPointsPerHorizon)
    throw std::invalid_argument(owner + ": Horizon over Spacing is " + std::to_string(trial_.horizon) +
                                "; the trial that finds the growth coefficient takes 2 to 6.5. Choose others, or give "
                                "Growth Coefficient and Growth Exponent");
  if (family_.volumeCorrection == kernels::VolumeCorrection::EveryNeighbor)
    throw std::invalid_argument(owner +
                                ": neighbourhoods have no end for the trial; choose another Volume Correction, "
                                "or give Growth Coefficient and Growth Exponent");
  const double young = params.get<double>("Young's Modulus"), poisson = params.get<double>("Poisson's Ratio");
  const kernels::ElasticConstants constants = family_.rescalesToLattice
                                                  ? family_.latticeElasticConstants(young, poisson, spacing_)
                                                  : family_.elasticConstants(young, poisson);
  hasTangential_ = constants.tangential != 0.0;
  trial_.bonds = latticeBonds(owner);
  // The lattice against the integrals, by bonds without k_t; with it E' is that of the material.
  const kernels::Stiffness c = kernels::stiffness(family_.section.geometry, young, poisson);
  const double cell = family_.dimension() == 3 ? std::pow(spacing_, 3) : spacing_ * spacing_ * family_.section.size;
  const double ofLattice = constants.normal * cell * spacing_ * planeStiffness(trial_.bonds).fractureModulus();
  modulus_ = hasTangential_ ? (c.c11 * c.c11 - c.c12 * c.c12) / c.c11 : ofLattice;
  result_ = growthTrial(trial_);
  // A = C (E' sqrt(delta))^M / (B delta), C in Pa sqrt(m)
  const double logCore = std::log(modulus_ * 1e-6 * std::sqrt(family_.horizon));
  if (params.isParameter("Paris Threshold")) {
    thresholdRange_ = 1e6 * params.get<double>("Paris Threshold");
    threshold_ = growthThreshold(trial_);
  }
  coefficient_ = std::exp(std::log(paris_) + trial_.exponent * logCore - std::log(result_.factor * family_.horizon));
}

/// Bonds of one projection onto the plane across the front and one length are one.
std::vector<LatticeBond> GrowthCoefficient::latticeBonds(const std::string& owner) const {
  const auto influence = PeridigmNS::InfluenceFunction::self().getInfluenceFunction();
  const int reach = static_cast<int>(std::ceil(trial_.horizon)) + 1, depth = family_.dimension() == 3 ? reach : 0;
  std::vector<LatticeBond> bonds;
  for (int x = -reach; x <= reach; ++x)
    for (int y = -reach; y <= reach; ++y)
      for (int z = 0; z <= depth; ++z) {
        if (x == 0 && y == 0) continue;
        const double length = std::sqrt(x * x + y * y + z * z);
        const double share = kernels::volumeShare(family_.volumeCorrection, length, trial_.horizon, 1.0);
        const double weight = share * influence(length * spacing_, family_.horizon);
        if (weight < 0.0)
          throw std::invalid_argument(owner + ": the influence function is negative at " +
                                      std::to_string(length / trial_.horizon) +
                                      " horizons, where this Volume Correction has bonds; write \"max(..., 0)\"");
        if (weight == 0.0) continue;
        const double count = z == 0 ? 1.0 : 2.0;
        bonds.push_back({x, y, length, weight * length * count, count});
      }
  return bonds;
}

kernels::LifeLaw GrowthCoefficient::law() const {
  return kernels::LifeLaw::power(coefficient_, trial_.exponent, threshold_.limit * strainAt(thresholdRange_),
                                 threshold_.sharpness);
}

/// da/dN at a range of K in Pa sqrt(m).
double GrowthCoefficient::predicted(double range) const {
  return paris_ * std::pow(1e-6 * std::max(range - thresholdRange_, 0.0), trial_.exponent);
}

std::vector<std::string> GrowthCoefficient::notes() const {
  std::ostringstream text;
  text.precision(4);
  text << "Remaining Life: growth coefficient A2 = " << coefficient_ << ", exponent " << trial_.exponent
       << ", from da/dN = " << paris_ << " m (dK / MPa m^0.5)^" << trial_.exponent
       << " by da/dN = B A2 delta (dK / (E' "
       << "delta^0.5))^M, B = " << result_.factor << " (trial with " << trial_.horizon << " spacings a horizon, "
       << result_.nBroken << " bonds), E' = " << modulus_ << " Pa of the lattice"
       << (hasTangential_ ? ", bonds without k_t" : "");
  if (thresholdRange_ > 0.0)
    text << "; dK - dK_th in place of dK, dK_th = " << 1e-6 * thresholdRange_ << " MPa m^0.5, by a limit of "
         << threshold_.limit * strainAt(thresholdRange_) << " of bonds' strain ranges with sharpness "
         << threshold_.sharpness << ", to " << 100.0 * threshold_.deviation << " % of growth";
  text << "; predicted da/dN at dK = 10, 20, 40 MPa m^0.5: ";
  for (const double range : {10.0, 20.0, 40.0}) text << predicted(1e6 * range) << (range < 40.0 ? ", " : " m/cycle");
  return {text.str()};
}

}  // namespace pd
