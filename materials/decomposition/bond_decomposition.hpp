// Bond decomposition (Liu & Bao, Aerospace 9 (2022) 641): a bond stands for the connections of all places in the cells
// of its two points, and carries the share of them that meets no crack and no void.
#ifndef PD_BOND_DECOMPOSITION_HPP
#define PD_BOND_DECOMPOSITION_HPP

#include <memory>
#include <vector>

#include "lines_through_plane_cells.hpp"
#include "sight.hpp"

namespace pd::decomposition {

/// How the connections of two cells are counted.
struct DecompositionRule {
  enum class Kind {
    Adaptive,      ///< in a plane lines through both cells, in space lines of one cell as seen from places of the
                   ///< other: more and more until the share is known to about `tolerance` of a bond
    Uniform,       ///< all pairs of n^D middles of equal parts of both cells: eqs. 13 and 14 there
    Intersection,  ///< the bond between the two points alone
    Both,          ///< the same, but at cracks in the plane by TipRule::Both
    Either         ///< TipRule::Either
  };
  Kind kind = Kind::Adaptive;
  double tolerance = 1e-3;
  int partitions = 20;  ///< n of Uniform
};

/// Cracks and voids of a body.
struct Discontinuities {
  std::vector<std::unique_ptr<Screen>> screens;  ///< cracks, and the surfaces of voids
  std::vector<std::unique_ptr<Void>> voids;
};

/// Those that meet the box.
NearDiscontinuities nearBox(const NearDiscontinuities& candidates, const Box& box);

/// Share of the cell's volume that is outside of all voids, within 1e-3 of what they take.
double solidShare(const Cell& cell, const std::vector<const Void*>& voids);
/// The same by a rule: by one that leaves cells all or nothing, nothing where the cell's point is in a void.
double solidShare(const Cell& cell, const std::vector<const Void*>& voids, const DecompositionRule& rule);
/// Cells that have no more material are left out: slivers, whose middles are far from it. Around a hole they are 1e-3
/// of the cells that it cuts.
constexpr double leastSolid = 0.05;

/// A cell and a number of its own.
struct NamedCell {
  int id;
  const Cell& cell;
};

/// Shares of many bonds, one after the other: what discontinuities take of cells is found once for all bonds of a cell.
class InteractionShares {
 public:
  explicit InteractionShares(const DecompositionRule& rule) : rule_(rule) {}

  /// eta V'_a V'_b/(V_a V_b) of eqs. 11 and 15 there, V' being the volumes of the cells and V those of the material in
  /// them: the share, of the pairs of places with material in the two cells, of those whose connection meets no crack
  /// and no void. Of a cell that a crack passes through count the places on the side of its point: to the letter of
  /// eq. 11 that point would hold on to both faces of the crack, and keep it together. 0 where it is below 1e-6. The
  /// two cells may not be exchanged without changing the last digits. `near`: at least what is near either of them, of
  /// the same discontinuities in the same order for all bonds.
  double of(const NamedCell& a, const NamedCell& b, const NearDiscontinuities& near);
  /// Of the bonds so far, those between whose cells a crack or a void may be.
  long long nNear() const { return nNear_; }
  /// Lines through cells, and lines of cells times places that looked at them, so far.
  long long nLines() const { return nLines_ + throughBoth_.nLines(); }

 private:
  /// By the middles of n^D parts of `a` that look at those of `b`; negative where none of `a`, or of `b`, counts.
  double byMiddles(const NamedCell& a, const NamedCell& b, const NearDiscontinuities& near, int n);
  /// By sample places of `a` (samplePlace), a few of which at a time look at other lines of `b`, until the halves of
  /// the sample agree. 0 where none of `a`, or of `b`, counts.
  double bySamples(const NamedCell& a, const NamedCell& b, const NearDiscontinuities& near);
  /// Makes less work of the screens between two cells.
  void narrow(const Cell& a, const Cell& b);
  double adaptively(const NamedCell& a, const NamedCell& b, const NearDiscontinuities& near);
  /// 0 where a crack cuts the bond by the rule for tips, or another screen its line.
  double byTipRule(const NamedCell& a, const NamedCell& b, const NearDiscontinuities& near, TipRule rule);

  const DecompositionRule rule_;
  LinedCells cells_;
  NearDiscontinuities between_;                    ///< the two cells
  std::vector<std::unique_ptr<Screen>> narrowed_;  ///< some of these
  std::array<std::vector<double>, 3> parts_;
  Sight sight_;
  LinesThroughPlaneCells throughBoth_;
  long long nNear_ = 0, nLines_ = 0;
};

/// Of one bond. `nLines`, where given, is raised by the lines that it took.
double interactionShare(const Cell& a, const Cell& b, const NearDiscontinuities& near, const DecompositionRule& rule,
                        long long* nLines = nullptr);

}  // namespace pd::decomposition

#endif
