#include "flow_rates.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "../../model/collective.hpp"
#include "diffusion_kernel.hpp"

namespace pd {

using kernels::FlowState;
using kernels::FlowStencils;
using kernels::FlowWeights;

namespace {

/// Of the sum of magnitudes: what a sum of weights that ought to be zero may be by rounding.
constexpr double roundedSum = 1e-9;
/// c of the smoothing c h^2/mu that Steady Flow has by default, and that density diffusion does not go beyond.
constexpr double viscousSmoothing = 0.05;

template <std::size_t N>
using RowWeights = std::map<int, std::array<double, N>>;

/// The weights of a row by point, the point itself among them.
template <std::size_t N>
RowWeights<N> rowWeights(const FlowOperator<N>& rows, std::size_t row) {
  RowWeights<N> weights;
  rows.forEach(row, [&](const auto& term) { weights.emplace(term.point, term.weights); });
  return weights;
}

/// What they add up to, zero where that is rounding.
template <std::size_t N>
std::array<double, N> rowSum(const FlowOperator<N>& rows, std::size_t row) {
  std::array<double, N> sum{}, size{};
  rows.forEach(row, [&](const auto& term) {
    for (std::size_t k = 0; k < N; ++k) {
      sum[k] += term.weights[k];
      size[k] += std::abs(term.weights[k]);
    }
  });
  for (std::size_t k = 0; k < N; ++k)
    if (std::abs(sum[k]) <= roundedSum * size[k]) sum[k] = 0.0;
  return sum;
}

/// Collects rows for FlowStencils.
class StencilMaker {
 public:
  explicit StencilMaker(int width) : width_(width) {}
  void beginRow(int point) {
    points_.push_back(point);
    count_ = list_.size();
    list_.push_back(0);
  }
  void add(int neighbor, const std::vector<double>& weights) {
    list_.push_back(neighbor);
    ++list_[count_];
    weights_.insert(weights_.end(), weights.begin(), weights.end());
  }
  std::unique_ptr<FlowStencils> make() {
    if (points_.empty()) return nullptr;
    return std::make_unique<FlowStencils>(std::move(points_), std::move(list_), weights_, width_);
  }

