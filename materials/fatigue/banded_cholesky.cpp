#include "banded_cholesky.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "simd.hpp"

namespace pd {

namespace {

void subtract(double* from, const double* what, double times, int n) {
  for (int k = 0; k < n; ++k) from[k] -= times * what[k];
}

double product(const double* a, const double* b, int n) {
  kernels::Vector sums = 0.0;
  int k = 0;
  for (; k + kernels::lanes <= n; k += kernels::lanes) sums += kernels::load(a + k) * kernels::load(b + k);
  double sum = kernels::stdx::reduce(sums);
  for (; k < n; ++k) sum += a[k] * b[k];
  return sum;
}

}  // namespace

BandedCholesky::BandedCholesky(int n, int width)
    : n_(n), width_(width), values_(static_cast<std::size_t>(n) * static_cast<std::size_t>(width + 1), 0.0) {}

void BandedCholesky::add(int i, int j, double value) { column(std::min(i, j))[std::abs(i - j)] += value; }

void BandedCholesky::factor() {
  for (int j = 0; j < n_; ++j) {
    double* own = column(j);
    if (!(own[0] > 0.0)) throw std::runtime_error("a band matrix is not positive definite");
    const double pivot = std::sqrt(own[0]);
    const int below = std::min(width_, n_ - 1 - j);
    for (int k = 0; k <= below; ++k) own[k] /= pivot;
    for (int k = 1; k <= below; ++k)
      if (own[k] != 0.0) subtract(column(j + k), own + k, own[k], below - k + 1);
  }
}

void BandedCholesky::solve(std::vector<double>& x) const {
  for (int j = 0; j < n_; ++j) {
    if (x[static_cast<std::size_t>(j)] == 0.0) continue;
    const double* own = column(j);
    double* at = x.data() + j;
    at[0] /= own[0];
    subtract(at + 1, own + 1, at[0], std::min(width_, n_ - 1 - j));
  }
  for (int j = n_ - 1; j >= 0; --j) {
    const double* own = column(j);
    double* at = x.data() + j;
    at[0] = (at[0] - product(own + 1, at + 1, std::min(width_, n_ - 1 - j))) / own[0];
  }
}

}  // namespace pd
