#include "growth_strip.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace pd {

namespace {

// Of the strip, in its heights: the crack at the start, what is left ahead of it at the end.
constexpr double crackedPart = 0.6, aheadPart = 0.8;
/// T sqrt(height)/K of a crack from the far left along the middle of a strip between grips that do not move along it,
/// C11 = 3 C12 = 3 C66 (all lattices of springs, nearly): by finite elements of second order, to 1e-3.
constexpr double stressAlong = -0.6095;
constexpr int rowsThatBreak = 3;  ///< beside the crack: of bonds that do not cross it

int rounded(double value) { return static_cast<int>(std::lround(value)); }

}  // namespace

void GrowthStrip::Measure::add(int where, double what) {
  for (int k = 0; k < n; ++k) {
    if (unknown[static_cast<std::size_t>(k)] != where) continue;
    value[static_cast<std::size_t>(k)] += what;
    return;
  }
  unknown[static_cast<std::size_t>(n)] = where;
  value[static_cast<std::size_t>(n++)] = what;
}

double GrowthStrip::Measure::of(const std::vector<double>& u) const {
  double sum = 0.0;
  for (std::size_t k = 0; k < static_cast<std::size_t>(n); ++k)
    sum += value[k] * u[static_cast<std::size_t>(unknown[k])];
  return sum;
}

GrowthStrip::GrowthStrip(std::vector<LatticeBond> bonds, double horizon, double height, double growth)
    : lattice_(std::move(bonds)), nRows_(rounded(0.5 * height * horizon)) {
  for (const LatticeBond& bond : lattice_) {
    reach_ = std::max({reach_, std::abs(bond.x), std::abs(bond.y)});
    bondsOfAPoint_ += bond.count;
  }
  const int nGrowth = rounded(growth * horizon);
  firstColumn_ = rounded(crackedPart * height * horizon);
  nColumns_ = firstColumn_ + nGrowth + rounded(aheadPart * height * horizon);
  nBroken_.assign(static_cast<std::size_t>(nColumns_ * nRows_), 0.0);
  const PlaneStiffness stiffness = planeStiffness(lattice_);
  poisson_ = stiffness.c12 / stiffness.c11;
  strainUnit_ = std::sqrt(solveFarAhead() / stiffness.fractureModulus() / horizon);
  // T = stressAlong K / sqrt(height), over E' along the crack
  frameStrain_ = -stressAlong * strainUnit_ * stiffness.fractureModulus() / stiffness.modulus() / std::sqrt(height);
  std::vector<Bond> all;
  for (int column = 0; column < nColumns_; ++column)
    for (int row = 0; row < nRows_; ++row) collect(column, row, all);

  const int n = 2 * nColumns_ * nRows_;
  BandedCholesky solver(n, 2 * (reach_ * nRows_ + reach_) + 1);
  std::vector<double> u(static_cast<std::size_t>(n), 0.0);
  for (const Bond& bond : all) {
    const Measure measure = measureOf(bond);
    for (std::size_t a = 0; a < static_cast<std::size_t>(measure.n); ++a) {
      const double force = bond.stiffness * measure.value[a];
      u[static_cast<std::size_t>(measure.unknown[a])] -= force * measure.ofFrame;
      for (std::size_t b = 0; b <= a; ++b) solver.add(measure.unknown[a], measure.unknown[b], force * measure.value[b]);
    }
    if (mayBreak(bond, nGrowth)) add(bond);
  }
  solver.factor();
  solver.solve(u);
  condense(solver, u);
}

/// Of a place of the frame, or beyond an end that of a strip without end.
GrowthStrip::Displacement GrowthStrip::ofFrame(int column, int row) const {
  const bool isAhead = column >= nColumns_ && row < nRows_;
  return {frameStrain_ * (column - firstColumn_),
          (isAhead ? farAhead_[static_cast<std::size_t>(row)] : 1.0) - poisson_ * frameStrain_ * (row + 0.5)};
}

/// Whether the crack of the start cuts a bond across the middle.
bool GrowthStrip::isCut(int column, int row, const LatticeBond& bond) const {
  return column + bond.x * (row + 0.5) / -bond.y < firstColumn_ - 0.5;
}

