#include "growth_body.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace pd {

namespace {

constexpr int rowsThatBreak = 3;  ///< beside the crack: of bonds that do not cross it

}  // namespace

void GrowthBody::Measure::add(int where, double what) {
  for (int k = 0; k < n; ++k) {
    if (unknown[static_cast<std::size_t>(k)] != where) continue;
    value[static_cast<std::size_t>(k)] += what;
    return;
  }
  unknown[static_cast<std::size_t>(n)] = where;
  value[static_cast<std::size_t>(n++)] = what;
}

double GrowthBody::Measure::of(const std::vector<double>& u) const {
  double sum = 0.0;
  for (std::size_t k = 0; k < static_cast<std::size_t>(n); ++k)
    sum += value[k] * u[static_cast<std::size_t>(unknown[k])];
  return sum;
}

GrowthBody::GrowthBody(std::vector<LatticeBond> bonds, double horizon, HalfBody half, double growth)
    : lattice_(std::move(bonds)), half_(std::move(half)), horizon_(horizon) {
  modulus_ = planeStiffness(lattice_).fractureModulus();
  for (const LatticeBond& bond : lattice_) {
    reach_ = std::max({reach_, std::abs(bond.x), std::abs(bond.y)});
    bondsOfAPoint_ += bond.count;
  }
  nBroken_.assign(static_cast<std::size_t>(half_.nColumns * half_.nRows), 0.0);
  std::vector<Bond> all;
  for (int column = 0; column < half_.nColumns; ++column)
    for (int row = 0; row < half_.nRows; ++row)
      if (half_.isIn(column, row)) collect(column, row, all);
  const int nGrowth = static_cast<int>(std::lround(growth * horizon));
  for (const Bond& bond : all)
    if (mayBreak(bond, nGrowth)) add(bond);
  BandedCholesky solver(2 * half_.nColumns * half_.nRows, 2 * (reach_ * half_.nRows + reach_) + 1);
  const std::vector<double> u = solve(all, solver);
  condense(solver, u);
  if (half_.energyReleaseRate == 0.0) cutStraight(nGrowth);
}

/// The bonds of a point that are listed at it.
void GrowthBody::collect(int column, int row, std::vector<Bond>& all) {
  const std::size_t from = half_.point(column, row);
  for (const LatticeBond& bond : lattice_) {
    const int toColumn = column + bond.x, toRow = row + bond.y;
    const double length2 = bond.length * bond.length;
    Bond made{from,       from,     false, false, bond.x / length2, bond.y / length2, bond.stiffness,
              bond.count, toColumn, toRow, 0.0};
    if (toRow < 0) {
      made.isAcross = true;
      made.row = -1 - toRow;
    }
    made.isToFrame = !half_.isWithin(toColumn, made.row);
    if (made.isToFrame ? !half_.frame : !half_.isIn(toColumn, made.row)) continue;
    if (made.isAcross) made.crossesAt = column + bond.x * (row + 0.5) / -bond.y;
    if (made.isAcross && made.crossesAt < half_.firstColumn - 0.5) {
      nBroken_[from] += bond.count;
      continue;
    }
    if (!made.isToFrame) {
      if (!made.isAcross && (bond.y < 0 || (bond.y == 0 && bond.x < 0))) continue;
      made.to = half_.point(toColumn, made.row);
      if (made.isAcross && made.to < from) continue;
      if (made.isAcross && made.to == from) made.stiffness *= 0.5;
    }
    all.push_back(made);
  }
}

GrowthBody::Measure GrowthBody::measureOf(const Bond& bond) const {
  Measure measure;
  const int from = 2 * static_cast<int>(bond.from), to = 2 * static_cast<int>(bond.to);
  const double mirroredY = bond.isAcross ? -bond.alongY : bond.alongY;
  measure.add(from, -bond.alongX);
  measure.add(from + 1, -bond.alongY);
  if (bond.isToFrame) {
    const HalfBody::Displacement u = half_.frame(bond.column, bond.row);
    measure.ofFrame = bond.alongX * u[0] + mirroredY * u[1];
  } else {
    measure.add(to, bond.alongX);
    measure.add(to + 1, mirroredY);
  }
  return measure;
}

bool GrowthBody::mayBreak(const Bond& bond, int growth) const {
  if (bond.isToFrame) return false;
  const auto rows = static_cast<std::size_t>(half_.nRows);
  const int a = static_cast<int>(bond.from / rows), b = static_cast<int>(bond.to / rows);
  if (std::min(a, b) < half_.firstColumn - 2 * reach_ || std::max(a, b) > half_.firstColumn + growth + reach_)
    return false;
  return bond.isAcross || std::max(bond.from % rows, bond.to % rows) < rowsThatBreak;
}

void GrowthBody::add(const Bond& bond) {
  const bool isUpright =
      bond.isAcross && bond.from == bond.to && bond.from % static_cast<std::size_t>(half_.nRows) == 0;
  const int column = static_cast<int>(bond.from) / half_.nRows;
  if (isUpright && column >= half_.firstColumn && bond.alongY == -1.0) tipBond_.push_back(bonds_.size());
  bonds_.push_back(bond);
  measures_.push_back(measureOf(bond));
  isBroken_.push_back(0);
}

