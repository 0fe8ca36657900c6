// Pairs of places of two cells in a plane, counted along the lines through both.
#ifndef PD_LINES_THROUGH_PLANE_CELLS_HPP
#define PD_LINES_THROUGH_PLANE_CELLS_HPP

#include "lined_cells.hpp"

namespace pd::decomposition {

/// The share, of the pairs of places of two cells that count, of those that see each other. On a line, which cracks and
/// voids cut in pieces, all pairs are counted at once: those of p = x + r u and q = x + s u are dp dq = |s - r| dr ds
/// times the measure of lines, dheight dangle (Santalo, Integral Geometry and Geometric Probability, 1976, I.4). Over
/// heights Gauss's rule, from one to the next at which a corner or the rim of something comes into sight, is exact
/// between straight outlines; what that leaves is continuous in the angle, 0 at its ends, and integrated by Simpson's
/// rule and halving.
class LinesThroughPlaneCells {
 public:
  /// A cell, and what counts of it: what it has outside of voids, as seen from a place of it past the screens.
  struct Side {
    const Cell* cell;
    const WithinCell* within;
  };
  /// Within about `tolerance` of a whole bond; negative where no pair counts. `screens`: at least those between the
  /// cells.
  double share(const Side& a, const Side& b, const std::vector<const Screen*>& screens, double tolerance);
  /// Lines so far.
  long long nLines() const { return nLines_; }

 private:
  struct Pairs {
    double seen = 0.0, all = 0.0;
  };
  struct PairsPerLane {
    kernels::Vector seen, all;
  };
  struct SideAtWork {
    Side of;
    std::vector<Place> outline;    ///< corners in turn
    std::array<Place, 2> perEdge;  ///< x . perEdge_k counts edges
    /// For each screen the half-planes that have in common what the cell's place does not see of it, from its centre.
    std::vector<std::vector<HalfSpace>> shadows;
    RangePerLane chord, inSight;
    std::vector<RangePerLane> taken;
  };

  void setUp(SideAtWork& side, const Side& of);
  Pairs atAllAngles(double tolerance);
  Pairs atAngle(const Place& along);
  bool findHeights(const Place& across);
  PairsPerLane pairsOn(const LinePerLane& lines);
  void findChord(SideAtWork& side, const LinePerLane& lines);
  void meetScreens(const LinePerLane& lines);
  void countOverlapping(std::size_t lane, PairsPerLane& pairs) const;

  SideAtWork a_, b_;
  std::vector<const Screen*> screens_;
  Place middle_{};
  std::vector<Place> kinks_;  ///< places at which outlines of what counts meet those of cells
  std::vector<double> heights_;
  std::vector<const Screen*> inReach_;  ///< of the lines at hand
  std::vector<RangePerLane> met_;
  long long nLines_ = 0;
};

}  // namespace pd::decomposition

#endif