 private:
  int width_;
  std::size_t count_ = 0;
  std::vector<int> points_, list_;
  std::vector<double> weights_;
};

/// Whether a matrix of weights acts on all `n` components alike: as a multiple of 1, or by rows that are the same.
bool isMultipleOfOne(const std::array<double, 9>& weights, std::size_t n) {
  for (std::size_t a = 0; a < n; ++a)
    for (std::size_t b = 0; b < n; ++b)
      if (weights[3 * a + b] != (a == b ? weights[0] : 0.0)) return false;
  return true;
}
bool hasEqualRows(const std::array<double, 9>& weights, std::size_t n) {
  for (std::size_t a = 1; a < n; ++a)
    for (std::size_t b = 0; b < n; ++b)
      if (weights[3 * a + b] != weights[b]) return false;
  return true;
}

template <std::size_t N, class Test>
bool allNeighbors(const RowWeights<N>& weights, int point, const Test& test) {
  return std::all_of(weights.begin(), weights.end(),
                     [&](const auto& entry) { return entry.first == point || test(entry.second); });
}

/// [n n] of the [3 3].
void appendMatrix(std::vector<double>& values, const std::array<double, 9>& weights, std::size_t n) {
  for (std::size_t a = 0; a < n; ++a)
    for (std::size_t b = 0; b < n; ++b) values.push_back(weights[3 * a + b]);
}

bool isTraceOfGradient(const FlowRows& rows, std::size_t row) {
  RowWeights<3> trace;
  rows.gradient.forEach(row, [&](const auto& term) {
    trace.emplace(term.point, std::array<double, 3>{term.weights[0], term.weights[4], term.weights[8]});
  });
  return trace == rowWeights(rows.divergence, row);
}

}  // namespace

FlowRates::FlowRates(Simulation& simulation, const FlowGeometry& geometry, FlowRows rows,
                     const kernels::TaitFluid& fluid, double densityDiffusion)
    : model_(simulation.model),
      geometry_(geometry),
      rows_(std::move(rows)),
      fluid_(fluid),
      dimension_(geometry.dimension()),
      sources_(simulation.conditions),
      boundariesAt_(std::numeric_limits<double>::quiet_NaN()),
      forcesAt_(boundariesAt_) {
  makeStencils();
  makeDivergence();
  makeEdges();
  makeShares();
  makeTau(densityDiffusion);
  findClosedPockets();
  forces_.zero(model_.nPoints(), 3);
  density_.zero(model_.nPoints(), 1);
  for (kernels::PointArrays* arrays : {&operators_.convection, &operators_.viscous, &operators_.pressureGradient,
                                       &operators_.divergence, &operators_.smoothing})
    arrays->zero(model_.nPoints(), dimension_);
}

void FlowRates::makeStencils() {
  const auto n = static_cast<std::size_t>(dimension_);
  StencilMaker viscous(1), viscousMatrix(dimension_ * dimension_), gradients(2 * dimension_),
      gradientMatrix(dimension_ * (dimension_ + 1)), smoothing(1);
  std::vector<double> values;
  for (std::size_t row = 0; row < geometry_.fluid().size(); ++row) {
    const int point = geometry_.fluid()[row];
    const RowWeights<9> ofViscosity = rowWeights(rows_.viscous, row);
    const bool isPlain = allNeighbors(ofViscosity, point, [&](const auto& w) { return isMultipleOfOne(w, n); });
    (isPlain ? viscous : viscousMatrix).beginRow(point);
    for (const auto& [neighbor, weights] : ofViscosity) {
      if (neighbor == point) continue;
      ++nBonds_;
      values.clear();
      if (isPlain)
        values.push_back(weights[0]);
      else
        appendMatrix(values, weights, n);
      (isPlain ? viscous : viscousMatrix).add(neighbor, values);
    }

    RowWeights<9> ofVelocity = rowWeights(rows_.gradient, row);
    RowWeights<3> pressure = rowWeights(rows_.pressureGradient, row);
    for (const auto& [neighbor, weights] : pressure) ofVelocity[neighbor];
    const bool isEqual = allNeighbors(ofVelocity, point, [&](const auto& w) { return hasEqualRows(w, n); });
    (isEqual ? gradients : gradientMatrix).beginRow(point);
    for (const auto& [neighbor, weights] : ofVelocity) {
      if (neighbor == point) continue;
      values.clear();
      if (isEqual)
        values.assign(weights.begin(), weights.begin() + dimension_);
      else
        appendMatrix(values, weights, n);
      for (std::size_t b = 0; b < n; ++b) values.push_back(pressure[neighbor][b]);
      (isEqual ? gradients : gradientMatrix).add(neighbor, values);
    }

    smoothing.beginRow(point);
    for (const auto& [neighbor, weights] : rowWeights(rows_.smoothing, row))
      if (neighbor != point) smoothing.add(neighbor, {weights[0]});
  }
  viscous_ = {viscous.make(), viscousMatrix.make()};
  gradients_ = {gradients.make(), gradientMatrix.make()};
  smoothing_ = smoothing.make();
}

/// Where it is not the trace of the gradient.
void FlowRates::makeDivergence() {
  std::vector<StencilMaker> makers(static_cast<std::size_t>(dimension_), StencilMaker(1));
  for (std::size_t row = 0; row < geometry_.fluid().size(); ++row) {
    if (isTraceOfGradient(rows_, row)) continue;
    const int point = geometry_.fluid()[row];
    balanced_.push_back(point);
    const RowWeights<3> weights = rowWeights(rows_.divergence, row);
    for (std::size_t a = 0; a < makers.size(); ++a) {
      makers[a].beginRow(point);
      for (const auto& [neighbor, weight] : weights)
        if (neighbor != point) makers[a].add(neighbor, {weight[a]});
    }
  }
  if (!balanced_.empty())
    for (StencilMaker& maker : makers) divergence_.push_back(maker.make());
}

void FlowRates::makeEdges() {
  const auto isZero = [](const auto& values) {
    return std::all_of(values.begin(), values.end(), [](double value) { return value == 0.0; });
  };
  std::vector<char> changes(geometry_.fluid().size(), 0);
  const auto mark = [&](const auto& shares) {
    for (const auto& share : shares) changes[share.row] = 1;
  };
  mark(rows_.viscous.shares);
  mark(rows_.gradient.shares);
  mark(rows_.divergence.shares);
  mark(rows_.pressureGradient.shares);
  mark(rows_.smoothing.shares);
  for (std::size_t row = 0; row < geometry_.fluid().size(); ++row) {
    const Edge edge{geometry_.fluid()[row],        rowSum(rows_.viscous, row),
                    rowSum(rows_.gradient, row),   rowSum(rows_.pressureGradient, row),
                    rowSum(rows_.divergence, row), rowSum(rows_.smoothing, row)[0]};
    std::array<double, nConstants> constants{};
    for (std::size_t a = 0; a < 3; ++a) {
      constants[ofViscous + a] = rows_.viscous.constants[row][3 * a];
      constants[ofPressure + a] = rows_.pressureGradient.constants[row][a];
    }
    std::copy_n(rows_.gradient.constants[row].begin(), 9, constants.begin() + ofGradient);
    constants[ofDivergence] = rows_.divergence.constants[row][0];
    constants[ofSmoothing] = rows_.smoothing.constants[row][0];
    if (changes[row] == 0 && isZero(edge.viscous) && isZero(edge.gradient) && isZero(edge.pressureGradient) &&
        isZero(edge.divergence) && edge.smoothing == 0.0 && isZero(constants))
      continue;
    edgeOf_[row] = edges_.size();
    edges_.push_back(edge);
    firstConstants_.insert(firstConstants_.end(), constants.begin(), constants.end());
  }
  constants_ = firstConstants_;
}

/// Constants by component of the sources (FlowOperator says how weights act).
void FlowRates::makeShares() {
  std::map<std::pair<std::size_t, std::size_t>, double> sums;
  const auto add = [&](std::size_t row, std::size_t constant, std::size_t source, std::size_t component,
                       double weight) {
    if (weight != 0.0) sums[{nConstants * edgeOf_.at(row) + constant, 3 * source + component}] += weight;
  };
  for (const auto& share : rows_.viscous.shares)
    for (std::size_t a = 0; a < 3; ++a)
      for (std::size_t b = 0; b < 3; ++b) add(share.row, ofViscous + a, share.source, b, share.weights[3 * a + b]);
  for (const auto& share : rows_.gradient.shares)
    for (std::size_t a = 0; a < 3; ++a)
      for (std::size_t b = 0; b < 3; ++b)
        add(share.row, ofGradient + 3 * a + b, share.source, a, share.weights[3 * a + b]);
  for (const auto& share : rows_.divergence.shares)
    for (std::size_t a = 0; a < 3; ++a) add(share.row, ofDivergence, share.source, a, share.weights[a]);
  for (const auto& share : rows_.pressureGradient.shares)
    for (std::size_t a = 0; a < 3; ++a) add(share.row, ofPressure + a, share.source, 0, share.weights[a]);
  for (const auto& share : rows_.smoothing.shares) add(share.row, ofSmoothing, share.source, 0, share.weights[0]);
  for (const auto& [key, weight] : sums) shares_.push_back({key.first, key.second, weight});
  values_.resize(3 * rows_.sources.size());
}

/// With D = eta c h the divergence has -D/(rho c^2) S p, but no more than Steady Flow's c h^2/mu S p: where viscosity
/// rules a bond, that much would spoil it.
void FlowRates::makeTau(double densityDiffusion) {
  tau_.zero(model_.nPoints(), 1);
  leastSpacing_ = HUGE_VAL;
  for (const int point : geometry_.fluid()) {
    const double h = geometry_.spacingOf(point), c = fluid_.soundSpeed;
    leastSpacing_ = std::min(leastSpacing_, h);
    if (densityDiffusion == 0.0) continue;
    const double tau = h * h / (fluid_.viscosity / viscousSmoothing + fluid_.density * c * h / densityDiffusion);
    tau_[0][point] = tau;
    largestNumber_ = std::max(largestNumber_, tau * fluid_.density * c * c / (h * h));
  }
  leastSpacing_ = model_.comm().min(leastSpacing_);
  largestNumber_ = model_.comm().max(largestNumber_);
}

void FlowRates::findClosedPockets() {
  pockets_ = findFlowPockets(model_, geometry_, rows_);
  for (const FlowPockets::Pocket& pocket : pockets_.pockets) isClosed_.push_back(pocket.isOpen ? 0 : 1);
  hasClosed_ = std::count(isClosed_.begin(), isClosed_.end(), 1) > 0;
  leakage_.assign(isClosed_.size(), 0.0);
}

double FlowRates::uniformShare() const {
  if (nBonds_ == 0 || !viscous_.scalar) return 0.0;
  return viscous_.scalar->uniformShare() * static_cast<double>(viscous_.scalar->neighborhood().nBonds()) /
         static_cast<double>(nBonds_);
}

FlowState FlowRates::makeState() const {
  FlowState state;
  state.velocity.zero(model_.nPoints(), dimension_);
  state.pressure.zero(model_.nPoints(), 1);
  return state;
}

void FlowRates::read(FlowState& state) const {
  const double *velocity = model_.field("Velocity"), *pressure = model_.field("Pressure");
  for (const int point : geometry_.fluid()) {
    for (int a = 0; a < dimension_; ++a) state.velocity[a][point] = velocity[3 * point + a];
    state.pressure[0][point] = pressure[point];
  }
}

void FlowRates::write(const FlowState& state) const {
  double *velocity = model_.field("Velocity"), *pressure = model_.field("Pressure");
  for (const int point : geometry_.fluid()) {
    for (int a = 0; a < dimension_; ++a) velocity[3 * point + a] = state.velocity[a][point];
    pressure[point] = state.pressure[0][point];
  }
  model_.importGhosts("Velocity");
  model_.importGhosts("Pressure");
}

void FlowRates::exchange(FlowState& state) const {
  if (model_.comm().size() == 1) return;
  const Timers::Scope timer(model_.timers(), "ghost exchange");
  for (int a = 0; a < dimension_; ++a) model_.exchange().import(state.velocity[a], 1, std::nullopt);
  model_.exchange().import(state.pressure[0], 1, std::nullopt);
}

void FlowRates::applyOperators(const FlowState& state) {
  for (const auto& [stencils, kind] :
       {std::pair{viscous_.scalar.get(), FlowWeights::Scalar}, std::pair{viscous_.matrix.get(), FlowWeights::Matrix}})
    if (stencils != nullptr) kernels::applyViscosity(*stencils, kind, dimension_, state, operators_);
  for (const auto& [stencils, kind] : {std::pair{gradients_.scalar.get(), FlowWeights::Scalar},
                                       std::pair{gradients_.matrix.get(), FlowWeights::Matrix}})
    if (stencils != nullptr) kernels::applyGradients(*stencils, kind, dimension_, state, operators_);
  for (const int point : balanced_) operators_.divergence[0][point] = 0.0;
  for (std::size_t a = 0; a < divergence_.size(); ++a)
    kernels::addFluxDivergence(divergence_[a]->neighborhood(), divergence_[a]->weights(), nullptr,
                               state.velocity[static_cast<int>(a)], operators_.divergence[0]);
  operators_.smoothing.zero(model_.nPoints(), 1);
  if (smoothing_)
    kernels::addFluxDivergence(smoothing_->neighborhood(), smoothing_->weights(), nullptr, state.pressure[0],
                               operators_.smoothing[0]);
}

void FlowRates::addEdges(const FlowState& state, bool isLinear) {
  const auto n = static_cast<std::size_t>(dimension_);
  for (std::size_t e = 0; e < edges_.size(); ++e) {
    const Edge& edge = edges_[e];
    static constexpr std::array<double, nConstants> none{};
    const double* constants = isLinear ? none.data() : &constants_[nConstants * e];
    const double pressure = state.pressure[0][edge.point];
    std::array<double, 3> velocity{};
    for (std::size_t a = 0; a < n; ++a) velocity[a] = state.velocity[static_cast<int>(a)][edge.point];
    double divergence = constants[ofDivergence];
    for (std::size_t a = 0; a < n; ++a) {
      double convection = 0.0, viscous = constants[ofViscous + a];
      for (std::size_t b = 0; b < n; ++b) {
        convection += velocity[b] * (edge.gradient[3 * a + b] * velocity[a] + constants[ofGradient + 3 * a + b]);
        viscous += edge.viscous[3 * a + b] * velocity[b];
      }
      divergence += edge.divergence[a] * velocity[a];
      const int component = static_cast<int>(a);
      operators_.convection[component][edge.point] += convection;
      operators_.viscous[component][edge.point] += viscous;
      operators_.pressureGradient[component][edge.point] +=
          edge.pressureGradient[a] * pressure + constants[ofPressure + a];
    }
    operators_.divergence[0][edge.point] += divergence;
    operators_.smoothing[0][edge.point] += edge.smoothing * pressure + constants[ofSmoothing];
  }
}

void FlowRates::followBoundaries(double t) {
  if (rows_.sources.empty() || t == boundariesAt_) return;
  boundariesAt_ = t;
  orAbort(model_.comm(), [&] { geometry_.requireNoneAcrossAxis(t); });
  for (std::size_t k = 0; k < rows_.sources.size(); ++k) {
    const FlowSource& source = rows_.sources[k];
    std::array<double, 3> value{};
    if (source.isPressure)
      value[0] = geometry_.outflowPressure(source.boundary, source.place, t);
    else
      value = geometry_.wallVelocity(source.boundary, source.place, t);
    for (std::size_t a = 0; a < 3; ++a) values_[3 * k + a] = value[a] - source.value[a];
  }
  constants_ = firstConstants_;
  for (const Share& share : shares_) constants_[share.constant] += share.weight * values_[share.value];
}

void FlowRates::followForces(double t) {
  const bool isKnown = t == forcesAt_ || (!std::isnan(forcesAt_) && !sources_.dependOnTime());
  if (sources_.empty() || isKnown) return;
  forcesAt_ = t;
  const std::vector<double> force = sources_.at(model_.discretization(), t);
  for (const int point : geometry_.fluid())
    for (int a = 0; a < dimension_; ++a) forces_[a][point] = force[static_cast<std::size_t>(3 * point + a)];
}

void FlowRates::evaluate(FlowState& state, double t, FlowState& rates) {
  exchange(state);
  {
    const Timers::Scope timer(model_.timers(), "flow boundaries");
    followBoundaries(t);
    followForces(t);
  }
  {
    const Timers::Scope timer(model_.timers(), "flow kernel", nBonds_);
    applyOperators(state);
  }
  const Timers::Scope timer(model_.timers(), "flow rates");
  addEdges(state, false);
  kernels::flowRates(fluid_, dimension_, model_.nOwned(), state, operators_, forces_, tau_, rates, density_);
  if (hasClosed_) keepMass(state, rates);
}

/// Adds to dp/dt what makes the sum of V d rho/dt = V rho/K dp/dt over a closed pocket zero.
void FlowRates::keepMass(const FlowState& state, FlowState& rates) {
  std::vector<double> sums(2 * isClosed_.size(), 0.0);  // of V d rho/dt, and of V rho
  const std::vector<double>& volume = model_.discretization().volume;
  const auto pocketOf = [&](int point) {
    return static_cast<std::size_t>(pockets_.pocketOf[static_cast<std::size_t>(point)]);
  };
  for (const int point : geometry_.fluid()) {
    const double pressure = state.pressure[0][point];
    const double mass = density_[0][point] * volume[static_cast<std::size_t>(point)];
    sums[2 * pocketOf(point)] += mass / fluid_.bulkModulus(pressure) * rates.pressure[0][point];
    sums[2 * pocketOf(point) + 1] += mass;
  }
  MPI_Allreduce(MPI_IN_PLACE, sums.data(), static_cast<int>(sums.size()), MPI_DOUBLE, MPI_SUM, model_.comm().mpi());
  for (std::size_t k = 0; k < isClosed_.size(); ++k)
    leakage_[k] = isClosed_[k] != 0 ? sums[2 * k] / sums[2 * k + 1] : 0.0;
  for (const int point : geometry_.fluid())
    rates.pressure[0][point] -= fluid_.bulkModulus(state.pressure[0][point]) * leakage_[pocketOf(point)];
}

void FlowRates::evaluateLinear(FlowState& state, const Parts& parts, FlowState& rates) {
  exchange(state);
  const Timers::Scope timer(model_.timers(), "flow time step", nBonds_);
  applyOperators(state);
  addEdges(state, true);
  const double kinematic = parts.viscosity * fluid_.viscosity / fluid_.density;
  const double perDensity = parts.acoustics / fluid_.density, bulkModulus = fluid_.bulkModulus(0.0);
  for (const int point : geometry_.fluid()) {
    for (int a = 0; a < dimension_; ++a)
      rates.velocity[a][point] =
          kinematic * operators_.viscous[a][point] - perDensity * operators_.pressureGradient[a][point];
    rates.pressure[0][point] = bulkModulus * (parts.diffusion * tau_[0][point] * operators_.smoothing[0][point] -
                                              parts.acoustics * operators_.divergence[0][point]);
  }
}

double FlowRates::excessMass(const FlowState& state) const {
  double excess = 0.0, whole = 0.0;
  for (const int point : geometry_.fluid()) {
    const auto p = static_cast<std::size_t>(point);
    if (isClosed_[static_cast<std::size_t>(pockets_.pocketOf[p])] == 0) continue;
    excess += (fluid_.densityAt(state.pressure[0][point]) / fluid_.density - 1.0) * model_.discretization().volume[p];
    whole += model_.discretization().volume[p];
  }
  excess = model_.comm().sum(excess);
  whole = model_.comm().sum(whole);
  return whole > 0.0 ? excess / whole : 0.0;
}

double FlowRates::largestNetFlow(double velocity) const {
  std::vector<double> flows = leakage_;
  for (double& flow : flows) flow *= leastSpacing_;
  return pd::largestNetFlow(pockets_, flows, velocity, static_cast<std::size_t>(dimension_));
}

}  // namespace pd