/// Equilibrium of all points; `solver` is that of its matrix then.
std::vector<double> GrowthBody::solve(const std::vector<Bond>& all, BandedCholesky& solver) const {
  std::vector<double> u(2 * nBroken_.size(), 0.0);
  double largest = 0.0;
  for (const Bond& bond : all) {
    const Measure measure = measureOf(bond);
    largest = std::max(largest, bond.stiffness);
    for (std::size_t a = 0; a < static_cast<std::size_t>(measure.n); ++a) {
      const double force = bond.stiffness * measure.value[a];
      u[static_cast<std::size_t>(measure.unknown[a])] -= force * measure.ofFrame;
      for (std::size_t b = 0; b <= a; ++b) solver.add(measure.unknown[a], measure.unknown[b], force * measure.value[b]);
    }
  }
  const auto hold = [&](std::size_t unknown) {
    solver.add(static_cast<int>(unknown), static_cast<int>(unknown), largest);
  };
  for (std::size_t p = 0; p < half_.isHole.size(); ++p) {
    if (half_.isHole[p] == 0) continue;
    hold(2 * p);
    hold(2 * p + 1);
  }
  if (!half_.frame)
    hold(2 * half_.point(half_.nColumns - 1, 0));  // along the crack, which nothing else holds: no force
  for (const std::size_t p : half_.pulled) u[2 * p + 1] += 1.0 / static_cast<double>(half_.pulled.size());
  solver.factor();
  solver.solve(u);
  return u;
}

/// Keeps of the solution what the bonds that may break see, and counts their unknowns anew.
void GrowthBody::condense(const BandedCholesky& solver, const std::vector<double>& u) {
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

std::vector<double> GrowthBody::movedBy(const Measure& pairOfForces) const {
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

void GrowthBody::breakBond(std::size_t bond) {
  const Bond& broken = bonds_[bond];
  isBroken_[bond] = 1;
  nBroken_[broken.from] += broken.count;
  if (broken.to != broken.from) nBroken_[broken.to] += broken.count;
  worn_.insert(worn_.end(), {broken.from, broken.to});
  if (broken.stiffness == 0.0) return;
  const Measure& measure = measures_[bond];
  const std::vector<double> moved = movedBy(measure);
  const double left = 1.0 - broken.stiffness * measure.of(moved);
  if (left < 1e-9) return;  // nothing else holds what it held
  const double factor = broken.stiffness / left, stretch = measure.of(u_);
  released_ += factor * stretch * stretch;  // 1/2 of the half, 2 halves; under loads, too
  const std::size_t n = u_.size();
  for (std::size_t i = 0; i < n; ++i) {
    const double times = factor * moved[i];
    u_[i] += times * stretch;
    double* row = &compliance_[i * n];
    for (std::size_t j = i; j < n; ++j) row[j] += times * moved[j];
  }
}

/// Points that have lost that part of their bonds, and their neighbours; returns whether there are more of them.
bool GrowthBody::findPointsNear(double damage) {
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
    const int column = static_cast<int>(p) / half_.nRows, row = static_cast<int>(p) % half_.nRows;
    for (const LatticeBond& bond : lattice_) {
      const int toColumn = column + bond.x, toRow = row + bond.y < 0 ? -1 - row - bond.y : row + bond.y;
      if (half_.isWithin(toColumn, toRow)) mark(half_.point(toColumn, toRow));
    }
  }
  worn_.clear();
  return areMore;
}

const std::vector<std::size_t>& GrowthBody::bondsNear(double damage) {
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

int GrowthBody::nColumnsOpen() const {
  int n = 0;
  while (n < static_cast<int>(tipBond_.size()) && isBroken(tipBond_[static_cast<std::size_t>(n)])) ++n;
  return n;
}

/// What straight cuts set free that go on from the crack of the start, column by column.
void GrowthBody::cutStraight(int growth) {
  GrowthBody cut = *this;
  releasedByCut_ = {0.0};
  for (int column = 1; column <= growth + 1; ++column) {
    for (std::size_t b = 0; b < bonds_.size(); ++b)
      if (bonds_[b].isAcross && !cut.isBroken(b) && bonds_[b].crossesAt < half_.firstColumn + column - 0.5)
        cut.breakBond(b);
    releasedByCut_.push_back(cut.released_);
  }
  const std::size_t last = releasedByCut_.size() - 1;
  rateOfCut_.assign(last + 1, 0.0);
  for (std::size_t k = 1; k < last; ++k) rateOfCut_[k] = 0.5 * (releasedByCut_[k + 1] - releasedByCut_[k - 1]);
  rateOfCut_[0] = 2.0 * rateOfCut_[1] - rateOfCut_[2];
  rateOfCut_[last] = 2.0 * rateOfCut_[last - 1] - rateOfCut_[last - 2];
}

double GrowthBody::strainUnit() const {
  double rate = half_.energyReleaseRate;
  if (rate == 0.0) {
    std::size_t k = 1;
    while (k + 1 < releasedByCut_.size() && releasedByCut_[k] < released_) ++k;
    const double part = (released_ - releasedByCut_[k - 1]) / (releasedByCut_[k] - releasedByCut_[k - 1]);
    rate = rateOfCut_[k - 1] + part * (rateOfCut_[k] - rateOfCut_[k - 1]);
  }
  return std::sqrt(rate / modulus_ / horizon_);
}

}  // namespace pd
