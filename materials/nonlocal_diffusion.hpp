// Nonlocal diffusion of a scalar field as a part of a material.
#ifndef PD_NONLOCAL_DIFFUSION_HPP
#define PD_NONLOCAL_DIFFUSION_HPP

#include <string>
#include <vector>

#include "Peridigm_DataManager.hpp"
#include "Peridigm_SerialMatrix.hpp"
#include "alive_bonds.hpp"
#include "bond_family.hpp"
#include "damage_views.hpp"
#include "diffusion_kernel.hpp"
#include "point_arrays.hpp"
#include "series_diffusivity.hpp"

namespace pd {

/// dC/dt = sum_j d kernel(|xi|) (C_j - C_i) (share of) V_j, constants in kernels/bond_constants.hpp. Fluxes are
/// pairwise antisymmetric: the integral of C over the body changes through prescribed values alone. Where blocks differ
/// in their diffusivity, d of a bond is that of the resistances along it (series_diffusivity.hpp).
class NonlocalDiffusion {
 public:
  struct Fields : FieldTable {
    FieldHandle modelCoordinates = reads(pd::fields::modelCoordinates());
    FieldHandle volume = reads(pd::fields::volume());
    FieldHandle blockId = reads(pd::fields::blockId());
    FieldHandle damage = readsIfThere(pd::fields::damage());
    FieldHandle bondDamage = readsIfThere(pd::fields::bondDamage());
    FieldHandle interactionShare = readsIfThere(pd::fields::interactionShare());
    FieldHandle cellVolume = readsIfThere(pd::fields::cellVolume());
    FieldHandle concentration, diffusivity, rate;
    std::string diffusingField;
    explicit Fields(const std::string& label) : diffusingField(label) {
      diffusivity = writes(diffusivityOf(label), Ghosts::AfterInitialize);
      concentration = reads(pd::fields::diffusingScalar(label));
      rate = adds(pd::fields::fluxDivergence(label));
    }
  };

  /// Of bonds between blocks: the resistances along them in series, the same flux to both ends; or to each end what its
  /// own block says.
  enum class Interface { Series, OwnConstants };
  /// What the flux of a bond is multiplied with: the (share of the) volume of the neighbour, or weights fitted to each
  /// neighbourhood (kernels/meshfree_quadrature.hpp), whose fluxes are not balanced.
  enum class Quadrature { Volumes, Fitted };

  static void declareParameters(ParameterDeclarations& declare);
  NonlocalDiffusion(const Teuchos::ParameterList& params, const BondFamily& family, const std::string& owner,
                    Interface interface = Interface::Series, Quadrature quadrature = Quadrature::Volumes);

  const Fields& fields() const { return fields_; }
  void initialize(const Call& call, PeridigmNS::DataManager& dataManager);
  void computeFluxDivergence(const Call& call, PeridigmNS::DataManager& dataManager) const;
  /// Adds d(rate)/d(C), each row times the volume of its point, where C is an unknown.
  void computeJacobian(const Call& call, PeridigmNS::DataManager& dataManager,
                       PeridigmNS::SerialMatrix& jacobian) const;
  /// Bonds were put back: all are read again.
  void forgetBonds() const {
    caches_.forEach([](Cache& cache) { cache.alive.forget(); });
  }

 private:
  /// A bond whose flux its point works out for both ends: rate_neighbor += rateConstant (C_point - C_neighbor).
  struct SharedBond {
    InterfaceBond ends;
    double rateConstant;
  };
  struct Cache {
    kernels::ChunkedNeighborhood neighborhood;
    kernels::BondConstants weights;
    kernels::AliveBonds alive;
    kernels::PointArrays concentration;
    std::vector<SharedBond> sharedBonds;
  };
  /// What a neighbourhood multiplies and adds up, apart from C.
  struct Quantities {
    const double *x, *volume, *blockId;
    std::vector<double> ofPlane;     ///< in bodies of revolution, volumes of the plane, which `volume` then are
    const double* cellVolume;        ///< volume where the deck has no voids
    const double* interactionShare;  ///< null: all of every bond
    std::vector<double> fitted;      ///< of fittedWeights()
    std::vector<double> relative;    ///< of seriesDiffusivities(); empty: all 1
  };
  /// Rate constants of a bond, 1/s: with which its flux counts at its point, and at its neighbour as far as the point
  /// sees to that.
  struct RateConstants {
    double own, neighbor;
  };

  /// d kernel(|xi|) share; times the neighbour's volume it is the rate constant of the bond, 1/s.
  double weight(const Quantities& of, const ReferenceBond& geometry, int i, int j, std::size_t bond) const;
  /// [bonds] Fitted weights, m3; empty where volumes are taken. Throws std::invalid_argument.
  std::vector<double> fittedWeights(const Call& call, const double* x) const;
  Quantities quantities(const Call& call, PeridigmNS::DataManager& dataManager) const;
  RateConstants rateConstants(const Quantities& of, int i, int j, std::size_t bond) const;
  Cache makeCache(const Call& call, const Quantities& of) const;
  /// Broken bonds, where they carry no flux.
  DamageViews cuts(PeridigmNS::DataManager& dataManager) const;

  std::string owner_;
  BondFamily family_;
  Interface interface_;
  Quadrature quadrature_;
  kernels::DiffusionKernel kernel_ = kernels::DiffusionKernel::InverseSquare;
  double diffusivity_ = 0.0, microDiffusivity_ = 0.0;
  bool stopsAtBrokenBonds_ = false;
  Fields fields_;
  mutable NeighborhoodCache<Cache> caches_;
};

}  // namespace pd

#endif