/// The bonds of a point that are listed at it.
void GrowthStrip::collect(int column, int row, std::vector<Bond>& all) {
  const std::size_t from = point(column, row);
  for (const LatticeBond& bond : lattice_) {
    const int toColumn = column + bond.x, toRow = row + bond.y;
    const double length2 = bond.length * bond.length;
    Bond made{from,           from,       false,    false, bond.x / length2, bond.y / length2,
              bond.stiffness, bond.count, toColumn, toRow};
    if (toRow < 0) {
      if (isCut(column, row, bond)) {
        nBroken_[from] += bond.count;
        continue;
      }
      made.isAcross = true;
      made.row = -1 - toRow;
    }
    made.isToFrame = toColumn < 0 || toColumn >= nColumns_ || toRow >= nRows_;
    if (!made.isToFrame) {
      if (!made.isAcross && (bond.y < 0 || (bond.y == 0 && bond.x < 0))) continue;
      made.to = point(toColumn, made.row);
      if (made.isAcross && made.to < from) continue;
      if (made.isAcross && made.to == from) made.stiffness *= 0.5;
    }
    all.push_back(made);
  }
}

GrowthStrip::Measure GrowthStrip::measureOf(const Bond& bond) const {
  Measure measure;
  const int from = 2 * static_cast<int>(bond.from), to = 2 * static_cast<int>(bond.to);
  const double mirroredY = bond.isAcross ? -bond.alongY : bond.alongY;
  measure.add(from, -bond.alongX);
  measure.add(from + 1, -bond.alongY);
  if (bond.isToFrame) {
    const Displacement u = ofFrame(bond.column, bond.row);
    measure.ofFrame = bond.alongX * u[0] + mirroredY * u[1];
  } else {
    measure.add(to, bond.alongX);
    measure.add(to + 1, mirroredY);
  }
  return measure;
}

bool GrowthStrip::mayBreak(const Bond& bond, int growth) const {
  if (bond.isToFrame) return false;
  const auto rows = static_cast<std::size_t>(nRows_);
  const int a = static_cast<int>(bond.from / rows), b = static_cast<int>(bond.to / rows);
  if (std::min(a, b) < firstColumn_ - 2 * reach_ || std::max(a, b) > firstColumn_ + growth + reach_) return false;
  return bond.isAcross || std::max(bond.from % rows, bond.to % rows) < rowsThatBreak;
}

void GrowthStrip::add(const Bond& bond) {
  const bool isUpright = bond.isAcross && bond.from == bond.to && bond.from % static_cast<std::size_t>(nRows_) == 0;
  const int column = static_cast<int>(bond.from) / nRows_;
  if (isUpright && column >= firstColumn_ && bond.alongY == -1.0) tipBond_.push_back(bonds_.size());
  bonds_.push_back(bond);
  measures_.push_back(measureOf(bond));
  isBroken_.push_back(0);
}

/// Keeps of the solution what the bonds that may break see, and counts their unknowns anew.
void GrowthStrip::condense(const BandedCholesky& solver, const std::vector<double>& u) {
  std::vector<int> place(u.size(), -1);
  std::vector<std::size_t> kept;
  for (Measure& measure : measures_)
    for (std::size_t k = 0; k < static_cast<std::size_t>(measure.n); ++k) {
      int& now = place[static_cast<std::size_t>(measure.unknown[k])];
      if (now < 0) {
        now = static_cast<int>(kept.size());
        kept.push_back(static_cast<std::size_t>(measure.unknown[k]));
      }
      measure.unknown[k] = now;
    }
  for (const std::size_t unknown : kept) u_.push_back(u[unknown]);
  compliance_ = solver.inverseAt(kept);
}

std::vector<double> GrowthStrip::movedBy(const Measure& pairOfForces) const {
  const std::size_t n = u_.size();
  std::vector<double> moved(n, 0.0);
  for (std::size_t k = 0; k < static_cast<std::size_t>(pairOfForces.n); ++k) {
    const auto unknown = static_cast<std::size_t>(pairOfForces.unknown[k]);
    const double force = pairOfForces.value[k], *row = &compliance_[unknown * n];
    for (std::size_t i = 0; i < unknown; ++i) moved[i] += force * compliance_[i * n + unknown];
    for (std::size_t i = unknown; i < n; ++i) moved[i] += force * row[i];
  }
  return moved;
}

