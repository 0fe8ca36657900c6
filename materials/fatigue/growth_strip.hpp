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
/// in displacements. Grips are one neighbourhood thick and move by 1 each. Bonds near the path of the crack may break:
/// their stretches follow by rank-one updates of their mutual flexibilities.
class GrowthStrip {
 public:
  /// `height` of the whole between the grips and `growth` that there is room for, in horizons of `horizon` spacings.
  GrowthStrip(std::vector<LatticeBond> bonds, double horizon, double height, double growth);

  /// K/(E' sqrt(horizon)) with K from the energy that the strip far ahead of the crack holds.
  double strainUnit() const { return strainUnit_; }
  std::size_t nBonds() const { return bonds_.size(); }  ///< that may break
  double stretch(std::size_t bond) const { return stretch_[bond]; }
  bool isBroken(std::size_t bond) const { return isBroken_[bond] != 0; }
  void breakBond(std::size_t bond);
  /// [points] 1 where a point or one of its neighbours has lost that part of its bonds.
  std::vector<char> pointsNear(double damage) const;
  bool hasEndIn(const std::vector<char>& points, std::size_t bond) const {
    return points[bonds_[bond].from] != 0 || points[bonds_[bond].to] != 0;
  }
  /// By how many columns the crack has grown: those whose two rows beside it have come apart.
  int nColumnsOpen() const;

 private:
  /// Between points of the upper half; of a pair across the crack and its mirror image one.
  struct Bond {
    std::size_t from, to;  ///< points
    bool isAcross, isInGrip;
    double alongX, alongY;  ///< xi / |xi|^2
    double stiffness, count;
  };
  /// stretch = sum of value[k] u[unknown[k]] + atGrips
  struct Measure {
    std::array<int, 4> unknown{};
    std::array<double, 4> value{};
    int n = 0;
    double atGrips = 0.0;
    void add(int where, double what);
    double of(const std::vector<double>& u) const;
  };

  std::size_t point(int column, int row) const { return static_cast<std::size_t>(column * nRows_ + row); }
  bool isCut(int column, int row, const LatticeBond& bond) const;
  void collect(int column, int row, std::vector<Bond>& all);
  Measure measureOf(const Bond& bond) const;
  bool mayBreak(const Bond& bond, int growth) const;
  void findFlexibilities(const BandedCholesky& solver, const std::vector<double>& u);
  double heldEnergy() const;

  std::vector<LatticeBond> lattice_;
  int reach_ = 0, nRows_, nColumns_, firstColumn_;
  double strainUnit_ = 0.0, bondsOfAPoint_ = 0.0;
  std::vector<double> nBroken_;  ///< [points]
  std::vector<Bond> bonds_;
  std::vector<Measure> measures_;
  std::vector<double> stretch_;
  std::vector<std::vector<double>> flexibility_;
  std::vector<char> isBroken_;
  std::vector<std::size_t> tipBond_;  ///< [columns from the first that may open] across the crack
};

}  // namespace pd

#endif
