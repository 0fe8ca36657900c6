#include "flow_weights.hpp"

#include <algorithm>
#include <cmath>

#include "exact_weights.hpp"

namespace pd::kernels {

namespace {

/// Largest miss of moments of order 1 that is taken for rounding.
constexpr double exactEnough = 1e-6;

double longestBond(const BondEnds& ends) {
  const auto dimension = static_cast<std::size_t>(ends.dimension);
  double longest = 0.0;
  for (std::size_t k = 0; k < ends.count(); ++k) {
    double square = 0.0;
    for (std::size_t a = 0; a < dimension; ++a) square += ends.xi[dimension * k + a] * ends.xi[dimension * k + a];
    longest = std::max(longest, square);
  }
  return std::sqrt(longest);
}

/// Bonds in units of the longest one, and their lengths as kernels see them: no end is nearer than `nearest`, so that
/// one that a wall cuts short does not outweigh all others.
struct ScaledEnds {
  static constexpr double nearest = 0.05;
  double unit;
  std::vector<double> xi, length;

  explicit ScaledEnds(const BondEnds& ends) : unit(longestBond(ends)), xi(ends.xi) {
    const auto dimension = static_cast<std::size_t>(ends.dimension);
    for (std::size_t k = 0; k < ends.count(); ++k) {
      double square = 0.0;
      for (std::size_t a = 0; a < dimension; ++a) {
        xi[dimension * k + a] /= unit;
        square += xi[dimension * k + a] * xi[dimension * k + a];
      }
      length.push_back(std::max(std::sqrt(square), nearest));
    }
  }
};

/// Of the moments of a gradient: kernel n/|xi|^2 = xi/|xi|^3, whose fit to a linear field has the weights 1/|xi|^3.
std::vector<double> gradientFreedom(const BondEnds& ends, const ScaledEnds& scaled) {
  std::vector<double> freedom(ends.count());
  for (std::size_t k = 0; k < ends.count(); ++k)
    freedom[k] = ends.volume[k] / (scaled.length[k] * scaled.length[k] * scaled.length[k]);
  return freedom;
}

/// Largest of its values 1, so that moments are about 1.
void normalize(std::vector<double>& values) {
  const double largest = values.empty() ? 0.0 : *std::max_element(values.begin(), values.end());
  if (largest > 0.0)
    for (double& value : values) value /= largest;
}

/// False where the ends cannot do it.
bool fitGradient(const BondEnds& ends, const ScaledEnds& scaled, int degree, std::vector<double> freedom,
                 std::vector<double>& result) {
  const auto dimension = static_cast<std::size_t>(ends.dimension);
  normalize(freedom);
  result.assign(dimension * ends.count(), 0.0);
  bool isExact = true;
  for (std::size_t a = 0; a < dimension; ++a) {
    std::array<double, 9> wanted{};
    wanted[a] = 1.0;
    std::vector<double> weights(ends.count(), 0.0);
    isExact = makeExact(ends.dimension, degree, scaled.xi, freedom, wanted, weights) < exactEnough && isExact;
    for (std::size_t k = 0; k < ends.count(); ++k) result[dimension * k + a] = weights[k] / scaled.unit;
  }
  return isExact;
}

}  // namespace

double viscousConstant(int dimension, ViscousKernel kernel) {
  const double laplacian = 2.0 * dimension;
  return kernel == ViscousKernel::Laplacian ? laplacian : laplacian * (dimension + 2.0) / (dimension + 1.0);
}

std::array<double, 9> BondEnds::viscousShare(std::size_t k, ViscousKernel kernel) const {
  std::array<double, 9> share{};
  const double* bond = &xi[k * static_cast<std::size_t>(dimension)];
  double square = 0.0;
  for (int a = 0; a < dimension; ++a) square += bond[a] * bond[a];
  for (int a = 0; a < dimension; ++a)
    for (int b = 0; b < dimension; ++b)
      share[static_cast<std::size_t>(3 * a + b)] =
          (a == b ? 1.0 : 0.0) - (kernel == ViscousKernel::Transverse ? bond[a] * bond[b] / square : 0.0);
  return share;
}

std::vector<double> viscousWeights(const BondEnds& ends, double horizonVolume, ViscousKernel kernel) {
  const ScaledEnds scaled(ends);
  const double alpha = viscousConstant(ends.dimension, ViscousKernel::Laplacian);
  std::vector<double> weights(ends.count());
  for (std::size_t k = 0; k < ends.count(); ++k)
    weights[k] = alpha / horizonVolume * ends.volume[k] / (scaled.length[k] * scaled.length[k]);
  std::vector<double> freedom = weights;
  normalize(freedom);
  std::array<double, 9> wanted{};
  std::size_t at = static_cast<std::size_t>(ends.dimension);
  for (int a = 0; a < ends.dimension; ++a)
    for (int b = a; b < ends.dimension; ++b) wanted[at++] = a == b ? 2.0 : 0.0;
  if (makeExact(ends.dimension, 2, scaled.xi, freedom, wanted, weights) > exactEnough) return {};
  const double ratio = viscousConstant(ends.dimension, kernel) / alpha;
  for (double& weight : weights) weight *= ratio / (scaled.unit * scaled.unit);
  return weights;
}

std::vector<double> gradientWeights(const BondEnds& ends) {
  const ScaledEnds scaled(ends);
  std::vector<double> weights;
  if (!fitGradient(ends, scaled, 2, gradientFreedom(ends, scaled), weights)) return {};
  return weights;
}

std::vector<double> linearGradientWeights(const BondEnds& ends) {
  const ScaledEnds scaled(ends);
  std::vector<double> weights;
  fitGradient(ends, scaled, 1, gradientFreedom(ends, scaled), weights);
  return weights;
}

std::vector<double> interpolationWeights(const BondEnds& ends, const double* place, int degree) {
  if (ends.count() == 0) return {};
  const ScaledEnds scaled(ends);
  const auto dimension = static_cast<std::size_t>(ends.dimension);
  std::array<double, 3> target{};
  for (std::size_t a = 0; a < dimension; ++a) target[a] = place[a] / scaled.unit;
  std::vector<double> freedom(ends.count()), weights(ends.count(), 0.0);
  for (std::size_t k = 0; k < ends.count(); ++k) {
    double square = 0.0;
    for (std::size_t a = 0; a < dimension; ++a) {
      const double apart = scaled.xi[dimension * k + a] - target[a];
      square += apart * apart;
    }
    constexpr double core = 0.03;  // of the longest bond, squared: ends nearer than that count alike
    freedom[k] = core * core / ((square + core) * (square + core));
  }
  if (makeExact(ends.dimension, degree, scaled.xi, freedom, monomialsOf(ends.dimension, degree, target.data()),
                weights) > exactEnough)
    return {};
  return weights;
}

double pressureSmoothing(int dimension, double spacing, double length) {
  // Sum of |xi|^-4 xi_x^2 over the points within 1.5 spacings of a square or cubic lattice: 3 in the plane, 4 in space
  // (2 on a line).
  const double moment = dimension == 1 ? 2.0 : dimension == 2 ? 3.0 : 4.0;
  const double square = length * length;
  return 2.0 / moment * spacing * spacing / (square * square);
}

}  // namespace pd::kernels
