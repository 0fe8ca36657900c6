// The upper half of a body of lattice with a crack along its middle: what breaks is exact, and cheap.
#ifndef PD_GROWTH_BODY_HPP
#define PD_GROWTH_BODY_HPP

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

#include "banded_cholesky.hpp"
#include "growth_trial.hpp"

namespace pd {

/// Square cells in columns and rows, in units of the spacing. The crack lies between the lowest row and its mirror
/// image.
struct HalfBody {
  using Displacement = std::array<double, 2>;

  int nColumns = 0, nRows = 0;
  int firstColumn = 0;       ///< of the ligament: the crack has cut those before it
  std::vector<char> isHole;  ///< [columns * rows]; empty: none
  /// Of places beyond the columns and rows, one neighbourhood thick; empty: nothing is there.
  std::function<Displacement(int column, int row)> frame;
  std::vector<std::size_t> pulled;  ///< points that share a force of 1 away from the crack
  double energyReleaseRate = 0.0;   ///< whatever the length of the crack; 0: that of straight cuts, found by cutting

  std::size_t point(int column, int row) const { return static_cast<std::size_t>(column * nRows + row); }
  bool isWithin(int column, int row) const { return column >= 0 && column < nColumns && row < nRows; }
  bool isIn(int column, int row) const {
    return isWithin(column, row) && (isHole.empty() || isHole[point(column, row)] == 0);
  }
};

/// Elastic energy of bonds is quadratic in displacements. Bonds near the path of the crack may break: displacements
/// there follow by rank-one updates of the compliance of its points.
class GrowthBody {
 public:
  /// `growth` that there is room for, in horizons of `horizon` spacings.
  GrowthBody(std::vector<LatticeBond> bonds, double horizon, HalfBody half, double growth);

  /// K/(E' sqrt(horizon)) with K from the energy that the crack sets free as it is now. Its length is that of the
  /// straight cut which has set free as much, as tests find it from their compliance.
  double strainUnit() const;
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
  /// Between points of the upper half; of a pair across the crack and its mirror image one.
  struct Bond {
    std::size_t from, to;  ///< points
    bool isAcross, isToFrame;
    double alongX, alongY;  ///< xi / |xi|^2
    double stiffness, count;
    int column, row;   ///< of the end in the frame
    double crossesAt;  ///< where it crosses the line of the crack, in columns
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

  void collect(int column, int row, std::vector<Bond>& all);
  Measure measureOf(const Bond& bond) const;
  bool mayBreak(const Bond& bond, int growth) const;
  void add(const Bond& bond);
  std::vector<double> solve(const std::vector<Bond>& all, BandedCholesky& solver) const;
  void condense(const BandedCholesky& solver, const std::vector<double>& u);
  bool findPointsNear(double damage);
  std::vector<double> movedBy(const Measure& pairOfForces) const;
  void cutStraight(int growth);

  std::vector<LatticeBond> lattice_;
  HalfBody half_;
  int reach_ = 0;
  double modulus_, horizon_;  ///< E'; in spacings
  double bondsOfAPoint_ = 0.0;
  std::vector<double> nBroken_;    ///< [points]
  std::vector<char> isNear_;       ///< [points] as findPointsNear() last found it; empty: never
  std::vector<std::size_t> worn_;  ///< points that have lost bonds since
  // Of bonds that may break. Their unknowns are counted among those of all such bonds.
  std::vector<Bond> bonds_;
  std::vector<Measure> measures_;
  std::vector<char> isBroken_;
  std::vector<double> u_;
  std::vector<double> compliance_;                 ///< [unknowns][unknowns], of which the upper triangle counts
  std::vector<std::size_t> bondsNear_;             ///< as bondsNear() last found them
  std::vector<std::size_t> tipBond_;               ///< [columns from the first that may open] across the crack
  double released_ = 0.0;                          ///< energy, of the whole body
  std::vector<double> releasedByCut_, rateOfCut_;  ///< [columns that a straight cut has gone on by]; a column
};

}  // namespace pd

#endif
