#include "phase_geometry.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pd {

namespace {

/// Of a symmetric matrix with the entries xx, yy, zz, xy, yz, zx and no negative eigenvalue (trigonometric formula).
double largestEigenvalue(const double (&m)[6]) {
  const double mean = (m[0] + m[1] + m[2]) / 3.0;
  const double a = m[0] - mean, b = m[1] - mean, c = m[2] - mean;
  const double spread = std::sqrt((a * a + b * b + c * c + 2.0 * (m[3] * m[3] + m[4] * m[4] + m[5] * m[5])) / 6.0);
  if (spread <= 1e-14 * mean) return mean;
  const double determinant =
      a * (b * c - m[4] * m[4]) - m[3] * (m[3] * c - m[4] * m[5]) + m[5] * (m[3] * m[4] - b * m[5]);
  const double cosine = std::clamp(0.5 * determinant / (spread * spread * spread), -1.0, 1.0);
  return mean + 2.0 * spread * std::cos(std::acos(cosine) / 3.0);
}

/// Solution of a system with such a matrix, by Cramer's rule, but for a factor.
std::array<double, 3> solved(const double (&m)[6], const double (&b)[3]) {
  const double c00 = m[1] * m[2] - m[4] * m[4], c11 = m[0] * m[2] - m[5] * m[5], c22 = m[0] * m[1] - m[3] * m[3];
  const double c01 = m[4] * m[5] - m[3] * m[2], c12 = m[3] * m[5] - m[0] * m[4], c02 = m[3] * m[4] - m[1] * m[5];
  return {c00 * b[0] + c01 * b[1] + c02 * b[2], c01 * b[0] + c11 * b[1] + c12 * b[2],
          c02 * b[0] + c12 * b[1] + c22 * b[2]};
}

/// Correction of a plane front of which bonds pass so much, before and behind a point. Sides of the body beside the
/// point cut both halves alike, and by the mean an error of the normal counts in second order alone; a side before or
/// behind it cuts one half. Of points that are no grid the halves differ by chance: where the larger one counts, a
/// front is slow.
double planeOf(const std::array<double, 2>& passed) {
  const double more = std::max(passed[0], passed[1]), less = std::min(passed[0], passed[1]);
  constexpr double isCut = 0.5, least = 0.1;  // the latter of points that hang by a corner
  return 1.0 / std::max(less > isCut * more ? 0.5 * (less + more) : more, least);
}

}  // namespace

void PhaseGeometry::findBonds(int point, const int* neighbors, int count) const {
  bonds_.resize(static_cast<std::size_t>(count));
  for (int k = 0; k < count; ++k) weights_.find(bonds_[static_cast<std::size_t>(k)], x_, point, neighbors[k]);
}

double PhaseGeometry::diffusionCorrection(int point, const int* neighbors, int count) const {
  findBonds(point, neighbors, count);
  double moment[6] = {};
  for (int k = 0; k < count; ++k) {
    const int j = neighbors[k];
    if (damage_[j] < 1.0) continue;
    const Bond& bond = bonds_[static_cast<std::size_t>(k)];
    const double weight = diffusionWeight(bond, point, j) * volume_[j];
    const auto& r = bond.along;
    for (std::size_t d = 0; d < 3; ++d) {
      moment[d] += weight * r[d] * r[d];
      moment[3 + d] += weight * r[d] * r[(d + 1) % 3];
    }
  }
  double along = largestEigenvalue(moment);
  const Normal wall = normal(point, neighbors, [&](int i) { return damage_[i] < 1.0 ? 1.0 : 0.0; });
  if (wall.isClear && weights_.dimension() > 1) {
    const auto& n = wall.direction;
    double across = 0.0;
    for (std::size_t d = 0; d < 3; ++d) across += n[d] * (moment[d] * n[d] + 2.0 * moment[3 + d] * n[(d + 1) % 3]);
    const double tangential = (moment[0] + moment[1] + moment[2] - across) / (weights_.dimension() - 1);
    constexpr double least = 0.5;  // walls of plane fronts take no more
    along = std::max(tangential, least * along);
  }
  return along > 0.0 ? 2.0 * weights_.diffusivity() / along : 1.0;
}

