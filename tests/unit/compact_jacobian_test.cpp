// What is left of a nonlocal diffusion and of what a flow carries in a matrix over near points.
#include "driver/solvers/corrosion/compact_jacobian.hpp"

#include <gtest/gtest.h>
#include <mpi.h>

#include <cmath>
#include <cstdlib>

namespace pd {
namespace {

constexpr int nPoints = 201, reach = 30;

/// Points 1 apart on a line, all free but the last.
Discretization line() {
  Discretization mesh;
  mesh.dimension = 1;
  mesh.nOwned = mesh.nPoints = nPoints;
  mesh.nGlobal = nPoints;
  for (int i = 0; i < nPoints; ++i) {
    mesh.globalIds.push_back(i);
    mesh.x.insert(mesh.x.end(), {static_cast<double>(i), 0.0, 0.0});
    mesh.volume.push_back(1.0);
  }
  return mesh;
}

PointUnknowns unknownsOf(const Discretization& mesh) {
  PointUnknowns unknowns;
  unknowns.localId = mesh.globalIds;
  for (int i = 0; i < nPoints; ++i) {
    unknowns.column.push_back(i);
    unknowns.isFree.push_back(i + 1 < nPoints ? 1.0 : 0.0);
  }
  return unknowns;
}

TEST(CompactJacobianTest, KeepsSumsAndSecondMomentsOfRowsAndWhatIsLarge) {
  const Discretization mesh = line();
  const PointUnknowns unknowns = unknownsOf(mesh);
  CompactJacobian jacobian(unknowns, mesh);
  double moment = 0.0;
  for (int k = 1; k <= reach; ++k) moment += 2.0 * 0.01 * k * k;
  constexpr int carriedFrom = 4;  // a bond of the flow, four points long, into point 120
  for (int i = 0; i < nPoints; ++i)
    for (int j = std::max(0, i - reach); j <= std::min(nPoints - 1, i + reach); ++j) {
      if (j == i) continue;
      jacobian.addValue(i, j, 0.01);
      jacobian.addValue(i, i, -0.01);
    }
  jacobian.addValue(120, 120 - carriedFrom, 3.0);
  jacobian.addValue(120, 120, -3.0);
  const std::vector<double> factor(nPoints, 2.0), more(nPoints, 1.0);
  const SparseRows rows = jacobian.finish(Communicator(MPI_COMM_SELF), factor, more);
  ASSERT_EQ(rows.count(), static_cast<std::size_t>(nPoints));
  const auto entriesOf = [&](std::size_t row) { return rows.start[row + 1] - rows.start[row]; };
  const auto sumOf = [&](std::size_t row, int power) {
    double sum = 0.0;
    for (std::size_t k = rows.start[row]; k < rows.start[row + 1]; ++k)
      sum += rows.values[k] * std::pow(static_cast<double>(rows.columns[k]) - static_cast<double>(row), power);
    return sum;
  };
  EXPECT_EQ(entriesOf(100), 3U);
  EXPECT_NEAR(sumOf(100, 0), 1.0, 1e-6);
  EXPECT_NEAR(sumOf(100, 2), 2.0 * moment, 1e-6 * moment);
  EXPECT_EQ(entriesOf(120), 4U);
  EXPECT_NEAR(sumOf(120, 0), 1.0, 1e-6);
  EXPECT_NEAR(sumOf(120, 1), -2.0 * 3.0 * carriedFrom, 0.5);  // what is small beside it goes to the nearest
  EXPECT_EQ(entriesOf(nPoints - 1), 1U);                      // not free
}

}  // namespace
}  // namespace pd
