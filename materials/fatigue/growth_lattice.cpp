#include "growth_lattice.hpp"

#include <algorithm>
#include <limits>
#include <sstream>
#include <stdexcept>

#include "Peridigm_InfluenceFunction.hpp"

namespace pd {

namespace {

constexpr double mostPointsPerHorizon = 6.5;  // the trial of more takes minutes
// Of a specimen's width: the crack of a shorter one is not half as long; the trial of more spacings takes minutes.
constexpr double leastHorizons = 12.0, mostSpacings = 240.0;

}  // namespace

void GrowthLattice::declareParameters(ParameterDeclarations& declare) {
  declare.real("Spacing", "m", "Distance between points, for the trial.").positive();
  declare.real("Young's Modulus", "Pa", "As in the material, for the trial.").positive();
  declare.real("Poisson's Ratio", "1", "As in the material, for the trial.").strictlyBetween(-1.0, 0.5);
  declare
      .real("Specimen Width", "m",
            "W of the compact tension specimen (ASTM E647) in which growth is to be what the constants say, at half of "
            "W, with the bonds of this horizon, which see more there than K. Where it is not given: in a body large "
            "beside the horizon.")
      .positive();
  BondFamily::declareParameters(declare);
}

std::vector<std::string> GrowthLattice::neededKeys() {
  return {"Spacing", "Young's Modulus", "Poisson's Ratio", "Horizon"};
}

GrowthLattice::GrowthLattice(const Teuchos::ParameterList& params, const std::string& owner,
                             const std::string& otherwise)
    : owner_(owner), otherwise_(otherwise), family_(params, owner), spacing_(params.get<double>("Spacing")) {
  trial_.horizon = family_.horizon / spacing_;
  trial_.growthDamage = params.get<double>("Growth Damage");
  if (family_.dimension() == 1) throw std::invalid_argument(owner_ + ": a bar has no crack that grows; " + otherwise_);
  if (trial_.horizon < 2.0 || trial_.horizon > mostPointsPerHorizon)
    throw std::invalid_argument(owner_ + ": Horizon over Spacing is " + std::to_string(trial_.horizon) +
                                "; the trial that finds how a crack grows takes 2 to 6.5. Choose others, or " +
                                otherwise_);
  if (family_.volumeCorrection == kernels::VolumeCorrection::EveryNeighbor)
    throw std::invalid_argument(
        owner_ + ": neighbourhoods have no end for the trial; choose another Volume Correction, or " + otherwise_);
  if (params.isParameter("Specimen Width")) setSpecimenWidth(params.get<double>("Specimen Width"));
  const double young = params.get<double>("Young's Modulus"), poisson = params.get<double>("Poisson's Ratio");
  const kernels::ElasticConstants constants = family_.rescalesToLattice
                                                  ? family_.latticeElasticConstants(young, poisson, spacing_)
                                                  : family_.elasticConstants(young, poisson);
  hasTangential_ = constants.tangential != 0.0;
  trial_.bonds = latticeBonds();
  // The lattice against the integrals, by bonds without k_t; with it E' is that of the material.
  const kernels::Stiffness c = kernels::stiffness(family_.section.geometry, young, poisson);
  const double cell = family_.dimension() == 3 ? std::pow(spacing_, 3) : spacing_ * spacing_ * family_.section.size;
  const double ofLattice = constants.normal * cell * spacing_ * planeStiffness(trial_.bonds).fractureModulus();
  modulus_ = hasTangential_ ? (c.c11 * c.c11 - c.c12 * c.c12) / c.c11 : ofLattice;
}

void GrowthLattice::setSpecimenWidth(double width) {
  trial_.specimenWidth = width / family_.horizon;
  if (trial_.specimenWidth < leastHorizons)
    throw std::invalid_argument(owner_ + ": Specimen Width is " + std::to_string(trial_.specimenWidth) +
                                " horizons; a crack of half of it takes 12. Choose a smaller horizon, or leave it out");
  if (width > mostSpacings * spacing_)
    throw std::invalid_argument(owner_ + ": Specimen Width is " + std::to_string(width / spacing_) +
                                " spacings; the trial takes up to 240. Leave it out: such a body is large beside the "
                                "horizon");
}

/// Bonds of one projection onto the plane across the front and one length are one. Those that the influence function
/// leaves without stiffness are neighbours that tire and count in damage all the same.
std::vector<LatticeBond> GrowthLattice::latticeBonds() const {
  const auto influence = PeridigmNS::InfluenceFunction::self().getInfluenceFunction();
  const int reach = static_cast<int>(std::ceil(trial_.horizon)) + 1, depth = family_.dimension() == 3 ? reach : 0;
  std::vector<LatticeBond> bonds;
  for (int x = -reach; x <= reach; ++x)
    for (int y = -reach; y <= reach; ++y)
      for (int z = 0; z <= depth; ++z) {
        if (x == 0 && y == 0) continue;
        const double length = std::sqrt(x * x + y * y + z * z);
        const double share = kernels::volumeShare(family_.volumeCorrection, length, trial_.horizon, 1.0);
        if (share == 0.0) continue;
        const double weight = share * influence(length * spacing_, family_.horizon);
        if (weight < 0.0)
          throw std::invalid_argument(owner_ + ": the influence function is negative at " +
                                      std::to_string(length / trial_.horizon) +
                                      " horizons, where this Volume Correction has bonds; write \"max(..., 0)\"");
        const double count = z == 0 ? 1.0 : 2.0;
        bonds.push_back({x, y, length, weight * length * count, count});
      }
  return bonds;
}

GrowthTrialCase GrowthLattice::trial(double exponent) const {
  GrowthTrialCase made = trial_;
  made.exponent = exponent;
  return made;
}

void GrowthLattice::requireSpacing(const Call& call, const double* modelCoordinates) const {
  constexpr double tolerance = 0.05;
  double shortest = std::numeric_limits<double>::infinity();
  forEachBond(call, [&](int i, int j, std::size_t) {
    shortest = std::min(shortest, ReferenceBond(modelCoordinates, i, j).length);
  });
  if (std::isfinite(shortest) && std::abs(shortest / spacing_ - 1.0) > tolerance)
    throw std::invalid_argument(owner_ + ": \"Spacing\" is " + std::to_string(spacing_) +
                                " m, but the shortest bond of the block has " + std::to_string(shortest) +
                                " m; give that, or, on meshes that are no lattice of squares or cubes, " + otherwise_);
}

std::string GrowthLattice::text() const {
  std::ostringstream text;
  text.precision(4);
  text << trial_.horizon << " spacings a horizon, E' = " << modulus_ << " Pa of the lattice";
  if (trial_.specimenWidth > 0.0) text << ", in a compact tension specimen of " << trial_.specimenWidth << " horizons";
  text << (hasTangential_ ? ", bonds without k_t" : "");
  return text.str();
}

}  // namespace pd
