// The way along a crack that turns.
#ifndef PD_CRACK_PATH_HPP
#define PD_CRACK_PATH_HPP

#include <algorithm>
#include <vector>

#include "connected_points.hpp"

namespace pd {

/// Each damaged point has a distance from the start of the crack: that of the shortest way through damaged points, from
/// each to a neighbour. On a strip of points the way is as long as the strip, within 1.5 % on square lattices of three
/// spacings a horizon, and shorter by a spacing or so for each radian that it turns, since it keeps to the inner side.
/// The crack ends where the distance is largest. As damage grows, distances may become shorter by what ways across a
/// thicker strip save.
class CrackPath {
 public:
  struct Point {
    ConnectedPoint point;  ///< with its damaged neighbours
    Vector3 place;         ///< m
    double damage;
    double fromStart;  ///< m; negative where the way does not begin
  };
  /// `mine`: of this rank, each in the list of one rank alone; `reach`: of the longest bond, m. Collective.
  CrackPath(const std::vector<Point>& mine, double reach, const Epetra_Comm& comm);

  double length() const { return length_; }  ///< m; 0: there is no crack
  /// How much of the crack is its end, m: a reach, or half of a short crack.
  double endLength() const { return std::min(reach_, 0.5 * length_); }
  /// From the start, m; negative for points that are none of the crack.
  double distance(int globalId) const;
  /// Mean place of the end, weighed by damage.
  Vector3 meanOfEnd() const { return meanBetween(0.0, 1.0); }
  /// From as much before the end to there; `atStart` for a crack shorter than a reach.
  Vector3 directionAtEnd(const Vector3& atStart) const;

 private:
  /// Of what lies so many end lengths behind the tip.
  Vector3 meanBetween(double nearest, double furthest) const;
  void findPositions();
  void findDistances();
  /// In points_; negative for ids that are none of them.
  int positionOf(int globalId) const {
    const int at = globalId - lowestId_;
    return at < 0 || at >= static_cast<int>(positions_.size()) ? -1 : positions_[static_cast<std::size_t>(at)];
  }

  double reach_, length_ = 0.0;
  std::vector<Point> points_;  ///< of all ranks
  std::vector<double> distances_;
  int lowestId_ = 0;
  std::vector<int> positions_;  ///< by global ids from the lowest on
};

}  // namespace pd

#endif
