// Search for the points within reach of a point.
#ifndef PD_NEIGHBOR_SEARCH_HPP
#define PD_NEIGHBOR_SEARCH_HPP

#include <array>
#include <vector>

namespace pd {

/// Point j is a neighbour of point i where |x_j - x_i| < reach_i + (margin_i + margin_j), or <= where `includesLimit`.
/// For points of one horizon this is the same from both ends, to the last bit. |.|: Euclidean, or the largest component
/// where `isBox`.
struct NeighborRule {
  std::vector<double> reach, margin;  ///< m, by point
  bool isBox = false, includesLimit = false;

  /// With `spacing`: distances below horizon + (spacing_i + spacing_j) / 4, that is, up to half a spacing beyond the
  /// horizon, as far as the volume correction ramp of partly covered neighbours goes. With an empty `spacing`:
  /// distances up to the horizon. Where a pair lies exactly on the limit, as happens on lattices, rounding does not
  /// decide: it is out (its weight on the ramp is 0) in the first case and in in the second.
  static NeighborRule make(const std::vector<double>& horizon, const std::vector<double>& spacing);

  /// Peridigm's: squares of distances up to that of the horizon (with `includesLimit`) or below it. On the limit
  /// rounding decides, as there.
  static NeighborRule exact(const std::vector<double>& horizon, bool includesLimit);

  double widest() const;  ///< no pair is further apart, m
};

/// Points in cells of about half a reach, those of a cell next to each other in memory.
class NeighborSearch {
 public:
  /// Looks among `candidates`, ids of points into x [3 n] and the rule. Refers to none of them later.
  NeighborSearch(const std::vector<double>& x, const NeighborRule& rule, const std::vector<int>& candidates);

  /// Replaces `neighbors` by the positions in `candidates` of the neighbours of candidates[position], in no
  /// particular order. Returns the square of the shortest distance to one, infinity without neighbours.
  double find(int position, std::vector<int>& neighbors) const;

 private:
  using Cell = std::array<int, 3>;
  Cell cellOf(double x, double y, double z) const;
  std::size_t indexOf(const Cell& cell) const;
  void chooseCells(const std::vector<double>& x, const NeighborRule& rule, const std::vector<int>& candidates);

  std::array<double, 3> low_{};
  double inverseCellSize_ = 0.0;
  Cell nCells_{1, 1, 1};
  std::vector<int> cellStart_;  ///< [cells + 1] into the arrays below
  std::vector<double> x_, y_, z_, reach_, margin_;
  std::vector<int> position_;  ///< in `candidates`
  std::vector<int> slot_;      ///< of each candidate in these arrays
  double widestMargin_ = 0.0;
  bool isBox_, includesLimit_;
};

}  // namespace pd

#endif
