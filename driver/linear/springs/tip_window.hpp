// Equilibria of the points around the tip of a crack, while bonds between them break.
#ifndef PD_TIP_WINDOW_HPP
#define PD_TIP_WINDOW_HPP

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "corridor.hpp"

namespace pd {

/// The stiffness of a body condensed onto the points of a window, as columns of its inverse G: once, from a corridor of
/// the body that holds the window. A spring that breaks, a support that is lost or added is one column of G each; the
/// displacements of the window's points are then those of the whole body in equilibrium, exactly (Woodbury's formula),
/// at the cost of a few products. Every so many columns are worked into G. Points that are only read have rows of G,
/// and no columns: nothing may change there. For springs along their bonds alone, in one piece, under loads and
/// prescribed displacements that stay as they are.
class TipWindow {
 public:
  /// Why there can be none for such springs; empty where there can.
  static std::string obstacle(const SpringOperator& stiffness);
  /// Condenses; `displacement` [3 nOwned] m: in equilibrium. Refers to the stiffness. Owned points of the corridor, no
  /// point in both.
  TipWindow(const SpringOperator& stiffness, const Corridor& corridor, const std::vector<int>& read,
            const std::vector<int>& changing, const double* displacement);

  /// What has stood in the way so far; nothing else of this may be used then. Empty where there is none.
  const std::string& trouble() const { return trouble_; }
  bool contains(int point) const { return placeOf_[static_cast<std::size_t>(point)] >= 0; }
  /// Whether the point is in it with all its neighbours: so that its bonds are as in the whole body.
  bool isInside(int point) const { return isInside_[static_cast<std::size_t>(point)] != 0; }
  const SpringOperator& stiffness() const { return stiffness_; }
  /// The largest difference between what solve() found and these displacements [3 nOwned], over the largest of them.
  double distanceFrom(const double* displacement) const;
  /// J, by which what has broken since the window was made has let the energy of the body and its loads fall.
  double releasedEnergy() const { return released_ + releasedByChanges_; }

  /// Takes up what has changed of the stiffness: the springs of the points `changed`, held degrees of freedom, and
  /// additions. `displacement` [3 nOwned]: where points are held that were not. False where it cannot be taken up: not
  /// all of it is inside.
  bool takeUp(const std::vector<int>& changed, const double* displacement);
  /// Writes the displacements of the window's points in equilibrium. False where the equations have no solution.
  bool solve(double* displacement);

 private:
  /// A spring, or the support of one degree of freedom, that has come or gone.
  struct Change {
    std::array<int, 4> unknown{-1, -1, -1, -1};  ///< of the window
    std::array<double, 4> factor{};
    double flexibility = 0.0;  ///< over the stiffness that has come; 0: infinitely stiff
    double rest = 0.0;         ///< its elongation without force, less that of what does not move
    double elongation(const double* unknowns) const;
  };

  void remember();
  double stiffnessOf(int i, int j) const;
  bool takeUpPoint(int point, const double* displacement);
  bool takeUpHeld(const double* displacement);
  bool takeUpAdditions(const double* displacement);
  void breakSpring(int i, int j, double change, const double* displacement);
  bool supportUnknown(int unknown, double flexibility, double place);
  bool hasColumns(int point) const;
  void add(const Change& change);
  bool findFactors(std::vector<double>& matrix, std::vector<int>& pivots) const;
  bool workIn();
  int unknownOf(int point, int component) const;

  const SpringOperator& stiffness_;
  int dimension_;
  std::vector<int> points_;  ///< those that are only read, then those where something may change
  int nRead_;
  std::vector<int> placeOf_;    ///< [nOwned] in points_; -1: none
  std::vector<char> isInside_;  ///< [nOwned]
  std::vector<int> unknownOf_;  ///< [points][dimension]; -1: was held from the start
  int nUnknowns_ = 0, firstColumn_ = 0;
  std::vector<double> inverse_;     ///< G [unknowns from firstColumn_ on][unknowns]
  std::vector<double> base_, now_;  ///< [unknowns] m: before and with the changes
  std::string trouble_;

  std::vector<std::pair<long long, double>> springs_;  ///< stiffness by both ends, of those unbroken at the start
  std::vector<std::vector<float>> alive_;              ///< [points] of their bonds, as they are taken up
  std::vector<char> isHeld_;                           ///< [3 nOwned]
  std::vector<SpringOperator::Addition> additions_;

  double released_ = 0.0, releasedByChanges_ = 0.0;  ///< J, by changes that G has taken up, and by the others

  std::vector<Change> changes_;  ///< since G was made or worked into
  std::vector<double> columns_;  ///< [changes][unknowns] G times each
  std::vector<double> couplings_;
};

}  // namespace pd

#endif
