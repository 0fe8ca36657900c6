// Geometry of bonds as every bond-based material of this library sees it: section, horizon, share of volume.
#ifndef PD_BOND_FAMILY_HPP
#define PD_BOND_FAMILY_HPP

#include <Teuchos_ParameterList.hpp>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "bond_constants.hpp"
#include "neighborhood_cache.hpp"
#include "parameters.hpp"
#include "rings.hpp"

namespace pd {

/// Parameters that describe the section and the quadrature, and what follows from them for one bond.
struct BondFamily {
  kernels::Section section;
  kernels::Rings rings;  ///< where there are any, the section is a plane 1 m thick: planeVolume()s are its volumes
  kernels::VolumeCorrection volumeCorrection = kernels::VolumeCorrection::RampBeyondHorizon;
  double horizon = 0.0;
  bool rescalesToLattice = false;

  static void declareParameters(ParameterDeclarations& declare);
  /// Plane stress or strain and the thickness alone.
  static void declarePlane(ParameterDeclarations& declare);
  /// The same, and bars.
  static void declareSection(ParameterDeclarations& declare);
  /// That the points may be half of a section of a body of revolution.
  static void declareAxis(ParameterDeclarations& declare);
  /// All but Lattice Rescaling, for materials that need none.
  static void declareGeometry(ParameterDeclarations& declare);
  /// From a completed list; what a material does not declare of these it does not have. Throws std::invalid_argument,
  /// naming `owner`.
  BondFamily(const Teuchos::ParameterList& params, const std::string& owner);

  int dimension() const { return kernels::dimensionOf(section.geometry); }
  double spacing(double volume) const {
    if (volume != lastVolume) lastSpacing = kernels::spacingOf(lastVolume = volume, section);
    return lastSpacing;
  }
  /// Share of the cell of either end that the other one sees; the same from both ends.
  double share(double distance, double volume, double neighborVolume) const {
    return kernels::volumeShare(volumeCorrection, distance, horizon, 0.5 * (spacing(volume) + spacing(neighborVolume)));
  }
  /// What the flux of the bond from i to j, or `part` of it, is multiplied by at i (kernels/rings.hpp); 1 in bodies
  /// that are not of revolution. `volume`, `neighborVolume`: of the plane.
  double ringShare(const double* x, int i, int j, double volume, double neighborVolume, double part = 1.0) const {
    return rings.areUsed() ? rings.share(x, i, j, 0.5 * (spacing(volume) + spacing(neighborVolume)), part) : 1.0;
  }
  /// Spacing of a uniform lattice, for rescaled constants. Throws std::invalid_argument where spacings differ by more
  /// than 1 %.
  double latticeSpacing(const Call& call, const double* volume, const std::string& owner) const;
  /// Constants of the two-parameter bond; k_t is 0 where it is next to nothing.
  kernels::ElasticConstants elasticConstants(double youngsModulus, double poissonsRatio) const;
  /// The same from sums over an ideal lattice of this spacing.
  kernels::ElasticConstants latticeElasticConstants(double youngsModulus, double poissonsRatio, double spacing) const;

  // Neighbours mostly have one volume, and roots take time.
  mutable double lastVolume = 0.0, lastSpacing = 0.0;
};

/// The bond from `point` to `neighbor` in the reference configuration.
struct ReferenceBond {
  std::array<double, 3> xi;
  double length;
  ReferenceBond(const double* x, int point, int neighbor) {
    double length2 = 0.0;
    for (std::size_t d = 0; d < 3; ++d) {
      xi[d] = x[3 * static_cast<std::size_t>(neighbor) + d] - x[3 * static_cast<std::size_t>(point) + d];
      length2 += xi[d] * xi[d];
    }
    length = std::sqrt(length2);
  }
};

/// Calls visit(point, neighbor, bond) for the bonds of a flat list, bond counting from 0.
template <class Visit>
void forEachBond(const Call& call, Visit visit) {
  std::size_t at = 0, bond = 0;
  for (int p = 0; p < call.nOwned; ++p) {
    const int count = call.neighborhoodList[at++];
    for (int k = 0; k < count; ++k) visit(call.ownedIds[p], call.neighborhoodList[at++], bond++);
  }
}

/// A bond to a point of another block, whose constants may differ: each block adds half of its own pair force or flux
/// to both ends, so that the pair stays balanced. Within a block both ends compute the same, and each adds its own part
/// only (in the objective form of the mechanics: what is left without the rotations).
struct InterfaceBond {
  int point, neighbor;
  std::size_t bond;
};

std::vector<InterfaceBond> findInterfaceBonds(const Call& call, const double* blockId);

}  // namespace pd

#endif
