// What the springs of a network couple each point with itself by.
#ifndef PD_SPRING_DIAGONAL_HPP
#define PD_SPRING_DIAGONAL_HPP

#include "spring_operator.hpp"

namespace pd {

/// [D (D + 1)/2][nPoints] upper triangles of the diagonal blocks of K without its families, complete at owned points,
/// in units of the network. Collective.
PointVector<double> springDiagonal(const SpringOperator& stiffness);

/// A point that hangs on too few springs (one, or some in a line) can move along some direction without force. What is
/// to be added to the diagonal, so that it cannot: a little of its own stiffness.
std::vector<SpringOperator::Addition> stiffeningOfLoosePoints(const SpringOperator& stiffness,
                                                              const PointVector<double>& diagonal);

}  // namespace pd

#endif
