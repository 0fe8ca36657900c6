#include "flow_rows.hpp"

#include <algorithm>
#include <optional>

#include "../../model/collective.hpp"
#include "flow_jumps.hpp"
#include "flow_mass_balance.hpp"
#include "flow_surroundings.hpp"

namespace pd {

namespace {

using FlowVector = std::array<double, 3>;
using FlowEnd = FlowGeometry::End;
using FlowKind = FlowGeometry::Kind;

std::size_t localIndex(int point) { return static_cast<std::size_t>(point); }

/// Of rows of the same boundaries before some points became fluid, those around which nothing has changed.
class KeptRows {
 public:
  KeptRows() = default;
  KeptRows(const EarlierFlowRows& earlier, Model& model) : rowOf_(localIndex(model.nOwned()), -1) {
    std::vector<double> isNear = earlier.isChanged;
    // A row is made of its neighbours and their fits, which are made of theirs.
    for (int reach = 0; reach < 2; ++reach) spread(model, isNear);
    for (std::size_t row = 0; row < earlier.fluid.size(); ++row)
      if (isNear[localIndex(earlier.fluid[row])] == 0.0)
        rowOf_[localIndex(earlier.fluid[row])] = static_cast<long long>(row);
  }
  bool areAny() const { return !rowOf_.empty(); }
  /// -1: it must be made.
  long long of(int point) const { return areAny() ? rowOf_[localIndex(point)] : -1; }

 private:
  static void spread(Model& model, std::vector<double>& isNear) {
    const Discretization& mesh = model.discretization();
    const std::vector<double> before = isNear;
    for (int point = 0; point < mesh.nOwned; ++point) {
      const int* list = mesh.neighborhoodList.data() + mesh.neighborhoodStart[localIndex(point)];
      if (std::any_of(list + 1, list + 1 + *list, [&](int other) { return before[localIndex(other)] != 0.0; }))
        isNear[localIndex(point)] = 1.0;
    }
    model.exchange().import(isNear.data(), 1, Reflection::Even);
  }

  std::vector<long long> rowOf_;  ///< [owned points], or empty
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
        velocities_(geometry, sources_, t),
        massBalance_(geometry, fits_, velocities_),
        surroundings_(geometry) {}

  FlowRows make(std::optional<EarlierFlowRows> earlier, Model* model) {
    collectively(comm_, [&] { geometry_.requireNoneAcrossAxis(t_); });
    rows_.jumps = findFlowJumps(geometry_, comm_, t_);
    if (earlier && earlier->rows.jumps.places == rows_.jumps.places) {
      kept_ = KeptRows(*earlier, *model);
      before_ = std::move(earlier->rows);
      rows_.takeStencils(before_);
    }
    collectively(comm_, [&] {
      for (std::size_t row = 0; row < geometry_.fluid().size(); ++row) makeRow(row);
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
  void makeRow(std::size_t row) {
    constexpr std::size_t sample = 200;
    const int point = geometry_.fluid()[row];
    const bool isAtJump = rows_.jumps.areNear(geometry_, point);
    if (isAtJump) ++rows_.nAtJumps;
    if (const long long before = kept_.of(point); before >= 0)
      return rows_.keep(before_, static_cast<std::size_t>(before), point);
    if (const long long like = isAtJump ? -1 : surroundings_.like(point, row); like >= 0)
      return rows_.repeat(static_cast<std::size_t>(like), point);
    const std::vector<FlowEnd> ends = geometry_.endsOf(point);
    velocityRows(row, ends);
    pressureRow(row);
    if (isAtJump)
      massBalance_.addRow(point, candidatesAround(point), rows_.divergence);
    else
      divergenceRow(row);
    smoothingRow(row, ends);
    if (row == sample && !kept_.areAny()) rows_.expect(geometry_.fluid().size());
    fits_.forget();
  }

  bool isCompact(const FlowEnd& end) const { return geometry_.law().gradientsReach(end.length); }

  bool reflectsPoints() const { return geometry_.law().reflectsPoints; }
  void velocityRows(std::size_t row, const std::vector<FlowEnd>& ends) {
    const int point = geometry_.fluid()[row];
    std::vector<FlowEnd> compact;
    for (const FlowEnd& end : ends)
      if (isCompact(end)) compact.push_back(end);
    const std::vector<double> weights = kernels::gradientWeights(velocities_.bondsOf(compact, reflectsPoints()));
    if (weights.empty()) velocities_.tooFewNeighbors(point);
    std::array<double, 9> own{}, constant{};
    for (std::size_t k = 0; k < compact.size(); ++k) {
      const EndVelocity value = velocities_.at(point, ends, compact[k]);
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
    const kernels::BondEnds bonds = velocities_.bondsOf(ends, reflectsPoints());
    const std::vector<double> weights = kernels::viscousWeights(bonds, law.horizonVolume(), law.viscousKernel);
    if (weights.empty()) velocities_.tooFewNeighbors(point);
    std::array<double, 9> own{}, constant{};
    for (std::size_t k = 0; k < ends.size(); ++k) {
      const std::array<double, 9> share = bonds.viscousShare(k, law.viscousKernel);
      const EndVelocity value = velocities_.at(point, ends, ends[k]);
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
  FlowRows rows_, before_;
  KeptRows kept_;  ///< of before_
  FlowSources sources_;
  PressureFits fits_;
  EndVelocities velocities_;
  MassBalance massBalance_;
  FlowSurroundings surroundings_;
};

}  // namespace

FlowRows makeFlowRows(const FlowGeometry& geometry, const Communicator& comm, double t) {
  return RowMaker(geometry, comm, t).make({}, nullptr);
}

FlowRows renewFlowRows(EarlierFlowRows earlier, const FlowGeometry& geometry, Model& model, double t) {
  return RowMaker(geometry, model.comm(), t).make(std::move(earlier), &model);
}

}  // namespace pd
