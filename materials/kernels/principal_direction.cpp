#include "principal_direction.hpp"

#include <cmath>
#include <cstddef>

namespace pd::kernels {

namespace {

/// Turns the plane of axes p and q so that the tensor has no part off the diagonal there; columns of `axes` follow.
void turnToDiagonal(Matrix3<double>& a, Matrix3<double>& axes, std::size_t p, std::size_t q) {
  const double off = a[3 * p + q];
  if (off == 0.0) return;
  const double theta = 0.5 * (a[3 * q + q] - a[3 * p + p]) / off;
  const double tangent = std::copysign(1.0, theta) / (std::abs(theta) + std::sqrt(theta * theta + 1.0));
  const double cosine = 1.0 / std::sqrt(tangent * tangent + 1.0), sine = tangent * cosine;
  for (std::size_t k = 0; k < 3; ++k) {
    const double ap = a[3 * k + p], aq = a[3 * k + q], up = axes[3 * k + p], uq = axes[3 * k + q];
    a[3 * k + p] = cosine * ap - sine * aq;
    a[3 * k + q] = sine * ap + cosine * aq;
    axes[3 * k + p] = cosine * up - sine * uq;
    axes[3 * k + q] = sine * up + cosine * uq;
  }
  for (std::size_t k = 0; k < 3; ++k) {
    const double pa = a[3 * p + k], qa = a[3 * q + k];
    a[3 * p + k] = cosine * pa - sine * qa;
    a[3 * q + k] = sine * pa + cosine * qa;
  }
  a[3 * p + q] = a[3 * q + p] = 0.0;
}

}  // namespace

std::array<double, 3> principalDirection(Matrix3<double> tensor) {
  Matrix3<double> axes{1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0};
  constexpr int enough = 8;  // sweeps; each about squares what is left off the diagonal
  for (int sweep = 0; sweep < enough; ++sweep) {
    turnToDiagonal(tensor, axes, 0, 1);
    turnToDiagonal(tensor, axes, 0, 2);
    turnToDiagonal(tensor, axes, 1, 2);
    if (tensor[1] == 0.0 && tensor[2] == 0.0 && tensor[5] == 0.0) break;
  }
  std::size_t largest = 0;
  for (std::size_t k = 1; k < 3; ++k)
    if (tensor[4 * k] > tensor[4 * largest]) largest = k;
  return {axes[largest], axes[3 + largest], axes[6 + largest]};
}

}  // namespace pd::kernels
