#include "lattice_stability.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pd::kernels {

namespace {

using Point = std::array<double, 3>;
using Tensor = std::array<std::array<double, 3>, 3>;

double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Tensor acousticTensor(const std::vector<WeightedBond>& bonds, const Point& q, int dimension,
                      const ElasticConstants& constants, TangentialForm form) {
  // Rotation of the neighbourhood in the wave u = a exp(iqx): with weights w = g V/|xi| and I = sum w (|xi|^2 1 - xi
  // xi^T), theta = I^-1 sum w sin(q.xi) xi x a; it takes k_t theta.I.theta from the energy (constraint of a stationary
  // point).
  Tensor a{};
  Tensor inertia{};
  Tensor moment{};  // theta_before_inverse = moment . a
  for (const WeightedBond& bond : bonds) {
    const double length2 = dot(bond.xi, bond.xi), length = std::sqrt(length2), phase = dot(q, bond.xi);
    const double w = bond.weight / length, rise = 1.0 - std::cos(phase), wave = std::sin(phase);
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) {
        const double m = bond.xi[i] * bond.xi[j] / length2, identity = i == j ? 1.0 : 0.0;
        a[i][j] += 2.0 * rise * w * ((constants.normal - constants.tangential) * m + constants.tangential * identity);
        inertia[i][j] += w * (length2 * identity - bond.xi[i] * bond.xi[j]);
      }
    const Point& x = bond.xi;
    const Tensor cross{{{0, -x[2], x[1]}, {x[2], 0, -x[0]}, {-x[1], x[0], 0}}};
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) moment[i][j] += w * wave * cross[i][j];
  }
  if (form == TangentialForm::Linear || dimension == 1) return a;
  // Neighbourhoods of a plane turn about z alone; those of a solid have a nearly diagonal inertia on lattices, but any
  // symmetric positive one is inverted here.
  Tensor inverse{};
  if (dimension == 2) {
    inverse[2][2] = 1.0 / inertia[2][2];
  } else {
    const auto& m = inertia;
    const double c0 = m[1][1] * m[2][2] - m[1][2] * m[2][1], c1 = m[1][2] * m[2][0] - m[1][0] * m[2][2],
                 c2 = m[1][0] * m[2][1] - m[1][1] * m[2][0];
    const double det = m[0][0] * c0 + m[0][1] * c1 + m[0][2] * c2;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) {
        const std::size_t r = (j + 1) % 3, s = (j + 2) % 3, t = (i + 1) % 3, u = (i + 2) % 3;
        inverse[i][j] = (m[r][t] * m[s][u] - m[r][u] * m[s][t]) / det;
      }
  }
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t k = 0; k < 3; ++k)
        for (std::size_t l = 0; l < 3; ++l)
          a[i][j] -= constants.tangential * moment[k][i] * inverse[k][l] * moment[l][j];
  return a;
}

/// Extreme eigenvalues of the leading block of a symmetric tensor, by Jacobi rotations.
std::array<double, 2> extremeEigenvalues(Tensor a, std::size_t dimension) {
  for (int sweep = 0; sweep < 20; ++sweep)
    for (std::size_t p = 0; p < dimension; ++p)
      for (std::size_t q = p + 1; q < dimension; ++q) {
        if (a[p][q] == 0.0) continue;
        const double theta = 0.5 * (a[q][q] - a[p][p]) / a[p][q];
        const double t = std::copysign(1.0, theta) / (std::abs(theta) + std::sqrt(theta * theta + 1.0));
        const double c = 1.0 / std::sqrt(t * t + 1.0), s = t * c;
        for (std::size_t k = 0; k < dimension; ++k) {
          const double kp = a[k][p], kq = a[k][q];
          a[k][p] = c * kp - s * kq;
          a[k][q] = s * kp + c * kq;
        }
        for (std::size_t k = 0; k < dimension; ++k) {
          const double pk = a[p][k], qk = a[q][k];
          a[p][k] = c * pk - s * qk;
          a[q][k] = s * pk + c * qk;
        }
      }
  double low = a[0][0], high = a[0][0];
  for (std::size_t i = 1; i < dimension; ++i) {
    low = std::min(low, a[i][i]);
    high = std::max(high, a[i][i]);
  }
  return {low, high};
}

std::vector<Point> directions(int dimension) {
  const double pi = std::acos(-1.0);
  std::vector<Point> result;
  if (dimension == 1) return {{1.0, 0.0, 0.0}};
  constexpr int steps = 24;
  for (int i = 0; i < steps; ++i) {
    const double phi = pi * i / steps;
    if (dimension == 2) {
      result.push_back({std::cos(phi), std::sin(phi), 0.0});
      continue;
    }
    for (int j = 0; j <= steps / 2; ++j) {
      const double theta = pi * j / steps;
      result.push_back({std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)});
    }
  }
  return result;
}

}  // namespace

double smallestRelativeStiffness(const std::vector<WeightedBond>& bonds, int dimension,
                                 const ElasticConstants& constants, TangentialForm form) {
  double shortest = std::numeric_limits<double>::infinity();
  for (const WeightedBond& bond : bonds) shortest = std::min(shortest, std::sqrt(dot(bond.xi, bond.xi)));
  double smallest = std::numeric_limits<double>::infinity();
  constexpr int waveNumbers = 12;
  for (const Point& direction : directions(dimension))
    for (int n = 1; n <= waveNumbers; ++n) {
      // The first one is the long-wave limit.
      const double scale = (n == 1 ? 1e-3 : static_cast<double>(n) / waveNumbers) * std::acos(-1.0) / shortest;
      const Point q{scale * direction[0], scale * direction[1], scale * direction[2]};
      const auto [low, high] =
          extremeEigenvalues(acousticTensor(bonds, q, dimension, constants, form), static_cast<std::size_t>(dimension));
      smallest = std::min(smallest, high > 0.0 ? low / high : -1.0);
    }
  return smallest;
}

}  // namespace pd::kernels
