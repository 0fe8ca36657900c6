#include "exact_weights.hpp"

#include <algorithm>
#include <cmath>

namespace pd::kernels {

int monomialCount(int dimension, int degree) {
  return degree == 1 ? dimension : dimension + dimension * (dimension + 1) / 2;
}

std::array<double, 9> monomialsOf(int dimension, int degree, const double* xi) {
  std::array<double, 9> values{};
  std::size_t at = 0;
  for (int a = 0; a < dimension; ++a) values[at++] = xi[a];
  if (degree < 2) return values;
  for (int a = 0; a < dimension; ++a)
    for (int b = a; b < dimension; ++b) values[at++] = xi[a] * xi[b];
  return values;
}

void solveNormalEquations(int n, double* matrix, double* rightSide) {
  const auto entry = [&](int row, int column) -> double& { return matrix[row * n + column]; };
  // Conditions differ in size by powers of the lengths of bonds: each is scaled by its own diagonal entry.
  std::array<double, 9> scale{};
  for (int i = 0; i < n; ++i)
    scale[static_cast<std::size_t>(i)] = entry(i, i) > 0.0 ? 1.0 / std::sqrt(entry(i, i)) : 0.0;
  for (int i = 0; i < n; ++i) {
    rightSide[i] *= scale[static_cast<std::size_t>(i)];
    for (int j = 0; j < n; ++j) entry(i, j) *= scale[static_cast<std::size_t>(i)] * scale[static_cast<std::size_t>(j)];
  }
  // A shift far below what counts and above rounding keeps the factor of a singular matrix finite.
  constexpr double shift = 1e-13;
  for (int j = 0; j < n; ++j) {
    double pivot = entry(j, j) + shift;
    for (int k = 0; k < j; ++k) pivot -= entry(j, k) * entry(j, k);
    entry(j, j) = std::sqrt(std::max(pivot, 0.5 * shift));
    for (int i = j + 1; i < n; ++i) {
      for (int k = 0; k < j; ++k) entry(i, j) -= entry(i, k) * entry(j, k);
      entry(i, j) /= entry(j, j);
    }
  }
  for (int i = 0; i < n; ++i) {
    for (int k = 0; k < i; ++k) rightSide[i] -= entry(i, k) * rightSide[k];
    rightSide[i] /= entry(i, i);
  }
  for (int i = n - 1; i >= 0; --i) {
    for (int k = i + 1; k < n; ++k) rightSide[i] -= entry(k, i) * rightSide[k];
    rightSide[i] /= entry(i, i);
  }
  for (int i = 0; i < n; ++i) rightSide[i] *= scale[static_cast<std::size_t>(i)];
}

double makeExact(int dimension, int degree, const std::vector<double>& xi, const std::vector<double>& freedom,
                 const std::array<double, 9>& wanted, std::vector<double>& weights) {
  const int count = monomialCount(dimension, degree);
  std::array<double, 81> matrix{};
  std::array<double, 9> missing = wanted;
  const auto valuesOf = [&](std::size_t k) {
    return monomialsOf(dimension, degree, &xi[k * static_cast<std::size_t>(dimension)]);
  };
  for (std::size_t k = 0; k < weights.size(); ++k) {
    const std::array<double, 9> values = valuesOf(k);
    for (int a = 0; a < count; ++a) {
      missing[static_cast<std::size_t>(a)] -= weights[k] * values[static_cast<std::size_t>(a)];
      for (int b = 0; b < count; ++b)
        matrix[static_cast<std::size_t>(a * count + b)] +=
            freedom[k] * values[static_cast<std::size_t>(a)] * values[static_cast<std::size_t>(b)];
    }
  }
  solveNormalEquations(count, matrix.data(), missing.data());
  std::array<double, 9> miss = wanted;
  for (std::size_t k = 0; k < weights.size(); ++k) {
    const std::array<double, 9> values = valuesOf(k);
    for (std::size_t a = 0; a < static_cast<std::size_t>(count); ++a) weights[k] += freedom[k] * missing[a] * values[a];
    for (std::size_t a = 0; a < static_cast<std::size_t>(count); ++a) miss[a] -= weights[k] * values[a];
  }
  double largest = 0.0;
  for (const double value : miss) largest = std::max(largest, std::abs(value));
  return largest;
}

}  // namespace pd::kernels
