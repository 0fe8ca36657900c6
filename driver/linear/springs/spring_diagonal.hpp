// What the springs of a network couple each point with itself by.
#ifndef PD_SPRING_DIAGONAL_HPP
#define PD_SPRING_DIAGONAL_HPP

#include "spring_operator.hpp"

namespace pd {

/// Writes `diagonal` [D (D + 1)/2][nPoints] at `points`, or everywhere where ranks or images share it: the upper
/// triangles of the diagonal blocks of K without its families, complete at owned points, in units of the network.
/// Collective.
void findSpringDiagonal(const SpringOperator& stiffness, const std::vector<int>& points, PointVector<double>& diagonal);

/// A point that hangs on too few springs (one, or some in a line) can move along some direction without force. What is
/// to be added to the diagonal of `points`, so that they cannot: a little of their own stiffness.
std::vector<SpringOperator::Addition> stiffeningOfLoosePoints(const SpringOperator& stiffness,
                                                              const PointVector<double>& diagonal,
                                                              const std::vector<int>& points);

}  // namespace pd

#endif
