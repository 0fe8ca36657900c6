#include "bond_flows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "../../linear/operator_system.hpp"
#include "../../linear/row_inverse.hpp"
#include "../../model/collective.hpp"
#include "flow_fields.hpp"
#include "flow_parts.hpp"

namespace pd {

namespace {

constexpr int balancePasses = 2;  // the second for what rounding leaves of the first
constexpr double balanceTolerance = 1e-12;
constexpr int balanceIterations = 50;
/// Part of a point's conductances that ties its potential to zero, lest a pocket without an outflow makes the matrix
/// singular.
constexpr double tie = 1e-12;
/// Of what passes a point, above which flows are of no use.
constexpr double mostImbalance = 1e-8;

double* viewOfBonds(PeridigmNS::Block& block, int id) {
  double* values = nullptr;
  block.getData(id, PeridigmNS::PeridigmField::STEP_NONE)->ExtractView(&values);
  return values;
}

}  // namespace

BondFlows::BondFlows(Simulation& simulation, const FlowGeometry& geometry, double reach)
    : simulation_(simulation), geometry_(geometry), reach_(reach * (1.0 + 1e-9)) {
  findFamilyVolumes();
}

void BondFlows::findFamilyVolumes() {
  const Discretization& mesh = geometry_.mesh();
  familyVolume_.assign(static_cast<std::size_t>(mesh.nPoints), 0.0);
  for (int point = 0; point < mesh.nOwned; ++point)
    for (const int neighbor : geometry_.neighborsOf(point))
      if (ReferenceBond(mesh.x.data(), point, neighbor).length <= reach_)
        familyVolume_[index(point)] += geometry_.planeVolume(neighbor);
  collectively(simulation_.model.comm(), [&] {
    for (const int point : geometry_.fluid()) {
      if (familyVolume_[index(point)] > 0.0) continue;
      const double* x = mesh.x.data() + 3 * index(point);
      throw RunError(
          fmt::format("Steady Flow: no neighbour of point {} at ({:g}, {:g}, {:g}) m is within the Flux Horizon of its "
                      "fluid, {:g} m, whose bonds carry scalars along; make it more than the spacing there, {:g} m",
                      mesh.globalIds[index(point)] + 1, x[0], x[1], x[2], reach_, geometry_.spacingOf(point)));
    }
  });
  simulation_.model.exchange().import(familyVolume_.data(), 1, Reflection::Even);
}

void BondFlows::update(double t) {
  rows_.clear();
  for (const int point : geometry_.fluid()) rows_.push_back(rowOf(point, t));
  closeParts();
  balance();
  requireBalance(t);
  write();
  rows_ = {};
}

BondFlows::Row BondFlows::rowOf(int point, double t) const {
  const double dimension = geometry_.dimension();
  const std::vector<int> neighbors = geometry_.neighborsOf(point);
  Row row{point, {}, std::vector<double>(neighbors.size(), 0.0)};
  for (std::size_t k = 0; k < neighbors.size(); ++k) {
    const int neighbor = neighbors[k];
    const FlowGeometry::End end = geometry_.endOf(point, neighbor, neighbors);
    const bool isOut = end.openFraction <= 1.0;
    if (end.volume > 0.0 && !isOut && !geometry_.isSolid(neighbor)) row.openings[k] = end.fraction;
    if (end.length > reach_) continue;
    const bool isFluid = geometry_.isFluid(neighbor) && !isOut && end.kind == FlowGeometry::Kind::Fluid;
    if (isOut && !geometry_.isBeyondOutflow(neighbor)) continue;
    const double flow = flowOf(point, end, neighbor, t);
    if (!isFluid && !isOut && flow == 0.0) continue;
    const double whole =
        isFluid ? 0.5 * (familyVolume_[index(point)] + familyVolume_[index(neighbor)]) : familyVolume_[index(point)];
    const double conductance = 2.0 * dimension * geometry_.planeVolume(neighbor) / (whole * end.length * end.length) *
                               ringShare(point, neighbor, end);
    if (conductance == 0.0) continue;
    row.bonds.push_back({neighbor, isFluid || isOut, conductance * end.length * flow, conductance, k});
  }
  return row;
}

/// Of bodies of revolution (kernels/rings.hpp), up to where the bond ends; 1 of others.
double BondFlows::ringShare(int point, int neighbor, const FlowGeometry::End& end) const {
  const Discretization& mesh = geometry_.mesh();
  return geometry_.law().family.ringShare(mesh.x.data(), point, neighbor, geometry_.planeVolume(point),
                                          geometry_.planeVolume(neighbor),
                                          std::min({1.0, end.fraction, end.openFraction}));
}

/// The velocity along the bond, m/s.
double BondFlows::flowOf(int point, const FlowGeometry::End& end, int neighbor, double t) const {
  const double* velocity = simulation_.model.field("Velocity");
  const auto along = [&](const double* v) {
    return (v[0] * end.xi[0] + v[1] * end.xi[1] + v[2] * end.xi[2]) / end.length;
  };
  if (end.openFraction <= 1.0) return along(velocity + 3 * point);
  if (end.kind == FlowGeometry::Kind::Fluid)
    return 0.5 * (along(velocity + 3 * point) + along(velocity + 3 * neighbor));
  if (end.boundary < 0 || geometry_.boundaryOf(neighbor) != end.boundary) return 0.0;
  const std::array<double, 3> place = geometry_.placeOn(point, end, end.fraction);
  const std::array<double, 3> ofWall = geometry_.wallVelocity(end.boundary, place, t);
  const std::array<double, 3> normal = geometry_.normalAt(end.boundary, place);
  if (normal == std::array<double, 3>{}) return along(ofWall.data());
  const double through = ofWall[0] * normal[0] + ofWall[1] * normal[1] + ofWall[2] * normal[2];
  return through * along(normal.data());
}

void BondFlows::findParts() {
  const auto openBondsOf = [&](std::size_t r, const auto& connect) {
    for (const Bond& bond : rows_[r].bonds)
      if (bond.isOpen && geometry_.isFluid(bond.neighbor)) connect(bond.neighbor);
  };
  const FlowParts found = findFlowParts(simulation_.model, geometry_.fluid(), openBondsOf);
  parts_.assign(found.nParts, Part());
  partOf_ = found.partOf;
  sumParts();
  isPinned_.assign(rows_.size(), 0);
  for (std::size_t r = 0; r < rows_.size(); ++r)
    if (!parts_[partOf_[r]].isOpen && found.isFirst[r] != 0) isPinned_[r] = 1;
}

/// What leaves each part, what passes its walls and inlets, and whether it has an outflow.
void BondFlows::sumParts() {
  std::vector<double> mine(4 * parts_.size(), 0.0), all(mine.size(), 0.0);
  for (std::size_t r = 0; r < rows_.size(); ++r) {
    const double own = geometry_.mesh().volume[index(rows_[r].point)];
    double* sums = &mine[4 * partOf_[r]];
    for (const Bond& bond : rows_[r].bonds) {
      sums[0] += bond.flow * own;
      if (!bond.isOpen) sums[1] += std::abs(bond.flow) * own;
      if (bond.isOpen && !geometry_.isFluid(bond.neighbor)) sums[3] = 1.0;
    }
    sums[2] += own;
  }
  MPI_Allreduce(mine.data(), all.data(), static_cast<int>(mine.size()), MPI_DOUBLE, MPI_SUM,
                simulation_.model.comm().mpi());
  for (std::size_t k = 0; k < parts_.size(); ++k)
    parts_[k] = {all[4 * k + 3] > 0.0, all[4 * k], all[4 * k + 1], all[4 * k + 2]};
}

/// Lets as much into parts that nothing can leave as out of them.
void BondFlows::closeParts() {
  findParts();
  for (std::size_t r = 0; r < rows_.size(); ++r) {
    const Part& part = parts_[partOf_[r]];
    if (part.isOpen || !(std::abs(part.net) < 0.5 * part.passing)) continue;
    for (Bond& bond : rows_[r].bonds)
      if (!bond.isOpen) bond.flow -= std::abs(bond.flow) * part.net / part.passing;
  }
}

/// Takes the mean out of what leaves the points of parts that nothing can leave, of which rounding is left.
void BondFlows::removeNetFlow(std::vector<double>& excess) const {
  std::vector<double> mine(parts_.size(), 0.0), net(parts_.size(), 0.0);
  for (std::size_t r = 0; r < rows_.size(); ++r)
    mine[partOf_[r]] += excess[r] * geometry_.mesh().volume[index(rows_[r].point)];
  MPI_Allreduce(mine.data(), net.data(), static_cast<int>(mine.size()), MPI_DOUBLE, MPI_SUM,
                simulation_.model.comm().mpi());
  for (std::size_t r = 0; r < rows_.size(); ++r)
    if (!parts_[partOf_[r]].isOpen) excess[r] -= net[partOf_[r]] / parts_[partOf_[r]].volume;
}

/// Of a potential `x` [rows_]: what it moves out of each point.
void BondFlows::applyPotential(const double* x, double* y) const {
  std::vector<double> potential(index(geometry_.mesh().nPoints), 0.0);
  for (std::size_t r = 0; r < rows_.size(); ++r) potential[index(rows_[r].point)] = x[r];
  simulation_.model.exchange().import(potential.data(), 1, Reflection::Even);
  for (std::size_t r = 0; r < rows_.size(); ++r) {
    double sum = 0.0, moved = 0.0;
    for (const Bond& bond : rows_[r].bonds) {
      if (!bond.isOpen) continue;
      sum += bond.conductance;
      if (geometry_.isFluid(bond.neighbor)) moved += bond.conductance * potential[index(bond.neighbor)];
    }
    y[r] = diagonal(r, sum) * x[r] - moved;
  }
}

/// `sum`: of the conductances of its open bonds.
double BondFlows::diagonal(std::size_t row, double sum) const {
  return sum > 0.0 ? (isPinned_[row] != 0 ? 2.0 : 1.0 + tie) * sum : 1.0;
}

/// The same as a matrix.
SparseRows BondFlows::potentialMatrix() const {
  const Model& model = simulation_.model;
  const Discretization& mesh = geometry_.mesh();
  const long long own = static_cast<long long>(rows_.size());
  long long first = 0;
  MPI_Exscan(&own, &first, 1, MPI_LONG_LONG, MPI_SUM, model.comm().mpi());
  if (model.comm().isRoot()) first = 0;
  std::vector<double> column(index(mesh.nPoints), -1.0);
  for (std::size_t r = 0; r < rows_.size(); ++r)
    column[index(rows_[r].point)] = static_cast<double>(first) + static_cast<double>(r);
  model.exchange().import(column.data(), 1, Reflection::Even);

  SparseRows matrix;
  std::vector<std::pair<long long, double>> entries;
  for (std::size_t r = 0; r < rows_.size(); ++r) {
    const Row& row = rows_[r];
    entries.clear();
    double sum = 0.0;
    for (const Bond& bond : row.bonds) {
      if (!bond.isOpen) continue;
      sum += bond.conductance;
      const double there = column[index(bond.neighbor)];
      if (geometry_.isFluid(bond.neighbor)) entries.emplace_back(static_cast<long long>(there), -bond.conductance);
    }
    entries.emplace_back(static_cast<long long>(column[index(row.point)]), diagonal(r, sum));
    matrix.addRow(entries);
  }
  return matrix;
}

void BondFlows::balance() {
  Model& model = simulation_.model;
  const Timers::Scope timer(model.timers(), "bond flows");
  RowInverse inverse(model.comm());
  if (!isWorthFactoring(geometry_.dimension(), model.comm().sum(static_cast<long long>(rows_.size()))))
    inverse.precondition("Multigrid", potentialMatrix());
  else if (const std::string trouble = inverse.factor(potentialMatrix()); !trouble.empty())
    throw RunError("Steady Flow: the flows of bonds are not balanced: " + trouble);
  const auto leaving = [&](const double* x, double* y) { applyPotential(x, y); };
  const auto precondition = [&](const double* r, double* z) { inverse.apply(r, z); };

  std::vector<double> potential(index(geometry_.mesh().nPoints), 0.0);
  largestCorrection_ = 0.0;
  for (int pass = 0; pass < balancePasses; ++pass) {
    std::vector<double> excess(rows_.size(), 0.0), solution(rows_.size(), 0.0);
    for (std::size_t r = 0; r < rows_.size(); ++r)
      for (const Bond& bond : rows_[r].bonds) excess[r] += bond.flow;
    removeNetFlow(excess);
    solveByGmres(model.comm(), leaving, precondition, excess, solution, balanceTolerance, balanceIterations,
                 balanceIterations);
    for (std::size_t r = 0; r < rows_.size(); ++r) potential[index(rows_[r].point)] = solution[r];
    model.exchange().import(potential.data(), 1, Reflection::Even);
    for (Row& row : rows_)
      for (Bond& bond : row.bonds) {
        if (!bond.isOpen) continue;
        const double change = bond.conductance * (potential[index(row.point)] - potential[index(bond.neighbor)]);
        bond.flow -= change;
        largestCorrection_ = std::max(largestCorrection_, std::abs(change));
      }
  }
  measure();
}

/// What is left, and what it took.
void BondFlows::measure() {
  const Communicator& comm = simulation_.model.comm();
  double largestFlow = 0.0;
  for (const Row& row : rows_)
    for (const Bond& bond : row.bonds) largestFlow = std::max(largestFlow, std::abs(bond.flow));
  largestFlow = comm.max(largestFlow);
  largestCorrection_ = largestFlow > 0.0 ? comm.max(largestCorrection_) / largestFlow : 0.0;
  largestImbalance_ = 0.0;
  for (const Row& row : rows_) {
    double sum = 0.0, passed = 0.0;
    for (const Bond& bond : row.bonds) {
      sum += bond.flow;
      passed += std::abs(bond.flow);
    }
    if (passed > 1e-6 * largestFlow) largestImbalance_ = std::max(largestImbalance_, 2.0 * std::abs(sum) / passed);
  }
  largestImbalance_ = comm.max(largestImbalance_);
}

void BondFlows::requireBalance(double t) const {
  if (largestImbalance_ <= mostImbalance) return;
  throw RunError(fmt::format(
      "Steady Flow: t = {:.6g} s: the flows of bonds, which carry scalars along, are not balanced: of what passes a "
      "point {:.2g} has no way in or out. Let no Surface of an Outflow be zero elsewhere in the fluid, as in a channel "
      "beside it (\"1 - x + 9*(y > 1.5)\" leaves out what is above y = 1.5); give a closed part an Outflow, or "
      "velocities that let out what they let in; give walls a Surface, or more bonds by a longer Flux Horizon",
      t, largestImbalance_));
}

void BondFlows::write() const {
  const int flowId = fields::bondFlow().id(), openingId = fields::bondOpening().id();
  std::vector<const Row*> rowOfPoint(index(geometry_.mesh().nOwned), nullptr);
  for (const Row& row : rows_) rowOfPoint[index(row.point)] = &row;
  for (PeridigmNS::Block& block : *simulation_.model.blocks()) {
    const auto has = [&](int id) { return block.hasData(id, PeridigmNS::PeridigmField::STEP_NONE); };
    const auto neighborhood = block.getNeighborhoodData();
    double* flow = has(flowId) ? viewOfBonds(block, flowId) : nullptr;
    double* opening = has(openingId) ? viewOfBonds(block, openingId) : nullptr;
    std::size_t bond = 0;
    for (int p = 0; p < neighborhood->NumOwnedPoints(); ++p) {
      const int point = neighborhood->OwnedIDs()[p];
      const std::size_t count = geometry_.neighborsOf(point).size();
      const Row* row = rowOfPoint[index(point)];
      for (std::size_t k = 0; k < count; ++k) {
        if (flow != nullptr) flow[bond + k] = 0.0;
        if (opening != nullptr) opening[bond + k] = row == nullptr ? 0.0 : row->openings[k];
      }
      if (row != nullptr && flow != nullptr)
        for (const Bond& own : row->bonds) flow[bond + own.place] = own.flow;
      bond += count;
    }
  }
}

}  // namespace pd
