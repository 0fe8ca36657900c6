#include "point_vector.hpp"

#include <cmath>
#include <numeric>

#include "simd.hpp"

namespace pd {

using kernels::lanes;
using kernels::load;

double dot(const PointVector<double>& a, const PointVector<double>& b, int nOwned) {
  double sum = 0.0;
  for (int c = 0; c < a.nComponents(); ++c) {
    const double *x = a[c], *y = b[c];
    // Sums that do not wait for each other.
    kernels::Vector first = 0.0, second = 0.0, third = 0.0, fourth = 0.0;
    int i = 0;
    for (; i + 4 * lanes <= nOwned; i += 4 * lanes) {
      first += load(x + i) * load(y + i);
      second += load(x + i + lanes) * load(y + i + lanes);
      third += load(x + i + 2 * lanes) * load(y + i + 2 * lanes);
      fourth += load(x + i + 3 * lanes) * load(y + i + 3 * lanes);
    }
    sum += kernels::stdx::reduce((first + second) + (third + fourth));
    for (; i < nOwned; ++i) sum += x[i] * y[i];
  }
  return sum;
}

double largestSize(const PointVector<double>& x, int nOwned) {
  double largest = 0.0;
  for (int c = 0; c < x.nComponents(); ++c) {
    kernels::Vector first = 0.0, second = 0.0;
    int i = 0;
    for (; i + 2 * lanes <= nOwned; i += 2 * lanes) {
      first = kernels::stdx::max(first, kernels::stdx::abs(load(x[c] + i)));
      second = kernels::stdx::max(second, kernels::stdx::abs(load(x[c] + i + lanes)));
    }
    largest = std::max(largest, kernels::stdx::hmax(kernels::stdx::max(first, second)));
    for (; i < nOwned; ++i) largest = std::max(largest, std::abs(x[c][i]));
  }
  return largest;
}

}  // namespace pd
