#include "growth_strip.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pd {

namespace {

// Of the strip, in its heights: the crack at the start, what is left ahead of it at the end.
constexpr double crackedPart = 0.6, aheadPart = 0.8;
/// T sqrt(height)/K of a crack from the far left along the middle of a strip between grips that do not move along it,
/// C11 = 3 C12 = 3 C66 (all lattices of springs, nearly): by finite elements of second order, to 1e-3.
constexpr double stressAlong = -0.6095;

int rounded(double value) { return static_cast<int>(std::lround(value)); }

struct FarAhead {
  std::vector<double> displacement;  ///< [rows] along y
  double energy = 0.0;               ///< of a column of the whole strip
};

/// Far ahead of the crack nothing moves along x and all columns alike. What stretches the frame adds nothing to what
/// the crack sets free.
FarAhead solveFarAhead(const std::vector<LatticeBond>& lattice, int nRows) {
  BandedCholesky solver(nRows, nRows - 1);
  FarAhead found;
  std::vector<double>& v = found.displacement;
  v.assign(static_cast<std::size_t>(nRows), 0.0);
  struct Upright {
    int from, to;  ///< rows; `to` < 0: a grip
    double sign, along, stiffness;
  };
  std::vector<Upright> bonds;
  for (int row = 0; row < nRows; ++row)
    for (const LatticeBond& bond : lattice) {
      if (bond.y == 0) continue;
      const int to = row + bond.y;
      const bool isInGrip = to >= nRows;
      bonds.push_back({row, isInGrip ? -1 : (to >= 0 ? to : -1 - to), to >= 0 ? 1.0 : -1.0,
                       bond.y / (bond.length * bond.length), isInGrip ? bond.stiffness : 0.5 * bond.stiffness});
    }
  for (const Upright& bond : bonds) {
    const double k = bond.stiffness * bond.along * bond.along;
    solver.add(bond.from, bond.from, k);
    if (bond.to < 0) {
      v[static_cast<std::size_t>(bond.from)] += k;
    } else if (bond.to == bond.from) {
      // v_to = -v_from: (sign - 1)^2 in all
      solver.add(bond.from, bond.from, k * (bond.sign * bond.sign - 2.0 * bond.sign));
    } else {
      solver.add(bond.to, bond.to, k);
      solver.add(bond.from, bond.to, -k * bond.sign);
    }
  }
  solver.factor();
  solver.solve(v);
  for (const Upright& bond : bonds) {
    const double far = bond.to < 0 ? 1.0 : bond.sign * v[static_cast<std::size_t>(bond.to)];
    const double stretch = bond.along * (far - v[static_cast<std::size_t>(bond.from)]);
    found.energy += bond.stiffness * stretch * stretch;  // 1/2 of the half, 2 halves
  }
  return found;
}

HalfBody halfStrip(const std::vector<LatticeBond>& lattice, double horizon, double height, double growth) {
  HalfBody half;
  half.nRows = rounded(0.5 * height * horizon);
  half.firstColumn = rounded(crackedPart * height * horizon);
  half.nColumns = half.firstColumn + rounded(growth * horizon) + rounded(aheadPart * height * horizon);
  const FarAhead farAhead = solveFarAhead(lattice, half.nRows);
  half.energyReleaseRate = farAhead.energy;
  const PlaneStiffness stiffness = planeStiffness(lattice);
  const double poisson = stiffness.c12 / stiffness.c11;
  // T = stressAlong K / sqrt(height), over E' along the crack
  const double frameStrain =
      -stressAlong * std::sqrt(farAhead.energy * stiffness.fractureModulus() / horizon / height) / stiffness.modulus();
  half.frame = [=, nColumns = half.nColumns, nRows = half.nRows, first = half.firstColumn,
                ahead = farAhead.displacement](int column, int row) -> HalfBody::Displacement {
    const bool isAhead = column >= nColumns && row < nRows;
    return {frameStrain * (column - first),
            (isAhead ? ahead[static_cast<std::size_t>(row)] : 1.0) - poisson * frameStrain * (row + 0.5)};
  };
  return half;
}

}  // namespace

GrowthStrip::GrowthStrip(const std::vector<LatticeBond>& bonds, double horizon, double height, double growth)
    : GrowthBody(bonds, horizon, halfStrip(bonds, horizon, height, growth), growth) {}

}  // namespace pd
