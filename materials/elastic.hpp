// The linear peridynamic solid, under Peridigm's name "Elastic".
#ifndef PD_ELASTIC_HPP
#define PD_ELASTIC_HPP

#include <string>
#include <vector>

#include "Peridigm_DataManager.hpp"
#include "Peridigm_Material.hpp"
#include "bond_family.hpp"
#include "fields.hpp"
#include "linear_bonds.hpp"
#include "linear_peridynamic_solid.hpp"
#include "step_listener.hpp"

namespace pd {

/// Ordinary state-based elasticity, in plane stress, plane strain or 3D, for any Poisson's ratio (formulas:
/// kernels/linear_peridynamic_solid.hpp).
class Elastic : public PeridigmNS::Material, public FieldUser, public StepListener, public LinearBonds {
 public:
  struct Fields : FieldTable {
    FieldHandle modelCoordinates = reads(pd::fields::modelCoordinates());
    FieldHandle coordinates = reads(pd::fields::coordinates());
    FieldHandle volume = reads(pd::fields::volume());
    FieldHandle weightedVolume = writes(pd::fields::weightedVolume());
    FieldHandle dilatation = writes(pd::fields::dilatation());
    FieldHandle force = adds(pd::fields::forceDensity());
    // A damage model of the block brings them.
    FieldHandle damage = readsIfThere(pd::fields::damage());
    FieldHandle bondDamage = readsIfThere(pd::fields::bondDamage());
    FieldHandle interactionShare = readsIfThere(pd::fields::interactionShare());
    FieldHandle cellVolume = readsIfThere(pd::fields::cellVolume());
    FieldHandle energy = addsIfThere(pd::fields::storedEnergyDensity());
  };

  static void declareParameters(ParameterDeclarations& declare);
  explicit Elastic(const Teuchos::ParameterList& given);

  std::string Name() const override { return "Elastic"; }
  double Density() const override { return density_; }
  double BulkModulus() const override { return bulkModulus_; }
  double ShearModulus() const override { return shearModulus_; }
  const Fields& fields() const override { return fields_; }
  std::vector<int> FieldIds() const override { return fields_.ids(); }

  /// Computes Weighted_Volume.
  void initialize(const double, const int numOwnedPoints, const int* ownedIDs, const int* neighborhoodList,
                  PeridigmNS::DataManager& dataManager) override;
  /// Force_Density and Dilatation.
  void computeForce(const double, const int numOwnedPoints, const int* ownedIDs, const int* neighborhoodList,
                    PeridigmNS::DataManager& dataManager) const override;
  /// W of kernels::SolidConstants.
  void computeStoredElasticEnergyDensity(const double, const int numOwnedPoints, const int* ownedIDs,
                                         const int* neighborhoodList,
                                         PeridigmNS::DataManager& dataManager) const override;
  LinearSprings::Family springFamily() const override { return LinearSprings::Family::Dilatation; }
  LinearSprings springs(const Call& call, PeridigmNS::DataManager& data) const override;
  void stepTakenBack() const override {
    caches_.forEach([](Cache& cache) { cache.alive.forget(); });
  }

 private:
  struct Cache {
    kernels::ChunkedNeighborhood neighborhood;
    kernels::SolidBondData data;
    kernels::AliveBonds alive;
    kernels::PointArrays reference, volume, displacement, force;
  };
  struct Views;

  /// `params`: completed.
  Elastic(const Teuchos::ParameterList& given, const Teuchos::ParameterList& params);
  Cache makeCache(const Call& call, const Views& views) const;
  /// Influence function x share of the neighbour's volume x share that no crack or void takes.
  double influence(const Views& views, const ReferenceBond& geometry, int point, int neighbor, std::size_t bond) const;
  /// The same as the kernel, bond by bond, with bonds that are damaged in part.
  void addForceOfDamagedBonds(const Call& call, const Views& views) const;
  /// theta of owned points, in their order. Bonds that are damaged by d count 1 - d.
  std::vector<double> dilatations(const Call& call, const Views& views) const;

  BondFamily family_;
  double density_ = 0.0, bulkModulus_ = 0.0, shearModulus_ = 0.0;
  kernels::SolidConstants constants_;
  Fields fields_;
  mutable NeighborhoodCache<Cache> caches_;
};

}  // namespace pd

#endif
