// Dissolution of a metal into an electrolyte, in which its ions diffuse.
//
// One concentration C lives on solid and liquid points; a point is liquid where its Damage is 1. Points of blocks that
// do not dissolve (Saturation_Concentration 0) are walls. The rate of C is
//   liquid i   sum_liquid d (a_i + a_j)/2 (C_j - C_i) V_j + sum_solid c b_j Q_i V_j
//   solid i  - sum_liquid c b_i Q_j V_j
// with weights d and c of the bonds (transport_weights.hpp; d between materials: series_diffusivity.hpp), corrections a
// at walls and b of slanting fronts (phase_geometry.hpp), and the flux of metal ions from the surface near liquid point
// j,
//   Q_j = (1 - S_j) (1 - F_j) i(C_j)/(z F) (1 - C_sat/C_solid) + B_j,
// S: share of the surface under salt, F: under a film (of a condition on Film_Coverage, times the Phase Film Share), B:
// further flux that a solver asks for; i, C_solid and F of the phase that the solid end belongs to. Where phases meet,
// each gives of B what its pace is under the film (solid_phases.hpp). A plane front passes Q exactly (a trial
// calibration has c of its own and b = 1). A solid point becomes liquid at C_sat and takes that much with it, hence the
// last factor: the front then moves at i/(z F C_solid). Kinetics after Jafarzadeh, Zhao, Shakouri & Bobaru,
// Electrochim. Acta 401 (2022) 139512.
//
// In a body of revolution (kernels/rings.hpp) volumes in these sums are those of the plane, d has the share of the
// rings, and a solid ring loses what it would in the plane, so that its front moves as there; the liquid one gains
// r_solid/r_liquid of that, which is the same amount.
#ifndef PD_CORROSION_DISSOLUTION_HPP
#define PD_CORROSION_DISSOLUTION_HPP

#include "Peridigm_Material.hpp"
#include "acidity.hpp"
#include "dissolution_kernel.hpp"
#include "fields.hpp"
#include "phase_geometry.hpp"
#include "point_arrays.hpp"
#include "run_notes.hpp"
#include "series_diffusivity.hpp"
#include "solid_phases.hpp"

namespace pd {

class CorrosionDissolution : public PeridigmNS::Material, public FieldUser, public RunNotes {
 public:
  struct Fields : FieldTable {
    FieldHandle modelCoordinates = reads(pd::fields::modelCoordinates());
    FieldHandle volume = reads(pd::fields::volume());
    FieldHandle damage = reads(pd::fields::damage());
    FieldHandle concentration, diffusivity, rate;
    FieldHandle salt = reads(pd::fields::saltCoverage());
    FieldHandle demand = reads(pd::fields::dissolutionDemand());
    FieldHandle film = readsIfThere(pd::fields::filmCoverage());
    FieldHandle area = writes(pd::fields::interfaceAreaDensity());
    FieldHandle current = writes(pd::fields::currentDensity());
    FieldHandle dissolutionRate = writes(pd::fields::dissolutionRate());
    FieldHandle slope = writes(pd::fields::dissolutionRateSlope());
    FieldHandle solid = writes(pd::fields::solidConcentration());
    FieldHandle saturation = writes(pd::fields::saturationConcentration(), Ghosts::AfterInitialize);
    FieldHandle diffusionCorrection =
        writes(pd::fields::pointScalar("Diffusion_Correction", "1", "Of fluxes near walls."), Ghosts::AfterPrecompute);
    FieldHandle dissolutionCorrection =
        writes(pd::fields::pointScalar("Dissolution_Correction", "1", "Of slanting fronts."), Ghosts::AfterPrecompute);
    FieldHandle ph, blockId;
    std::string label;  ///< of the concentration
    Fields(const std::string& concentrationField, bool hasAcidity, bool hasPhases) : label(concentrationField) {
      concentration = reads(pd::fields::ionConcentration(label));
      diffusivity = writes(diffusivityOf(label), Ghosts::AfterInitialize);
      rate = adds(pd::fields::ionFluxDivergence(label));
      if (hasAcidity) ph = writes(pd::fields::pointScalar("pH", "1", "Of the electrolyte; no number in the metal."));
      if (hasPhases) blockId = reads(pd::fields::blockId());
    }
  };

