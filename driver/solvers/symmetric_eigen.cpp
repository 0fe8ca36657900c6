#include "symmetric_eigen.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace pd {

namespace {

/// A square matrix in rows.
struct Square {
  std::vector<double>& entries;
  std::size_t n;
  double& operator()(std::size_t i, std::size_t j) const { return entries[i * n + j]; }
};

/// Rotates rows and columns p and q of `a` so that a(p, q) vanishes; `v` collects the rotations in its rows.
void rotate(const Square& a, const Square& v, std::size_t p, std::size_t q) {
  const double theta = 0.5 * (a(q, q) - a(p, p)) / a(p, q);
  const double t = std::copysign(1.0, theta) / (std::abs(theta) + std::hypot(1.0, theta));
  const double c = 1.0 / std::hypot(1.0, t), s = t * c;
  for (std::size_t k = 0; k < a.n; ++k) {
    const double kp = a(k, p), kq = a(k, q);
    a(k, p) = c * kp - s * kq;
    a(k, q) = s * kp + c * kq;
  }
  for (std::size_t k = 0; k < a.n; ++k) {
    const double pk = a(p, k), qk = a(q, k), vp = v(p, k), vq = v(q, k);
    a(p, k) = c * pk - s * qk;
    a(q, k) = s * pk + c * qk;
    v(p, k) = c * vp - s * vq;
    v(q, k) = s * vp + c * vq;
  }
}

}  // namespace

SymmetricEigen symmetricEigen(std::vector<double> matrix, int size) {
  const auto n = static_cast<std::size_t>(size);
  const Square a{matrix, n};
  std::vector<double> vectors(n * n, 0.0);
  const Square v{vectors, n};
  double norm = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    v(i, i) = 1.0;
    for (std::size_t j = 0; j < i; ++j) a(i, j) = a(j, i) = 0.5 * (a(i, j) + a(j, i));
  }
  for (const double entry : matrix) norm += entry * entry;
  const double negligible = 1e-16 * std::sqrt(norm);
  // Convergence is quadratic: a handful of sweeps reaches round-off, 30 are never needed.
  for (int sweep = 0; sweep < 30; ++sweep) {
    bool isDiagonal = true;
    for (std::size_t p = 0; p < n; ++p)
      for (std::size_t q = p + 1; q < n; ++q)
        if (std::abs(a(p, q)) > negligible) {
          rotate(a, v, p, q);
          isDiagonal = false;
        }
    if (isDiagonal) break;
  }
  std::vector<std::size_t> order(n);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return a(i, i) < a(j, j); });
  SymmetricEigen result;
  for (const std::size_t k : order) {
    result.values.push_back(a(k, k));
    for (std::size_t i = 0; i < n; ++i) result.vectors.push_back(v(k, i));
  }
  return result;
}

}  // namespace pd
