#include "bond_constants.hpp"

#include <algorithm>
#include <cmath>

namespace pd::kernels {

namespace {

const double pi = std::acos(-1.0);

/// Moment integral_0^1 omega(r delta) r^power dr relative to that of omega = 1, by composite two-point Gauss.
double relativeMoment(const Influence& influence, double horizon, int power) {
  constexpr int panels = 2000;
  const double gauss = 0.5 / std::sqrt(3.0);
  double weighted = 0.0;
  for (int panel = 0; panel < panels; ++panel)
    for (const double shift : {0.5 - gauss, 0.5 + gauss}) {
      const double r = (panel + shift) / panels;
      weighted += 0.5 / panels * influence(r * horizon, horizon) * std::pow(r, power);
    }
  return weighted * (power + 1);
}

/// Calls visit(x, y, z, r, share of the cell) for every neighbour on an ideal lattice.
template <class Visit>
void forLattice(int dimension, double horizon, double spacing, VolumeCorrection rule, Visit visit) {
  if (rule == VolumeCorrection::EveryNeighbor) rule = VolumeCorrection::None;  // a lattice has points everywhere
  const int reach = static_cast<int>(std::ceil(horizon / spacing)) + 1;
  const int reachY = dimension > 1 ? reach : 0, reachZ = dimension > 2 ? reach : 0;
  for (int k = -reachZ; k <= reachZ; ++k)
    for (int j = -reachY; j <= reachY; ++j)
      for (int i = -reach; i <= reach; ++i) {
        if (i == 0 && j == 0 && k == 0) continue;
        const double x = i * spacing, y = j * spacing, z = k * spacing;
        const double r = std::sqrt(x * x + y * y + z * z);
        const double share = volumeShare(rule, r, horizon, spacing);
        if (share > 0.0) visit(x, y, z, r, share);
      }
}

double cellVolume(double spacing, const Section& section) {
  return section.size * std::pow(spacing, dimensionOf(section.geometry));
}

}  // namespace

int dimensionOf(Geometry geometry) {
  if (geometry == Geometry::Bar) return 1;
  return geometry == Geometry::Solid ? 3 : 2;
}

double spacingOf(double volume, const Section& section) {
  switch (dimensionOf(section.geometry)) {
    case 1:
      return volume / section.size;
    case 2:
      return std::sqrt(volume / section.size);
    default:
      return std::cbrt(volume);
  }
}

double horizonVolume(double horizon, const Section& section) {
  switch (dimensionOf(section.geometry)) {
    case 1:
      return 2.0 * section.size * horizon;
    case 2:
      return pi * section.size * horizon * horizon;
    default:
      return 4.0 / 3.0 * pi * horizon * horizon * horizon;
  }
}

double volumeShare(VolumeCorrection rule, double distance, double horizon, double spacing) {
  // Lattice points at exactly the horizon are in, whatever the round-off of their coordinates.
  const bool isInside = distance <= horizon * (1.0 + 1e-10);
  if (rule == VolumeCorrection::EveryNeighbor) return 1.0;
  if (rule == VolumeCorrection::None) return isInside ? 1.0 : 0.0;
  if (rule == VolumeCorrection::RampToHorizon && !isInside) return 0.0;
  return std::clamp((horizon + 0.5 * spacing - distance) / spacing, 0.0, 1.0);
}

double surfaceFactor(double wholeVolume, double familyVolume, double neighborFamilyVolume) {
  return 2.0 * wholeVolume / (familyVolume + neighborFamilyVolume);
}

double latticeFamilyVolume(const Section& section, double horizon, double spacing, VolumeCorrection rule) {
  double sum = 0.0;
  forLattice(dimensionOf(section.geometry), horizon, spacing, rule,
             [&](double, double, double, double, double share) { sum += share; });
  return sum * cellVolume(spacing, section);
}

Stiffness stiffness(Geometry geometry, double youngsModulus, double nu) {
  const double E = youngsModulus;
  if (geometry == Geometry::Bar) return {E, 0.0};
  if (geometry == Geometry::PlaneStress) return {E / (1.0 - nu * nu), nu * E / (1.0 - nu * nu)};
  const double lame = E * nu / ((1.0 + nu) * (1.0 - 2.0 * nu));
  return {lame + E / (1.0 + nu), lame};
}

ElasticConstants elasticConstants(const Section& section, double youngsModulus, double nu, double horizon,
                                  const Influence& influence) {
  const double moment = relativeMoment(influence, horizon, dimensionOf(section.geometry));
  const double h = section.size, E = youngsModulus;
  switch (section.geometry) {
    case Geometry::Bar:
      return {2.0 * E / (h * horizon * horizon) / moment, 0.0};
    case Geometry::PlaneStress: {
      const double normal = 6.0 * E / (pi * h * std::pow(horizon, 3) * (1.0 - nu)) / moment;
      return {normal, normal * (1.0 - 3.0 * nu) / (1.0 + nu)};
    }
    case Geometry::PlaneStrain: {
      const double normal = 6.0 * E / (pi * h * std::pow(horizon, 3) * (1.0 + nu) * (1.0 - 2.0 * nu)) / moment;
      return {normal, normal * (1.0 - 4.0 * nu)};
    }
    default: {
      const double normal = 6.0 * E / (pi * std::pow(horizon, 4) * (1.0 - 2.0 * nu)) / moment;
      return {normal, normal * (1.0 - 4.0 * nu) / (1.0 + nu)};
    }
  }
}

ElasticConstants latticeElasticConstants(const Section& section, double youngsModulus, double nu, double horizon,
                                         double spacing, VolumeCorrection rule, const Influence& influence,
                                         bool isBondBased) {
  // Strain energy of a bond under strain eps: with direction n, e_n = n.eps.n and e_t^2 = |eps n|^2 - e_n^2:
  // C11 = 1/2 sum r (k_n n1^4 + k_t (n1^2 - n1^4)) V,  C12 = 1/2 sum r (k_n - k_t) n1^2 n2^2 V.
  double normal11 = 0.0, tangential11 = 0.0, mixed = 0.0;
  const double cell = cellVolume(spacing, section);
  forLattice(dimensionOf(section.geometry), horizon, spacing, rule,
             [&](double x, double y, double, double r, double share) {
               const double weight = 0.5 * r * share * cell * influence(r, horizon);
               const double n1 = x * x / (r * r), n2 = y * y / (r * r);
               normal11 += weight * n1 * n1;
               tangential11 += weight * (n1 - n1 * n1);
               mixed += weight * n1 * n2;
             });
  const auto [c11, c12] = stiffness(section.geometry, youngsModulus, nu);
  if (section.geometry == Geometry::Bar) return {c11 / normal11, 0.0};
  if (isBondBased) {
    // One constant: match Young's modulus, which the lattice's own C12/C11 enters.
    const double ratio = mixed / normal11;
    const bool isPlane = section.geometry != Geometry::Solid;
    const double latticeYoung = isPlane ? 1.0 - ratio * ratio : 1.0 - 2.0 * ratio * ratio / (1.0 + ratio);
    const double target = section.geometry == Geometry::PlaneStrain ? c11 - c12 * c12 / c11 : youngsModulus;
    return {target / (normal11 * latticeYoung), 0.0};
  }
  const double difference = c12 / mixed;  // k_n - k_t
  const double normal = (c11 + tangential11 * difference) / (normal11 + tangential11);
  return {normal, normal - difference};
}

double criticalStretch(const Section& section, double youngsModulus, double nu, double fractureEnergy, double horizon,
                       const Influence& influence) {
  const double c = elasticConstants(section, youngsModulus, nu, horizon, influence).normal;
  const int dimension = dimensionOf(section.geometry);
  const double moment = relativeMoment(influence, horizon, dimension + 1);
  // Work per area to break all bonds across a plane at the stretch 1.
  double work = 0.0;
  if (dimension == 1)
    work = c * section.size * std::pow(horizon, 3) / 6.0;
  else if (dimension == 2)
    work = c * section.size * std::pow(horizon, 4) / 4.0;
  else
    work = c * pi * std::pow(horizon, 5) / 10.0;
  return std::sqrt(fractureEnergy / (work * moment));
}

double criticalStretchOfPoint(const Section& section, double normal, double fractureEnergy, double moment) {
  if (moment == 0.0) return 0.0;
  // A bond crosses |xi.n| planes in a row of unit distance, and half of all bonds start on either side.
  const int dimension = dimensionOf(section.geometry);
  const double meanCosine = dimension == 1 ? 1.0 : dimension == 2 ? 2.0 / pi : 0.5;
  return std::sqrt(fractureEnergy / (0.25 * normal * meanCosine * moment));
}

double kernelValue(DiffusionKernel kernel, double distance) {
  switch (kernel) {
    case DiffusionKernel::InverseSquare:
      return 1.0 / (distance * distance);
    case DiffusionKernel::Inverse:
      return 1.0 / distance;
    default:
      return 1.0;
  }
}

double microDiffusivity(const Section& section, DiffusionKernel kernel, double diffusivity, double horizon) {
  // D = 1/2 integral d kernel(r) x^2 dV over the neighbourhood, x^2 = r^2/dimension on average.
  const int dimension = dimensionOf(section.geometry);
  const int kernelPower = kernel == DiffusionKernel::InverseSquare ? 2 : kernel == DiffusionKernel::Inverse ? 1 : 0;
  const int power = dimension + 2 - kernelPower;  // of delta, after integration of r^(dimension - 1 + 2 - kernelPower)
  const double sphere = dimension == 1 ? 2.0 * section.size : dimension == 2 ? 2.0 * pi * section.size : 4.0 * pi;
  return diffusivity * 2.0 * dimension * power / (sphere * std::pow(horizon, power));
}

double latticeMicroDiffusivity(const Section& section, DiffusionKernel kernel, double diffusivity, double horizon,
                               double spacing, VolumeCorrection rule) {
  double sum = 0.0;
  const double cell = cellVolume(spacing, section);
  forLattice(dimensionOf(section.geometry), horizon, spacing, rule,
             [&](double x, double, double, double r, double share) {
               sum += 0.5 * kernelValue(kernel, r) * x * x * share * cell;
             });
  return diffusivity / sum;
}

double interfaceFluxConstant(const Section& section, double horizon) {
  // q = integral c q/r x dV over the half neighbourhood x > 0: over dV, every bond crosses as many planes as x is long.
  const int dimension = dimensionOf(section.geometry);
  const double halfSphere = dimension == 1 ? section.size : dimension == 2 ? 2.0 * section.size : pi;
  return dimension / (halfSphere * std::pow(horizon, dimension));
}

}  // namespace pd::kernels
