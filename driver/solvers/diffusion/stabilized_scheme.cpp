#include "stabilized_scheme.hpp"

#include <cmath>
#include <cstddef>

namespace pd {

namespace {

/// b_j and a_j of both papers, w1, and the parts of the polynomials' recursion
/// P_j(x) = (forward_j x) P_{j-1} - backward_j P_{j-2} at the shifted argument x = w0 + w1 z.
struct Polynomials {
  std::vector<double> a, b, forward, backward;
  double w0 = 1.0, w1 = 0.0, stability = 0.0;
};

Polynomials chebyshev(int nStages) {
  const auto n = static_cast<std::size_t>(nStages) + 1;
  Polynomials p{std::vector<double>(n), std::vector<double>(n), std::vector<double>(n, 2.0),
                std::vector<double>(n, 1.0)};
  const double damping = 2.0 / 13.0;  // Sommeijer et al., eq. (2.3)
  p.w0 = 1.0 + damping / (static_cast<double>(nStages) * nStages);
  std::vector<double> t(n), d(n), d2(n);  // T_j(w0) and its first two derivatives
  t[0] = 1.0, t[1] = p.w0, d[1] = 1.0;
  for (std::size_t j = 2; j < n; ++j) {
    t[j] = 2.0 * p.w0 * t[j - 1] - t[j - 2];
    d[j] = 2.0 * t[j - 1] + 2.0 * p.w0 * d[j - 1] - d[j - 2];
    d2[j] = 4.0 * d[j - 1] + 2.0 * p.w0 * d2[j - 1] - d2[j - 2];
  }
  p.w1 = d[n - 1] / d2[n - 1];
  for (std::size_t j = 2; j < n; ++j) p.b[j] = d2[j] / (d[j] * d[j]);
  p.b[0] = p.b[1] = p.b[2];
  for (std::size_t j = 0; j < n; ++j) p.a[j] = 1.0 - p.b[j] * t[j];
  p.stability = (p.w0 + 1.0) / p.w1;
  return p;
}

Polynomials legendre(int nStages) {
  const auto n = static_cast<std::size_t>(nStages) + 1;
  Polynomials p{std::vector<double>(n), std::vector<double>(n), std::vector<double>(n), std::vector<double>(n)};
  const double s = nStages;
  p.w1 = 4.0 / (s * s + s - 2.0);  // Meyer et al., eq. (17)
  for (std::size_t k = 2; k < n; ++k) {
    const auto j = static_cast<double>(k);
    p.b[k] = (j * j + j - 2.0) / (2.0 * j * (j + 1.0));
    p.forward[k] = (2.0 * j - 1.0) / j;
    p.backward[k] = (j - 1.0) / j;
  }
  p.b[0] = p.b[1] = p.b[2];
  for (std::size_t k = 0; k < n; ++k) p.a[k] = 1.0 - p.b[k];  // P_j(1) = 1
  p.stability = 2.0 / p.w1;
  return p;
}

Polynomials polynomials(StabilizedFamily family, int nStages) {
  return family == StabilizedFamily::Chebyshev ? chebyshev(nStages) : legendre(nStages);
}

}  // namespace

StabilizedScheme stabilizedScheme(StabilizedFamily family, int nStages) {
  const Polynomials p = polynomials(family, nStages);
  StabilizedScheme scheme;
  scheme.stability = p.stability;
  scheme.stages.resize(static_cast<std::size_t>(nStages));
  scheme.stages[0].muTilde = scheme.stages[0].c = p.b[1] * p.w1;
  double cTwoBefore = 0.0;
  for (std::size_t j = 2; j <= static_cast<std::size_t>(nStages); ++j) {
    const StabilizedStage& before = scheme.stages[j - 2];
    StabilizedStage& stage = scheme.stages[j - 1];
    stage.mu = p.forward[j] * p.w0 * p.b[j] / p.b[j - 1];
    stage.nu = -p.backward[j] * p.b[j] / p.b[j - 2];
    stage.muTilde = p.forward[j] * p.w1 * p.b[j] / p.b[j - 1];
    stage.gammaTilde = -p.a[j - 1] * stage.muTilde;
    // What the recursion makes of y' = 1.
    stage.c = stage.mu * before.c + stage.nu * cTwoBefore + stage.muTilde + stage.gammaTilde;
    cTwoBefore = before.c;
  }
  return scheme;
}

int requiredStages(StabilizedFamily family, double stiffness) {
  // Both limits grow as (const) s^2; start below and step up.
  const bool isLegendre = family == StabilizedFamily::Legendre;
  const int step = isLegendre ? 2 : 1;
  int nStages = isLegendre ? 3 : 2;
  const int guess = static_cast<int>(std::sqrt(std::max(0.0, stiffness) / 0.7)) - 2;
  if (guess > nStages) nStages += (guess - nStages) / step * step;
  while (polynomials(family, nStages).stability < stiffness) nStages += step;
  return nStages;
}

}  // namespace pd
