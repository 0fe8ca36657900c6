// An incompressible Newtonian fluid on points that stay where they are.
#include <numeric>

#include "Peridigm_Material.hpp"
#include "flow_fields.hpp"
#include "flow_law.hpp"
#include "plugins.hpp"

namespace pd {

using PeridigmNS::DataManager;

/// Gives the rate of the velocity at points that stay where they are,
///   dv/dt = -(v.grad) v + (mu lap v - grad p)/rho,
/// over bonds that reach from point to point: a wall is points that have its velocity. V_H of the viscous operator is
/// the volume of the neighbours that there are, gradients are exact for linear fields. Solvers that know where walls
/// are between the points ask for the flowLaw() and do better.
class NavierStokes : public PeridigmNS::Material, public FieldUser, public FlowMaterial {
 public:
  struct Fields : FieldTable {
    FieldHandle modelCoordinates = reads(pd::fields::modelCoordinates());
    FieldHandle volume = reads(pd::fields::volume());
    FieldHandle velocity = reads(pd::fields::velocity());
    FieldHandle pressure = reads(pd::fields::pressure());
    FieldHandle rate = adds(pd::fields::velocityRate());
    FieldHandle viscosity = writes(pd::fields::viscosity());
  };

  static void declareParameters(ParameterDeclarations& declare) {
    declare.text("Material Model", "Name of this model.").defaultTo("Navier Stokes");
    declare.real("Density", "kg/m3", "Mass density.").positive().required();
    declare.real("Viscosity", "Pa s", "Dynamic viscosity.").positive().required();
    declare
        .text("Viscous Kernel",
              "What a bond passes on of a difference of velocities: all of it (Laplacian), or what is across the bond "
              "(Transverse), which on lattices is not the same in all directions.")
        .oneOf({"Laplacian", "Transverse"})
        .defaultTo("Laplacian")
        .from("Transverse: Zhao, Larios & Bobaru, CMAME 2022, doi 10.1016/j.cma.2022.114815");
    declare
        .text("Walls",
              "How flows see them: bonds end at their Surface, with their velocity (Cut Bonds), or points beyond it "
              "have twice that less the velocity of the mirrored place (Reflected Points), which is right for linear "
              "velocities alone, for comparison.")
        .oneOf({"Cut Bonds", "Reflected Points"})
        .defaultTo("Cut Bonds");
    declare
        .real("Gradient Horizon", "m",
              "Reach of gradients, divergence and convection, at most half of the horizon, which is the default. "
              "Viscosity has the horizon of the block.")
        .positive();
    declare
        .real("Flux Horizon", "m",
              "Longest bond that moves volume from point to point, where a material carries a scalar along "
              "(Bond_Flow); by default that of gradients. On lattices of squares and cubes 1.2 spacings, the nearest "
              "neighbours alone, spread what is carried least.")
        .positive();
    declare.real("Horizon", "m", "Radius of the neighbourhood; given by the block.").positive();
    BondFamily::declareSection(declare);
    BondFamily::declareAxis(declare);
    declare.text("Volume Correction", "As of PDHE; by default none.")
        .oneOf({"Ramp Beyond Horizon", "Ramp To Horizon", "None", "Every Neighbor"})
        .defaultTo("None");
  }

  explicit NavierStokes(const Teuchos::ParameterList& given)
      : NavierStokes(given, completed<NavierStokes>(given, "material Navier Stokes")) {}

  std::string Name() const override { return "Navier Stokes"; }
  double Density() const override { return law_.density; }
  // Incompressible, and without shear stiffness; Peridigm asks every material for these.
  double BulkModulus() const override { return 0.0; }
  double ShearModulus() const override { return 0.0; }
  const FlowLaw* flowLaw() const override { return &law_; }
  const FieldTable& fields() const override { return fields_; }
  std::vector<int> FieldIds() const override { return fields_.ids(); }

  void initialize(const double, const int numOwnedPoints, const int* ownedIDs, const int*,
                  DataManager& dataManager) override {
    double* viscosity = fields_.viscosity.of(dataManager);
    for (int p = 0; p < numOwnedPoints; ++p) viscosity[ownedIDs[p]] = law_.viscosity;
  }

  void computeFluxDivergence(const double, const int numOwnedPoints, const int* ownedIDs, const int* neighborhoodList,
                             DataManager& dataManager) const override {
    double* rate = fields_.rate.of(dataManager);
    std::fill(rate, rate + fields_.rate.length(dataManager), 0.0);
    const int* list = neighborhoodList;
    for (int p = 0; p < numOwnedPoints; ++p) {
      const int count = *list++;
      addRate(ownedIDs[p], count, list, dataManager, rate + 3 * static_cast<std::size_t>(ownedIDs[p]));
      list += count;
    }
  }

 private:
  NavierStokes(const Teuchos::ParameterList& given, const Teuchos::ParameterList& params)
      : Material(given), law_(lawFrom(params)) {}

