// The way along a crack that turns.
#ifndef PD_CRACK_PATH_HPP
#define PD_CRACK_PATH_HPP

#include <unordered_map>
#include <vector>

#include "connected_points.hpp"

namespace pd {

/// Each damaged point has a distance from the start of the crack: that of the shortest way through damaged points, from
/// each to a neighbour. On a strip of points the way is as long as the strip, within 1.5 % on square lattices of three
/// spacings a horizon. The crack ends where the distance is largest. As damage grows, distances may become shorter by
/// what ways across a thicker strip save.
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

  double reach() const { return reach_; }
  double length() const { return length_; }  ///< m; 0: there is no crack
  /// From the start, m; negative for points that are none of the crack.
  double distance(int globalId) const;
  /// Mean place, weighed by damage, of what is within `reach` of the end.
  Vector3 meanOfEnd() const { return meanBetween(0.0, 1.0); }
  /// From the part before that to there; `atStart` where the crack is too short for both.
  Vector3 directionAtEnd(const Vector3& atStart) const;

 private:
  /// Of what ends so many reaches behind the end.
  Vector3 meanBetween(double nearest, double furthest) const;
  void findDistances();

  double reach_, length_ = 0.0;
  std::vector<Point> points_;  ///< of all ranks
  std::vector<double> distances_;
  std::unordered_map<int, std::size_t> positions_;
};

}  // namespace pd

#endif
