// Deformation of a point from its unbroken bonds.
#ifndef PD_POINT_DEFORMATION_HPP
#define PD_POINT_DEFORMATION_HPP

#include <array>
#include <vector>

#include "compute_support.hpp"

namespace pd {

/// Row by row: xx, xy, xz, yx, ...
using Tensor = std::array<double, 9>;

/// The gradient that fits the deformed bonds best, by volume (Silling et al. 2007, eq. 142):
///   F = (sum of V_j y (x) xi) K^+ + I - K K^+,   K = sum of V_j xi (x) xi,
/// xi a bond before and y after deformation. In directions in which the unbroken bonds do not reach (z of a plane body,
/// all where a point is loose) the pseudo-inverse leaves the identity.
class DeformationGradients {
 public:
  struct Fields : FieldTable {
    FieldHandle volume = reads(pd::fields::volume());
    FieldHandle modelCoordinates = reads(pd::fields::modelCoordinates());
    FieldHandle coordinates = reads(pd::fields::coordinates());
    FieldHandle bondDamage = readsIfThere(pd::fields::bondDamage());
    FieldHandle interactionShare = readsIfThere(pd::fields::interactionShare());
  };

  /// One a point, in the order of the block's OwnedIDs; the identity at points that keep less than `leastIntact` of
  /// their neighbours, by volume.
  std::vector<Tensor> of(PeridigmNS::Block& block, double leastIntact = 0.0) const;
  /// The same for the points at `places` of the block's OwnedIDs alone; `starts`: its listStarts().
  std::vector<Tensor> at(PeridigmNS::Block& block, double leastIntact, const std::vector<std::size_t>& places,
                         const std::vector<std::size_t>& starts) const;

 private:
  Fields fields_;
};

/// Of a symmetric tensor without negative eigenvalues; those below 1e-8 of the largest count as zero.
Tensor pseudoInverse(const Tensor& symmetric);

/// What becomes of a tensor where vectors v become `reflection` v, a symmetric matrix.
Tensor reflected(const Tensor& tensor, const Tensor& reflection);

/// "Small" (F + F^T)/2 - I, or "Green-Lagrange" (F^T F - I)/2.
void declareStrainMeasure(ParameterDeclarations& declarations);
Tensor strainOf(const Tensor& deformationGradient, bool isGreenLagrange);

/// Isotropic linear elasticity with the moduli of a block's material.
class HookesLaw {
 public:
  /// Declares "Plane Stress".
  static void declareParameters(ParameterDeclarations& declarations);
  HookesLaw(const PeridigmNS::Material& material, bool isPlaneStress);
  Tensor stress(const Tensor& strain) const;

 private:
  double lambda_, shearModulus_;
  bool isPlaneStress_;
};

}  // namespace pd

#endif