/// Direction of the least-squares fit a + b.r to what there is of solid, `solidOf` a point in [0, 1], over a window
/// that is a box along the axes, as are the weights' factors: sides of the body that cut it along them do not turn b.
template <class SolidOf>
PhaseGeometry::Normal PhaseGeometry::normal(int point, const int* neighbors, SolidOf solidOf) const {
  double total = volume_[point], solid = total * solidOf(point), place[3] = {}, solidPlace[3] = {}, solidSquare[3] = {},
         square[6] = {};
  for (std::size_t k = 0; k < bonds_.size(); ++k) {
    const int j = neighbors[k];
    const Bond& bond = bonds_[k];
    const double weight = volume_[j] * weights_.window(bond);
    if (weight == 0.0) continue;
    const auto& r = bond.mapped;
    const double metal = weight * solidOf(j);
    total += weight;
    solid += metal;
    for (std::size_t d = 0; d < 3; ++d) {
      place[d] += weight * r[d];
      square[d] += weight * r[d] * r[d];
      square[3 + d] += weight * r[d] * r[(d + 1) % 3];
      solidPlace[d] += metal * r[d];
      solidSquare[d] += metal * r[d] * r[d];
    }
  }
  double size = 0.0, slope[3], slant = 0.0;
  for (std::size_t d = 0; d < 3; ++d) {
    square[d] -= place[d] * place[d] / total;
    square[3 + d] -= place[d] * place[(d + 1) % 3] / total;
    size = std::max(size, square[d]);
  }
  for (std::size_t d = 0; d < 3; ++d) {
    slope[d] = solidPlace[d] - solid * place[d] / total;
    slant += slope[d] * slope[d];
    square[d] += 1e-6 * size;  // directions in which there is nothing
  }
  std::array<double, 3> n{};
  constexpr double isUnclear = 0.05;  // between two walls, that cancel: the axis along which most solid lies
  const bool isClear = slant > isUnclear * isUnclear * solid * solid * size / total;
  if (!isClear)
    n[static_cast<std::size_t>(std::max_element(solidSquare, solidSquare + 3) - solidSquare)] = 1.0;
  else
    n = solved(square, slope);
  // A normal maps with the inverse of the map of lengths. Where cells are long, that makes much of what chance leaves
  // of a front that is plane: tilts below `chance` count for next to nothing.
  constexpr double chance = 8e-3;
  const double most = std::max({std::abs(n[0]), std::abs(n[1]), std::abs(n[2])});
  for (std::size_t d = 0; d < 3; ++d) {
    const double tilt = n[d] / (chance * most);
    n[d] *= weights_.stretch(d) * tilt * tilt / (1.0 + tilt * tilt);
  }
  const double length = std::hypot(n[0], n[1], n[2]);
  for (double& component : n) component /= length;
  return {n, isClear};
}

PhaseGeometry::Surface PhaseGeometry::surface(int point, const int* neighbors, int count) const {
  findBonds(point, neighbors, count);
  // What points have lost makes a front smooth that is a staircase of phases. But in metal of several phases one loses
  // more than the other, wherever the front is; and bonds that break at random leave a plane front uneven.
  const auto solidOf = [&](int i) {
    const double left = 1.0 - damage_[i];
    return followsLoss_ || left == 0.0 ? left : 1.0;
  };
  const std::array<double, 3> n = normal(point, neighbors, solidOf).direction;
  const std::size_t own = blockId_ == nullptr ? 0 : phases_->ofBlock(blockId_[point]);
  std::vector<Surface::OfPhase> phases(blockId_ == nullptr ? 1 : phases_->count());
  for (int k = 0; k < count; ++k) {
    const int j = neighbors[k];
    const bool mayDiffer = blockId_ != nullptr && damage_[j] < 1.0;
    Surface::OfPhase& phase = phases[mayDiffer ? phases_->ofBlock(blockId_[j]) : own];
    phase.isAround = phase.isAround || mayDiffer;
    const Bond& bond = bonds_[static_cast<std::size_t>(k)];
    const double weight = dissolutionWeight(bond, point, j);
    if (weight == 0.0) continue;
    const double across = bond.along[0] * n[0] + bond.along[1] * n[1] + bond.along[2] * n[2];
    phase.passed[across > 0.0] += weight * volume_[j] * std::abs(across);
  }
  const auto mayBeAlike = [&](const Surface::OfPhase& phase) {
    const auto p = static_cast<std::size_t>(&phase - phases.data());
    return !phase.isAround || phases_->filmsDiffer() || phases_->areAlike(own, p, 0.0);
  };
  const Bend bend = std::all_of(phases.begin(), phases.end(), mayBeAlike) ? bendOf(point, neighbors, n) : Bend();
  Surface surface;
  surface.spread = surface.spreadOfOne = bend.spread;
  surface.gap = bend.gap;
  surface.nCurvatures = weights_.dimension() - 1;
  if (blockId_ == nullptr) {
    surface.plane = planeOf(phases[0].passed);
  } else {
    surface.phases = std::move(phases);
    takeUpFilm(0.0, point, surface);
  }
  return surface;
}

