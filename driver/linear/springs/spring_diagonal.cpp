#include "spring_diagonal.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "../../solvers/symmetric_eigen.hpp"

namespace pd {

namespace {

/// Place of (a, b) in an upper triangle.
int place(int dimension, int a, int b) {
  if (a > b) std::swap(a, b);
  return a * dimension - a * (a - 1) / 2 + b - a;
}

/// What the springs of images resist at what they mirror: M k M.
std::array<double, 6> turned(const Symmetry::Matrix& m, int dimension, const double* k) {
  std::array<double, 6> result{};
  for (int a = 0; a < dimension; ++a)
    for (int b = a; b < dimension; ++b)
      for (int c = 0; c < dimension; ++c)
        for (int d = 0; d < dimension; ++d)
          result[static_cast<std::size_t>(place(dimension, a, b))] += m[static_cast<std::size_t>(3 * a + c)] *
                                                                      k[place(dimension, c, d)] *
                                                                      m[static_cast<std::size_t>(3 * d + b)];
  return result;
}

/// Adds what ghosts and images hold to the points that they stand for.
void sumOverCopies(const SpringOperator& stiffness, PointVector<double>& diagonal) {
  const Discretization& points = stiffness.network().points();
  const int width = diagonal.nComponents();
  std::vector<double> values(static_cast<std::size_t>(points.nPoints) * static_cast<std::size_t>(width));
  const auto at = [&](int point) { return &values[static_cast<std::size_t>(point) * static_cast<std::size_t>(width)]; };
  for (int point = 0; point < points.nPoints; ++point) {
    std::array<double, 6> own{};
    for (int c = 0; c < width; ++c) own[static_cast<std::size_t>(c)] = diagonal[c][point];
    if (points.isImage(point)) own = turned(points.symmetry.matrix(points.copyOf(point)), points.dimension, own.data());
    for (int c = 0; c < width; ++c) at(points.sourceOf(point))[c] += own[static_cast<std::size_t>(c)];
  }
  stiffness.exchange().exportAdd(values.data(), width, std::nullopt);
  for (int point = 0; point < points.nOwned; ++point)
    for (int c = 0; c < width; ++c) diagonal[c][point] = at(point)[c];
}

}  // namespace

void findSpringDiagonal(const SpringOperator& stiffness, const std::vector<int>& points,
                        PointVector<double>& diagonal) {
  const SpringNetwork& network = stiffness.network();
  const int d = network.dimension();
  const auto nPoints = static_cast<std::size_t>(network.points().nPoints);
  // Ghosts and images bring what other ranks and the points that they mirror have found.
  const bool findsAll = stiffness.isDistributed();
  std::vector<char> isWanted(nPoints, findsAll ? 1 : 0), isAround = isWanted;
  if (findsAll) diagonal.zero();
  if (!findsAll) isAround = network.around(points);
  for (const int i : points) {
    isWanted[static_cast<std::size_t>(i)] = 1;
    for (int c = 0; c < diagonal.nComponents(); ++c) diagonal[c][i] = 0.0;
  }
  // A point's springs come in the same order, whatever else has changed: so its sums are the same to the last bit.
  network.forEachSpringIn([&](int i) { return isAround[static_cast<std::size_t>(i)] != 0; },
                          [&](int i, int j, const double* xi, const SpringConstants<double>& c) {
                            for (const int point : {i, j}) {
                              if (isWanted[static_cast<std::size_t>(point)] == 0) continue;
                              for (int a = 0, at = 0; a < d; ++a)
                                for (int b = a; b < d; ++b, ++at)
                                  diagonal[at][point] += c.radial * xi[a] * xi[b] + (a == b ? c.across : 0.0);
                            }
                          });
  if (stiffness.isDistributed()) sumOverCopies(stiffness, diagonal);
}

std::vector<SpringOperator::Addition> stiffeningOfLoosePoints(const SpringOperator& stiffness,
                                                              const PointVector<double>& diagonal,
                                                              const std::vector<int>& points) {
  constexpr double negligible = 1e-6, added = 1e-4;  // of the point's largest stiffness
  const int d = stiffness.network().dimension();
  std::vector<SpringOperator::Addition> additions;
  std::vector<int> axes;
  std::vector<double> own;
  for (const int point : points) {
    axes.clear();
    own.clear();
    for (int axis = 0; axis < d; ++axis)
      if (!stiffness.isHeld(point, axis)) axes.push_back(axis);
    if (axes.empty()) continue;
    for (const int a : axes)
      for (const int b : axes) own.push_back(diagonal[place(d, a, b)][point]);
    // Most points are far from it, as their determinants tell without eigenvalues.
    if (axes.size() == 2 && own[0] * own[3] - own[1] * own[2] > 2.0 * negligible * std::pow(own[0] + own[3], 2))
      continue;
    if (axes.size() == 1 && own[0] > 0.0) continue;
    if (axes.size() == 3) {
      const double determinant = own[0] * (own[4] * own[8] - own[5] * own[7]) -
                                 own[1] * (own[3] * own[8] - own[5] * own[6]) +
                                 own[2] * (own[3] * own[7] - own[4] * own[6]);
      if (determinant > 2.0 * negligible * std::pow(own[0] + own[4] + own[8], 3)) continue;
    }
    const SymmetricEigen eigen = symmetricEigen(own, static_cast<int>(axes.size()));
    if (eigen.values.front() > negligible * eigen.values.back()) continue;
    const double largest = std::max(std::abs(eigen.values.front()), std::abs(eigen.values.back()));
    for (const int axis : axes) additions.push_back({point, axis, largest > 0.0 ? added * largest : 1.0});
  }
  return additions;
}

}  // namespace pd
