#include "flow_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "../../model/collective.hpp"
#include "exact_weights.hpp"
#include "flow_pressure_fits.hpp"
#include "flow_surroundings.hpp"

namespace pd {

namespace {

using FlowVector = std::array<double, 3>;
using FlowEnd = FlowGeometry::End;
using FlowKind = FlowGeometry::Kind;

/// Up to this many spacings from a jump of the walls' velocity the divergence is a balance of mass. (On a lattice
/// points are whole numbers of spacings apart: those at this very distance are within it, however they are rounded.)
constexpr double jumpReach = 8.0 + 1e-6;
/// Jumps above this part of the largest velocity count.
constexpr double jumpShare = 0.05;

std::size_t localIndex(int point) { return static_cast<std::size_t>(point); }

/// A velocity as a sum over points, some of which are seen mirrored, and a constant.
struct VelocityValue {
  struct Part {
    int point, copy;
    double weight;
  };
  std::vector<Part> parts;
  FlowVector constant{};
  SourceWeights<double> sources{};
};

class RowMaker {
 public:
  RowMaker(const FlowGeometry& geometry, const Communicator& comm, double t)
      : geometry_(geometry),
        comm_(comm),
        t_(t),
        n_(static_cast<std::size_t>(geometry.dimension())),
        sources_(geometry, t),
        fits_(geometry, sources_, t),
        surroundings_(geometry) {}

  FlowRows make() {
    std::vector<double> jumpOf;
    collectively(comm_, [&] {
      geometry_.requireNoneAcrossAxis(t_);
      jumpOf = findJumps();
    });
    const std::vector<double> jumps = comm_.gather(placesOfJumps(jumpOf));
    collectively(comm_, [&] {
      for (std::size_t row = 0; row < geometry_.fluid().size(); ++row) makeRow(row, jumps);
    });
    rows_.nAtJumps = comm_.sum(rows_.nAtJumps);
    rows_.sources = sources_.take();
    rows_.finish();
    return std::move(rows_);
  }

 private:
  const Discretization& mesh() const { return geometry_.mesh(); }
  double sign(int copy, std::size_t a) const { return mesh().symmetry.matrix(copy)[4 * a]; }

  /// In space the ends of all bonds would take more memory than all rows: they are found when they are needed.
  void makeRow(std::size_t row, const std::vector<double>& jumps) {
    constexpr std::size_t sample = 200;
    const int point = geometry_.fluid()[row];
    const bool isAtJump = isNearJump(point, jumps);
    if (const long long like = isAtJump ? -1 : surroundings_.like(point, row); like >= 0)
      return rows_.repeat(static_cast<std::size_t>(like), point);
    const std::vector<FlowEnd> ends = geometry_.endsOf(point);
    velocityRows(row, ends);
    pressureRow(row);
    if (isAtJump)
      massBalanceRow(row);
    else
      divergenceRow(row);
    smoothingRow(row, ends);
    if (row == sample) rows_.expect(geometry_.fluid().size());
    fits_.forget();
  }

  FlowVector velocityAt(int point, const FlowEnd& end) const {
    return geometry_.wallVelocity(end.boundary, geometry_.placeOn(point, end, end.fraction), t_);
  }
  SourceWeights<double> sourceOf(int point, const FlowEnd& end, double weight) {
    return sources_.at(end.boundary, geometry_.placeOn(point, end, end.fraction), false, weight);
  }
  bool isCompact(const FlowEnd& end) const { return geometry_.law().gradientsReach(end.length); }

  /// By row, how far the velocities of two walls differ beside the point, m/s; and the largest velocity.
  std::vector<double> findJumps() {
    std::vector<double> jumpOf(geometry_.fluid().size(), 0.0);
    for (std::size_t row = 0; row < jumpOf.size(); ++row) {
      const int point = geometry_.fluid()[row];
      if (!geometry_.isNearBoundary(point)) continue;
      const std::vector<FlowEnd> ends = geometry_.endsOf(point);
      for (const FlowEnd& end : ends) {
        if (end.kind != FlowKind::Wall) continue;
        const FlowVector velocity = velocityAt(point, end);
        rows_.largestVelocity = std::max(rows_.largestVelocity, std::hypot(velocity[0], velocity[1], velocity[2]));
      }
      jumpOf[row] = largestJump(point, ends);
    }
    return jumpOf;
  }

