// Weights of the bonds of a dissolving body: what diffuses over those within the electrolyte, and what dissolves over
// those between solid and electrolyte, for horizons of any shape.
#ifndef PD_TRANSPORT_WEIGHTS_HPP
#define PD_TRANSPORT_WEIGHTS_HPP

#include <array>
#include <cmath>
#include <string>

#include "bond_family.hpp"
#include "horizon_shape.hpp"

namespace pd {

class TransportWeights {
 public:
  static void declareParameters(ParameterDeclarations& declare);
  /// `params`: completed. Throws std::invalid_argument, naming `owner`.
  TransportWeights(const Teuchos::ParameterList& params, const std::string& owner);

  /// Vectors of a bond along the axes of the horizon (m) and in the space where it is a ball, and its length there.
  struct Bond {
    std::array<double, 3> along, mapped;
    double length;
    std::size_t kind;  ///< the longest axis of the horizon along which the bond has a component
  };
  Bond bond(const double* x, int point, int neighbor) const {
    Bond bond;
    find(bond, x, point, neighbor);
    return bond;
  }
  /// The same into `bond`: for loops over many, in which copying what has just been written would wait for it.
  void find(Bond& bond, const double* x, int point, int neighbor) const {
    const ReferenceBond reference(x, point, neighbor);
    bond.along = bond.mapped = reference.xi;
    bond.length = reference.length;
    bond.kind = 0;
    if (shape_.isBall()) return;
    bond.along = shape_.along(reference.xi.data());
    bond.mapped = shape_.mapped(bond.along);
    bond.length = shape_.length(bond.mapped);
    bond.kind = kindOf(bond.mapped);
  }

  /// Constants of horizons that are no balls, for a point of this volume in a grid along the axes of the horizon whose
  /// spacings have their ratio: such that diffusion along each axis is D, and a front across each axis passes what it
  /// should. A bond counts for the longest axis that it has a component of: on a grid of 25:1, bonds that lean by one
  /// spacing carry next to nothing across, and those along the short axis alone make up for it.
  void fitToGrid(double volume);
  /// Of Interface Kernel: Trial Calibration, after fitToGrid. Throws std::invalid_argument.
  void calibrateByTrial(bool breaksBondsAtRandom);
  bool isCalibratedByTrial() const { return isByTrial_; }
  const std::string& trialOutcome() const { return trialOutcome_; }  ///< in words; empty before and without a trial
  /// Throws std::invalid_argument, naming the remedy, where the bonds of this point, if it has as many as one inside
  /// such a grid, do not diffuse with D along each axis to 5 %: the mesh is no such grid. Nor may it have cells of
  /// several sizes with a trial.
  void checkGrid(const double* x, const double* volume, int point, const int* neighbors, int count) const;

  /// Per volume of the neighbour, 1/(m3 s).
  double diffusion(const Bond& bond, double volume, double neighborVolume) const {
    return diffusionFactor_[bond.kind] * share(bond.length, family_.horizon, volume, neighborVolume) /
           (bond.length * bond.length);
  }
  /// Flux through a plane front over this bond, 1/m4 a unit of flux.
  double dissolution(const Bond& bond, double volume, double neighborVolume) const {
    return dissolutionFactor_[bond.kind] * share(bond.length, range_, volume, neighborVolume) * byLength(bond.length);
  }

  /// What a neighbour counts where the direction of a front is looked for: by a Gaussian of its distance, which leaves
  /// no direction out, in a box that fits into the neighbourhood. Where cells are long, fronts climb many rows from one
  /// column to the next, and the box is narrow and as high as it can be.
  double window(const Bond& bond) const {
    for (std::size_t d = 0; d < 3; ++d)
      if (std::abs(bond.mapped[d]) > window_[d]) return 0.0;
    return gaussian(bond);
  }
  /// The same without the box, for what must be alike in all directions.
  double gaussian(const Bond& bond) const {
    const auto& r = bond.along;
    return std::exp(-(r[0] * r[0] + r[1] * r[1] + r[2] * r[2]) * windowSharpness_);
  }
  double gaussianVariance() const { return 0.5 / windowSharpness_; }  ///< along an axis, m2
  double gaussianSum() const { return gaussianSum_; }                 ///< of a whole neighbourhood of volumes, m3
  /// Of mapped space along an axis of the horizon.
  double stretch(std::size_t axis) const { return shape_.isBall() ? 1.0 : shape_.radius() / shape_.halfAxis(axis); }

  bool isIsotropic() const { return shape_.isBall(); }

  const kernels::Rings& rings() const { return family_.rings; }
  double ringShare(const double* x, int i, int j, double volume, double neighborVolume) const {
    return family_.ringShare(x, i, j, volume, neighborVolume);
  }

  double diffusivity() const { return diffusivity_; }
  double horizon() const { return family_.horizon; }
  int dimension() const { return family_.dimension(); }

 private:
  /// The longest axis along which a vector in mapped space has a component.
  std::size_t kindOf(const std::array<double, 3>& mapped) const {
    constexpr double none = 1e-3;
    for (const std::size_t axis : shape_.longestFirst())
      if (std::abs(mapped[axis]) > none * shape_.radius()) return axis;
    return 0;
  }
  /// In mapped space, of a point's cell.
  double spacingOf(double volume) const {
    return volume == gridVolume_ ? gridSpacing_ : family_.spacing(shape_.volumeFactor() * volume);
  }
  double share(double length, double range, double volume, double neighborVolume) const;
  /// The interface kernel but for its constant.
  double byLength(double length) const { return 1.0 / (isByTrial_ ? length * length : length); }
  void setWindow();
  template <class Visit>
  void forGrid(double volume, Visit visit) const;

  BondFamily family_;  ///< in the space where the horizon is a ball
  kernels::HorizonShape shape_;
  std::string owner_;
  double diffusivity_, range_;      ///< range of bonds that dissolve
  std::array<double, 3> window_{};  ///< half edges, mapped
  double windowSharpness_;          ///< 1/(2 sigma^2)
  double gaussianSum_ = 0.0;
  bool isByTrial_;  ///< what dissolves over a bond is k/|xi|^2, k by a trial, not c/|xi|
  std::string trialOutcome_;
  std::array<double, 3> diffusionFactor_{}, dissolutionFactor_{};  ///< by kind of bond
  int nNeighbors_ = 0;                                             ///< of a point inside the grid
  double gridVolume_ = 0.0, gridSpacing_ = 0.0;                    ///< of the grid that this was fitted to
};

}  // namespace pd

#endif