  static FlowLaw lawFrom(const Teuchos::ParameterList& params) {
    const BondFamily family(params, "material Navier Stokes");
    const double half = 0.5 * family.horizon;
    const double reach = params.isParameter("Gradient Horizon") ? params.get<double>("Gradient Horizon") : half;
    if (reach > half)
      throw std::invalid_argument("material Navier Stokes: \"Gradient Horizon\" " + std::to_string(reach) +
                                  " m is more than half of the horizon, " + std::to_string(family.horizon) +
                                  " m; gradients of neighbours must lie within it");
    if (family.rings.areUsed() && params.get<std::string>("Viscous Kernel") == "Transverse")
      throw std::invalid_argument(
          "material Navier Stokes: \"Viscous Kernel: Transverse\" is for flows without divergence in the plane, which "
          "those in a body of revolution have; take Laplacian");
    const double flux = params.isParameter("Flux Horizon") ? params.get<double>("Flux Horizon") : reach;
    if (flux > family.horizon)
      throw std::invalid_argument("material Navier Stokes: \"Flux Horizon\" " + std::to_string(flux) +
                                  " m is more than the horizon, " + std::to_string(family.horizon) + " m");
    return {params.get<double>("Density"),
            params.get<double>("Viscosity"),
            params.get<std::string>("Viscous Kernel") == "Laplacian" ? kernels::ViscousKernel::Laplacian
                                                                     : kernels::ViscousKernel::Transverse,
            reach,
            flux,
            params.get<std::string>("Walls") == "Reflected Points",
            family};
  }

  /// Bonds of a point no longer than `reach`, and the neighbours at their ends.
  kernels::BondEnds bondsWithin(double reach, int point, int count, const int* neighbors, const double* x,
                                const double* volume, std::vector<int>& ends) const {
    const auto volumeOf = [&](int i) { return law_.family.rings.planeVolume(x, volume, i); };
    kernels::BondEnds bonds;
    bonds.dimension = law_.family.dimension();
    ends.clear();
    for (int k = 0; k < count; ++k) {
      const ReferenceBond bond(x, point, neighbors[k]);
      const double share = law_.volumeOf(bond.length, volumeOf(point), volumeOf(neighbors[k]));
      if (bond.length > reach || share == 0.0) continue;
      bonds.add(bond.xi.data(), share);
      ends.push_back(neighbors[k]);
    }
    return bonds;
  }

  /// A point that lacks neighbours, as in a corner of the mesh, gets what those that it has can tell.
  void addRate(int point, int count, const int* neighbors, DataManager& data, double* rate) const {
    const double *x = fields_.modelCoordinates.of(data), *volume = fields_.volume.of(data);
    const double *velocity = fields_.velocity.of(data), *pressure = fields_.pressure.of(data);
    const auto dimension = static_cast<std::size_t>(law_.family.dimension());
    const auto difference = [&](int end, std::size_t a) { return velocity[3 * end + a] - velocity[3 * point + a]; };
    std::vector<int> ends;
    const kernels::BondEnds viscous = bondsWithin(law_.family.horizon, point, count, neighbors, x, volume, ends);
    const double whole = std::accumulate(viscous.volume.begin(), viscous.volume.end(), 0.0);
    const double alpha = kernels::viscousConstant(static_cast<int>(dimension), law_.viscousKernel);
    for (std::size_t k = 0; k < ends.size(); ++k) {
      const double length = ReferenceBond(x, point, ends[k]).length;
      const double weight = alpha / whole * viscous.volume[k] / (length * length);
      const std::array<double, 9> share = viscous.viscousShare(k, law_.viscousKernel);
      for (std::size_t a = 0; a < dimension; ++a)
        for (std::size_t b = 0; b < dimension; ++b)
          rate[a] += law_.viscosity / law_.density * weight * share[3 * a + b] * difference(ends[k], b);
    }
    const kernels::BondEnds compact = bondsWithin(law_.gradientHorizon, point, count, neighbors, x, volume, ends);
    const std::vector<double> gradient = kernels::linearGradientWeights(compact);
    // In rings lap v has d/dr v/r besides, and -v_r/r^2 along the radius.
    const double ofRings =
        law_.family.rings.areUsed() ? law_.viscosity / law_.density / law_.family.rings.radius(x, point) : 0.0;
    for (std::size_t k = 0; k < ends.size(); ++k)
      for (std::size_t b = 0; b < dimension; ++b) {
        const double weight = gradient[dimension * k + b];
        rate[b] -= weight * (pressure[ends[k]] - pressure[point]) / law_.density;
        for (std::size_t a = 0; a < dimension; ++a)
          rate[a] -= velocity[3 * point + static_cast<int>(b)] * weight * difference(ends[k], a);
        if (law_.family.rings.areUsed() && b == law_.family.rings.radial())
          for (std::size_t a = 0; a < dimension; ++a) rate[a] += ofRings * weight * difference(ends[k], a);
      }
    if (law_.family.rings.areUsed())
      rate[law_.family.rings.radial()] -= ofRings * velocity[3 * point + static_cast<int>(law_.family.rings.radial())] /
                                          law_.family.rings.radius(x, point);
  }

  FlowLaw law_;
  Fields fields_;
};

PD_REGISTER_MATERIAL(NavierStokes, "Navier Stokes", "An incompressible Newtonian fluid, for flows.")

}  // namespace pd