  /// [3 n]
  std::vector<double> placesOfJumps(const std::vector<double>& jumpOf) {
    rows_.largestVelocity = comm_.max(rows_.largestVelocity);
    std::vector<double> places;
    for (std::size_t row = 0; row < jumpOf.size(); ++row) {
      if (!(jumpOf[row] > jumpShare * rows_.largestVelocity)) continue;
      const double* x = &mesh().x[3 * localIndex(geometry_.fluid()[row])];
      places.insert(places.end(), x, x + 3);
    }
    return places;
  }

  double largestJump(int point, const std::vector<FlowEnd>& ends) const {
    const double reach = geometry_.spacingOf(point);
    const auto velocity = [&](const FlowEnd& wall, const FlowVector& place) {
      return geometry_.wallVelocity(wall.boundary, place, t_);
    };
    const auto apart = [](const FlowVector& a, const FlowVector& b) {
      return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
    };
    double largest = 0.0;
    for (std::size_t k = 0; k < ends.size(); ++k)
      for (std::size_t m = 0; m < k; ++m) {
        const FlowEnd &one = ends[k], &other = ends[m];
        if (one.kind != FlowKind::Wall || other.kind != FlowKind::Wall || one.boundary == other.boundary) continue;
        const FlowVector here = geometry_.placeOn(point, one, one.fraction);
        const FlowVector there = geometry_.placeOn(point, other, other.fraction);
        if (apart(here, there) > reach) continue;
        // An inlet's profile that ends in the velocity of the wall does not jump, however near to it bonds end.
        largest = std::max(largest, std::min(apart(velocity(one, here), velocity(other, here)),
                                             apart(velocity(one, there), velocity(other, there))));
      }
    return largest;
  }

  bool isNearJump(int point, const std::vector<double>& jumps) const {
    const double* x = &mesh().x[3 * localIndex(point)];
    const double reach = jumpReach * geometry_.spacingOf(point);
    for (std::size_t k = 0; k < jumps.size(); k += 3)
      if (std::hypot(x[0] - jumps[k], x[1] - jumps[k + 1], x[2] - jumps[k + 2]) < reach) return true;
    return false;
  }

  [[noreturn]] void tooFewNeighbors(int point) const {
    const double* x = &mesh().x[3 * localIndex(point)];
    throw DeckError(
        fmt::format("the neighbours of the fluid point at ({:g}, {:g}, {:g}) m do not suffice for its "
                    "gradients: the gap is too narrow there, or points beyond a wall are missing; they are "
                    "needed one horizon deep. Where points are irregular, a larger Horizon, or Gradient Horizon of the "
                    "material, helps",
                    x[0], x[1], x[2]));
  }

  bool reflectsPoints() const { return geometry_.law().reflectsPoints; }

  /// Bonds up to their ends: at a wall, or whole, as all are where points `beyond` walls have a value.
  kernels::BondEnds bondsOf(const std::vector<FlowEnd>& ends, bool beyond = false) const {
    kernels::BondEnds bonds;
    bonds.dimension = geometry_.dimension();
    for (const FlowEnd& end : ends) {
      const double part = beyond ? 1.0 : end.fraction;
      const FlowVector xi{part * end.xi[0], part * end.xi[1], part * end.xi[2]};
      bonds.add(xi.data(), end.volume);
    }
    return bonds;
  }

  VelocityValue valueOf(int point, const std::vector<FlowEnd>& ends, const FlowEnd& end) {
    if (end.kind == FlowKind::Fluid) return {{{end.point, end.copy, 1.0}}};
    if (end.kind == FlowKind::Wall && reflectsPoints()) return reflectedValue(point, ends, end);
    if (end.kind == FlowKind::Wall) return {{}, velocityAt(point, end), sourceOf(point, end, 1.0)};
    return mirroredValue(point, ends, geometry_.mirrored(point, end));
  }

