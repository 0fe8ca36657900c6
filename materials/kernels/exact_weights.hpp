// Weights of neighbours that reproduce polynomials exactly, however the points lie.
#ifndef PD_EXACT_WEIGHTS_HPP
#define PD_EXACT_WEIGHTS_HPP

#include <array>
#include <vector>

namespace pd::kernels {

/// How many monomials x, y, (z,) x^2, xy, ... of degree 1 to `degree` (1 or 2) there are.
int monomialCount(int dimension, int degree);

/// Their values at `xi` [dimension], in the order above.
std::array<double, 9> monomialsOf(int dimension, int degree, const double* xi);

/// Changes `weights` [n] so that sum_k weights_k m(xi_k) = wanted_m for all monomials m of degree 1 to `degree`. Of all
/// such weights these have the least sum_k change_k^2 / freedom_k; those with freedom 0 stay as they are. `xi`
/// [dimension n], in units in which it is about 1. Returns the largest miss: far above rounding where the points cannot
/// do it (too few, or on a line); then the conditions that they can meet are met.
/// With weights that begin at zero this is the moving least squares fit with the weights `freedom` (Lancaster &
/// Salkauskas, Math. Comp. 37 (1981) 141).
double makeExact(int dimension, int degree, const std::vector<double>& xi, const std::vector<double>& freedom,
                 const std::array<double, 9>& wanted, std::vector<double>& weights);

/// Solves M y = r with M [n n] symmetric, not negative. Directions in which M has nothing get nothing.
/// M and r are overwritten; r becomes y.
void solveNormalEquations(int n, double* matrix, double* rightSide);

}  // namespace pd::kernels

#endif
