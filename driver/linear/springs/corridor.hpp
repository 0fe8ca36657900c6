// Part of a body in which a crack may grow, with the rest of the body condensed onto its rim.
#ifndef PD_CORRIDOR_HPP
#define PD_CORRIDOR_HPP

#include <string>
#include <vector>

#include "spring_operator.hpp"

namespace pd {

struct CorridorResponse {
  std::vector<double> values;  ///< [columns][rows]
  std::string trouble;         ///< why there is none; empty where there is
};

/// The rest is eliminated once, at the cost of a factor of the whole, which holds for as long as nothing changes there;
/// the body's response to forces in the corridor then takes a factor of the corridor. For springs along their bonds
/// alone, in one piece, under loads and prescribed displacements that stay as they are.
class Corridor {
 public:
  /// Refers to the stiffness. `points`: owned ones.
  Corridor(const SpringOperator& stiffness, const std::vector<int>& points);

  /// Why it is of no use; empty where it is.
  const std::string& trouble() const { return trouble_; }
  bool contains(int point) const { return isIn_[static_cast<std::size_t>(point)] != 0; }
  /// Whether the rest is as it was, where the springs of the points `changed` have changed since the last call, and
  /// held degrees of freedom or additions perhaps.
  bool fitsAfter(const std::vector<int>& changed) const;
  /// How the whole body's points `rows` move under forces at `columns`, all of them of the corridor, with its springs
  /// as they are now: over their degrees of freedom that are not held, point after point, in units of the network.
  CorridorResponse response(const std::vector<int>& rows, const std::vector<int>& columns) const;

 private:
  bool isRim(int point) const { return isRim_[static_cast<std::size_t>(point)] != 0; }
  void condense(std::vector<int> rest);
  /// What the rest depends on besides springs: by point and component, -1 where held, else additions.
  std::vector<double> supportsOfRest() const;

  const SpringOperator& stiffness_;
  std::vector<int> points_, rim_;   ///< rim_: those with springs to the rest
  std::vector<char> isIn_, isRim_;  ///< [nOwned]
  std::vector<double> supports_;    ///< supportsOfRest() when it was condensed
  mutable std::vector<char> held_;  ///< of the stiffness, when they were last seen to fit
  mutable std::vector<SpringOperator::Addition> additions_;
  std::vector<double> ofRest_;  ///< [unknowns of rim_][unknowns of rim_]
  std::string trouble_;
};

}  // namespace pd

#endif
