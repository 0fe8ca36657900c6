#include "exact_weights.hpp"

#include <Teuchos_LAPACK.hpp>
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
  if (n == 0) return;
  // Conditions differ in size by powers of the lengths of bonds: each is scaled by its own diagonal entry.
  std::array<double, 9> scale{}, size{}, scaled{};
  for (std::size_t i = 0; i < static_cast<std::size_t>(n); ++i) {
    const double own = matrix[i * static_cast<std::size_t>(n + 1)];
    scale[i] = own > 0.0 ? 1.0 / std::sqrt(own) : 0.0;
    scaled[i] = scale[i] * rightSide[i];
  }
  for (int i = 0; i < n * n; ++i)
    matrix[i] *= scale[static_cast<std::size_t>(i / n)] * scale[static_cast<std::size_t>(i % n)];
  std::array<double, 64> work{};
  int info = 0;
  const Teuchos::LAPACK<int, double> lapack;
  lapack.SYEV('V', 'U', n, matrix, n, size.data(), work.data(), static_cast<int>(work.size()), &info);
  std::fill(rightSide, rightSide + n, 0.0);
  if (info != 0) return;
  constexpr double nothing = 1e-11;  // of the largest eigenvalue, the last one
  for (int k = 0; k < n; ++k) {
    const double* direction = matrix + k * n;
    if (size[static_cast<std::size_t>(k)] <= nothing * size[static_cast<std::size_t>(n - 1)]) continue;
    double along = 0.0;
    for (int i = 0; i < n; ++i) along += direction[i] * scaled[static_cast<std::size_t>(i)];
    along /= size[static_cast<std::size_t>(k)];
    for (int i = 0; i < n; ++i) rightSide[i] += along * direction[i];
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
