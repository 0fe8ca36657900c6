#include "flow_preconditioner.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "flow_products.hpp"

namespace pd {

namespace {

/// A bond that a wall cuts shorter than this counts as one of this part: one row must not be all wall.
constexpr double shortestCut = 0.1;
/// Of the pressure's Laplacian, since pockets without an outflow leave a constant free.
constexpr double pressureTie = 1e-6;

}  // namespace

FlowPreconditioner::FlowPreconditioner(Model& model, const FlowEquations& equations, bool hasConvection,
                                       bool convectsPressure)
    : model_(model),
      equations_(equations),
      geometry_(equations.geometry()),
      hasConvection_(hasConvection),
      n_(static_cast<std::size_t>(geometry_.dimension())) {
  numberRows();
  makeMatrices(hasConvection && convectsPressure);
}

/// In one pass over the points, whose bonds take longer to find than to use.
void FlowPreconditioner::makeMatrices(bool wantsPressure) {
  const std::size_t nRows = geometry_.fluid().size();
  std::vector<SparseRows> velocity(model_.discretization().symmetry.empty() ? 1 : n_);
  SparseRows pressure;
  shortWaves_.resize(velocity.size() * nRows);
  for (std::size_t row = 0; row < nRows; ++row) {
    const std::vector<Bond> bonds = bondsOf(geometry_.fluid()[row]);
    for (std::size_t component = 0; component < velocity.size(); ++component)
      shortWaves_[component * nRows + row] = addVelocityRow(row, component, bonds, velocity[component]);
    if (wantsPressure) addPressureRow(row, bonds, pressure);
  }
  for (SparseRows& rows : velocity) {
    velocity_.push_back(multigrid(rows));
    rows = {};
  }
  if (wantsPressure) pressure_ = multigrid(pressure);
}

std::unique_ptr<RowInverse> FlowPreconditioner::multigrid(const SparseRows& rows) const {
  auto made = std::make_unique<RowInverse>(model_.comm());
  made->precondition("Multigrid", rows);
  return made;
}

void FlowPreconditioner::numberRows() {
  const auto own = static_cast<long long>(geometry_.fluid().size());
  MPI_Exscan(&own, &firstRow_, 1, MPI_LONG_LONG, MPI_SUM, model_.comm().mpi());
  if (model_.comm().isRoot()) firstRow_ = 0;
  columnOf_.assign(static_cast<std::size_t>(model_.nPoints()), -1.0);
  for (std::size_t row = 0; row < geometry_.fluid().size(); ++row)
    columnOf_[static_cast<std::size_t>(geometry_.fluid()[row])] =
        static_cast<double>(firstRow_ + static_cast<long long>(row));
  model_.exchange().import(columnOf_.data(), 1, std::nullopt);
}

/// Within the reach of gradients, with weights for which the Laplacian of |x|^2 is right where no wall is near.
std::vector<FlowPreconditioner::Bond> FlowPreconditioner::bondsOf(int point) const {
  std::vector<Bond> bonds;
  double moment = 0.0;
  for (const FlowGeometry::End& end : geometry_.compactEndsOf(point, geometry_.neighborsOf(point))) {
    const double weight = geometry_.compactWeight(point, end);
    moment += weight * end.length * end.length;
    Bond bond{end.point,
              weight,
              std::max(end.fraction, shortestCut),
              end.xi,
              {1.0, 1.0, 1.0},
              end.kind == FlowGeometry::Kind::Fluid,
              end.openFraction <= 1.0};
    for (std::size_t a = 0; a < n_; ++a) bond.sign[a] = geometry_.mesh().symmetry.matrix(end.copy)[4 * a];
    bonds.push_back(bond);
  }
  for (Bond& bond : bonds) bond.weight *= 2.0 * static_cast<double>(n_) / moment;
  return bonds;
}

/// Returns the part of the identity that the inverse has besides.
double FlowPreconditioner::addVelocityRow(std::size_t row, std::size_t component, const std::vector<Bond>& bonds,
                                          SparseRows& rows) const {
  const int point = geometry_.fluid()[row];
  const double* v = model_.field("Velocity") + 3 * point;
  const double unit = equations_.unit(), ratio = equations_.density() / equations_.viscosity();
  std::vector<std::pair<long long, double>> entries;
  double diagonal = 0.0, viscous = 0.0;
  for (const Bond& bond : bonds) {
    if (bond.isOpen) continue;  // the velocity goes on as it is
    const double weight = unit * unit * bond.weight / (bond.isFluid ? 1.0 : bond.fraction);
    viscous += weight;
    // Half of the Laplacian's weight times the bond is that of a gradient.
    const double along =
        hasConvection_ ? 0.5 * ratio * (v[0] * bond.xi[0] + v[1] * bond.xi[1] + v[2] * bond.xi[2]) : 0.0;
    const double passed = weight * std::max(0.0, 1.0 - (bond.isFluid ? 1.0 : bond.fraction) * along);
    diagonal += passed;
    if (bond.isFluid)
      entries.emplace_back(static_cast<long long>(columnOf_[static_cast<std::size_t>(bond.point)]),
                           -passed * bond.sign[component]);
  }
  entries.emplace_back(firstRow_ + static_cast<long long>(row), diagonal);
  rows.addRow(entries);
  double own = 0.0;
  equations_.rows().viscous.forEach(row, [&](const auto& term) {
    if (term.point == point) own = -unit * unit * term.weights[4 * component];
  });
  const double convective = hasConvection_ ? ratio * unit * std::hypot(v[0], v[1], v[2]) : 0.0;
  return std::max(0.0, 1.0 / (own + convective) - 1.0 / (viscous + convective));
}

/// -lap, with a pressure of zero at outflows and no flux through walls.
void FlowPreconditioner::addPressureRow(std::size_t row, const std::vector<Bond>& bonds, SparseRows& rows) const {
  const double unit = equations_.unit();
  std::vector<std::pair<long long, double>> entries;
  double diagonal = pressureTie;
  for (const Bond& bond : bonds) {
    if (!bond.isOpen && !bond.isFluid) continue;
    const double weight = unit * unit * bond.weight;
    diagonal += bond.isOpen ? 2.0 * weight : weight;  // beyond an outflow it is that of the mirrored place, negative
    if (!bond.isOpen)
      entries.emplace_back(static_cast<long long>(columnOf_[static_cast<std::size_t>(bond.point)]), -weight);
  }
  entries.emplace_back(firstRow_ + static_cast<long long>(row), diagonal);
  rows.addRow(entries);
}

void FlowPreconditioner::apply(const double* r, double* z) const {
  std::copy_n(r, equations_.count(), z);  // for points that are solid
  applyToPressure(r, z);
  applyToVelocity(r, z);
}

/// Gradient [3 rows] of values [rows] that are zero at outflows.
std::vector<double> FlowPreconditioner::gradientOf(const std::vector<double>& scalar) const {
  std::vector<double> state(flow_products::width * static_cast<std::size_t>(model_.nPoints()), 0.0);
  for (std::size_t row = 0; row < scalar.size(); ++row)
    state[flow_products::width * static_cast<std::size_t>(geometry_.fluid()[row]) + 3] = scalar[row];
  model_.exchange().import(state.data(), static_cast<int>(flow_products::width), std::nullopt);
  std::vector<double> gradient(3 * scalar.size(), 0.0);
  for (std::size_t row = 0; row < scalar.size(); ++row)
    flow_products::addGradient(equations_.rows().pressureGradient.row(row), state, 1.0, &gradient[3 * row]);
  return gradient;
}

void FlowPreconditioner::applyToPressure(const double* r, double* z) const {
  const std::size_t nRows = geometry_.fluid().size();
  std::vector<double> given(nRows), result(nRows);
  for (std::size_t row = 0; row < nRows; ++row) given[row] = r[equations_.place(row, n_)];
  equations_.balancePockets(given, z);
  result = given;
  if (pressure_) {
    const std::vector<double> convected = convectedBy(given);
    for (std::size_t row = 0; row < nRows; ++row) result[row] -= convected[row];
  }
  equations_.shiftPockets(r, result);
  for (std::size_t row = 0; row < nRows; ++row) z[equations_.place(row, n_)] = result[row];
}

/// (-lap)^-1 div C grad (-lap)^-1 of divergences [rows], C the convection of the present flow over mu.
std::vector<double> FlowPreconditioner::convectedBy(const std::vector<double>& divergence) const {
  const std::size_t nRows = divergence.size();
  const auto importGhosts = [&](std::vector<double>& state) {
    model_.exchange().import(state.data(), static_cast<int>(flow_products::width), std::nullopt);
  };
  std::vector<double> potential(nRows), result(nRows);
  pressure_->apply(divergence.data(), potential.data(), 1);
  const std::vector<double> gradient = gradientOf(potential);
  const double square = equations_.unit() * equations_.unit();
  std::vector<double> flow(flow_products::width * static_cast<std::size_t>(model_.nPoints()), 0.0), momentum = flow;
  const auto at = [&](std::size_t row) {
    return flow_products::width * static_cast<std::size_t>(geometry_.fluid()[row]);
  };
  for (std::size_t row = 0; row < nRows; ++row)
    for (std::size_t a = 0; a < n_; ++a) flow[at(row) + a] = square * gradient[3 * row + a];
  importGhosts(flow);
  for (std::size_t row = 0; row < nRows; ++row) equations_.addConvection(row, flow, &momentum[at(row)]);
  importGhosts(momentum);
  for (std::size_t row = 0; row < nRows; ++row)
    potential[row] = flow_products::divergence(equations_.rows().divergence.row(row), momentum);
  equations_.balancePockets(potential, nullptr);
  pressure_->apply(potential.data(), result.data(), 1);
  return result;
}

void FlowPreconditioner::applyToVelocity(const double* r, double* z) const {
  const std::size_t nRows = geometry_.fluid().size();
  std::vector<double> pressure(nRows), given(n_ * nRows), result(n_ * nRows);
  for (std::size_t row = 0; row < nRows; ++row) pressure[row] = z[equations_.place(row, n_)];
  const std::vector<double> gradient = gradientOf(pressure);
  for (std::size_t row = 0; row < nRows; ++row)
    for (std::size_t a = 0; a < n_; ++a)
      given[a * nRows + row] = r[equations_.place(row, a)] - equations_.unit() * gradient[3 * row + a];
  if (velocity_.size() == 1)
    velocity_[0]->apply(given.data(), result.data(), n_);
  else
    for (std::size_t a = 0; a < n_; ++a) velocity_[a]->apply(&given[a * nRows], &result[a * nRows], 1);
  for (std::size_t row = 0; row < nRows; ++row)
    for (std::size_t a = 0; a < n_; ++a) {
      const double share = shortWaves_[(velocity_.size() == 1 ? 0 : a * nRows) + row];
      z[equations_.place(row, a)] = result[a * nRows + row] + share * given[a * nRows + row];
    }
}

}  // namespace pd