/// A front is bent by what is the same everywhere around, not beside phases that another front passes through.
void PhaseGeometry::takeUpFilm(double filmCoverage, int point, Surface& surface) const {
  const std::size_t own = phases_->ofBlock(blockId_[point]);
  std::array<double, 2> passed{};
  bool areAlike = true;
  for (std::size_t p = 0; p < surface.phases.size(); ++p) {
    const Surface::OfPhase& phase = surface.phases[p];
    if (p != own && !phase.isAround) continue;
    const double share = phases_->keepsUp(own, p, filmCoverage);
    for (std::size_t side = 0; side < 2; ++side) passed[side] += share * phase.passed[side];
    areAlike = areAlike && phases_->areAlike(own, p, filmCoverage);
  }
  surface.plane = planeOf(passed);
  surface.spread = areAlike ? surface.spreadOfOne : 0.0;
}

/// Exact where curvatures are alike, as of a circle and a ball.
double PhaseGeometry::Surface::correctionAfter(double way) const {
  if (spread == 0.0) return plane;
  constexpr double most = 0.3;  // change of the area that is believed of so small a piece
  const double growth = std::clamp(spread * (gap + way), -most, most);
  return plane * (nCurvatures == 1 ? 1.0 + growth : (1.0 + 0.5 * growth) * (1.0 + 0.5 * growth));
}

/// With solid f(n - kappa t^2/2) about the point (n along the normal, t across), sums over a Gaussian of width s give,
/// by parts, N = sum f n = s^2 sum f' and T = sum f (t^2 - <t^2>) = -kappa s^4 sum f'. What solid points have lost, G,
/// is the gap that the front is ahead by, times sum f'.
PhaseGeometry::Bend PhaseGeometry::bendOf(int point, const int* neighbors, const std::array<double, 3>& n) const {
  if (!knowsLoss_ || !weights_.isIsotropic()) return {};
  double total = volume_[point], lost = total * damage_[point], solid = total - lost;
  double across = 0.0, solidAcross = 0.0, along2 = 0.0, solidAlong2 = 0.0;
  for (std::size_t k = 0; k < bonds_.size(); ++k) {
    const int j = neighbors[k];
    const bool isLiquid = damage_[j] >= 1.0;
    const Bond& bond = bonds_[k];
    const double weight = volume_[j] * weights_.gaussian(bond);
    const double d = n[0] * bond.along[0] + n[1] * bond.along[1] + n[2] * bond.along[2];
    const double t2 = bond.length * bond.length - d * d;
    total += weight;
    across += weight * d;
    along2 += weight * t2;
    if (isLiquid) continue;
    const double metal = weight * (1.0 - damage_[j]);
    solid += metal;
    solidAcross += metal * d;
    solidAlong2 += metal * t2;
    lost += weight * damage_[j];
  }
  constexpr double whole = 0.95;  // of a window; sides of the body cut it
  const double first = solidAcross - solid * across / total, second = solidAlong2 - solid * along2 / total;
  if (total < whole * weights_.gaussianSum() || !(first > 0.0)) return {};
  const double variance = weights_.gaussianVariance(), gap = lost * variance / first;
  // The rows of a plane front that one after another turn liquid leave it a little uneven, by chance; what that bends
  // it counts for next to nothing.
  constexpr double chance = 0.08;  // a horizon
  const double spread = second / (first * variance), bend2 = std::pow(spread * weights_.horizon() / chance, 2);
  return {spread * bend2 * bend2 / (1.0 + bend2 * bend2), gap};
}

}  // namespace pd
