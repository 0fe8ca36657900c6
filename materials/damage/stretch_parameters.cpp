#include "stretch_parameters.hpp"

#include "Peridigm_InfluenceFunction.hpp"
#include "bond_constants.hpp"

namespace pd {

void declareCriticalStretch(ParameterDeclarations& declare) {
  declare.text("Damage Model", "Name of this model.");
  declare.real("Critical Stretch", "1", "Stretch (change of length / length) at which a bond breaks.").positive();
  declare
      .real("Fracture Energy", "J/m2",
            "Energy to open a unit area of crack, in place of the critical stretch; needs the constants below. It is "
            "the work to break all bonds across a plane. A crack needs more: points hold it up, so that it grows at "
            "1.2 to 1.7 times this energy with 3 or 4 spacings a horizon, and it bends along rows of points, by 20 "
            "degrees. Nodal Energy does neither.")
      .positive();
  declare.real("Young's Modulus", "Pa", "Young's modulus, for Fracture Energy.").positive();
  declare.real("Poisson's Ratio", "1", "Poisson's ratio, for Fracture Energy.").strictlyBetween(-1.0, 0.5);
  declare.real("Horizon", "m", "Horizon of the block, for Fracture Energy.").positive();
  declare.flag("Plane Stress", "As in the material, for Fracture Energy.").defaultTo(false);
  declare.flag("Plane Strain", "As in the material, for Fracture Energy.").defaultTo(false);
  declare.flag("One Dimensional", "As in the material, for Fracture Energy.").defaultTo(false);
  declare.exactlyOneOf({"Critical Stretch", "Fracture Energy"});
  declare.needs("Fracture Energy", {"Young's Modulus", "Poisson's Ratio", "Horizon"});
  declare.atMostOneOf({"Plane Stress", "Plane Strain", "One Dimensional"});
}

double criticalStretchFrom(const Teuchos::ParameterList& params) {
  if (params.isParameter("Critical Stretch")) return params.get<double>("Critical Stretch");
  kernels::Section section;
  if (params.get<bool>("Plane Stress")) section.geometry = kernels::Geometry::PlaneStress;
  if (params.get<bool>("Plane Strain")) section.geometry = kernels::Geometry::PlaneStrain;
  if (params.get<bool>("One Dimensional")) section.geometry = kernels::Geometry::Bar;
  return kernels::criticalStretch(section, params.get<double>("Young's Modulus"), params.get<double>("Poisson's Ratio"),
                                  params.get<double>("Fracture Energy"), params.get<double>("Horizon"),
                                  PeridigmNS::InfluenceFunction::self().getInfluenceFunction());
}

}  // namespace pd
