#include "bond_family.hpp"

#include <algorithm>
#include <stdexcept>

#include "Peridigm_InfluenceFunction.hpp"

namespace pd {

namespace {

/// |k_t| below this share of k_n is taken as none: nu within about 0.0005 of bond-based PD's.
constexpr double negligibleTangentialShare = 1e-3;

}  // namespace

void BondFamily::declarePlane(ParameterDeclarations& declare) {
  declare.flag("Plane Stress", "Thin plate in the x-y plane, free of stress across its thickness.").defaultTo(false);
  declare.flag("Plane Strain", "Slice of a thick body, without strain along z.").defaultTo(false);
  declare.real("Thickness", "m", "Thickness of a plane problem (volumes of the mesh are area x thickness).")
      .positive()
      .defaultTo(1.0);
}

void BondFamily::declareSection(ParameterDeclarations& declare) {
  declarePlane(declare);
  declare.flag("One Dimensional", "Bar along x.").defaultTo(false);
  declare.real("Cross Section Area", "m2", "Cross-section of a bar (volumes of the mesh are length x area).")
      .positive()
      .defaultTo(1.0);
  declare.atMostOneOf({"Plane Stress", "Plane Strain", "One Dimensional"});
}

void BondFamily::declareAxis(ParameterDeclarations& declare) {
  declare
      .text(
          axisOfRevolution,
          "Points are half of a section of a body of revolution about this axis, and volumes those of rings; given by "
          "Discretization.")
      .oneOf({"x", "y"});
}

void BondFamily::declareGeometry(ParameterDeclarations& declare) {
  declare.real("Horizon", "m", "Radius of the neighbourhood: that of the block, which materials get from it.")
      .positive();
  declareSection(declare);
  declare
      .text("Volume Correction",
            "Which share of a neighbour's cell counts near the horizon: linear between horizon -/+ half a spacing "
            "(Ramp Beyond Horizon; needs neighbours up to there), the same but nothing beyond the horizon (Ramp To "
            "Horizon), all of it up to the horizon (None), or of every neighbour, however far (Every Neighbor).")
      .oneOf({"Ramp Beyond Horizon", "Ramp To Horizon", "None", "Every Neighbor"})
      .defaultTo("Ramp Beyond Horizon")
      .from("Hu, Ha & Bobaru, CMAME 217-220 (2012) 247; Madenci & Oterkus, Peridynamic Theory (2014)");
}

void BondFamily::declareParameters(ParameterDeclarations& declare) {
  declareGeometry(declare);
  declare
      .flag("Lattice Rescaling",
            "Constants from the sums over the actual square or cubic lattice in place of integrals, so that bulk "
            "Young's modulus, Poisson's ratio and diffusivity are exact.")
      .defaultTo(false);
}

BondFamily::BondFamily(const Teuchos::ParameterList& params, const std::string& owner) {
  if (!params.isParameter("Horizon"))
    throw std::invalid_argument(owner + ": \"Horizon\" is missing (the block gives it to its material)");
  horizon = params.get<double>("Horizon");
  const auto is = [&](const char* flag) { return params.isParameter(flag) && params.get<bool>(flag); };
  if (is("Plane Stress"))
    section = {kernels::Geometry::PlaneStress, params.get<double>("Thickness")};
  else if (is("Plane Strain"))
    section = {kernels::Geometry::PlaneStrain, params.get<double>("Thickness")};
  else if (is("One Dimensional"))
    section = {kernels::Geometry::Bar, params.get<double>("Cross Section Area")};
  if (params.isParameter(axisOfRevolution)) {
    rings = kernels::Rings(params.get<std::string>(axisOfRevolution));
    section = {kernels::Geometry::PlaneStrain, 1.0};
  }
  const std::string rule = params.get<std::string>("Volume Correction");
  if (rule == "Every Neighbor") volumeCorrection = kernels::VolumeCorrection::EveryNeighbor;
  if (rule == "None") volumeCorrection = kernels::VolumeCorrection::None;
  if (rule == "Ramp To Horizon") volumeCorrection = kernels::VolumeCorrection::RampToHorizon;
  rescalesToLattice = is("Lattice Rescaling");
}

double BondFamily::latticeSpacing(const Call& call, const double* volume, const std::string& owner) const {
  if (call.nOwned == 0) return horizon / 3.0;
  double low = volume[call.ownedIds[0]], high = low;
  for (int p = 0; p < call.nOwned; ++p) {
    low = std::min(low, volume[call.ownedIds[p]]);
    high = std::max(high, volume[call.ownedIds[p]]);
  }
  if (spacing(high) > 1.01 * spacing(low))
    throw std::invalid_argument(
        owner + ": \"Lattice Rescaling\" needs a uniform lattice, but the spacings of this mesh differ (" +
        std::to_string(spacing(low) / spacing(high)) +
        " smallest/largest); use \"Surface Correction: Energy Method\" on such meshes");
  return spacing(low);
}

kernels::ElasticConstants BondFamily::elasticConstants(double youngsModulus, double poissonsRatio) const {
  kernels::ElasticConstants constants = kernels::elasticConstants(
      section, youngsModulus, poissonsRatio, horizon, PeridigmNS::InfluenceFunction::self().getInfluenceFunction());
  if (std::abs(constants.tangential) < negligibleTangentialShare * constants.normal) constants.tangential = 0.0;
  return constants;
}

kernels::ElasticConstants BondFamily::latticeElasticConstants(double youngsModulus, double poissonsRatio,
                                                              double spacing) const {
  const bool isBondBased = elasticConstants(youngsModulus, poissonsRatio).tangential == 0.0;
  return kernels::latticeElasticConstants(section, youngsModulus, poissonsRatio, horizon, spacing, volumeCorrection,
                                          PeridigmNS::InfluenceFunction::self().getInfluenceFunction(), isBondBased);
}

std::vector<InterfaceBond> findInterfaceBonds(const Call& call, const double* blockId) {
  std::vector<InterfaceBond> found;
  forEachBond(call, [&](int point, int neighbor, std::size_t bond) {
    if (blockId[point] != blockId[neighbor]) found.push_back({point, neighbor, bond});
  });
  return found;
}

}  // namespace pd
