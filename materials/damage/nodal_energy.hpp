// Breakage by the energy of points, so that the lattice does not hold a crack up.
#ifndef PD_NODAL_ENERGY_HPP
#define PD_NODAL_ENERGY_HPP

#include <set>
#include <string>
#include <vector>

#include "bond_damage_model.hpp"
#include "bond_family.hpp"
#include "point_arrays.hpp"
#include "rotation.hpp"
#include "stretch_kernel.hpp"
#include "surface_correction.hpp"

namespace pd {

/// Where single bonds break at their stretch or energy, a lattice holds a crack up until 1.2 to 1.7 times the fracture
/// energy is there, and bends it along its rows. Here a bond needs the energy of its neighbourhoods. With w the energy
/// of an unbroken bond along n that is stretched, and w_c what it takes to break (their sum over a plane is the
/// fracture energy), m is the direction in which a point stores most, the first principal axis of sum w n n^T, and with
/// D the part of sum w_c (n.m)^2 that is broken,
///
///   U = [sum w (n.m)^2 / sum w_c (n.m)^2 (unbroken bonds)] (1 - D) / max(0.8 - D, 0.05) / k
///
/// is the utilisation of the point: what is stretched along a crack hardly helps to open it. A bond breaks where the
/// mean U of its ends is 1 and its own stretch is at least sqrt(0.6 k) of the one with w = w_c. Bonds that were cut
/// before the run and are kept as broken count in D, those that a free surface lacks do not. k is calibrated
/// (breakageConstant in the source).
///
/// U of neighbours is needed before any bond breaks: precompute() finds it, and the host exchanges it. A host that does
/// not call precompute() is served where it has no ghosts, and told where it has.
class NodalEnergy : public BondDamageModel {
 public:
  struct Fields : BondDamageModel::Fields {
    FieldHandle modelCoordinates = reads(pd::fields::modelCoordinates());
    FieldHandle coordinates = reads(pd::fields::coordinates());
    FieldHandle volume = reads(pd::fields::volume());
    FieldHandle surfaceFactor = readsIfThere(surfaceCorrectionFactor());
    FieldHandle criticalStretch = writes(
        pd::fields::pointScalar("Nodal_Critical_Stretch", "1",
                                "Stretch of a point's bonds at which planes through it take the fracture energy."),
        Ghosts::AfterInitialize);
    FieldHandle utilisation =
        writes(pd::fields::pointScalar("Nodal_Utilisation", "1",
                                       "Energy of a point's bonds over that at which those between such points break."),
               Ghosts::AfterPrecompute);
    FieldHandle concentration;  ///< of the hydrogen, in models that know it
    /// `concentrationField`: empty where the model has none.
    explicit Fields(const std::string& concentrationField = "") {
      if (!concentrationField.empty()) concentration = reads(pd::fields::diffusingScalar(concentrationField));
    }
  };

  static void declareParameters(ParameterDeclarations& declare);
  explicit NodalEnergy(const Teuchos::ParameterList& params);

  std::string Name() const override { return "Nodal Energy"; }
  const Fields& fields() const override { return fields_; }
  void initialize(const double dt, const int numOwnedPoints, const int* ownedIDs, const int* neighborhoodList,
                  PeridigmNS::DataManager& dataManager) const override;
  void precompute(const double dt, const int numOwnedPoints, const int* ownedIDs, const int* neighborhoodList,
                  PeridigmNS::DataManager& dataManager) const override;
  /// Throws std::runtime_error where neighbours are ghosts and precompute() has not been called.
  void worsen(double dt, const Call& call, PeridigmNS::DataManager& dataManager) const override;

 protected:
  /// For derived models: `params` completed with their own declarations.
  NodalEnergy(const Teuchos::ParameterList& params, const Fields& fields, const std::string& owner);
  static void declareCommonParameters(ParameterDeclarations& declare);
  /// psi in [0, 1] of all local points, or false where the model has none.
  virtual bool coverage(PeridigmNS::DataManager&, kernels::PointArrays&) const { return false; }

  /// Factor of the critical stretch over the coverage.
  kernels::CriticalStretchLaw degradation_;

 private:
  struct Cache {
    kernels::ChunkedNeighborhood neighborhood;  ///< what it was made for
    std::vector<double> weight;                 ///< w_c of bonds, per volume of their point and stretch squared
    kernels::PointArrays coverage;
  };
  struct Views;
  struct Family;

  Cache& cacheOf(const Call& call, PeridigmNS::DataManager& dataManager, Views& views) const;
  /// Of bonds of a point of this volume.
  kernels::ElasticConstants constantsOf(double volume) const;
  kernels::Matrix3<double> storedEnergy(const Family& family, const Views& views, const Cache& cache) const;
  double utilisationOf(const Family& family, const Views& views, const Cache& cache) const;

  Fields fields_;
  std::string owner_;
  BondFamily family_;
  double youngsModulus_, poissonsRatio_, fractureEnergy_, constant_;
  kernels::ElasticConstants constants_;  ///< by integrals
  mutable NeighborhoodCache<Cache> caches_;
  // Neighbours mostly have one volume, and sums over lattices take time.
  mutable double lastVolume_ = 0.0;
  mutable kernels::ElasticConstants lastConstants_;
  mutable std::set<const PeridigmNS::DataManager*> prepared_;  ///< blocks whose utilisation is there
};

}  // namespace pd

#endif
