#include "spring_operator.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "../../solvers/symmetric_eigen.hpp"
#include "spring_kernels.hpp"

namespace pd {

namespace {

using Family = SpringNetwork::Family;

/// Minus the inverse of a symmetric matrix (upper triangle of 3 x 3); directions that nothing turns stay as they are.
std::array<double, 6> minusInverse(const std::array<double, 6>& a) {
  const SymmetricEigen eigen = symmetricEigen({a[0], a[1], a[2], a[1], a[3], a[4], a[2], a[4], a[5]}, 3);
  std::array<double, 6> result{};
  for (std::size_t k = 0; k < 3; ++k) {
    if (std::abs(eigen.values[k]) <= 1e-10 * std::abs(eigen.values[2])) continue;
    const double* v = &eigen.vectors[3 * k];
    for (std::size_t i = 0, at = 0; i < 3; ++i)
      for (std::size_t j = i; j < 3; ++j, ++at) result[at] -= v[i] * v[j] / eigen.values[k];
  }
  return result;
}

}  // namespace

SpringOperator::SpringOperator(const SpringNetwork& network, const PointExchange& exchange, bool isDistributed)
    : network_(network), exchange_(exchange), isDistributed_(isDistributed) {
  const int n = network.points().nPoints, width = network.familyWidth();
  if (isDistributed) findSources();
  response_ = {PointVector<double>(n, width == 3 ? 6 : width), PointVector<float>(n, width == 3 ? 6 : width)};
  families_ = {PointVector<double>(n, width), PointVector<float>(n, width)};
  const int nOwned = network.points().nOwned;
  isHeld_.assign(3 * static_cast<std::size_t>(nOwned), 0);
  if (network.family() == Family::Dilatation && width > 0) {
    const double unit = network.stiffnessUnit() * network.lengthUnit() * network.lengthUnit();
    for (int i = 0; i < nOwned; ++i) {
      std::get<0>(response_)[0][i] = unit * network.dilatational()[static_cast<std::size_t>(i)];
      std::get<1>(response_)[0][i] = static_cast<float>(std::get<0>(response_)[0][i]);
    }
  }
}

/// What ghosts and images add reaches the points that they stand for.
void SpringOperator::findSources() {
  const int nOwned = network_.points().nOwned;
  exchanged_.resize(3 * static_cast<std::size_t>(network_.points().nPoints));
  std::fill(exchanged_.begin() + nOwned, exchanged_.begin() + network_.points().nPoints, 1.0);
  exchange_.exportAdd(exchanged_.data(), 1, Reflection::Even);
  for (int i = 0; i < nOwned; ++i)
    if (exchanged_[static_cast<std::size_t>(i)] != 0.0) sources_.push_back(i);
}

void SpringOperator::refresh(const std::vector<int>& changed) {
  if (network_.family() == Family::Rotation && network_.familyWidth() > 0) findResponse(changed);
}

/// Minus the inverse of what the springs of a family resist its rotation by.
void SpringOperator::findResponse(const std::vector<int>& changed) {
  const int width = network_.familyWidth(), nOwned = network_.points().nOwned;
  PointVector<double>& response = std::get<0>(response_);
  PointVector<float>& floatResponse = std::get<1>(response_);
  const auto set = [&](int component, int i, double value) {
    response[component][i] = value;
    floatResponse[component][i] = static_cast<float>(value);
  };
  std::vector<char> isChanged(static_cast<std::size_t>(network_.points().nPoints), 0);
  for (const int i : changed) {
    isChanged[static_cast<std::size_t>(i)] = 1;
    for (int k = 0; k < response.nComponents(); ++k) response[k][i] = 0.0;
  }
  const std::vector<char> isAround = network_.around(changed);
  // A point's springs come in the same order, whatever else has changed: so its sums are the same to the last bit.
  network_.forEachSpringIn([&](int i) { return isAround[static_cast<std::size_t>(i)] != 0; },
                           [&](int i, int j, const double* xi, const SpringConstants<double>& c) {
                             const auto add = [&](int point, double share) {
                               if (isChanged[static_cast<std::size_t>(point)] == 0) return;
                               if (width == 1) {
                                 response[0][point] += share * (xi[0] * xi[0] + xi[1] * xi[1]);
                                 return;
                               }
                               const double length2 = xi[0] * xi[0] + xi[1] * xi[1] + xi[2] * xi[2];
                               for (int a = 0, at = 0; a < 3; ++a)
                                 for (int b = a; b < 3; ++b, ++at)
                                   response[at][point] += share * ((a == b ? length2 : 0.0) - xi[a] * xi[b]);
                             };
                             add(i, c.own);
                             if (j < nOwned) add(j, c.others);
                           });
  for (const int i : changed) {
    if (width == 1) {
      set(0, i, response[0][i] != 0.0 ? -1.0 / response[0][i] : 0.0);
      continue;
    }
    std::array<double, 6> a{};
    for (int k = 0; k < 6; ++k) a[static_cast<std::size_t>(k)] = response[k][i];
    a = minusInverse(a);
    for (int k = 0; k < 6; ++k) set(k, i, a[static_cast<std::size_t>(k)]);
  }
}

void SpringOperator::hold(const std::vector<char>& isHeld) {
  isHeld_ = isHeld;
  held_.clear();
  for (int c = 0; c < network_.dimension(); ++c)
    for (int i = 0; i < network_.points().nOwned; ++i)
      if (this->isHeld(i, c)) held_.emplace_back(c, i);
}

template <class Real>
void SpringOperator::zeroHeld(PointVector<Real>& x) const {
  for (const auto& [component, point] : held_) x[component][point] = Real(0);
}

template <class Real>
void SpringOperator::import(PointVector<Real>& x, int width, int first, Reflection rule) {
  if (!isDistributed_) return;
  const int nOwned = network_.points().nOwned, nPoints = network_.points().nPoints;
  const auto at = [&](int c, int i) -> double& { return exchanged_[static_cast<std::size_t>(width * i + first + c)]; };
  for (int c = 0; c < x.nComponents(); ++c)
    for (const int i : sources_) at(c, i) = static_cast<double>(x[c][i]);
  exchange_.import(exchanged_.data(), width, rule);
  for (int c = 0; c < x.nComponents(); ++c)
    for (int i = nOwned; i < nPoints; ++i) x[c][i] = static_cast<Real>(at(c, i));
}

/// The families at the other ends of springs that are no halves.
template <class Real>
void SpringOperator::importResponses(PointVector<Real>& t) {
  if (network_.hasHalves()) return;
  if (network_.family() == Family::Dilatation) return import(t, 1, 0, Reflection::Even);
  import(t, 3, t.nComponents() == 1 ? 2 : 0, Reflection::AxialVector);
}

template <class Real>
void SpringOperator::exportFrom(PointVector<Real>& y) {
  if (!isDistributed_ || !network_.hasHalves()) return;
  const int nOwned = network_.points().nOwned, nPoints = network_.points().nPoints;
  const auto copy = [&](int c, int i) {
    exchanged_[static_cast<std::size_t>(3 * i + c)] = c < y.nComponents() ? static_cast<double>(y[c][i]) : 0.0;
  };
  for (int c = 0; c < 3; ++c) {
    for (const int i : sources_) copy(c, i);
    for (int i = nOwned; i < nPoints; ++i) copy(c, i);
  }
  exchange_.exportAdd(exchanged_.data(), 3, Reflection::Vector);
  for (int c = 0; c < y.nComponents(); ++c)
    for (const int i : sources_) y[c][i] = static_cast<Real>(exchanged_[static_cast<std::size_t>(3 * i + c)]);
}

template <class Real>
void SpringOperator::applyToAll(PointVector<Real>& x, PointVector<Real>& y) {
  importInto(x);
  PointVector<Real>& t = std::get<PointVector<Real>>(families_);
  const PointVector<Real>& response = std::get<PointVector<Real>>(response_);
  const int width = network_.familyWidth(), nOwned = network_.points().nOwned;
  if (width > 0) {
    t.zero();
    addSpringFamilies(network_, x, t);
    for (int i = 0; i < nOwned && width == 1; ++i) t[0][i] *= response[0][i];
    for (int i = 0; i < nOwned && width == 3; ++i) {
      const Real s[3] = {t[0][i], t[1][i], t[2][i]};
      t[0][i] = response[0][i] * s[0] + response[1][i] * s[1] + response[2][i] * s[2];
      t[1][i] = response[1][i] * s[0] + response[3][i] * s[1] + response[4][i] * s[2];
      t[2][i] = response[2][i] * s[0] + response[4][i] * s[1] + response[5][i] * s[2];
    }
    importResponses(t);
  }
  springForces(network_, x, t, y);
  exportFrom(y);
}

namespace {

using Vector3 = std::array<double, 3>;

/// Of components that a point has, 0 in the others.
Vector3 at(const PointVector<double>& x, int point) {
  Vector3 value{};
  for (int c = 0; c < x.nComponents(); ++c) value[static_cast<std::size_t>(c)] = x[c][point];
  return value;
}
Vector3 difference(const PointVector<double>& x, int i, int j) {
  const int d = x.nComponents();
  return {x[0][j] - x[0][i], d > 1 ? x[1][j] - x[1][i] : 0.0, d > 2 ? x[2][j] - x[2][i] : 0.0};
}
Vector3 spatial(const double* xi, int dimension) {
  return {xi[0], dimension > 1 ? xi[1] : 0.0, dimension > 2 ? xi[2] : 0.0};
}
double dot(const Vector3& a, const Vector3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vector3 cross(const Vector3& a, const Vector3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
/// As many components as a family has: of a rotation in a plane the third alone.
Vector3 familyVector(const PointVector<double>& t, int point) {
  const Vector3 value = at(t, point);
  return t.nComponents() == 1 ? Vector3{0.0, 0.0, value[0]} : value;
}

}  // namespace

void SpringOperator::updateResponses(const std::vector<int>& changed, const PointVector<double>& x,
                                     PointVector<double>& responses) {
  const int nOwned = network_.points().nOwned, width = network_.familyWidth();
  std::vector<char> isChanged(static_cast<std::size_t>(network_.points().nPoints), 0);
  for (const int i : changed) isChanged[static_cast<std::size_t>(i)] = 1;
  const std::vector<char> isAround = network_.around(changed);
  std::vector<Vector3> s(isChanged.size());
  network_.forEachSpringIn(
      [&](int i) { return isAround[static_cast<std::size_t>(i)] != 0; },
      [&](int i, int j, const double* inSpace, const SpringConstants<double>& c) {
        const Vector3 xi = spatial(inSpace, network_.dimension()), eta = difference(x, i, j);
        const Vector3 bond = network_.family() == Family::Rotation ? cross(xi, eta) : Vector3{0.0, 0.0, dot(xi, eta)};
        for (std::size_t d = 0; d < 3; ++d) {
          s[static_cast<std::size_t>(i)][d] += c.own * bond[d];
          if (j < nOwned) s[static_cast<std::size_t>(j)][d] += c.others * bond[d];
        }
      });
  const PointVector<double>& r = response<double>();
  for (const int i : changed) {
    const Vector3& own = s[static_cast<std::size_t>(i)];
    if (width == 1) {
      responses[0][i] = r[0][i] * own[2];
      continue;
    }
    responses[0][i] = r[0][i] * own[0] + r[1][i] * own[1] + r[2][i] * own[2];
    responses[1][i] = r[1][i] * own[0] + r[3][i] * own[1] + r[4][i] * own[2];
    responses[2][i] = r[2][i] * own[0] + r[4][i] * own[1] + r[5][i] * own[2];
  }
  importResponses(responses);
}

/// Owned points that are among these or have one of them as a neighbour: they feel what its family turns by.
/// `otherHasChanged` [nPoints] of ghosts and images; empty: none.
std::vector<int> SpringOperator::pointsThatFeel(const std::vector<int>& changed,
                                                const std::vector<char>& otherHasChanged) const {
  std::vector<char> feels = network_.around(changed);
  const int nOwned = network_.points().nOwned;
  for (int i = 0; i < nOwned && !otherHasChanged.empty(); ++i) {
    const int *first = network_.neighbors(i), *last = first + network_.nNeighbors(i);
    if (first == last || last[-1] < nOwned || feels[static_cast<std::size_t>(i)] != 0) continue;
    feels[static_cast<std::size_t>(i)] =
        std::any_of(first, last, [&](int j) { return otherHasChanged[static_cast<std::size_t>(j)] != 0; }) ? 1 : 0;
  }
  std::vector<int> felt;
  for (int i = 0; i < nOwned; ++i)
    if (feels[static_cast<std::size_t>(i)] != 0) felt.push_back(i);
  return felt;
}

void SpringOperator::bringToOthers(PointVector<double>& x, PointVector<double>& responses) {
  importInto(x);
  if (network_.familyWidth() > 0) importResponses(responses);
}

void SpringOperator::updateAll(const std::vector<int>& changed, const PointVector<double>& x,
                               PointVector<double>& responses, PointVector<double>& y) {
  const int nOwned = network_.points().nOwned, nPoints = network_.points().nPoints;
  const bool hasFamily = network_.familyWidth() > 0;
  std::vector<char> otherHasChanged;
  if (hasFamily) {
    std::vector<double> before;  // of ghosts and images
    for (int c = 0; c < responses.nComponents(); ++c)
      before.insert(before.end(), responses[c] + nOwned, responses[c] + nPoints);
    updateResponses(changed, x, responses);
    auto known = before.begin();
    for (int c = 0; c < responses.nComponents(); ++c)
      for (int i = nOwned; i < nPoints; ++i) {
        if (responses[c][i] == *known++) continue;
        otherHasChanged.resize(static_cast<std::size_t>(nPoints), 0);
        otherHasChanged[static_cast<std::size_t>(i)] = 1;
      }
  }
  const std::vector<int> felt = pointsThatFeel(changed, otherHasChanged);
  std::vector<char> isFelt(static_cast<std::size_t>(nPoints), 0);
  for (const int i : felt) {
    isFelt[static_cast<std::size_t>(i)] = 1;
    for (int c = 0; c < y.nComponents(); ++c) y[c][i] = 0.0;
  }
  const std::vector<char> isAround = network_.around(felt);
  network_.forEachSpringIn(
      [&](int i) { return isAround[static_cast<std::size_t>(i)] != 0; },
      [&](int i, int j, const double* inSpace, const SpringConstants<double>& spring) {
        const Vector3 xi = spatial(inSpace, network_.dimension()), eta = difference(x, i, j);
        const double along = spring.radial * dot(xi, eta);
        Vector3 force{};
        for (std::size_t d = 0; d < 3; ++d) force[d] = along * xi[d] + spring.across * eta[d];
        if (hasFamily) {
          const Vector3 a = familyVector(responses, i), b = familyVector(responses, j);
          const Vector3 t{spring.own * a[0] + spring.others * b[0], spring.own * a[1] + spring.others * b[1],
                          spring.own * a[2] + spring.others * b[2]};
          const Vector3 turn =
              network_.family() == Family::Rotation ? cross(t, xi) : Vector3{t[2] * xi[0], t[2] * xi[1], t[2] * xi[2]};
          for (std::size_t d = 0; d < 3; ++d) force[d] += turn[d];
        }
        for (int c = 0; c < y.nComponents(); ++c) {
          if (isFelt[static_cast<std::size_t>(i)] != 0) y[c][i] -= force[static_cast<std::size_t>(c)];
          if (isFelt[static_cast<std::size_t>(j)] != 0) y[c][j] += force[static_cast<std::size_t>(c)];
        }
      });
}

template <class Real>
void SpringOperator::addAdditions(const PointVector<Real>& x, PointVector<Real>& y) const {
  for (const Addition& addition : additions_)
    y[addition.component][addition.point] += static_cast<Real>(addition.value) * x[addition.component][addition.point];
}

template <class Real>
void SpringOperator::apply(PointVector<Real>& x, PointVector<Real>& y) {
  applyToAll(x, y);
  addAdditions(x, y);
  zeroHeld(y);
}

void SpringOperator::applyStiffly(PointVector<float>& x, PointVector<float>& y) {
  if (network_.family() != Family::Rotation) return apply(x, y);
  importInto(x);
  stiffSpringForces(network_, x, y);
  exportFrom(y);
  addAdditions(x, y);
  zeroHeld(y);
}

template void SpringOperator::applyToAll(PointVector<double>&, PointVector<double>&);
template void SpringOperator::applyToAll(PointVector<float>&, PointVector<float>&);
template void SpringOperator::apply(PointVector<double>&, PointVector<double>&);
template void SpringOperator::apply(PointVector<float>&, PointVector<float>&);
template void SpringOperator::addAdditions(const PointVector<double>&, PointVector<double>&) const;
template void SpringOperator::zeroHeld(PointVector<double>&) const;
template void SpringOperator::zeroHeld(PointVector<float>&) const;

}  // namespace pd
