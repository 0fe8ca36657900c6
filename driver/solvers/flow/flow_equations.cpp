#include "flow_equations.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "flow_blocks.hpp"
#include "flow_products.hpp"

namespace pd {

FlowEquations::FlowEquations(Simulation& simulation, const FlowLaw& law, const std::vector<int>& flowBlocks,
                             double smoothing, const std::vector<char>& isSolid)
    : simulation_(simulation),
      model_(simulation.model),
      geometry_(simulation, law, flowBlocks, isSolid),
      smoothing_(smoothing),
      density_(law.density),
      viscosity_(law.viscosity),
      n_(static_cast<std::size_t>(geometry_.dimension())) {
  unit_ = HUGE_VAL;
  for (const int point : geometry_.fluid()) unit_ = std::min(unit_, geometry_.spacingOf(point));
  unit_ = model_.comm().min(unit_);
  markFluid(model_, geometry_);
}

void FlowEquations::goOnFrom(FlowEquations& earlier) {
  const auto nPoints = static_cast<std::size_t>(model_.nPoints());
  std::vector<double> isChanged(nPoints, 0.0);
  for (std::size_t point = 0; point < nPoints; ++point)
    if (geometry_.isSolid(static_cast<int>(point)) != earlier.geometry_.isSolid(static_cast<int>(point)))
      isChanged[point] = 1.0;
  if (earlier.hasRows_ && !model_.comm().any(!earlier.rows_.sources.empty()))
    earlier_ = EarlierFlowRows{std::move(earlier.rows_), earlier.geometry_.fluid(), std::move(isChanged)};
}

void FlowEquations::setTime(double t) {
  if (t != time_) {
    time_ = t;
    force_ = FlowForces(simulation_.conditions).at(model_.discretization(), t);
    if (!hasRows_ || model_.comm().any(!rows_.sources.empty())) makeRows(t);
  }
  refreshSmoothing();
}

void FlowEquations::makeRows(double t) {
  rows_ =
      earlier_ ? renewFlowRows(std::move(*earlier_), geometry_, model_, t) : makeFlowRows(geometry_, model_.comm(), t);
  earlier_.reset();
  hasRows_ = true;
  pockets_ = findFlowPockets(model_, geometry_, rows_);
  numberUnknowns();
}

/// Those of a rank in sequence: its points', then lambda of the closed pockets whose first points it has.
void FlowEquations::numberUnknowns() {
  ownPockets_.clear();
  for (std::size_t k = 0; k < pockets_.pockets.size(); ++k)
    if (!pockets_.pockets[k].isOpen && pockets_.pockets[k].firstPoint >= 0) ownPockets_.push_back(static_cast<int>(k));
  const long long own = static_cast<long long>(nOfPoints() + ownPockets_.size());
  long long first = 0;
  MPI_Exscan(&own, &first, 1, MPI_LONG_LONG, MPI_SUM, model_.comm().mpi());
  if (model_.comm().isRoot()) first = 0;
  firstUnknown_ = first;
  firstColumn_.assign(static_cast<std::size_t>(model_.nPoints()), -1.0);
  for (std::size_t row = 0; row < geometry_.fluid().size(); ++row)
    firstColumn_[index(geometry_.fluid()[row])] = static_cast<double>(first) + static_cast<double>(place(row, 0));
  model_.exchange().import(firstColumn_.data(), 1, std::nullopt);
  pocketColumn_.assign(pockets_.pockets.size(), -1);
  lambda_.resize(pockets_.pockets.size(), 0.0);
  for (std::size_t k = 0; k < ownPockets_.size(); ++k)
    pocketColumn_[static_cast<std::size_t>(ownPockets_[k])] = first + static_cast<long long>(nOfPoints() + k);
  MPI_Allreduce(MPI_IN_PLACE, pocketColumn_.data(), static_cast<int>(pocketColumn_.size()), MPI_LONG_LONG, MPI_MAX,
                model_.comm().mpi());
}

long long FlowEquations::column(int point, std::size_t component) const {
  return static_cast<long long>(firstColumn_[index(point)]) + static_cast<long long>(component);
}

double FlowEquations::speed(int point) const {
  const double* v = model_.field("Velocity") + 3 * point;
  return std::hypot(v[0], v[1], v[2]);
}

void FlowEquations::refreshSmoothing() {
  tau_.clear();
  gradients_.resize(geometry_.fluid().size());
  for (std::size_t row = 0; row < gradients_.size(); ++row) gradients_[row] = gradientAt(row);
  for (const int point : geometry_.fluid()) {
    const double h = geometry_.spacingOf(point), cellReynolds = density_ * speed(point) * h / viscosity_;
    tau_.push_back(smoothing_ * h * h / (viscosity_ * (1.0 + 0.25 * cellReynolds)));
  }
}

std::array<double, 9> FlowEquations::gradientAt(std::size_t row) const {
  const double* velocity = model_.field("Velocity");
  std::array<double, 9> gradient = rows_.gradient.constants[row];
  rows_.gradient.forEach(row, [&](const auto& term) {
    for (std::size_t a = 0; a < n_; ++a)
      for (std::size_t b = 0; b < n_; ++b)
        gradient[3 * a + b] += term.weights[3 * a + b] * velocity[3 * index(term.point) + a];
  });
  return gradient;
}

/// What is linear in the velocity and pressure of a row, but for constants and lambda; `own` [n_ + 1].
void FlowEquations::addLinear(std::size_t row, const std::vector<double>& state, double* own) const {
  const double ofMomentum = unit_ * unit_ / viscosity_;
  std::array<double, 3> sum{};
  flow_products::addGradient(rows_.pressureGradient.row(row), state, ofMomentum, sum.data());
  flow_products::addProduct(rows_.viscous.row(row), state, -viscosity_ * ofMomentum, sum.data());
  for (std::size_t a = 0; a < n_; ++a) own[a] += sum[a];
  own[n_] += (flow_products::divergence(rows_.divergence.row(row), state) -
              tau_[row] * flow_products::smoothing(rows_.smoothing.row(row), state)) *
             unit_;
}

void FlowEquations::addConvection(std::size_t row, const std::vector<double>& state, double* own) const {
  const double factor = density_ * unit_ * unit_ / viscosity_;
  const int point = geometry_.fluid()[row];
  const double* change = flow_products::valuesOf(state, point);
  std::array<double, 3> sum{};
  flow_products::addCarried(rows_.gradient.row(row), state, model_.field("Velocity") + 3 * index(point), factor,
                            sum.data());
  for (std::size_t a = 0; a < n_; ++a) {
    own[a] += sum[a];
    for (std::size_t b = 0; b < n_; ++b) own[a] += factor * gradients_[row][3 * a + b] * change[b];
  }
}

/// Velocities and pressures of the fields, ghosts included, as flow_products want them.
std::vector<double> FlowEquations::presentState() const {
  const double *velocity = model_.field("Velocity"), *pressure = model_.field("Pressure");
  std::vector<double> state(flow_products::width * static_cast<std::size_t>(model_.nPoints()));
  for (std::size_t point = 0; point < static_cast<std::size_t>(model_.nPoints()); ++point) {
    std::copy_n(velocity + 3 * point, 3, &state[flow_products::width * point]);
    state[flow_products::width * point + 3] = pressure[point];
  }
  return state;
}

/// All of the residuals of a point but convection and lambda.
void FlowEquations::addStokes(std::size_t row, const std::vector<double>& state, double* own) const {
  const double ofMomentum = unit_ * unit_ / viscosity_;
  const int point = geometry_.fluid()[row];
  for (std::size_t a = 0; a < n_; ++a)
    own[a] += (rows_.pressureGradient.constants[row][a] - viscosity_ * rows_.viscous.constants[row][3 * a] -
               force_[3 * index(point) + a]) *
              ofMomentum;
  own[n_] = (rows_.divergence.constants[row][0] - tau_[row] * rows_.smoothing.constants[row][0]) * unit_;
  addLinear(row, state, own);
}

double FlowEquations::drive() const {
  std::vector<double> state = presentState();
  const std::vector<double> outside = outflowPressures(model_.field("Pressure"));
  for (const int point : geometry_.fluid()) {
    double* values = &state[flow_products::width * index(point)];
    std::fill_n(values, 3, 0.0);
    values[3] = outside[static_cast<std::size_t>(pockets_.pocketOf[index(point)])];
  }
  model_.exchange().import(state.data(), static_cast<int>(flow_products::width), std::nullopt);
  double square = 0.0;
  for (std::size_t row = 0; row < geometry_.fluid().size(); ++row) {
    std::array<double, 4> own{};
    addStokes(row, state, own.data());
    for (const double value : own) square += value * value;
  }
  return std::sqrt(model_.comm().sum(square));
}

std::vector<double> FlowEquations::residual(bool hasConvection) const {
  const double *velocity = model_.field("Velocity"), *pressure = model_.field("Pressure");
  const double ofMomentum = unit_ * unit_ / viscosity_;
  std::vector<double> result(nOfPoints() + ownPockets_.size(), 0.0);
  const std::vector<double> state = presentState();
  for (std::size_t row = 0; row < geometry_.fluid().size(); ++row) {
    const int point = geometry_.fluid()[row];
    double* own = &result[place(row, 0)];
    if (hasConvection) {
      const std::array<double, 9> gradient = gradientAt(row);
      for (std::size_t a = 0; a < n_; ++a)
        for (std::size_t b = 0; b < n_; ++b)
          own[a] += density_ * velocity[3 * index(point) + b] * gradient[3 * a + b] * ofMomentum;
    }
    addStokes(row, state, own);
    const auto pocket = static_cast<std::size_t>(pockets_.pocketOf[index(point)]);
    if (pocketColumn_[pocket] >= 0) own[n_] += lambda_[pocket];
  }
  for (std::size_t k = 0; k < ownPockets_.size(); ++k)
    result[nOfPoints() + k] =
        pressure[pockets_.pockets[static_cast<std::size_t>(ownPockets_[k])].firstPoint] * unit_ / viscosity_;
  return result;
}

void FlowEquations::apply(bool hasConvection, const double* x, double* y) const {
  std::vector<double> state(flow_products::width * static_cast<std::size_t>(model_.nPoints()), 0.0);
  for (std::size_t row = 0; row < geometry_.fluid().size(); ++row) {
    double* values = &state[flow_products::width * index(geometry_.fluid()[row])];
    std::copy_n(x + place(row, 0), n_, values);
    values[3] = x[place(row, n_)] * viscosity_ / unit_;
  }
  model_.exchange().import(state.data(), static_cast<int>(flow_products::width), std::nullopt);
  std::copy_n(x, nOfPoints(), y);  // for points that are solid
  const std::vector<double> lambdas = ofPockets(x);
  for (std::size_t row = 0; row < geometry_.fluid().size(); ++row) {
    const int point = geometry_.fluid()[row];
    double* own = y + place(row, 0);
    std::fill_n(own, n_ + 1, 0.0);
    addLinear(row, state, own);
    if (hasConvection) addConvection(row, state, own);
    own[n_] += lambdas[static_cast<std::size_t>(pockets_.pocketOf[index(point)])];
  }
  for (std::size_t k = 0; k < ownPockets_.size(); ++k)
    y[nOfPoints() + k] =
        state[flow_products::width * index(pockets_.pockets[static_cast<std::size_t>(ownPockets_[k])].firstPoint) + 3] *
        unit_ / viscosity_;
}

SparseRows FlowEquations::matrix(bool hasConvection) const {
  SparseRows result;
  std::vector<std::pair<long long, double>> entries;
  const auto addIdentityUpTo = [&](std::size_t unknown) {
    while (result.count() < unknown) {
      entries = {{firstUnknown_ + static_cast<long long>(result.count()), 1.0}};
      result.addRow(entries);
    }
  };
  for (std::size_t row = 0; row < geometry_.fluid().size(); ++row) {
    addIdentityUpTo(place(row, 0));
    for (std::size_t component = 0; component <= n_; ++component) {
      entries = entriesOf(row, component, hasConvection);
      result.addRow(entries);
    }
  }
  addIdentityUpTo(nOfPoints());
  for (const int pocket : ownPockets_) {
    entries = {{column(pockets_.pockets[static_cast<std::size_t>(pocket)].firstPoint, n_), 1.0}};
    result.addRow(entries);
  }
  return result;
}

SparseRows FlowEquations::matrixWithin(const std::vector<std::size_t>& rows, bool hasConvection) const {
  std::vector<long long> numberOf(count(), -1);
  long long number = 0;
  for (const std::size_t row : rows)
    for (std::size_t component = 0; component <= n_; ++component) numberOf[place(row, component)] = number++;
  SparseRows result;
  std::vector<std::pair<long long, double>> within;
  for (const std::size_t row : rows)
    for (std::size_t component = 0; component <= n_; ++component) {
      within.clear();
      for (const auto& [column, value] : entriesOf(row, component, hasConvection)) {
        const long long own = column - firstUnknown_;
        if (own < 0 || own >= static_cast<long long>(count())) continue;
        if (const long long k = numberOf[static_cast<std::size_t>(own)]; k >= 0) within.emplace_back(k, value);
      }
      result.addRow(within);
    }
  return result;
}

/// Of the equation of a component of a row, the divergence's last: columns, some of them several times, and values.
std::vector<std::pair<long long, double>> FlowEquations::entriesOf(std::size_t row, std::size_t component,
                                                                   bool hasConvection) const {
  std::vector<std::pair<long long, double>> entries;
  const double ofPressure = viscosity_ / unit_;
  const int point = geometry_.fluid()[row];
  if (component < n_) {
    addMomentumEntries(row, component, hasConvection, entries);
    return entries;
  }
  rows_.divergence.forEach(row, [&](const auto& term) {
    for (std::size_t a = 0; a < n_; ++a) entries.emplace_back(column(term.point, a), term.weights[a] * unit_);
  });
  rows_.smoothing.forEach(row, [&](const auto& term) {
    entries.emplace_back(column(term.point, n_), -tau_[row] * term.weights[0] * unit_ * ofPressure);
  });
  const auto pocket = static_cast<std::size_t>(pockets_.pocketOf[index(point)]);
  if (pocketColumn_[pocket] >= 0) entries.emplace_back(pocketColumn_[pocket], 1.0);
  return entries;
}

void FlowEquations::addMomentumEntries(std::size_t row, std::size_t a, bool hasConvection,
                                       std::vector<std::pair<long long, double>>& entries) const {
  const double ofMomentum = unit_ * unit_ / viscosity_, ofPressure = viscosity_ / unit_;
  const int point = geometry_.fluid()[row];
  const double* velocity = model_.field("Velocity") + 3 * index(point);
  rows_.viscous.forEach(row, [&](const auto& term) {
    for (std::size_t b = 0; b < n_; ++b)
      if (term.weights[3 * a + b] != 0.0)
        entries.emplace_back(column(term.point, b), -viscosity_ * term.weights[3 * a + b] * ofMomentum);
  });
  rows_.pressureGradient.forEach(row, [&](const auto& term) {
    entries.emplace_back(column(term.point, n_), term.weights[a] * ofMomentum * ofPressure);
  });
  if (!hasConvection) return;
  rows_.gradient.forEach(row, [&](const auto& term) {
    double along = 0.0;
    for (std::size_t b = 0; b < n_; ++b) along += velocity[b] * term.weights[3 * a + b];
    entries.emplace_back(column(term.point, a), density_ * along * ofMomentum);
  });
  for (std::size_t b = 0; b < n_; ++b)
    entries.emplace_back(column(point, b), density_ * gradients_[row][3 * a + b] * ofMomentum);
}

/// Of the unknowns `x` of this rank, lambda of all pockets.
std::vector<double> FlowEquations::ofPockets(const double* x) const {
  std::vector<double> all(lambda_.size(), 0.0);
  for (std::size_t k = 0; k < ownPockets_.size(); ++k)
    all[static_cast<std::size_t>(ownPockets_[k])] = x[nOfPoints() + k];
  MPI_Allreduce(MPI_IN_PLACE, all.data(), static_cast<int>(all.size()), MPI_DOUBLE, MPI_SUM, model_.comm().mpi());
  return all;
}

void FlowEquations::balancePockets(std::vector<double>& divergence, double* z) const {
  std::vector<double> means(lambda_.size(), 0.0);
  for (std::size_t row = 0; row < divergence.size(); ++row) {
    const auto pocket = static_cast<std::size_t>(pockets_.pocketOf[index(geometry_.fluid()[row])]);
    if (pocketColumn_[pocket] >= 0)
      means[pocket] += divergence[row] / static_cast<double>(pockets_.pockets[pocket].nPoints);
  }
  MPI_Allreduce(MPI_IN_PLACE, means.data(), static_cast<int>(means.size()), MPI_DOUBLE, MPI_SUM, model_.comm().mpi());
  for (std::size_t row = 0; row < divergence.size(); ++row)
    divergence[row] -= means[static_cast<std::size_t>(pockets_.pocketOf[index(geometry_.fluid()[row])])];
  if (z == nullptr) return;
  for (std::size_t k = 0; k < ownPockets_.size(); ++k)
    z[nOfPoints() + k] = means[static_cast<std::size_t>(ownPockets_[k])];
}

void FlowEquations::shiftPockets(const double* r, std::vector<double>& pressure) const {
  std::vector<double> shifts = ofPockets(r), atFirst(lambda_.size(), 0.0);
  for (std::size_t row = 0; row < pressure.size(); ++row) {
    const int point = geometry_.fluid()[row];
    const auto pocket = static_cast<std::size_t>(pockets_.pocketOf[index(point)]);
    if (pocketColumn_[pocket] >= 0 && pockets_.pockets[pocket].firstPoint == point) atFirst[pocket] = pressure[row];
  }
  MPI_Allreduce(MPI_IN_PLACE, atFirst.data(), static_cast<int>(atFirst.size()), MPI_DOUBLE, MPI_SUM,
                model_.comm().mpi());
  for (std::size_t row = 0; row < pressure.size(); ++row) {
    const auto pocket = static_cast<std::size_t>(pockets_.pocketOf[index(geometry_.fluid()[row])]);
    if (pocketColumn_[pocket] >= 0) pressure[row] += shifts[pocket] - atFirst[pocket];
  }
}

void FlowEquations::add(double factor, const std::vector<double>& change) {
  double *velocity = model_.field("Velocity"), *pressure = model_.field("Pressure");
  for (std::size_t row = 0; row < geometry_.fluid().size(); ++row) {
    const std::size_t point = index(geometry_.fluid()[row]);
    for (std::size_t a = 0; a < n_; ++a) velocity[3 * point + a] += factor * change[place(row, a)];
    pressure[point] += factor * change[place(row, n_)] * viscosity_ / unit_;
  }
  const std::vector<double> changes = ofPockets(change.data());
  for (std::size_t k = 0; k < lambda_.size(); ++k) lambda_[k] += factor * changes[k];
  model_.importGhosts("Velocity");
  model_.importGhosts("Pressure");
}

/// By pocket: means over the bonds of fluid points to points beyond outflows, of `pressure` [points]; 0 without any.
std::vector<double> FlowEquations::outflowPressures(const double* pressure) const {
  const std::size_t nPockets = pockets_.pockets.size();
  std::vector<double> sums(2 * nPockets, 0.0), means(nPockets, 0.0);
  for (const int point : geometry_.fluid()) {
    if (!geometry_.isNearBoundary(point)) continue;
    const auto pocket = static_cast<std::size_t>(pockets_.pocketOf[index(point)]);
    for (const int neighbor : geometry_.neighborsOf(point)) {
      if (!geometry_.isBeyondOutflow(neighbor)) continue;
      sums[pocket] += pressure[neighbor];
      sums[nPockets + pocket] += 1.0;
    }
  }
  MPI_Allreduce(MPI_IN_PLACE, sums.data(), static_cast<int>(sums.size()), MPI_DOUBLE, MPI_SUM, model_.comm().mpi());
  for (std::size_t k = 0; k < nPockets; ++k)
    if (sums[nPockets + k] > 0.0) means[k] = sums[k] / sums[nPockets + k];
  return means;
}

void FlowEquations::followOutflows(const std::vector<double>& before) {
  double* pressure = model_.field("Pressure");
  const std::vector<double> now = outflowPressures(pressure), earlier = outflowPressures(before.data());
  if (now == earlier) return;
  for (const int point : geometry_.fluid()) {
    const auto pocket = static_cast<std::size_t>(pockets_.pocketOf[index(point)]);
    pressure[point] += now[pocket] - earlier[pocket];
  }
  model_.importGhosts("Pressure");
}

void FlowEquations::comeToRest() {
  double *velocity = model_.field("Velocity"), *pressure = model_.field("Pressure");
  const std::vector<double> outside = outflowPressures(pressure);
  for (const int point : geometry_.fluid()) {
    std::fill_n(velocity + 3 * index(point), 3, 0.0);
    pressure[point] = outside[static_cast<std::size_t>(pockets_.pocketOf[index(point)])];
  }
  std::fill(lambda_.begin(), lambda_.end(), 0.0);
  model_.importGhosts("Velocity");
  model_.importGhosts("Pressure");
}

void FlowEquations::settle(double t) {
  double* pressure = model_.field("Pressure");
  const std::vector<double>& volume = model_.discretization().volume;
  std::vector<double> means(pockets_.pockets.size(), 0.0);
  for (const int point : geometry_.fluid()) {
    const auto pocket = static_cast<std::size_t>(pockets_.pocketOf[index(point)]);
    means[pocket] += pressure[point] * volume[index(point)] / pockets_.pockets[pocket].volume;
  }
  MPI_Allreduce(MPI_IN_PLACE, means.data(), static_cast<int>(means.size()), MPI_DOUBLE, MPI_SUM, model_.comm().mpi());
  for (const int point : geometry_.fluid()) {
    const auto pocket = static_cast<std::size_t>(pockets_.pocketOf[index(point)]);
    if (!pockets_.pockets[pocket].isOpen) pressure[point] -= means[pocket];
  }
  simulation_.conditions.applyPrescribed(t);
  model_.importGhosts("Pressure");
}

double FlowEquations::largestSpeed() const {
  double largest = 0.0;
  for (const int point : geometry_.fluid()) largest = std::max(largest, speed(point));
  return model_.comm().max(largest);
}

double FlowEquations::scaleOfSpeed() const {
  return std::max({largestSpeed(), rows_.jumps.largestVelocity, speedOfRounding()});
}

double FlowEquations::speedOfRounding() const {
  constexpr double rounded = 1e-6;  // a flow that p drives over a thousand spacings is a hundred times as fast
  const double* pressure = model_.field("Pressure");
  double largest = 0.0;
  for (const int point : geometry_.fluid())
    largest = std::max(largest, rounded * std::abs(pressure[point]) * geometry_.spacingOf(point) / viscosity_);
  return model_.comm().max(largest);
}

double FlowEquations::largestCellReynolds() const {
  double largest = 0.0;
  for (const int point : geometry_.fluid())
    largest = std::max(largest, density_ * speed(point) * geometry_.spacingOf(point) / viscosity_);
  return model_.comm().max(largest);
}

double FlowEquations::largestNetFlow() const { return pd::largestNetFlow(pockets_, lambda_, scaleOfSpeed(), n_); }

double FlowEquations::leakage() const {
  double largest = 0.0;
  for (const double value : lambda_) largest = std::max(largest, std::abs(value) / unit_);
  return largest;
}

double FlowEquations::largestDivergence() const {
  const double* velocity = model_.field("Velocity");
  double largest = 0.0;
  for (std::size_t row = 0; row < geometry_.fluid().size(); ++row) {
    double sum = rows_.divergence.constants[row][0];
    rows_.divergence.forEach(row, [&](const auto& term) {
      for (std::size_t a = 0; a < n_; ++a) sum += term.weights[a] * velocity[3 * index(term.point) + a];
    });
    largest = std::max(largest, std::abs(sum));
  }
  return model_.comm().max(largest);
}

}  // namespace pd