void GrowthStrip::breakBond(std::size_t bond) {
  const Bond& broken = bonds_[bond];
  isBroken_[bond] = 1;
  nBroken_[broken.from] += broken.count;
  if (broken.to != broken.from) nBroken_[broken.to] += broken.count;
  worn_.insert(worn_.end(), {broken.from, broken.to});
  const Measure& measure = measures_[bond];
  const std::vector<double> moved = movedBy(measure);
  const double left = 1.0 - broken.stiffness * measure.of(moved);
  if (left < 1e-9) return;  // nothing else holds what it held
  const double factor = broken.stiffness / left, stretch = measure.of(u_);
  const std::size_t n = u_.size();
  for (std::size_t i = 0; i < n; ++i) {
    const double times = factor * moved[i];
    u_[i] += times * stretch;
    double* row = &compliance_[i * n];
    for (std::size_t j = i; j < n; ++j) row[j] += times * moved[j];
  }
}

/// Points that have lost that part of their bonds, and their neighbours; returns whether there are more of them.
bool GrowthStrip::findPointsNear(double damage) {
  if (isNear_.empty()) {
    isNear_.assign(nBroken_.size(), 0);
    worn_.resize(nBroken_.size());
    std::iota(worn_.begin(), worn_.end(), std::size_t(0));
  }
  bool areMore = false;
  const auto mark = [&](std::size_t p) { areMore = std::exchange(isNear_[p], 1) == 0 || areMore; };
  for (const std::size_t p : worn_) {
    if (nBroken_[p] < damage * bondsOfAPoint_) continue;
    mark(p);
    const int column = static_cast<int>(p) / nRows_, row = static_cast<int>(p) % nRows_;
    for (const LatticeBond& bond : lattice_) {
      const int toColumn = column + bond.x, toRow = row + bond.y < 0 ? -1 - row - bond.y : row + bond.y;
      if (toColumn >= 0 && toColumn < nColumns_ && toRow < nRows_) mark(point(toColumn, toRow));
    }
  }
  worn_.clear();
  return areMore;
}

const std::vector<std::size_t>& GrowthStrip::bondsNear(double damage) {
  if (findPointsNear(damage)) {
    bondsNear_.resize(bonds_.size());
    std::iota(bondsNear_.begin(), bondsNear_.end(), std::size_t(0));
  }
  const auto isOut = [&](std::size_t b) {
    return isBroken(b) || (isNear_[bonds_[b].from] == 0 && isNear_[bonds_[b].to] == 0);
  };
  bondsNear_.erase(std::remove_if(bondsNear_.begin(), bondsNear_.end(), isOut), bondsNear_.end());
  return bondsNear_;
}

int GrowthStrip::nColumnsOpen() const {
  int n = 0;
  while (n < static_cast<int>(tipBond_.size()) && isBroken(tipBond_[static_cast<std::size_t>(n)])) ++n;
  return n;
}

/// Finds how rows move far ahead of the crack, where nothing moves along x and all columns alike, and returns the
/// energy of a column of the whole strip there. What stretches the frame adds nothing to what the crack sets free.
double GrowthStrip::solveFarAhead() {
  BandedCholesky solver(nRows_, nRows_ - 1);
  std::vector<double>& v = farAhead_;
  v.assign(static_cast<std::size_t>(nRows_), 0.0);
  struct Upright {
    int from, to;  ///< rows; `to` < 0: a grip
    double sign, along, stiffness;
  };
  std::vector<Upright> bonds;
  for (int row = 0; row < nRows_; ++row)
    for (const LatticeBond& bond : lattice_) {
      if (bond.y == 0) continue;
      const int to = row + bond.y;
      const bool isInGrip = to >= nRows_;
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
  double energy = 0.0;
  for (const Upright& bond : bonds) {
    const double far = bond.to < 0 ? 1.0 : bond.sign * v[static_cast<std::size_t>(bond.to)];
    const double stretch = bond.along * (far - v[static_cast<std::size_t>(bond.from)]);
    energy += bond.stiffness * stretch * stretch;  // 1/2 of the half, 2 halves
  }
  return energy;
}

}  // namespace pd
