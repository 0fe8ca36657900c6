// The mechanics of PDHE: the two-parameter bond model of kernels/two_parameter_bond.hpp as a part of a material.
#ifndef PD_BOND_MECHANICS_HPP
#define PD_BOND_MECHANICS_HPP

#include <unordered_map>
#include <vector>

#include "Peridigm_DataManager.hpp"
#include "Peridigm_SerialMatrix.hpp"
#include "alive_bonds.hpp"
#include "bond_family.hpp"
#include "fields.hpp"
#include "lattice_stability.hpp"
#include "linear_bonds.hpp"
#include "point_arrays.hpp"
#include "two_parameter_bond.hpp"

namespace pd {

enum class SurfaceCorrection { None, VolumeMethod, EnergyMethod };

class BondMechanics {
 public:
  struct Fields : FieldTable {
    FieldHandle modelCoordinates = reads(pd::fields::modelCoordinates());
    FieldHandle coordinates = reads(pd::fields::coordinates());
    FieldHandle volume = reads(pd::fields::volume());
    FieldHandle blockId = reads(pd::fields::blockId());
    FieldHandle force = adds(pd::fields::forceDensity());
    // A damage model of the block brings them.
    FieldHandle damage = readsIfThere(pd::fields::damage());
    FieldHandle bondDamage = readsIfThere(pd::fields::bondDamage());
    FieldHandle interactionShare = readsIfThere(pd::fields::interactionShare());
    FieldHandle cellVolume = readsIfThere(pd::fields::cellVolume());
    FieldHandle energy = addsIfThere(pd::fields::storedEnergyDensity());
    FieldHandle familyVolume, surfaceFactor;
    explicit Fields(SurfaceCorrection correction);
  };

  static void declareParameters(ParameterDeclarations& declare);
  /// `params`: completed. Throws std::invalid_argument.
  BondMechanics(const Teuchos::ParameterList& params, const BondFamily& family, const std::string& owner);

  double youngsModulus() const { return youngsModulus_; }
  double poissonsRatio() const { return poissonsRatio_; }
  const Fields& fields() const { return fields_; }

  /// Computes the surface correction of points; checks stability where k_t < 0.
  void initialize(const Call& call, PeridigmNS::DataManager& dataManager);
  void computeForce(const Call& call, PeridigmNS::DataManager& dataManager) const;
  void computeStoredElasticEnergyDensity(const Call& call, PeridigmNS::DataManager& dataManager) const;
  /// Adds d(force)/d(displacement), each row times the volume of its point, where the displacement is unknown.
  void computeJacobian(const Call& call, PeridigmNS::DataManager& dataManager,
                       PeridigmNS::SerialMatrix& jacobian) const;
  /// Of small displacements (LinearBonds).
  LinearSprings springs(const Call& call, PeridigmNS::DataManager& dataManager) const;
  LinearSprings::Family springFamily() const;
  /// Bonds were put back: all are read again.
  void forgetBonds() const {
    caches_.forEach([](Cache& cache) { cache.alive.forget(); });
  }

 private:
  struct Cache {
    kernels::ChunkedNeighborhood neighborhood;
    kernels::BondForceData data;
    kernels::AliveBonds alive;
    kernels::PointArrays reference, volume, displacement, force;
    std::vector<InterfaceBond> interfaceBonds;
  };
  struct Views;

  Cache makeCache(const Call& call, const Views& views, bool foldsDamage) const;
  void addForce(Cache& cache, const Views& views) const;
  /// Moves half of what the kernel gave to the point of a bond between blocks, whose neighbour may have computed
  /// another force, to the neighbour, with the opposite sign.
  void addInterfaceForce(const Cache& cache, const Views& views) const;
  /// g of a bond: influence x share of volume x surface factor x share that no crack or void takes.
  double strength(const Views& views, const ReferenceBond& geometry, int point, int neighbor, std::size_t bond) const;
  double surfaceFactor(const Views& views, const ReferenceBond& bond, int point, int neighbor) const;
  /// Of a point of this volume inside a lattice of such points.
  double wholeFamilyVolume(double volume) const;
  void computeSurfaceData(const Call& call, const Views& views) const;
  /// Calls visit(point, its unbroken bonds in the current state).
  template <class Visit>
  void forEachFamily(const Call& call, const Views& views, Visit visit) const;
  void checkStability(const Call& call, const Views& views) const;
  std::vector<kernels::WeightedBond> familyOf(int point, const int* neighbors, int count, const Views& views) const;

  std::string owner_;
  BondFamily family_;
  double youngsModulus_ = 0.0, poissonsRatio_ = 0.0;
  kernels::ElasticConstants constants_;
  kernels::TangentialForm form_ = kernels::TangentialForm::Objective;
  SurfaceCorrection surfaceCorrection_ = SurfaceCorrection::None;
  Fields fields_;
  /// By volume of the point: of a mesh, many that differ by rounding.
  mutable std::unordered_map<double, double> wholeFamilyVolumes_;
  mutable NeighborhoodCache<Cache> caches_;
};

}  // namespace pd

#endif
