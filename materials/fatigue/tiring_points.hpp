// Which points of a block have bonds that cycles may do something to.
#ifndef PD_TIRING_POINTS_HPP
#define PD_TIRING_POINTS_HPP

#include <cstddef>
#include <vector>

#include "call.hpp"

namespace pd {

/// Most bonds of a cracked body lose no life, and are far from any limit: they need not be looked at in each step. This
/// remembers, from one call to the next, how far. What is found is the same to the last bit as by a look at every bond.
/// Points are named by their place in the block's list.
class TiringPoints {
 public:
  explicit TiringPoints(const Call& call);
  /// Whether it was made for these very lists.
  bool isFor(const Call& call) const;

  int neighbor(std::size_t bond, std::size_t point) const { return list_[bond + point + 1]; }
  std::size_t firstBond(std::size_t point) const { return firstBond_[point]; }
  int nBonds(std::size_t point) const { return static_cast<int>(firstBond_[point + 1] - firstBond_[point]); }

  /// Writes `nearTip`, by local id, at the block's points: 1 where they or a neighbour have lost the part `cracked` of
  /// their bonds. `damage` [nPoints].
  void markTips(const double* damage, int nPoints, double cracked, double* nearTip);

  /// Makes a value zero at all points of the block.
  void clear(double* values) const;

  /// `lost` of NP1 becomes that of N, both [bonds]. A host that swaps their memory has all of it copied; in another
  /// one NP1 is N at the start of a step, but for what has been written since.
  void startFrom(const double* before, double* lost);

  /// Those that find() found last: NP1 differs from N at their bonds alone.
  const std::vector<std::size_t>& lastFound() const { return tiring_; }

  /// Of the bonds of the points found last, from firstKnown(p) on, where mayStretch(p): what a caller has found out of
  /// them, and NaN. It is kept as long as places `y` [3 nPoints] and tips are the same, the rates as long as
  /// `strainRange` is, too.
  struct Known {
    std::vector<double> stretches, rates;
  };
  /// Null where the points are so many that what is known of them would take more memory than it is worth. With the
  /// same `strainRange` and `peak` as before the points leaveOut() has named are none of those found last any more.
  /// `x`, `y` [3 nPoints]: places in the reference configuration, and now.
  Known* known(const double* x, const double* y, int nPoints, double strainRange, double peak);
  std::size_t firstKnown(std::size_t point) const { return firstKnown_[point]; }
  /// Whether a bond of the point that had life at N may be longer now by more than `least` of its length. After known()
  /// with these y.
  bool mayStretch(std::size_t point, const double* y, double least);
  /// No bond of the point has lost life or broken at these places, whatever the number of cycles.
  void leaveOut(std::size_t point) { isLeftOut_[point] = 1; }

  /// What leaves bonds away from tips alone: a strain range (`strainRange` for each part that a bond is longer or
  /// shorter by) up to `restingRange`, and a stretch (`peak` for each) below `criticalStretch`.
  struct Limits {
    double strainRange, restingRange, peak, criticalStretch;
    bool areReachedBy(double stretch) const {
      return !(strainRange * stretch <= restingRange) || !(peak * stretch < criticalStretch);
    }
  };
  /// Points with a bond near a tip (`nearTip` [nPoints]; null: there are none), or with one that may have reached a
  /// limit. `x`, `y` [3 nPoints]: places in the reference configuration, and now. The caller may write their bonds.
  const std::vector<std::size_t>& find(const double* nearTip, const double* x, const double* y, int nPoints,
                                       const Limits& limits);

 private:
  struct IdRange {
    int first, last;  ///< last: one more
  };
  /// Whether the point or a neighbour may have an id of these.
  bool reaches(std::size_t point, const IdRange& ids) const {
    return family_[point].first < ids.last && ids.first < family_[point].last;
  }
  IdRange takeUpCracked(const double* damage, int nPoints, double cracked);
  bool isBesideTip(std::size_t point) const { return !isBesideTip_.empty() && isBesideTip_[point] != 0; }
  void findBesideTips(const double* nearTip, int nPoints);
  bool findReaching(const double* y, const Limits& limits);
  void lookAtAll(const double* x, const double* y, int nPoints);
  void findWeights(const double* x);
  double largestSquare(std::size_t point, const double* y) const;

  int nOwned_;
  const int *ownedIds_, *list_;
  bool areConsecutive_ = true;          ///< the local ids of the points
  std::vector<std::size_t> firstBond_;  ///< [points + 1]
  std::vector<IdRange> family_;         ///< [points] of itself and its neighbours

  std::vector<char> isCracked_;    ///< [nPoints] as markTips() last found it
  std::vector<double> marks_;      ///< [points] what it made of it
  std::vector<double> nearTip_;    ///< [nPoints] as find() last found it
  std::vector<char> isBesideTip_;  ///< [points]
  std::vector<std::size_t> besideTips_;

  std::vector<double> seenPlaces_;                  ///< [3 nPoints] when all bonds were looked at
  std::vector<double> largest_;                     ///< [points] largest |stretch| of a bond then
  double largestOfAll_ = 0.0, shortestBond_ = 0.0;  ///< 1; m
  int nCallsToWait_ = 0;                            ///< before the next look

  Known known_;
  std::vector<std::size_t> knownPoints_;  ///< whose bonds those are
  std::vector<double> knownPlaces_;       ///< [3 nPoints]
  std::vector<std::size_t> firstKnown_;   ///< [points]
  std::vector<double> weights_;           ///< of those bonds: 1 / length^2 at rest; 0: had no life at N
  std::vector<double> squares_;           ///< [points] the largest (length now / at rest)^2 of them; NaN: not found yet
  std::vector<std::size_t> seen_;         ///< points of which it has been found
  std::vector<char> isLeftOut_;           ///< [points]
  double knownRange_ = 0.0, knownPeak_ = 0.0;
  bool tipsHaveChanged_ = true;  ///< since then

  const double *before_ = nullptr, *lost_ = nullptr;
  std::vector<std::size_t> tiring_;  ///< whose bonds NP1 may differ from N at
};

}  // namespace pd

#endif
