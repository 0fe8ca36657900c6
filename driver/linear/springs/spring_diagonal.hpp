// What the springs of a network couple each point with itself by.
#ifndef PD_SPRING_DIAGONAL_HPP
#define PD_SPRING_DIAGONAL_HPP

#include "spring_operator.hpp"

namespace pd {

/// The upper triangles of the diagonal blocks of K without its families, in units of the network.
class SpringDiagonal {
 public:
  /// Refers to the stiffness.
  explicit SpringDiagonal(const SpringOperator& stiffness);
  /// Writes `diagonal` [D (D + 1)/2][nPoints] at the owned `points`, rising: all of them at first, then those whose
  /// springs have changed. Collective.
  void find(const std::vector<int>& points, PointVector<double>& diagonal);

 private:
  void findOwn(const std::vector<char>& isWanted, const std::vector<char>& isAround,
               PointVector<double>& diagonal) const;
  template <int D>
  void addOwn(const std::vector<char>& isWanted, const std::vector<char>& isAround,
              PointVector<double>& diagonal) const;
  void sumOverCopies(const std::vector<int>& points, PointVector<double>& diagonal) const;

  const SpringOperator& stiffness_;
  // Where ranks or images share points:
  std::vector<int> border_;  ///< owned points with a neighbour that is none
  PointVector<double> own_;  ///< what this rank's springs hold, at ghosts and images, too
};

/// A point that hangs on too few springs (one, or some in a line) can move along some direction without force. What is
/// to be added to the diagonal of `points`, so that they cannot: a little of their own stiffness.
std::vector<SpringOperator::Addition> stiffeningOfLoosePoints(const SpringOperator& stiffness,
                                                              const PointVector<double>& diagonal,
                                                              const std::vector<int>& points);

}  // namespace pd

#endif
