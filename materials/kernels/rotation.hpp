// The rotation of a neighbourhood: the rotation part of B = sum_j w_j Y_j xi_j^T, which makes sum_j w_j |Y_j - R
// xi_j|^2 stationary. Templated on double or Vector (one neighbourhood a lane).
#ifndef PD_ROTATION_HPP
#define PD_ROTATION_HPP

#include <array>
#include <cmath>

#include "simd.hpp"

namespace pd::kernels {

/// [[cosine, -sine], [sine, cosine]]
template <class Scalar>
struct PlaneRotation {
  Scalar cosine, sine;
};

/// From dot = sum w Y.xi and cross = sum w (xi_x Y_y - xi_y Y_x). Identity where both vanish (no bond left).
template <class Scalar>
PlaneRotation<Scalar> planeRotation(Scalar dot, Scalar cross) {
  const Scalar norm2 = dot * dot + cross * cross;
  if constexpr (std::is_same_v<Scalar, double>) {
    if (!(norm2 > 0.0)) return {1.0, 0.0};
    const double inverse = 1.0 / std::sqrt(norm2);
    return {dot * inverse, cross * inverse};
  } else {
    const Scalar inverse = inverseSquareRoot(wherePositive(norm2, norm2, 1.0));
    return {wherePositive(norm2, dot * inverse, 1.0), wherePositive(norm2, cross * inverse, 0.0)};
  }
}

template <class Scalar>
using Matrix3 = std::array<Scalar, 9>;  ///< row by row

/// Rotation part of B (9 values, row by row). Newton iteration on R^T B = symmetric from the identity; where that does
/// not lead to the nearest rotation (turns beyond a right angle, degenerate B), by Horn's quaternion method (J. Opt.
/// Soc. Am. A 4 (1987) 629). Identity where B vanishes.
Matrix3<double> solidRotation(const Matrix3<double>& b);
Matrix3<Vector> solidRotation(const Matrix3<Vector>& b);

}  // namespace pd::kernels

#endif
