// Elimination of points of a body, front by front.
#ifndef PD_FRONTAL_FACTOR_HPP
#define PD_FRONTAL_FACTOR_HPP

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "part_stiffness.hpp"

namespace pd {

/// Cholesky's factor of the stiffness of a part of a body by the multifrontal method (I. S. Duff & J. K. Reid, ACM
/// Trans. Math. Softw. 9 (1983) 302): each group of points is eliminated from a dense matrix over itself and its
/// border, the later points that it is joined to; what that leaves of the border waits for the group of the first of
/// them. Some points are kept: they are the last group.
class FrontalFactor {
 public:
  /// Refers to the part, whose points are in the order of elimination; `ends` of the groups but the last, which may be
  /// empty.
  FrontalFactor(const PartStiffness& part, const std::vector<std::size_t>& ends);

  static constexpr const char* singular = "the matrix is singular";

  /// Eliminates all points but those that are kept. Returns why that cannot be; empty where it can. With
  /// `keepsColumns` those of the factor stay for columnsOfInverse().
  std::string eliminate(bool keepsColumns);
  /// The stiffness that is left of what is kept once the others are in equilibrium. Leaves nothing of this.
  std::vector<double> takeLeft();
  /// How the unknowns `rows` move under forces at each that is kept, [kept][rows]; empty where the stiffness is
  /// singular. Leaves nothing of this.
  std::vector<double> columnsOfInverse(const std::vector<int>& rows);

 private:
  using Values = std::unique_ptr<double[]>;
  struct Front {
    int firstPoint, endPoint;
    int parent = -1;            ///< the front that what this leaves waits for
    std::vector<int> border;    ///< points, rising
    std::vector<int> children;  ///< fronts
    std::vector<int> unknowns;  ///< own ones and those of the border, rising
    int width = 0;              ///< own ones
    Values columns;             ///< [width][unknowns] of the factor
    Values rest;                ///< [border][border] what is left of the border, the lower triangle
    int nBorder() const { return static_cast<int>(unknowns.size()) - width; }
  };

  void sortSprings();
  void findFronts(const std::vector<std::size_t>& ends);
  std::vector<int> borderOf(const Front& front);
  bool eliminate(Front& front);
  void addPoints(const Front& front);
  void addChildren(Front& front, bool toOwn);
  bool factorOwn(Front& front);
  bool invertLeft();
  std::vector<char> frontsAbove(const std::vector<int>& unknowns) const;
  void substitute(const Front& front, int count);

  const PartStiffness& part_;
  std::vector<PartStiffness::Spring> springs_;  ///< by their first ends
  std::vector<std::size_t> firstSpring_;        ///< [points + 1]
  std::vector<Front> fronts_;                   ///< the last one: what is kept
  std::vector<int> frontOf_, seen_;             ///< [points]
  std::vector<int> local_;                      ///< [unknowns] row in the present front
  std::vector<double> moved_;                   ///< [unknowns][columns] of a part of the inverse
};

}  // namespace pd

#endif
