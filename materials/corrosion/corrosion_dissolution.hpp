// Dissolution of a metal into an electrolyte, in which its ions diffuse.
//
// One concentration C lives on solid and liquid points; a point is liquid where its Damage is 1. Its rate is
//   liquid   sum_liquid d (C_j - C_i)/|xi|^2 V_j + sum_solid c/m_j Q_i/|xi| V_j
//   solid  - sum_liquid c/m_i Q_j/|xi| V_j
// with the flux of metal ions from the surface near liquid point j,
//   Q_j = (1 - S_j) i(C_j)/(z F) (1 - C_sat/C_solid) + B_j,
// S: share of the surface under salt, B: further flux that a solver asks for. The constant c makes the flux through a
// plane front Q exactly (kernels/bond_constants.hpp), with m < 1 at the sides of the body, where bonds are missing. A
// solid point becomes liquid at C_sat and takes that much with it, hence the last factor: the front then moves at i/(z
// F C_solid). Kinetics after Jafarzadeh, Zhao, Shakouri & Bobaru, Electrochim. Acta 401 (2022) 139512.
#ifndef PD_CORROSION_DISSOLUTION_HPP
#define PD_CORROSION_DISSOLUTION_HPP

#include "Peridigm_Material.hpp"
#include "bond_family.hpp"
#include "current_density.hpp"
#include "dissolution_kernel.hpp"
#include "point_arrays.hpp"

namespace pd {

class CorrosionDissolution : public PeridigmNS::Material {
 public:
  static void declareParameters(ParameterDeclarations& declare);
  explicit CorrosionDissolution(const Teuchos::ParameterList& params);

  std::string Name() const override { return "Corrosion Dissolution"; }
  double Density() const override;
  double BulkModulus() const override { return 0.0; }
  double ShearModulus() const override { return 0.0; }
  std::vector<int> FieldIds() const override;
  std::vector<int> FieldIdsForSynchronizationAfterInitialize() const override { return {completenessId_}; }

  /// Solid is what has more than C_sat.
  void initialize(const double dt, const int numOwnedPoints, const int* ownedIDs, const int* neighborhoodList,
                  PeridigmNS::DataManager& dataManager) override;
  void computeForce(const double, const int, const int*, const int*, PeridigmNS::DataManager&) const override {}
  void computeFluxDivergence(const double dt, const int numOwnedPoints, const int* ownedIDs,
                             const int* neighborhoodList, PeridigmNS::DataManager& dataManager) const override;
  void computeJacobian(const double dt, const int numOwnedPoints, const int* ownedIDs, const int* neighborhoodList,
                       PeridigmNS::DataManager& dataManager, PeridigmNS::SerialMatrix& jacobian,
                       JacobianType type) const override;

 private:
  CorrosionDissolution(const Teuchos::ParameterList& given, const Teuchos::ParameterList& params);  ///< completed

  struct Views;
  struct Cache {
    kernels::ChunkedNeighborhood neighborhood;
    kernels::BondConstants diffusion, dissolution;  ///< d share/|xi|^2 V_j; c share/|xi| V_j
    kernels::PhaseBonds phases;
    kernels::PointArrays concentration, lostFlux, area, perCompleteness;
  };

  Cache& cacheOf(const Call& call, const Views& views) const;
  double diffusionWeight(const ReferenceBond& bond, double volume, double neighborVolume) const;
  double dissolutionWeight(const ReferenceBond& bond, double volume, double neighborVolume) const;
  void findCompleteness(const Call& call, const Views& views) const;
  void updateInterface(Cache& cache, int nPoints) const;

  BondFamily family_, interfaceFamily_;
  double diffusivity_, solidConcentration_, saturation_, chargeNumber_;
  CurrentDensity currentDensity_;
  double microDiffusivity_ = 0.0, interfaceConstant_ = 0.0;
  int modelCoordinatesId_, volumeId_, concentrationId_, rateId_, damageId_, saltId_, demandId_, areaId_, currentId_,
      dissolutionRateId_, slopeId_, solidId_, saturationId_, completenessId_;
  mutable NeighborhoodCache<Cache> caches_;
};

}  // namespace pd

#endif
