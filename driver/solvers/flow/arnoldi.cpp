#include "arnoldi.hpp"

#include <Teuchos_LAPACK.hpp>
#include <algorithm>
#include <cmath>
#include <numeric>

namespace pd {

namespace {

constexpr int askEvery = 10;
using Basis = std::vector<std::vector<double>>;

/// Products of `vector` with the basis, and with itself at last; all ranks.
std::vector<double> productsWith(const Communicator& comm, const Basis& basis, const std::vector<double>& vector) {
  std::vector<double> own, sums(basis.size() + 1);
  for (const std::vector<double>& other : basis)
    own.push_back(std::inner_product(vector.begin(), vector.end(), other.begin(), 0.0));
  own.push_back(std::inner_product(vector.begin(), vector.end(), vector.begin(), 0.0));
  comm.SumAll(own.data(), sums.data(), static_cast<int>(own.size()));
  return sums;
}

/// Takes the parts along the basis out of `vector`, twice, since once leaves rounding of the larger ones. Adds them to
/// `parts`; returns the norm of what is left.
double orthogonalize(const Communicator& comm, const Basis& basis, std::vector<double>& vector, double* parts) {
  for (int pass = 0; pass < 2; ++pass) {
    const std::vector<double> products = productsWith(comm, basis, vector);
    for (std::size_t k = 0; k < basis.size(); ++k) {
      parts[k] += products[k];
      for (std::size_t i = 0; i < vector.size(); ++i) vector[i] -= products[k] * basis[k][i];
    }
  }
  return std::sqrt(productsWith(comm, {}, vector).back());
}

/// Of the leading n by n part of `hessenberg`, column by column, `rows` a column.
std::vector<std::complex<double>> eigenvalues(const std::vector<double>& hessenberg, int rows, int n) {
  std::vector<double> matrix, real(static_cast<std::size_t>(n)), imaginary(real.size()), work(8 * real.size());
  for (int column = 0; column < n; ++column)
    matrix.insert(matrix.end(), hessenberg.begin() + column * rows, hessenberg.begin() + column * rows + n);
  int info = 0;
  double none = 0.0;
  Teuchos::LAPACK<int, double>().GEEV('N', 'N', n, matrix.data(), n, real.data(), imaginary.data(), &none, 1, &none, 1,
                                      work.data(), static_cast<int>(work.size()), nullptr, &info);
  if (info != 0) throw std::logic_error("eigenvalues of a small matrix were not found");
  std::vector<std::complex<double>> values;
  for (std::size_t k = 0; k < real.size(); ++k) values.emplace_back(real[k], imaginary[k]);
  return values;
}

}  // namespace

std::vector<std::complex<double>> outerEigenvalues(
    const Communicator& comm, const std::function<void(const double*, double*)>& apply, std::vector<double> start,
    const std::function<bool(const std::vector<std::complex<double>>&)>& isEnough, int maximumIterations) {
  const int rows = maximumIterations + 1;
  std::vector<double> hessenberg(static_cast<std::size_t>(rows) * static_cast<std::size_t>(maximumIterations), 0.0);
  Basis basis;
  double norm = std::sqrt(productsWith(comm, {}, start).back());
  double largest = 0.0;
  for (int n = 1; norm > 1e-13 * largest; ++n) {
    for (double& value : start) value /= norm;
    basis.push_back(start);
    apply(basis.back().data(), start.data());
    double* column = &hessenberg[static_cast<std::size_t>(n - 1) * static_cast<std::size_t>(rows)];
    norm = orthogonalize(comm, basis, start, column);
    column[n] = norm;
    for (int k = 0; k <= n; ++k) largest = std::max(largest, std::abs(column[k]));
    const bool isLast = n == maximumIterations || !(norm > 1e-13 * largest);
    if (!isLast && n % askEvery != 0) continue;
    std::vector<std::complex<double>> values = eigenvalues(hessenberg, rows, n);
    if (isLast || isEnough(values)) return values;
  }
  return {};
}

}  // namespace pd
