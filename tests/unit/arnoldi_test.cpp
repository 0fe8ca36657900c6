// The rim of the spectrum of an operator that is not self-adjoint.
#include "driver/solvers/flow/arnoldi.hpp"

#include <gtest/gtest.h>
#include <mpi.h>

#include <cmath>
#include <numeric>

#include "driver/solvers/lanczos.hpp"

namespace pd {
namespace {

TEST(ArnoldiTest, FindsTheRimOfASpectrum) {
  // Turning and shrinking planes: eigenvalues -k/n +- i sqrt(k/n), and 3 of them far out.
  constexpr std::size_t n = 200;
  const auto eigenvalueOf = [](std::size_t k) {
    const double x = static_cast<double>(k) / n;
    return k == 7 ? std::complex<double>(-5.0, 0.5) : std::complex<double>(-x, std::sqrt(x));
  };
  const auto apply = [&](const double* x, double* y) {
    for (std::size_t k = 0; k < n; ++k) {
      const std::complex<double> value = eigenvalueOf(k);
      y[2 * k] = value.real() * x[2 * k] - value.imag() * x[2 * k + 1];
      y[2 * k + 1] = value.imag() * x[2 * k] + value.real() * x[2 * k + 1];
    }
  };
  const Communicator comm(MPI_COMM_SELF);
  std::vector<int> ids(n);
  std::iota(ids.begin(), ids.end(), 0);
  const auto found = outerEigenvalues(
      comm, apply, randomPointValues(ids, n, 2), [](const auto&) { return false; }, 40);
  EXPECT_EQ(found.size(), 40u);
  double nearest = 1.0, highest = 0.0;
  for (const std::complex<double>& value : found) {
    nearest = std::min(nearest, std::abs(value - std::complex<double>(-5.0, 0.5)));
    highest = std::max(highest, value.imag());
  }
  EXPECT_LT(nearest, 1e-8);
  EXPECT_NEAR(highest, std::sqrt(199.0 / n), 1e-2);
  EXPECT_TRUE(outerEigenvalues(
                  comm, apply, std::vector<double>(2 * n, 0.0), [](const auto&) { return true; }, 9)
                  .empty());
}

}  // namespace
}  // namespace pd