  /// At the place `seen` from the point: of the point that is there, or of a fit to the ends near it.
  VelocityValue mirroredValue(int point, const std::vector<FlowEnd>& ends, const FlowVector& seen) {
    const double near = 1e-3 * geometry_.spacingOf(point);
    if (std::hypot(seen[0], seen[1], seen[2]) < near) return {{{point, 0, 1.0}}};
    std::vector<FlowEnd> usable;
    for (const FlowEnd& end : ends) {
      if (end.kind == FlowKind::Fluid &&
          std::hypot(end.xi[0] - seen[0], end.xi[1] - seen[1], end.xi[2] - seen[2]) < near)
        return {{{end.point, end.copy, 1.0}}};
      if (end.kind != FlowKind::Beyond) usable.push_back(end);
    }
    const std::vector<double> weights = kernels::interpolationWeights(bondsOf(usable), seen.data(), 2);
    if (weights.empty()) tooFewNeighbors(point);
    VelocityValue value;
    double rest = 1.0;
    for (std::size_t k = 0; k < usable.size(); ++k) {
      rest -= weights[k];
      if (usable[k].kind == FlowKind::Fluid) {
        value.parts.push_back({usable[k].point, usable[k].copy, weights[k]});
      } else {
        const FlowVector velocity = velocityAt(point, usable[k]);
        for (std::size_t a = 0; a < 3; ++a) value.constant[a] += weights[k] * velocity[a];
        for (const auto& source : sourceOf(point, usable[k], weights[k])) value.sources.push_back(source);
      }
    }
    value.parts.push_back({point, 0, rest});
    return value;
  }

  /// Of the point beyond a wall: twice the wall's velocity less that of the mirrored place.
  VelocityValue reflectedValue(int point, const std::vector<FlowEnd>& ends, const FlowEnd& end) {
    requireNormal(point, end);
    const FlowVector seen = geometry_.mirroredAtWall(point, end);
    FlowVector foot;
    for (std::size_t a = 0; a < 3; ++a) foot[a] = mesh().x[3 * localIndex(point) + a] + 0.5 * (end.xi[a] + seen[a]);
    VelocityValue value = mirroredValue(point, ends, seen);
    const FlowVector ofWall = geometry_.wallVelocity(end.boundary, foot, t_);
    for (auto& part : value.parts) part.weight = -part.weight;
    for (auto& [source, share] : value.sources) share = -share;
    for (std::size_t a = 0; a < 3; ++a) value.constant[a] = 2.0 * ofWall[a] - value.constant[a];
    for (const auto& source : sources_.at(end.boundary, foot, false, 2.0)) value.sources.push_back(source);
    return value;
  }

  void requireNormal(int point, const FlowEnd& end) const {
    if (geometry_.normalAt(end.boundary, geometry_.placeOn(point, end, end.fraction)) != FlowVector{}) return;
    const double* x = &mesh().x[3 * localIndex(point)];
    throw DeckError(fmt::format(
        "the wall beside the fluid point at ({:g}, {:g}, {:g}) m has no Surface, by which \"Walls: Reflected "
        "Points\" of Navier Stokes mirrors what is beyond it; give it one, or leave Walls out, as with "
        "metal that dissolves",
        x[0], x[1], x[2]));
  }

  void velocityRows(std::size_t row, const std::vector<FlowEnd>& ends) {
    const int point = geometry_.fluid()[row];
    std::vector<FlowEnd> compact;
    for (const FlowEnd& end : ends)
      if (isCompact(end)) compact.push_back(end);
    const std::vector<double> weights = kernels::gradientWeights(bondsOf(compact, reflectsPoints()));
    if (weights.empty()) tooFewNeighbors(point);
    std::array<double, 9> own{}, constant{};
    for (std::size_t k = 0; k < compact.size(); ++k) {
      const VelocityValue value = valueOf(point, ends, compact[k]);
      for (std::size_t b = 0; b < n_; ++b)
        for (std::size_t a = 0; a < n_; ++a) {
          own[3 * a + b] -= weights[n_ * k + b];
          constant[3 * a + b] += weights[n_ * k + b] * value.constant[a];
        }
      for (const auto& part : value.parts) {
        std::array<double, 9> term{};
        for (std::size_t a = 0; a < n_; ++a)
          for (std::size_t b = 0; b < n_; ++b) term[3 * a + b] = part.weight * weights[n_ * k + b] * sign(part.copy, a);
        rows_.gradient.add(part.point, term);
      }
      for (const auto& [source, share] : value.sources) {
        std::array<double, 9> term{};
        for (std::size_t a = 0; a < n_; ++a)
          for (std::size_t b = 0; b < n_; ++b) term[3 * a + b] = share * weights[n_ * k + b];
        rows_.gradient.addShare(source, term);
      }
    }
    rows_.gradient.add(point, own);
    rows_.gradient.close(point, constant);
    viscousRow(row, ends);
  }

