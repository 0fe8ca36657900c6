#include "rotation.hpp"

#include <algorithm>

namespace pd::kernels {

namespace {

constexpr int maximumNewtonSteps = 8;

double largest(double value) { return value; }
double largest(const Vector& value) { return stdx::hmax(value); }

template <class Scalar>
Scalar absolute(const Scalar& value) {
  using std::abs;
  using std::max;
  return max(value, -value);
}

/// R <- R exp([omega]) for small omega, exactly a rotation (unit quaternion of half the Cayley step).
template <class Scalar>
void turn(Matrix3<Scalar>& r, const Scalar& a, const Scalar& b, const Scalar& c) {
  // quaternion (1, omega/2), normalised
  const Scalar x = 0.5 * a, y = 0.5 * b, z = 0.5 * c;
  const Scalar scale = 2.0 / (1.0 + x * x + y * y + z * z);
  const Matrix3<Scalar> q{1.0 - scale * (y * y + z * z), scale * (x * y - z),           scale * (x * z + y),
                          scale * (x * y + z),           1.0 - scale * (x * x + z * z), scale * (y * z - x),
                          scale * (x * z - y),           scale * (y * z + x),           1.0 - scale * (x * x + y * y)};
  Matrix3<Scalar> product;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      product[3 * i + j] = r[3 * i] * q[j] + r[3 * i + 1] * q[3 + j] + r[3 * i + 2] * q[6 + j];
  r = product;
}

/// Newton iteration; `remaining` is the size of the last step, large where the iteration is not to be trusted.
template <class Scalar>
Matrix3<Scalar> newtonRotation(const Matrix3<Scalar>& b, Scalar& remaining) {
  const Scalar one(1.0), zero(0.0);
  Matrix3<Scalar> r{one, zero, zero, zero, one, zero, zero, zero, one};
  for (int step = 0; step < maximumNewtonSteps; ++step) {
    Matrix3<Scalar> m;  // R^T B
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) m[3 * i + j] = r[i] * b[j] + r[3 + i] * b[3 + j] + r[6 + i] * b[6 + j];
    // (tr(S) I - S) omega = axial vector of M - M^T, S = sym(M)
    const Scalar a0 = m[7] - m[5], a1 = m[2] - m[6], a2 = m[3] - m[1];
    const Scalar d00 = m[4] + m[8], d11 = m[0] + m[8], d22 = m[0] + m[4];
    const Scalar d01 = -0.5 * (m[1] + m[3]), d02 = -0.5 * (m[2] + m[6]), d12 = -0.5 * (m[5] + m[7]);
    const Scalar c00 = d11 * d22 - d12 * d12, c01 = d02 * d12 - d01 * d22, c02 = d01 * d12 - d02 * d11;
    const Scalar determinant = d00 * c00 + d01 * c01 + d02 * c02;
    const Scalar inverse = 1.0 / determinant;
    const Scalar x = inverse * (c00 * a0 + c01 * a1 + c02 * a2);
    const Scalar y = inverse * (c01 * a0 + (d00 * d22 - d02 * d02) * a1 + (d01 * d02 - d00 * d12) * a2);
    const Scalar z = inverse * (c02 * a0 + (d01 * d02 - d00 * d12) * a1 + (d00 * d11 - d01 * d01) * a2);
    turn(r, x, y, z);
    // Positive leading minors of tr(S) I - S: a maximum of tr(R^T B), i.e. the nearest rotation.
    using std::max;
    using std::min;
    const Scalar minor = d00 * d11 - d01 * d01;
    const Scalar worst = min(min(d00, minor), determinant);
    remaining = max(max(absolute(x), absolute(y)), absolute(z));
    const double unsure = largest(remaining);
    if constexpr (std::is_same_v<Scalar, double>) {
      if (!(worst > 0.0)) remaining = 1.0;
    } else {
      remaining = wherePositive(worst, remaining, 1.0);
    }
    // The step after one of this size is smaller than its square.
    if (unsure < 1e-8) break;
  }
  return r;
}

/// Eigenvector of the largest eigenvalue of a symmetric 4 x 4 matrix, by cyclic Jacobi rotations.
std::array<double, 4> leadingEigenvector(std::array<std::array<double, 4>, 4> a) {
  std::array<std::array<double, 4>, 4> v{};
  for (std::size_t i = 0; i < 4; ++i) v[i][i] = 1.0;
  for (int sweep = 0; sweep < 30; ++sweep) {
    double off = 0.0;
    for (std::size_t p = 0; p < 4; ++p)
      for (std::size_t q = p + 1; q < 4; ++q) {
        off += std::abs(a[p][q]);
        if (a[p][q] == 0.0) continue;
        const double theta = 0.5 * (a[q][q] - a[p][p]) / a[p][q];
        const double t = std::copysign(1.0, theta) / (std::abs(theta) + std::sqrt(theta * theta + 1.0));
        const double c = 1.0 / std::sqrt(t * t + 1.0), s = t * c;
        for (std::size_t k = 0; k < 4; ++k) {
          const double kp = a[k][p], kq = a[k][q];
          a[k][p] = c * kp - s * kq;
          a[k][q] = s * kp + c * kq;
        }
        for (std::size_t k = 0; k < 4; ++k) {
          const double pk = a[p][k], qk = a[q][k], vp = v[k][p], vq = v[k][q];
          a[p][k] = c * pk - s * qk;
          a[q][k] = s * pk + c * qk;
          v[k][p] = c * vp - s * vq;
          v[k][q] = s * vp + c * vq;
        }
      }
    if (off == 0.0) break;
  }
  std::size_t best = 0;
  for (std::size_t i = 1; i < 4; ++i)
    if (a[i][i] > a[best][best]) best = i;
  return {v[0][best], v[1][best], v[2][best], v[3][best]};
}

Matrix3<double> hornRotation(const Matrix3<double>& b) {
  const double norm =
      *std::max_element(b.begin(), b.end(), [](double x, double y) { return std::abs(x) < std::abs(y); });
  if (norm == 0.0 || !std::isfinite(norm)) return {1, 0, 0, 0, 1, 0, 0, 0, 1};
  // b[i][j] = sum w Y_i xi_j: the quaternion that takes xi to Y.
  const auto m = [&](std::size_t i, std::size_t j) { return b[3 * j + i]; };  // m(i, j) = sum w xi_i Y_j
  const std::array<std::array<double, 4>, 4> n{
      {{m(0, 0) + m(1, 1) + m(2, 2), m(1, 2) - m(2, 1), m(2, 0) - m(0, 2), m(0, 1) - m(1, 0)},
       {m(1, 2) - m(2, 1), m(0, 0) - m(1, 1) - m(2, 2), m(0, 1) + m(1, 0), m(2, 0) + m(0, 2)},
       {m(2, 0) - m(0, 2), m(0, 1) + m(1, 0), m(1, 1) - m(0, 0) - m(2, 2), m(1, 2) + m(2, 1)},
       {m(0, 1) - m(1, 0), m(2, 0) + m(0, 2), m(1, 2) + m(2, 1), m(2, 2) - m(0, 0) - m(1, 1)}}};
  const auto [w, x, y, z] = leadingEigenvector(n);
  return {1 - 2 * (y * y + z * z), 2 * (x * y - w * z),     2 * (x * z + w * y),
          2 * (x * y + w * z),     1 - 2 * (x * x + z * z), 2 * (y * z - w * x),
          2 * (x * z - w * y),     2 * (y * z + w * x),     1 - 2 * (x * x + y * y)};
}

}  // namespace

Matrix3<double> solidRotation(const Matrix3<double>& b) {
  double remaining = 1.0;
  const Matrix3<double> r = newtonRotation(b, remaining);
  return remaining < 1e-7 ? r : hornRotation(b);
}

Matrix3<Vector> solidRotation(const Matrix3<Vector>& b) {
  Vector remaining = 1.0;
  Matrix3<Vector> r = newtonRotation(b, remaining);
  for (std::size_t lane = 0; lane < static_cast<std::size_t>(lanes); ++lane) {
    if (remaining[lane] < 1e-7) continue;
    Matrix3<double> one;
    for (std::size_t i = 0; i < 9; ++i) one[i] = b[i][lane];
    one = hornRotation(one);
    for (std::size_t i = 0; i < 9; ++i) r[i][lane] = one[i];
  }
  return r;
}

}  // namespace pd::kernels
