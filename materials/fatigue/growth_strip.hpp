// A long strip of lattice with a crack along its middle, between grips that move apart: what breaks is exact, and
// cheap.
#ifndef PD_GROWTH_STRIP_HPP
#define PD_GROWTH_STRIP_HPP

#include <array>
#include <cstddef>
#include <vector>

#include "banded_cholesky.hpp"
#include "growth_trial.hpp"

namespace pd {

/// The upper half alone, in units of the spacing; the crack lies between two rows. Elastic energy of bonds is quadratic
/// in displacements. The strip stands in a frame one neighbourhood thick: grips that move by 1 each, and beyond both
/// ends what a strip without end does. The frame is stretched along the crack, too, and contracts across it as a free
/// plate does: that adds a uniform stress along the crack and no K, and is such that the T-stress is 0, which it would
/// else be as 1/sqrt(height) only. Bonds near the path of the crack may break: displacements there follow by rank-one
/// updates of the compliance of its points.
class GrowthStrip {
 public:
  /// `height` of the whole between the grips and `growth` that there is room for, in horizons of `horizon` spacings.
  GrowthStrip(std::vector<LatticeBond> bonds, double horizon, double height, double growth);

  /// K/(E' sqrt(horizon)) with K from the energy that the strip far ahead of the crack holds.
  double strainUnit() const { return strainUnit_; }
  std::size_t nBonds() const { return bonds_.size(); }  ///< that may break
  double stretch(std::size_t bond) const { return measures_[bond].of(u_); }
  bool isBroken(std::size_t bond) const { return isBroken_[bond] != 0; }
  void breakBond(std::size_t bond);
  /// Unbroken ones, rising, with an end that has lost that part of its bonds, or one of whose neighbours has: the same
  /// part in all calls.
  const std::vector<std::size_t>& bondsNear(double damage);
  /// By how many columns the crack has grown: those whose two rows beside it have come apart.
  int nColumnsOpen() const;

 private:
  using Displacement = std::array<double, 2>;

  /// Between points of the upper half; of a pair across the crack and its mirror image one.
  struct Bond {
    std::size_t from, to;  ///< points
    bool isAcross, isToFrame;
    double alongX, alongY;  ///< xi / |xi|^2
    double stiffness, count;
    int column, row;  ///< of the end in the frame
  };
  /// stretch = sum of value[k] u[unknown[k]] + ofFrame
  struct Measure {
    std::array<int, 4> unknown{};
    std::array<double, 4> value{};
    int n = 0;
    double ofFrame = 0.0;
    void add(int where, double what);
    double of(const std::vector<double>& u) const;
  };

  std::size_t point(int column, int row) const { return static_cast<std::size_t>(column * nRows_ + row); }
  bool isCut(int column, int row, const LatticeBond& bond) const;
  void collect(int column, int row, std::vector<Bond>& all);
  Displacement ofFrame(int column, int row) const;
  Measure measureOf(const Bond& bond) const;
  bool mayBreak(const Bond& bond, int growth) const;
  void add(const Bond& bond);
  void condense(const BandedCholesky& solver, const std::vector<double>& u);
  bool findPointsNear(double damage);
  std::vector<double> movedBy(const Measure& pairOfForces) const;
  double solveFarAhead();

  std::vector<LatticeBond> lattice_;
  int reach_ = 0, nRows_, nColumns_, firstColumn_;
  double poisson_, strainUnit_ = 0.0, frameStrain_ = 0.0, bondsOfAPoint_ = 0.0;
  std::vector<double> farAhead_;   ///< [rows] displacement along y far ahead of the crack
  std::vector<double> nBroken_;    ///< [points]
  std::vector<char> isNear_;       ///< [points] as findPointsNear() last found it; empty: never
  std::vector<std::size_t> worn_;  ///< points that have lost bonds since
  // Of bonds that may break. Their unknowns are counted among those of all such bonds.
  std::vector<Bond> bonds_;
  std::vector<Measure> measures_;
  std::vector<char> isBroken_;
  std::vector<double> u_;
  std::vector<double> compliance_;      ///< [unknowns][unknowns], of which the upper triangle counts
  std::vector<std::size_t> bondsNear_;  ///< as bondsNear() last found them
  std::vector<std::size_t> tipBond_;    ///< [columns from the first that may open] across the crack
};

}  // namespace pd

#endif
