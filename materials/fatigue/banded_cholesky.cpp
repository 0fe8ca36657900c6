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

/// As many right-hand sides as a vector has lanes, [unknowns][lanes], zero before `first`; solutions from `lowest` on.
void BandedCholesky::solveSides(std::vector<double>& x, int first, int lowest) const {
  const auto at = [&](int j) { return x.data() + static_cast<std::ptrdiff_t>(j) * kernels::lanes; };
  for (int j = first; j < n_; ++j) {
    const double* own = column(j);
    const kernels::Vector found = kernels::load(at(j)) / own[0];
    kernels::store(found, at(j));
    for (int k = std::min(width_, n_ - 1 - j); k > 0; --k)
      kernels::store(kernels::load(at(j + k)) - own[k] * found, at(j + k));
  }
  for (int j = n_ - 1; j >= lowest; --j) {
    const double* own = column(j);
    kernels::Vector sum = kernels::load(at(j));
    for (int k = std::min(width_, n_ - 1 - j); k > 0; --k) sum -= own[k] * kernels::load(at(j + k));
    kernels::store(sum / own[0], at(j));
  }
}

std::vector<double> BandedCholesky::inverseAt(const std::vector<std::size_t>& unknowns) const {
  constexpr auto lanes = static_cast<std::size_t>(kernels::lanes);
  const std::size_t n = unknowns.size();
  std::vector<double> inverse(n * n), x;
  if (n == 0) return inverse;
  const auto lowest = static_cast<int>(*std::min_element(unknowns.begin(), unknowns.end()));
  for (std::size_t begin = 0; begin < n; begin += lanes) {
    const std::size_t count = std::min(lanes, n - begin);
    x.assign(static_cast<std::size_t>(n_) * lanes, 0.0);
    std::size_t first = unknowns[begin];
    for (std::size_t lane = 0; lane < count; ++lane) {
      x[unknowns[begin + lane] * lanes + lane] = 1.0;
      first = std::min(first, unknowns[begin + lane]);
    }
    solveSides(x, static_cast<int>(first), lowest);
    for (std::size_t lane = 0; lane < count; ++lane)
      for (std::size_t k = 0; k < n; ++k) inverse[(begin + lane) * n + k] = x[unknowns[k] * lanes + lane];
  }
  return inverse;
}

}  // namespace pd
