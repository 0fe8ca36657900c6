// Inverses of rows in either precision, and GMRES with them.
#include "driver/linear/row_inverse.hpp"

#include <gtest/gtest.h>
#include <mpi.h>

#include <cmath>
#include <stdexcept>

#include "driver/linear/operator_system.hpp"

namespace pd {
namespace {

constexpr std::size_t nRows = 300;

/// Of advection and diffusion along a line, `tilt` of the diagonal apart from symmetry.
SparseRows line(double tilt) {
  SparseRows rows;
  for (std::size_t i = 0; i < nRows; ++i) {
    std::vector<std::pair<long long, double>> entries;
    const auto column = static_cast<long long>(i);
    if (i > 0) entries.emplace_back(column - 1, -1.0 - tilt);
    if (i + 1 < nRows) entries.emplace_back(column + 1, -1.0 + tilt);
    entries.emplace_back(column, 1.5);
    entries.emplace_back(column, 0.5);  // entries of one place add up
    rows.addRow(entries);
  }
  return rows;
}

void multiply(const SparseRows& rows, const double* x, double* y) {
  for (std::size_t i = 0; i < rows.count(); ++i) {
    y[i] = 0.0;
    for (std::size_t k = rows.start[i]; k < rows.start[i + 1]; ++k) y[i] += rows.values[k] * x[rows.columns[k]];
  }
}

TEST(RowInverseTest, IsNotAppliedBeforeItIsMade) {
  const Communicator comm(MPI_COMM_SELF);
  const RowInverse inverse(comm);
  double b = 1.0, x = 0.0;
  EXPECT_FALSE(inverse.isMadeFor(0));
  EXPECT_THROW(inverse.apply(&b, &x), std::logic_error);
}

TEST(RowInverseTest, GmresGetsWhereItsPrecisionDoesNot) {
  const Communicator comm(MPI_COMM_SELF);
  const SparseRows earlier = line(0.3), present = line(0.31);
  std::vector<double> exact(nRows), right(nRows);
  for (std::size_t i = 0; i < nRows; ++i) exact[i] = std::sin(0.1 * static_cast<double>(i));
  multiply(present, exact.data(), right.data());
  const auto errorOf = [&](const std::vector<double>& x) {
    double largest = 0.0;
    for (std::size_t i = 0; i < nRows; ++i) largest = std::max(largest, std::abs(x[i] - exact[i]));
    return largest;
  };
  for (const FactorPrecision precision : {FactorPrecision::Single, FactorPrecision::Double}) {
    RowInverse inverse(comm);
    EXPECT_FALSE(inverse.isMadeFor(nRows));
    ASSERT_EQ(inverse.factor(present, precision), "");
    EXPECT_TRUE(inverse.isMadeFor(nRows));
    EXPECT_FALSE(inverse.isMadeFor(nRows + 1));
    std::vector<double> alone(nRows);
    inverse.apply(right.data(), alone.data());
    if (precision == FactorPrecision::Double)
      EXPECT_LT(errorOf(alone), 1e-11);
    else
      EXPECT_GT(errorOf(alone), 1e-9);
    ASSERT_EQ(inverse.factor(earlier, precision), "");
    std::vector<double> solution(nRows, 0.0);
    const GmresReport report = solveByGmres(
        comm, [&](const double* x, double* y) { multiply(present, x, y); },
        [&](const double* r, double* z) { inverse.apply(r, z); }, right, solution, 1e-12, 100, 100);
    EXPECT_TRUE(report.hasConverged);
    EXPECT_LT(errorOf(solution), 1e-9);
  }
}

TEST(RowInverseTest, SaysWhereAMatrixIsSingular) {
  const Communicator comm(MPI_COMM_SELF);
  SparseRows rows;
  for (const long long column : {0, 0}) {
    std::vector<std::pair<long long, double>> entries{{column, 1.0}};
    rows.addRow(entries);
  }
  for (const FactorPrecision precision : {FactorPrecision::Single, FactorPrecision::Double}) {
    RowInverse inverse(comm);
    EXPECT_EQ(inverse.factor(rows, precision), "the matrix is singular");
    EXPECT_FALSE(inverse.isMadeFor(2));
  }
}

}  // namespace
}  // namespace pd
