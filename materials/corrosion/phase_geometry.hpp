// What the weights of bonds must be corrected by where walls cut neighbourhoods, and where fronts slant.
#ifndef PD_PHASE_GEOMETRY_HPP
#define PD_PHASE_GEOMETRY_HPP

#include <array>
#include <vector>

#include "solid_phases.hpp"
#include "transport_weights.hpp"

namespace pd {

/// Sums over the whole neighbourhood of one point. Arrays by local id; a point is liquid where its `damage` is 1.
class PhaseGeometry {
 public:
  /// `phases`, `blockId`: of a solid of several phases. `followsLoss`: whether `damage` says what points have lost.
  PhaseGeometry(const TransportWeights& weights, const double* x, const double* volume, const double* damage,
                const SolidPhases* phases = nullptr, const double* blockId = nullptr, bool followsLoss = true)
      : weights_(weights),
        x_(x),
        volume_(volume),
        damage_(damage),
        phases_(phases),
        blockId_(blockId),
        knowsLoss_(followsLoss),
        followsLoss_(followsLoss && blockId == nullptr) {}

  double diffusionWeight(int i, int j) const { return diffusionWeight(weights_.bond(x_, i, j), i, j); }
  double dissolutionWeight(int i, int j) const { return dissolutionWeight(weights_.bond(x_, i, j), i, j); }

  /// What the diffusion weights of a liquid point must be multiplied by so that its bonds to liquid points diffuse with
  /// D along the wall next to it: 1 inside the electrolyte, more at a wall, which cuts the neighbourhood. Between two
  /// walls that is the direction in which they diffuse most. With the mean of both ends' values on each bond, mass is
  /// conserved, and the bonds of a straight gap together diffuse with D along it exactly.
  double diffusionCorrection(int point, const int* neighbors, int count) const;

  /// The surface near a solid point, for its dissolution weights.
  struct Surface {
    /// What they must be multiplied by for a plane front of the direction that the solid around has: bonds of a grid
    /// pass up to 8 % more where a front slants. Sides of the body, where bonds are missing, are made up for: the side
    /// that has more of them counts. So are slower phases beside the point's, which such a front leaves behind.
    double plane = 1.0;
    double spread = 0.0;  ///< Growth of its area with its way, 1/m: sum of curvatures, above 0 in a hole.
    double gap = 0.0;     ///< From liquid points to where the metal that is left begins, m: half a spacing and more.
    int nCurvatures = 1;
    struct OfPhase {
      std::array<double, 2> passed{};  ///< of such a front, by bonds before and behind the point to metal of the phase
      bool isAround = false;           ///< in the neighbourhood
    };
    /// Of metal of several phases; bonds to electrolyte are with the point's own. Empty where there is one.
    std::vector<OfPhase> phases;
    double spreadOfOne = 0.0;  ///< `spread` where a front passes all of them alike; else it is 0
    /// What they must be multiplied by once the front has moved so far, in m. The front is where metal begins; a round
    /// one has more area than the liquid points, or less.
    double correctionAfter(double way) const;
  };
  /// That of a surface without a film.
  Surface surface(int point, const int* neighbors, int count) const;
  /// `plane` and `spread` of one in metal of several phases where a film covers so much.
  void takeUpFilm(double filmCoverage, int point, Surface& surface) const;

 private:
  using Bond = TransportWeights::Bond;
  double diffusionWeight(const Bond& bond, int i, int j) const {
    return weights_.diffusion(bond, volume_[i], volume_[j]);
  }
  double dissolutionWeight(const Bond& bond, int i, int j) const {
    return weights_.dissolution(bond, volume_[i], volume_[j]);
  }
  struct Normal {
    std::array<double, 3> direction;  ///< unit vector from electrolyte to solid, along the axes of the horizon
    bool isClear;                     ///< false between walls that cancel, and where there is no solid
  };
  void findBonds(int point, const int* neighbors, int count) const;
  template <class SolidOf>
  Normal normal(int point, const int* neighbors, SolidOf solidOf) const;  ///< after findBonds
  struct Bend {
    double spread = 0.0;  ///< 1/m, as in Surface
    double gap = 0.0;     ///< from the points that are liquid to the front, m
  };
  Bend bendOf(int point, const int* neighbors, const std::array<double, 3>& normal) const;

  const TransportWeights& weights_;
  const double *x_, *volume_, *damage_;
  const SolidPhases* phases_;
  const double* blockId_;
  bool knowsLoss_, followsLoss_;
  mutable std::vector<Bond> bonds_;  ///< of the point at work
};

}  // namespace pd

#endif