  const kernels::Rings& rings() const { return geometry_.rings(); }
  double radius(int point) const { return rings().radius(mesh().x.data(), point); }

  /// Of the last row.
  static std::vector<const FlowOperator<9>::Share*> sharesOf(const FlowOperator<9>& gradient, std::size_t row) {
    std::vector<const FlowOperator<9>::Share*> found;
    for (auto share = gradient.shares.rbegin(); share != gradient.shares.rend() && share->row == row; ++share)
      found.push_back(&*share);
    return found;
  }

  /// After the gradient's.
  void viscousRow(std::size_t row, const std::vector<FlowEnd>& ends) {
    const int point = geometry_.fluid()[row];
    const FlowLaw& law = geometry_.law();
    const kernels::BondEnds bonds = bondsOf(ends, reflectsPoints());
    const std::vector<double> weights = kernels::viscousWeights(bonds, law.horizonVolume(), law.viscousKernel);
    if (weights.empty()) tooFewNeighbors(point);
    std::array<double, 9> own{}, constant{};
    for (std::size_t k = 0; k < ends.size(); ++k) {
      const std::array<double, 9> share = bonds.viscousShare(k, law.viscousKernel);
      const VelocityValue value = valueOf(point, ends, ends[k]);
      for (std::size_t a = 0; a < n_; ++a)
        for (std::size_t b = 0; b < n_; ++b) {
          own[3 * a + b] -= weights[k] * share[3 * a + b];
          constant[3 * a] += weights[k] * share[3 * a + b] * value.constant[b];
        }
      for (const auto& part : value.parts) {
        std::array<double, 9> term{};
        for (std::size_t a = 0; a < n_; ++a)
          for (std::size_t b = 0; b < n_; ++b)
            term[3 * a + b] = part.weight * weights[k] * share[3 * a + b] * sign(part.copy, b);
        rows_.viscous.add(part.point, term);
      }
      for (const auto& [source, part] : value.sources) {
        std::array<double, 9> term = share;
        for (double& weight : term) weight *= part * weights[k];
        rows_.viscous.addShare(source, term);
      }
    }
    if (rings().areUsed()) addRingViscosity(row, own, constant);
    rows_.viscous.add(point, own);
    rows_.viscous.close(point, constant);
  }

  /// What lap v of a body of revolution has besides: dv/dr /r, and along the radius -v_r/r^2.
  void addRingViscosity(std::size_t row, std::array<double, 9>& own, std::array<double, 9>& constant) {
    const int point = geometry_.fluid()[row];
    const double r = radius(point);
    const std::size_t radial = rings().radial();
    rows_.gradient.forEach(row, [&](const auto& term) {
      std::array<double, 9> part{};
      for (std::size_t a = 0; a < n_; ++a) part[4 * a] = term.weights[3 * a + radial] / r;
      rows_.viscous.add(term.point, part);
    });
    for (const auto* share : sharesOf(rows_.gradient, row)) {
      std::array<double, 9> part{};
      for (std::size_t a = 0; a < n_; ++a) part[4 * a] = share->weights[3 * a + radial] / r;
      rows_.viscous.addShare(share->source, part);
    }
    for (std::size_t a = 0; a < n_; ++a) constant[3 * a] += rows_.gradient.constants[row][3 * a + radial] / r;
    own[4 * radial] -= 1.0 / (r * r);
  }

