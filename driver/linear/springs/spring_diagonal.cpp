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

}  // namespace

SpringDiagonal::SpringDiagonal(const SpringOperator& stiffness) : stiffness_(stiffness) {
  if (!stiffness.isDistributed() || !stiffness.network().hasHalves()) return;
  const SpringNetwork& network = stiffness.network();
  const Discretization& points = network.points();
  own_ = PointVector<double>(points.nPoints, points.dimension * (points.dimension + 1) / 2);
  for (int i = 0; i < points.nOwned; ++i)
    if (std::any_of(network.neighbors(i), network.neighbors(i) + network.nNeighbors(i),
                    [&](int j) { return j >= points.nOwned; }))
      border_.push_back(i);
}

void SpringDiagonal::find(const std::vector<int>& points, PointVector<double>& diagonal) {
  const SpringNetwork& network = stiffness_.network();
  std::vector<char> isWanted(static_cast<std::size_t>(network.points().nPoints), 0);
  for (const int i : points) isWanted[static_cast<std::size_t>(i)] = 1;
  std::vector<char> isAround = network.around(points);
  if (!stiffness_.isDistributed() || !network.hasHalves()) return findOwn(isWanted, isAround, diagonal);
  // Springs of changed points end at ghosts and images: of these all are found.
  std::fill(isWanted.begin() + network.points().nOwned, isWanted.end(), 1);
  for (const int i : border_) isAround[static_cast<std::size_t>(i)] = 1;
  findOwn(isWanted, isAround, own_);
  sumOverCopies(points, diagonal);
}

/// What the springs around them that this rank has hold at the points that are wanted.
void SpringDiagonal::findOwn(const std::vector<char>& isWanted, const std::vector<char>& isAround,
                             PointVector<double>& diagonal) const {
  for (int c = 0; c < diagonal.nComponents(); ++c)
    for (std::size_t i = 0; i < isWanted.size(); ++i)
      if (isWanted[i] != 0) diagonal[c][i] = 0.0;
  const int d = stiffness_.network().dimension();
  if (d == 1) return addOwn<1>(isWanted, isAround, diagonal);
  if (d == 2) return addOwn<2>(isWanted, isAround, diagonal);
  addOwn<3>(isWanted, isAround, diagonal);
}

/// A point's springs come in the same order, whatever else has changed: so its sums are the same to the last bit.
template <int D>
void SpringDiagonal::addOwn(const std::vector<char>& isWanted, const std::vector<char>& isAround,
                            PointVector<double>& diagonal) const {
  constexpr std::size_t nStiffness = D * (D + 1) / 2;
  std::array<double*, nStiffness> sums{};
  for (std::size_t k = 0; k < nStiffness; ++k) sums[k] = diagonal[static_cast<int>(k)];
  stiffness_.network().forEachSpringIn([&](int i) { return isAround[static_cast<std::size_t>(i)] != 0; },
                                       [&](int i, int j, const double* xi, const SpringConstants<double>& c) {
                                         std::array<double, nStiffness> own{};
                                         for (std::size_t a = 0, k = 0; a < D; ++a)
                                           for (std::size_t b = a; b < D; ++b, ++k)
                                             own[k] = c.radial * xi[a] * xi[b] + (a == b ? c.across : 0.0);
                                         for (const int point : {i, j})
                                           for (std::size_t k = 0; k < nStiffness; ++k)
                                             if (isWanted[static_cast<std::size_t>(point)] != 0)
                                               sums[k][point] += own[k];
                                       });
}

/// Adds what ghosts and images hold to the points that they stand for.
void SpringDiagonal::sumOverCopies(const std::vector<int>& wanted, PointVector<double>& diagonal) const {
  const Discretization& points = stiffness_.network().points();
  const int width = own_.nComponents();
  std::vector<double> values(static_cast<std::size_t>(points.nPoints) * static_cast<std::size_t>(width));
  const auto at = [&](int point) { return &values[static_cast<std::size_t>(point) * static_cast<std::size_t>(width)]; };
  for (int point = 0; point < points.nPoints; ++point) {
    std::array<double, 6> own{};
    for (int c = 0; c < width; ++c) own[static_cast<std::size_t>(c)] = own_[c][point];
    if (points.isImage(point)) own = turned(points.symmetry.matrix(points.copyOf(point)), points.dimension, own.data());
    for (int c = 0; c < width; ++c) at(points.sourceOf(point))[c] += own[static_cast<std::size_t>(c)];
  }
  stiffness_.exchange().exportAdd(values.data(), width, std::nullopt);
  for (const int point : wanted)
    for (int c = 0; c < width; ++c) diagonal[c][point] = at(point)[c];
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