  static void declareParameters(ParameterDeclarations& declare);
  static FieldTable describeFields() { return Fields("Concentration", true, true); }
  explicit CorrosionDissolution(const Teuchos::ParameterList& params);

  std::string Name() const override { return "Corrosion Dissolution"; }
  double Density() const override;
  double BulkModulus() const override { return 0.0; }
  double ShearModulus() const override { return 0.0; }
  std::vector<std::string> runNotes() const override;
  const Fields& fields() const override { return fields_; }
  std::vector<int> FieldIds() const override { return fields_.ids(); }
  std::vector<int> FieldIdsForSynchronizationAfterInitialize() const override {
    return fields_.ids(Ghosts::AfterInitialize);
  }
  std::vector<int> FieldIdsForSynchronizationAfterPrecompute() const override {
    return fields_.ids(Ghosts::AfterPrecompute);
  }

  /// Solid is what has more than C_sat.
  void initialize(const double dt, const int numOwnedPoints, const int* ownedIDs, const int* neighborhoodList,
                  PeridigmNS::DataManager& dataManager) override;
  /// Takes up which points have changed phase.
  void precompute(const double dt, const int numOwnedPoints, const int* ownedIDs, const int* neighborhoodList,
                  PeridigmNS::DataManager& dataManager) const override;
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
    kernels::BondConstants diffusion, dissolution;  ///< d V_j; c V_j (of rings, over r_i)
    kernels::PhaseBonds phases;
    kernels::PointArrays concentration, diffusionCorrection;
    std::vector<kernels::PointArrays> isOfPhase, correction, area,
        lostFlux;                                         ///< by solid phase; the first empty where there is one
    std::vector<PhaseGeometry::Surface> surface;          ///< of owned points, by local id
    kernels::PointArrays current, currentSum, weightSum;  ///< of sums over dissolving bonds, as they are needed
    std::vector<int> liquid;                              ///< owned points, where pH is kept
    std::vector<char> isListed;                           ///< by local id: in `liquid`
    bool hasAreas = false;                                ///< `area` is of the present phases
    bool isPrepared = false;         ///< precompute() has been called: it will be whenever phases change
    const double* zeroed = nullptr;  ///< rates that are 0 wherever nothing flows
    std::vector<int> ofOtherBlocks;  ///< owned points, whose rates the host may have written
  };

  Cache& cacheOf(const Call& call, const Views& views, PeridigmNS::DataManager& dataManager) const;
  /// [bonds] In parts of the material's diffusivity; empty: all 1.
  std::vector<double> relativeDiffusivities(const Call& call, const Views& views) const;
  double radius(const Views& views, int point) const;
  PhaseGeometry geometry(const Views& views, const double* damage) const;
  void takeUpPhases(double dt, Cache& cache, const Views& views) const;
  void refreshAroundChanges(Cache& cache, const Views& views) const;
  void findSurfaces(Cache& cache, const Views& views) const;
  template <class Visit>
  static void forSolid(const Cache& cache, Visit visit);
  static void sumOverDissolvingBonds(const Cache& cache, const double* values, double* sum);
  void takeUpFilms(Cache& cache, const Views& views) const;
  void findDissolutionCorrections(double dt, Cache& cache, const Views& views) const;
  void findAreas(Cache& cache, const Views& views) const;
  void findAcidity(const Cache& cache, const Views& views) const;
  /// Of a liquid point near the surface: Q of each phase into cache.lostFlux, and what it gains itself.
  bool dissolve(Cache& cache, const Views& views, int point) const;

  TransportWeights weights_;
  std::vector<double> planeVolumes_;  ///< by local id, of bodies of revolution; empty: those of the points
  double saturation_, chargeNumber_;
  SolidPhases phases_;
  Acidity acidity_;
  bool followsLoss_ = true;  ///< Damage of a solid point is the share of its metal that is gone
  Fields fields_;
  mutable NeighborhoodCache<Cache> caches_;
};

}  // namespace pd

#endif