  std::vector<int> candidatesAround(int point) const {
    std::vector<int> candidates = geometry_.neighborsOf(point);
    candidates.push_back(point);
    return candidates;
  }

  void pressureRow(std::size_t row) {
    const int point = geometry_.fluid()[row];
    const PressureFit& fit = fits_.at(point, {});
    for (const auto& term : fit.terms) rows_.pressureGradient.add(term.point, term.weight);
    for (const auto& [source, weight] : fit.sources) rows_.pressureGradient.addShare(source, weight);
    rows_.pressureGradient.close(point, fit.constant);
  }

  /// The trace of the gradient, and in bodies of revolution v_r/r.
  void divergenceRow(std::size_t row) {
    const FlowOperator<9>& gradient = rows_.gradient;
    gradient.forEach(row, [&](const auto& term) {
      FlowVector weight{};
      for (std::size_t a = 0; a < n_; ++a) weight[a] = term.weights[4 * a];
      rows_.divergence.add(term.point, weight);
    });
    if (rings().areUsed()) {
      const int point = geometry_.fluid()[row];
      FlowVector weight{};
      weight[rings().radial()] = 1.0 / radius(point);
      rows_.divergence.add(point, weight);
    }
    for (const auto* share : sharesOf(gradient, row))
      rows_.divergence.addShare(share->source, {share->weights[0], share->weights[4], share->weights[8]});
    double constant = 0.0;
    for (std::size_t a = 0; a < n_; ++a) constant += gradient.constants[row][4 * a];
    rows_.divergence.close(geometry_.fluid()[row], {constant, 0.0, 0.0});
  }

  /// What is said of a boundary by the bonds that meet it around a point.
  struct Facet {
    FlowVector normal{}, velocity{};
    SourceWeights<double> sources{};  ///< of the sum of velocities
    double count = 0.0;
    double area = 0.0;  ///< over the volume of the point, 1/m
  };

  /// -sum_j V_j/V_i G_ji v_j, with G the gradient of the pressure, and the flux through walls and inlets. That through
  /// outflows is in the first term, since pressures are known there.
  void massBalanceRow(std::size_t row) {
    const int point = geometry_.fluid()[row];
    const std::vector<int> candidates = candidatesAround(point);
    const std::vector<double>& volume = mesh().volume;
    FlowVector area{}, constantFlux{};
    std::map<int, Facet> facets;
    for (const int other : candidates) {
      if (!geometry_.isFluid(other)) continue;
      if (other != point && !geometry_.law().gradientsReach(ReferenceBond(mesh().x.data(), point, other).length))
        continue;
      FlowVector weight{};
      for (const auto& part : fits_.at(other, candidates).terms)
        if (part.point == point && part.copy == 0)
          for (std::size_t a = 0; a < n_; ++a)
            weight[a] += part.weight[a] * volume[localIndex(other)] / volume[localIndex(point)];
      for (std::size_t a = 0; a < n_; ++a) area[a] += weight[a];
      FlowVector term{};
      for (std::size_t a = 0; a < n_; ++a) term[a] = -weight[a] * sign(mesh().copyOf(other), a);
      rows_.divergence.add(mesh().sourceOf(other), term);
      addFacets(other, candidates, facets);
    }
    // Without walls there would be -1/r left: the divergence of 1 along the radius.
    if (rings().areUsed()) area[rings().radial()] += 1.0 / radius(point);
    splitArea(area, facets);
    for (const auto& [key, facet] : facets) {
      FlowVector outward{};
      for (std::size_t a = 0; a < n_; ++a) outward[a] = facet.area * facet.normal[a];
      for (double& component : outward) component /= facet.count;
      for (std::size_t a = 0; a < n_; ++a) constantFlux[0] += outward[a] * facet.velocity[a];
      for (const auto& [source, weight] : facet.sources)
        rows_.divergence.addShare(source, {weight * outward[0], weight * outward[1], weight * outward[2]});
    }
    rows_.divergence.close(point, constantFlux);
    ++rows_.nAtJumps;
  }

