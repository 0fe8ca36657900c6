// The stiffness of part of a body, and what it is to some of its points once the others are in equilibrium.
#ifndef PD_PART_STIFFNESS_HPP
#define PD_PART_STIFFNESS_HPP

#include <vector>

#include "../methods/schur_complement.hpp"
#include "spring_operator.hpp"

namespace pd {

/// Entries over the degrees of freedom of some owned points that are not held, for springs along their bonds alone, in
/// one piece. All in units of the network.
class PartStiffness {
 public:
  /// Refers to the stiffness.
  PartStiffness(const SpringOperator& stiffness, const std::vector<int>& points);

  /// The springs as damage has left them for whose ends takesPart(i, j), both of them points of the part.
  template <class TakesPart>
  void addSprings(const TakesPart& takesPart) {
    stiffness_.network().forEachSpringIn([&](int i) { return has(i); },
                                         [&](int i, int j, const double* xi, const SpringConstants<double>& spring) {
                                           if (has(j) && takesPart(i, j)) addSpring(i, j, xi, spring.radial);
                                         });
  }
  /// What the stiffness adds to the diagonal at the points of which takesPart(point).
  template <class TakesPart>
  void addAdditions(const TakesPart& takesPart) {
    for (const SpringOperator::Addition& each : stiffness_.additions())
      if (has(each.point) && takesPart(each.point)) ofPoint(each.point, each.component, each.component) += each.value;
  }
  /// A symmetric matrix over the degrees of freedom of `points` that are not held, in their order.
  void add(const std::vector<int>& points, const std::vector<double>& values);

  /// Onto the degrees of freedom of `kept` that are not held, in its order; `eliminated`: the other points of the part,
  /// in the order that they are to go in. Leaves nothing of this.
  SchurComplement condenseOnto(const std::vector<int>& kept, const std::vector<int>& eliminated);

  /// Of the inverse, over the degrees of freedom of these points that are not held; `order`: all points of the part, as
  /// they are to be eliminated. Leaves nothing of this.
  InverseColumns inverse(const std::vector<int>& rows, const std::vector<int>& columns, const std::vector<int>& order);

 private:
  void addDiagonal();
  bool has(int point) const { return placeOf_[static_cast<std::size_t>(point)] >= 0; }
  /// From 1; 0: held.
  int unknown(int point, int component) const;
  std::vector<int> unknownsOf(const std::vector<int>& points) const;
  double& ofPoint(int point, int c, int d);
  void addEntry(int i, int c, int j, int d, double value);
  void addSpring(int i, int j, const double* xi, double radial);

  const SpringOperator& stiffness_;
  int dimension_;
  std::vector<int> points_, placeOf_;  ///< placeOf_ [nOwned] in points_; -1: none
  std::vector<int> unknown_;           ///< [points][dimension]
  SymmetricEntries entries_;
  std::vector<double> diagonal_;  ///< [points][dimension][dimension]
};

}  // namespace pd

#endif
