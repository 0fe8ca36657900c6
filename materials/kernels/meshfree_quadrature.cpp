#include "meshfree_quadrature.hpp"

#include <Teuchos_LAPACK.hpp>
#include <algorithm>
#include <array>
#include <cmath>

namespace pd::kernels {

namespace {

constexpr int nConditions = 9;
using Column = std::array<double, nConditions>;

/// kernel p of one neighbour, for x, y, z, x^2, y^2, z^2, xy, xz, yz; lengths in horizons.
Column conditionsOf(double x, double y, double z, DiffusionKernel kernel) {
  const double k = kernelValue(kernel, std::sqrt(x * x + y * y + z * z));
  return {k * x, k * y, k * z, k * x * x, k * y * y, k * z * z, k * x * y, k * x * z, k * y * z};
}

/// Integral of kernel x^2 over the unit ball.
double secondMoment(DiffusionKernel kernel) {
  const int power = kernel == DiffusionKernel::InverseSquare ? 2 : kernel == DiffusionKernel::Inverse ? 1 : 0;
  return 4.0 * 3.14159265358979323846 / (3.0 * (5 - power));
}

}  // namespace

std::vector<double> meshfreeWeights(const std::vector<double>& xi, double horizon, DiffusionKernel kernel) {
  const int n = static_cast<int>(xi.size() / 3);
  if (n < nConditions) return {};
  std::vector<Column> columns;
  for (std::size_t j = 0; j < xi.size(); j += 3)
    columns.push_back(conditionsOf(xi[j] / horizon, xi[j + 1] / horizon, xi[j + 2] / horizon, kernel));
  Column wanted{};
  for (const std::size_t square : {3u, 4u, 5u}) wanted[square] = secondMoment(kernel);

  std::vector<double> matrix, weights(static_cast<std::size_t>(n), 0.0), singular(nConditions), work(1);
  for (const Column& column : columns) matrix.insert(matrix.end(), column.begin(), column.end());
  std::copy(wanted.begin(), wanted.end(), weights.begin());
  const Teuchos::LAPACK<int, double> lapack;
  constexpr double relativeRank = 1e-10;  // directions that no neighbour has
  int rank = 0, info = 0;
  const auto solve = [&](int workSize) {
    lapack.GELSS(nConditions, n, 1, matrix.data(), nConditions, weights.data(), n, singular.data(), relativeRank, &rank,
                 work.data(), workSize, &info);
  };
  solve(-1);
  work.resize(static_cast<std::size_t>(work[0]));
  solve(static_cast<int>(work.size()));
  if (info != 0) return {};

  constexpr double tolerance = 1e-8;
  for (std::size_t c = 0; c < nConditions; ++c) {
    double sum = 0.0;
    for (std::size_t j = 0; j < columns.size(); ++j) sum += columns[j][c] * weights[j];
    if (!(std::abs(sum - wanted[c]) < tolerance)) return {};
  }
  for (double& weight : weights) weight *= horizon * horizon * horizon;
  return weights;
}

}  // namespace pd::kernels
