// Assembly and solves on 1, 2 and 4 ranks against matrices that every rank can evaluate point by point.
#include "driver/linear/linear_system.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>

#include "lattice.hpp"

namespace pd::test {
namespace {

const Communicator& world() {
  static const Communicator comm(MPI_COMM_WORLD);
  return comm;
}

double error(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return world().max(largest);
}

void add(LinearSystem& system, const std::vector<int>& indices, const std::vector<std::vector<double>>& block) {
  std::vector<const double*> rows;
  for (const auto& row : block) rows.push_back(row.data());
  system.addValues(static_cast<int>(indices.size()), indices.data(), rows.data());
}

/// The graph Laplacian: sum over bonds of (u_i - u_j)^2 / 2. Each rank adds half of each of its directed bonds, so
/// that rows of ghosts are filled by two ranks.
void addLaplacian(LinearSystem& system, const Discretization& points, double stiffness = 1.0) {
  const int* list = points.neighborhoodList.data();
  const double half = 0.5 * stiffness;
  for (int i = 0; i < points.nOwned; ++i)
    for (int count = *list++; count > 0; --count) {
      const int a = points.globalIds[static_cast<std::size_t>(i)];
      const int b = points.globalIds[static_cast<std::size_t>(*list++)];
      add(system, {a, b}, {{half, -half}, {-half, half}});
    }
}

std::vector<char> leftSideHeld(const Discretization& points, int width) {
  std::vector<char> flags;
  for (int i = 0; i < points.nPoints; ++i)
    flags.insert(flags.end(), static_cast<std::size_t>(width), points.x[static_cast<std::size_t>(3 * i)] == 0.0);
  return flags;
}

/// Zero on the left side, without symmetry.
double exact(const Lattice& lattice, int id, int component) {
  const double x = lattice.coordinate(id, 0), y = lattice.coordinate(id, 1), z = lattice.coordinate(id, 2);
  return x * (1.0 + 0.3 * component + 0.1 * y * y + 0.2 * z) / 10.0;
}

std::vector<double> exactField(const Lattice& lattice, const Discretization& points, int width) {
  std::vector<double> field;
  for (int i = 0; i < points.nOwned; ++i)
    for (int c = 0; c < width; ++c)
      field.push_back(c < lattice.dimension() ? exact(lattice, points.globalIds[static_cast<std::size_t>(i)], c) : 0.0);
  return field;
}

struct Choice {
  const char* method;
  const char* preconditioner;
};
constexpr std::array<Choice, 8> choices{{{"CG", "None"},
                                         {"CG", "Jacobi"},
                                         {"CG", "Block Jacobi"},
                                         {"CG", "ILU"},
                                         {"CG", "Multigrid"},
                                         {"GMRES", "ILU"},
                                         {"GMRES", "Multigrid"},
                                         {"Direct", "None"}}};

TEST(LinearSystemOnRanks, SolvesTheGraphLaplacianByEveryMethod) {
  const Lattice lattice{19, 13, 1, 2.5};
  const Discretization points = lattice.discretization(world());
  LinearSystem system(world(), points, 1, false);
  system.putScalar(0.0);
  addLaplacian(system, points);
  system.finish(leftSideHeld(points, 1));
  EXPECT_FALSE(system.graphIsTooSmall());

  const std::vector<double> solution = exactField(lattice, points, 1);
  std::vector<double> b;
  for (int i = 0; i < points.nOwned; ++i) {
    const int id = points.globalIds[static_cast<std::size_t>(i)];
    double sum = 0.0;
    for (const int other : lattice.neighbours(id)) sum += exact(lattice, id, 0) - exact(lattice, other, 0);
    b.push_back(points.x[static_cast<std::size_t>(3 * i)] == 0.0 ? 0.0 : sum);
  }
  std::vector<double> product(b.size());
  system.apply(solution.data(), product.data());
  EXPECT_LT(error(product, b), 1e-13);

  for (const Choice& choice : choices) {
    std::vector<double> x(b.size(), 0.0);
    const LinearSolveReport report = system.solve(b.data(), x.data(), choice.method, choice.preconditioner, 1e-12, 500);
    EXPECT_TRUE(report.hasConverged) << choice.method << " " << choice.preconditioner;
    EXPECT_LE(report.relativeResidual, 1e-12) << choice.method << " " << choice.preconditioner;
    EXPECT_EQ(report.method, choice.method);
    // The condition number of this lattice is below 1e3.
    EXPECT_LT(error(x, solution), 1e-9) << choice.method << " " << choice.preconditioner;
  }
}

/// Bonds that resist elongation along their own direction: blocks e e^T.
void addSprings(
    LinearSystem& system, const Discretization& points,
    const std::function<bool(const double*, const double*)>& isBroken = [](auto, auto) { return false; }) {
  const int* list = points.neighborhoodList.data();
  for (int i = 0; i < points.nOwned; ++i)
    for (int count = *list++; count > 0; --count) {
      const int j = *list++;
      if (isBroken(&points.x[static_cast<std::size_t>(3 * i)], &points.x[static_cast<std::size_t>(3 * j)])) continue;
      std::array<double, 3> e{};
      double length = 0.0;
      for (int k = 0; k < 3; ++k) {
        e[static_cast<std::size_t>(k)] =
            points.x[static_cast<std::size_t>(3 * j + k)] - points.x[static_cast<std::size_t>(3 * i + k)];
        length += e[static_cast<std::size_t>(k)] * e[static_cast<std::size_t>(k)];
      }
      std::vector<int> indices;
      for (const int point : {i, j})
        for (int k = 0; k < 3; ++k) indices.push_back(3 * points.globalIds[static_cast<std::size_t>(point)] + k);
      std::vector<std::vector<double>> block(6, std::vector<double>(6));
      for (std::size_t a = 0; a < 6; ++a)
        for (std::size_t b = 0; b < 6; ++b)
          block[a][b] = 0.5 * ((a < 3) == (b < 3) ? 1.0 : -1.0) * e[a % 3] * e[b % 3] / length;
      add(system, indices, block);
    }
}

std::vector<double> springForces(const Lattice& lattice, const Discretization& points) {
  std::vector<double> force(static_cast<std::size_t>(3 * points.nOwned), 0.0);
  for (int i = 0; i < points.nOwned; ++i) {
    const int id = points.globalIds[static_cast<std::size_t>(i)];
    if (lattice.coordinate(id, 0) == 0.0) continue;
    for (const int other : lattice.neighbours(id)) {
      const double length = lattice.distance(id, other);
      double elongation = 0.0;
      for (int k = 0; k < lattice.dimension(); ++k)
        elongation += (lattice.coordinate(other, k) - lattice.coordinate(id, k)) / length *
                      (exact(lattice, other, k) - exact(lattice, id, k));
      for (int k = 0; k < 3; ++k)
        force[static_cast<std::size_t>(3 * i + k)] -=
            elongation * (lattice.coordinate(other, k) - lattice.coordinate(id, k)) / length;
    }
  }
  return force;
}

class SpringLattice : public ::testing::TestWithParam<Lattice> {};

TEST_P(SpringLattice, IsSolvedByEveryMethodInItsOwnDimension) {
  const Lattice lattice = GetParam();
  const Discretization points = lattice.discretization(world());
  LinearSystem system(world(), points, 3, false);
  system.putScalar(0.0);
  addSprings(system, points);
  system.finish(leftSideHeld(points, 3));
  const std::vector<double> solution = exactField(lattice, points, 3);
  const std::vector<double> b = springForces(lattice, points);
  std::vector<double> product(b.size());
  system.apply(solution.data(), product.data());
  EXPECT_LT(error(product, b), 1e-12);
  for (const Choice& choice : choices) {
    std::vector<double> x(b.size(), 0.0);
    const LinearSolveReport report = system.solve(b.data(), x.data(), choice.method, choice.preconditioner, 1e-11, 800);
    EXPECT_TRUE(report.hasConverged) << choice.method << " " << choice.preconditioner;
    // The condition number of these lattices is below 1e4.
    EXPECT_LT(error(x, solution), 1e-6) << choice.method << " " << choice.preconditioner;
  }
}

INSTANTIATE_TEST_SUITE_P(Dimensions, SpringLattice,
                         ::testing::Values(Lattice{40, 1, 1, 2.2}, Lattice{17, 11, 1, 3.015}, Lattice{7, 6, 5, 2.2}));

TEST(LinearSystemOnRanks, MultigridStaysDefiniteAndQuickOnACrackedPlate) {
  const Lattice lattice{48, 32, 1, 3.015};
  const Discretization points = lattice.discretization(world());
  LinearSystem system(world(), points, 3, false);
  system.putScalar(0.0);
  addSprings(system, points, [](const double* a, const double* b) {
    return (a[1] > 15.5) != (b[1] > 15.5) && 0.5 * (a[0] + b[0]) > 20.0;
  });
  system.finish(leftSideHeld(points, 3));
  const std::vector<double> solution = exactField(lattice, points, 3);
  std::vector<double> b(solution.size()), x(solution.size(), 0.0);
  system.apply(solution.data(), b.data());
  const LinearSolveReport report = system.solve(b.data(), x.data(), "CG", "Multigrid", 1e-10, 500);
  EXPECT_TRUE(report.hasConverged);
  EXPECT_EQ(report.method, "CG");
  // The points are scattered over the ranks on purpose; multigrid without that needs a third of this.
  EXPECT_LT(report.iterations, 100);
  EXPECT_LT(error(x, solution), 1e-5);
}

/// s_i s_i^T with a vector over the whole family of i couples neighbours' neighbours.
double familyWeight(int centre, int member) { return 1.0 + 0.1 * ((centre * 7 + member * 3) % 11); }

void addFamilies(LinearSystem& system, const Discretization& points) {
  const int* list = points.neighborhoodList.data();
  for (int i = 0; i < points.nOwned; ++i) {
    const int count = *list++;
    std::vector<int> family{points.globalIds[static_cast<std::size_t>(i)]};
    for (int k = 0; k < count; ++k) family.push_back(points.globalIds[static_cast<std::size_t>(*list++)]);
    std::vector<std::vector<double>> block;
    for (const int a : family) {
      block.emplace_back();
      for (const int b : family) block.back().push_back(familyWeight(family[0], a) * familyWeight(family[0], b));
    }
    add(system, family, block);
  }
}

TEST(LinearSystemOnRanks, CouplesWholeFamiliesAcrossRanks) {
  const Lattice lattice{15, 9, 1, 2.3};
  const Discretization points = lattice.discretization(world());
  LinearSystem system(world(), points, 1, true);
  system.putScalar(0.0);
  addFamilies(system, points);
  system.finish(std::vector<char>(static_cast<std::size_t>(points.nPoints), 0));
  EXPECT_FALSE(system.graphIsTooSmall());

  const std::vector<double> field = exactField(lattice, points, 1);
  std::vector<double> expected;
  for (int i = 0; i < points.nOwned; ++i) {
    const int id = points.globalIds[static_cast<std::size_t>(i)];
    double sum = 0.0;
    for (int centre = 0; centre < lattice.size(); ++centre) {
      std::vector<int> family = lattice.neighbours(centre);
      family.push_back(centre);
      if (std::find(family.begin(), family.end(), id) == family.end()) continue;
      for (const int member : family)
        sum += familyWeight(centre, id) * familyWeight(centre, member) * exact(lattice, member, 0);
    }
    expected.push_back(sum);
  }
  std::vector<double> product(field.size());
  system.apply(field.data(), product.data());
  EXPECT_LT(error(product, expected), 1e-10);  // sums of some 1e3 terms of size 10
}

TEST(LinearSystemOnRanks, NoticesAMaterialThatCouplesMoreThanTheGraph) {
  const Lattice lattice{15, 9, 1, 2.3};
  const Discretization points = lattice.discretization(world());
  LinearSystem system(world(), points, 1, false);
  const std::vector<char> isFree(static_cast<std::size_t>(points.nPoints), 0);
  system.putScalar(0.0);
  addFamilies(system, points);
  system.finish(isFree);
  EXPECT_TRUE(system.graphIsTooSmall());
  system.putScalar(0.0);
  addLaplacian(system, points);
  system.finish(isFree);
  EXPECT_FALSE(system.graphIsTooSmall());
}

TEST(LinearSystemOnRanks, ReportsASingularMatrix) {
  const Lattice lattice{15, 9, 1, 2.3};
  const Discretization points = lattice.discretization(world());
  LinearSystem system(world(), points, 1, false);
  system.putScalar(0.0);
  addLaplacian(system, points);
  system.finish(std::vector<char>(static_cast<std::size_t>(points.nPoints), 0));
  // Nothing holds the body and the load does not balance: there is no solution.
  const std::vector<double> b(static_cast<std::size_t>(points.nOwned), 1.0);
  for (const Choice& choice : choices) {
    std::vector<double> x(b.size(), 0.0);
    const LinearSolveReport report = system.solve(b.data(), x.data(), choice.method, choice.preconditioner, 1e-8, 50);
    EXPECT_FALSE(report.hasConverged) << choice.method << " " << choice.preconditioner;
    for (const double value : x) EXPECT_TRUE(std::isfinite(value)) << choice.method << " " << choice.preconditioner;
  }
}

TEST(LinearSystemOnRanks, SolvesAnIndefiniteMatrixWhereCgCannot) {
  const Lattice lattice{15, 9, 1, 2.3};
  const Discretization points = lattice.discretization(world());
  LinearSystem system(world(), points, 1, false);
  system.putScalar(0.0);
  addLaplacian(system, points);
  for (int i = 0; i < points.nOwned; ++i) system.addToDiagonal(i, 0, -5.0);  // within the spectrum [0, 40]
  system.finish(leftSideHeld(points, 1));
  const std::vector<double> solution = exactField(lattice, points, 1);
  std::vector<double> b(solution.size()), x(solution.size(), 0.0);
  system.apply(solution.data(), b.data());
  const LinearSolveReport report = system.solve(b.data(), x.data(), "CG", "None", 1e-11, 500);
  EXPECT_TRUE(report.hasConverged);
  EXPECT_EQ(report.method, "GMRES");
  EXPECT_LT(error(x, solution), 1e-7);
}

TEST(LinearSystemOnRanks, SolvesAgainWithAnotherMatrix) {
  const Lattice lattice{15, 9, 1, 2.3};
  const Discretization points = lattice.discretization(world());
  LinearSystem system(world(), points, 1, false);
  const std::vector<double> solution = exactField(lattice, points, 1);
  for (const double stiffness : {1.0, 1e12, 1e-15}) {
    system.putScalar(0.0);
    addLaplacian(system, points, stiffness);
    system.finish(leftSideHeld(points, 1));
    std::vector<double> b(solution.size());
    system.apply(solution.data(), b.data());
    for (const Choice& choice : choices) {
      std::vector<double> x(b.size(), 0.0);
      system.solve(b.data(), x.data(), choice.method, choice.preconditioner, 1e-11, 500);
      EXPECT_LT(error(x, solution), 1e-8) << choice.method << " " << choice.preconditioner << " " << stiffness;
    }
  }
}

}  // namespace
}  // namespace pd::test