  void addFacets(int point, const std::vector<int>& candidates, std::map<int, Facet>& facets) {
    const std::vector<int> own = point < mesh().nOwned ? geometry_.neighborsOf(point) : candidates;
    for (const FlowEnd& end : geometry_.compactEndsOf(point, own)) {
      if (end.kind != FlowKind::Wall || end.openFraction <= 1.0) continue;
      const FlowVector place = geometry_.placeOn(point, end, end.fraction);
      Facet& facet = facets[end.boundary];
      facet.count += 1.0;
      const FlowVector normal = geometry_.normalAt(end.boundary, place);
      const FlowVector velocity = geometry_.wallVelocity(end.boundary, place, t_);
      for (std::size_t a = 0; a < n_; ++a) {
        facet.normal[a] += normal[a];
        facet.velocity[a] += velocity[a];
      }
      for (const auto& source : sourceOf(point, end, 1.0)) facet.sources.push_back(source);
    }
  }

  /// Shares the area vector out among the boundaries' normals, by least squares.
  void splitArea(const FlowVector& area, std::map<int, Facet>& facets) const {
    std::vector<Facet*> list;
    for (auto& [key, facet] : facets) {
      const double size = std::hypot(facet.normal[0], facet.normal[1], facet.normal[2]);
      if (size == 0.0) continue;  // the deck does not say where it is, and nothing flows through it
      for (double& component : facet.normal) component /= size;
      if (list.size() < 9) list.push_back(&facet);
    }
    const std::size_t count = list.size();
    std::vector<double> matrix(count * count), share(count, 0.0);
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t j = 0; j < count; ++j)
        for (std::size_t a = 0; a < n_; ++a) matrix[i * count + j] += list[i]->normal[a] * list[j]->normal[a];
      for (std::size_t a = 0; a < n_; ++a) share[i] += list[i]->normal[a] * area[a];
    }
    kernels::solveNormalEquations(static_cast<int>(count), matrix.data(), share.data());
    for (std::size_t i = 0; i < count; ++i) list[i]->area = share[i];
  }

  void smoothingRow(std::size_t row, const std::vector<FlowEnd>& ends) {
    const int point = geometry_.fluid()[row];
    const std::vector<int> candidates = candidatesAround(point);
    double constant = 0.0;
    const auto add = [&](int other, double weight) { rows_.smoothing.add(other, {weight}); };
    for (const FlowEnd& end : ends) {
      if (!isCompact(end) || end.kind != FlowKind::Fluid || end.openFraction <= 1.0) continue;
      const int neighbor = localNeighbor(point, end);
      const double weight = geometry_.compactWeight(point, end);
      add(end.point, weight);
      add(point, -weight);
      for (const int side : {point, neighbor}) {
        const PressureFit& fit = fits_.at(side, candidates);
        const auto along = [&](const FlowVector& g) { return g[0] * end.xi[0] + g[1] * end.xi[1] + g[2] * end.xi[2]; };
        for (const auto& term : fit.terms) add(term.point, -0.5 * weight * along(term.weight));
        constant -= 0.5 * weight * along(fit.constant);
        for (const auto& [source, share] : fit.sources)
          rows_.smoothing.addShare(source, {-0.5 * weight * along(share)});
      }
    }
    rows_.smoothing.close(point, {constant});
  }

  /// The local id, that of an image where it is one.
  int localNeighbor(int point, const FlowEnd& end) const {
    if (end.copy == 0) return end.point;
    for (const int neighbor : geometry_.neighborsOf(point))
      if (mesh().sourceOf(neighbor) == end.point && mesh().copyOf(neighbor) == end.copy) return neighbor;
    throw std::logic_error("an image is no neighbour");
  }

  const FlowGeometry& geometry_;
  const Communicator& comm_;
  const double t_;
  const std::size_t n_;
  FlowRows rows_;
  FlowSources sources_;
  PressureFits fits_;
  FlowSurroundings surroundings_;
};

}  // namespace

FlowRows makeFlowRows(const FlowGeometry& geometry, const Communicator& comm, double t) {
  return RowMaker(geometry, comm, t).make();
}

}  // namespace pd
