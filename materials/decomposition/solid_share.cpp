#include <algorithm>
#include <cmath>

#include "bond_decomposition.hpp"

namespace pd::decomposition {

namespace {

/// center + sum of s_k edge_k
Place placeIn(const Cell& cell, const std::array<double, 3>& s) {
  Place place = cell.center;
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t d = 0; d < 3; ++d) place[d] += s[k] * cell.edges[k][d];
  return place;
}

/// Nodes and weights of Gauss and Legendre on [-1, 1].
struct GaussRule {
  static constexpr int n = 16;
  std::array<double, n> at{}, weight{};
  GaussRule() {
    constexpr double pi = 3.14159265358979323846;
    for (int k = 0; k < n; ++k) {
      double x = std::cos(pi * (k + 0.75) / (n + 0.5)), slope = 0.0;
      for (int iteration = 0; iteration < 20; ++iteration) {
        double previous = 1.0, value = x;
        for (int m = 2; m <= n; ++m) {
          const double next = ((2 * m - 1) * x * value - (m - 1) * previous) / m;
          previous = value;
          value = next;
        }
        slope = n * (x * value - previous) / (x * x - 1.0);
        x -= value / slope;
      }
      at[static_cast<std::size_t>(k)] = x;
      weight[static_cast<std::size_t>(k)] = 2.0 / ((1.0 - x * x) * slope * slope);
    }
  }
};

/// Integral of f over s from -1/2 to 1/2 across the cell's edge k, piece by piece between the heights at which voids
/// change their form; ends with infinite slope, as of a circle, do no harm.
template <class Function>
double integralAcross(const Cell& cell, std::size_t k, const std::vector<const Void*>& voids, Function f) {
  static const GaussRule gauss;
  constexpr double halfPi = 1.57079632679489661923;
  const double edge2 = dot(cell.edges[k], cell.edges[k]), middle = dot(cell.center, cell.edges[k]);
  std::vector<double> breaks{-0.5, 0.5};
  for (const Void* v : voids)
    for (const double height : v->heights(cell.edges[k])) {
      const double s = (height - middle) / edge2;
      if (s > -0.5 && s < 0.5) breaks.push_back(s);
    }
  std::sort(breaks.begin(), breaks.end());
  double sum = 0.0;
  for (std::size_t piece = 0; piece + 1 < breaks.size(); ++piece) {
    const double half = 0.5 * (breaks[piece + 1] - breaks[piece]), center = breaks[piece] + half;
    if (half <= 0.0) continue;
    for (std::size_t g = 0; g < GaussRule::n; ++g) {
      const double angle = halfPi * gauss.at[g];
      sum += gauss.weight[g] * half * halfPi * std::cos(angle) * f(center + half * std::sin(angle));
    }
  }
  return sum;
}

}  // namespace

double solidShare(const Cell& cell, const std::vector<const Void*>& voids) {
  if (voids.empty()) return 1.0;
  std::vector<Range> ranges;
  const auto takenOfLine = [&](double t, double u) {
    const Place start = placeIn(cell, {-0.5, t, u});
    ranges.clear();
    for (const Void* v : voids) v->addWithin(start, cell.edges[0], ranges);
    return joined(ranges);
  };
  const auto takenOfSection = [&](double u) {
    return integralAcross(cell, 1, voids, [&](double t) { return takenOfLine(t, u); });
  };
  const double taken = cell.dimension == 3 ? integralAcross(cell, 2, voids, takenOfSection) : takenOfSection(0.0);
  return std::max(0.0, 1.0 - taken);
}

double solidShare(const Cell& cell, const std::vector<const Void*>& voids, const DecompositionRule& rule) {
  using Kind = DecompositionRule::Kind;
  if (rule.kind == Kind::Adaptive || rule.kind == Kind::Uniform) return solidShare(cell, voids);
  return std::any_of(voids.begin(), voids.end(), [&](const Void* v) { return v->contains(cell.center); }) ? 0.0 : 1.0;
}

}  // namespace pd::decomposition
