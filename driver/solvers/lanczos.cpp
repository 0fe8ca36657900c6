#include "lanczos.hpp"

#include <Random123/philox.h>

#include <Teuchos_LAPACK.hpp>
#include <algorithm>
#include <cmath>
#include <cstdint>

namespace pd {

namespace {

struct RitzValues {
  double largest, smallest;
  double lastComponent;  ///< |s_m| of the largest one's unit eigenvector: the residual of the Ritz pair is beta_m |s_m|
};

/// Extreme eigenvalues of the symmetric tridiagonal matrix.
RitzValues extremeRitzValues(std::vector<double> diagonal, std::vector<double> offDiagonal) {
  const int n = static_cast<int>(diagonal.size());
  std::vector<double> vectors(static_cast<std::size_t>(n) * static_cast<std::size_t>(n));
  std::vector<double> work(static_cast<std::size_t>(std::max(1, 2 * n - 2)));
  int info = 0;
  offDiagonal.resize(static_cast<std::size_t>(std::max(1, n - 1)));
  Teuchos::LAPACK<int, double>().STEQR('I', n, diagonal.data(), offDiagonal.data(), vectors.data(), n, work.data(),
                                       &info);
  return {diagonal.back(), diagonal.front(), std::abs(vectors.back())};
}

}  // namespace

LargestEigenvalue largestEigenvalue(const SelfAdjointOperator& op, std::vector<double> start, double relativeTolerance,
                                    int maximumIterations) {
  LargestEigenvalue result;
  const std::size_t n = start.size();
  std::vector<double> current = std::move(start), previous(n, 0.0), image(n, 0.0);
  const double length = std::sqrt(op.dot(current.data(), current.data()));
  if (!(length > 0.0)) return result;
  for (double& value : current) value /= length;

  std::vector<double> diagonal, offDiagonal;
  double beta = 0.0;
  while (result.iterations < maximumIterations) {
    ++result.iterations;
    op.apply(current.data(), image.data());
    const double alpha = op.dot(current.data(), image.data());
    for (std::size_t i = 0; i < n; ++i) image[i] -= alpha * current[i] + beta * previous[i];
    diagonal.push_back(alpha);
    beta = std::sqrt(op.dot(image.data(), image.data()));

    const auto [ritzValue, smallest, lastComponent] = extremeRitzValues(diagonal, offDiagonal);
    result.value = ritzValue;
    result.smallestSeen = smallest;
    result.upperBound = ritzValue + beta * lastComponent;
    // A residual of round-off size (an invariant subspace) ends the iteration whatever the tolerance.
    if (!(beta * lastComponent > std::max(relativeTolerance, 1e-14) * std::abs(ritzValue))) break;
    offDiagonal.push_back(beta);
    for (std::size_t i = 0; i < n; ++i) {
      previous[i] = current[i];
      current[i] = image[i] / beta;
    }
  }
  return result;
}

std::vector<double> randomPointValues(const std::vector<int>& globalIds, int nOwned, int width) {
  const r123::Philox2x32 generator;
  std::vector<double> values(static_cast<std::size_t>(nOwned) * static_cast<std::size_t>(width));
  for (int i = 0; i < nOwned; ++i)
    for (int k = 0; k < width; ++k) {
      const auto id = static_cast<std::uint32_t>(globalIds[static_cast<std::size_t>(i)]);
      const auto number = generator({{id, static_cast<std::uint32_t>(k)}}, {{0x9E3779B9u}})[0];
      values[static_cast<std::size_t>(i) * static_cast<std::size_t>(width) + static_cast<std::size_t>(k)] =
          number * (1.0 / 2147483648.0) - 1.0;
    }
  return values;
}

}  // namespace pd
