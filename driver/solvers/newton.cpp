#include "newton.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "../model/collective.hpp"
#include "Peridigm_DegreesOfFreedomManager.hpp"
#include "Peridigm_Field.hpp"
#include "symmetric_eigen.hpp"

namespace pd {

namespace {

/// Watches a tangent for values that couple two points of which neither is one of `centres`.
class FamilyCouplingProbe : public PeridigmNS::SerialMatrix {
 public:
  FamilyCouplingProbe(const int* centres, int nCentres, const PeridigmNS::PointMap& points) {
    for (int k = 0; k < nCentres; ++k) centres_.push_back(points.GID(centres[k]));
  }
  bool isCoupled() const { return isCoupled_; }

  void addValue(int globalRow, int globalCol, double value) override {
    if (value == 0.0 || globalRow / 3 == globalCol / 3) return;
    if (!isCentre(globalRow / 3) && !isCentre(globalCol / 3)) isCoupled_ = true;
  }
  void addValues(int numIndices, const int* globalIndices, const double* const* values) override {
    for (int i = 0; i < numIndices && !isCoupled_; ++i)
      for (int j = 0; j < numIndices; ++j) addValue(globalIndices[i], globalIndices[j], values[i][j]);
  }
  void addBlockDiagonalValues(int, const int*, const double* const*) override {}
  void putScalar(double) override {}

 private:
  bool isCentre(int globalId) const { return std::find(centres_.begin(), centres_.end(), globalId) != centres_.end(); }
  std::vector<int> centres_;
  bool isCoupled_ = false;
};

// A tangent is made anew where it reduces the residual by less than this in one iteration.
constexpr double goodReduction = 0.3;

}  // namespace

void Newton::hold(const std::vector<char>& isHeld) {
  if (isHeld != isHeld_) hasTangent_ = false;
  isHeld_ = isHeld;
}

Newton::Balance Newton::evaluate(Simulation& simulation, double dt, const std::vector<double>& externalForce) {
  Model& model = simulation.model;
  model.updateCoordinates();
  model.evaluateForce(dt);
  const double *force = model.field(fields_.force), *volume = model.field("Volume");
  const std::vector<char>& isPrescribed = simulation.conditions.displacementIsPrescribed();
  residual_.assign(isHeld_.size(), 0.0);
  std::array<double, 3> mine{}, all{};  // squares of the free, external and reaction forces
  for (std::size_t i = 0; i < isHeld_.size(); ++i) {
    const double external = externalForce[i] * volume[i / 3], internal = force[i] * volume[i / 3];
    if (!isHeld_[i]) {
      residual_[i] = internal + external;
      mine[0] += residual_[i] * residual_[i];
      mine[1] += external * external;
    } else if (isPrescribed[i]) {
      mine[2] += internal * internal;
    }
  }
  model.comm().SumAll(mine.data(), all.data(), 3);
  return {std::sqrt(all[0]), std::sqrt(std::max(all[1], all[2]))};
}

void Newton::assembleOnce(Simulation& simulation, double dt) {
  Model& model = simulation.model;
  if (!system_) system_ = std::make_unique<LinearSystem>(model.comm(), model.discretization(), 3, couplesFamilies_);
  system_->putScalar(0.0);
  model.assembleJacobian(dt, *system_);
  system_->scale(-1.0);  // positive definite where the body is stable
  std::vector<char> isConstrained = isHeld_;
  isConstrained.resize(3 * static_cast<std::size_t>(model.nPoints()), 0);
  const Timers::Scope timer(model.timers(), "tangent assembly");
  system_->finish(isConstrained);
}

/// Whether the tangent of a few points couples their neighbours with each other: then the matrix needs the wider graph.
/// (Where these points do not show it, the first assembly will.)
bool Newton::someFamilyIsCoupled(Model& model, double dt) const {
  bool isCoupled = false;
  const int force = PeridigmNS::FieldManager::self().getFieldId("Force_Density");
  for (PeridigmNS::Block& block : *model.blocks()) {
    const auto ids = block.getMaterialModel()->FieldIds();
    const auto points = block.getNeighborhoodData();
    const int nProbed = std::min(4, points->NumOwnedPoints());
    if (nProbed == 0 || std::find(ids.begin(), ids.end(), force) == ids.end()) continue;
    FamilyCouplingProbe probe(points->OwnedIDs(), nProbed, *block.getOverlapScalarPointMap());
    orAbort(model.comm(), [&] {
      block.getMaterialModel()->computeJacobian(dt, nProbed, points->OwnedIDs(), points->NeighborhoodList(),
                                                *block.getDataManager(), probe);
    });
    isCoupled = isCoupled || probe.isCoupled();
  }
  return model.comm().any(isCoupled);
}

void Newton::assemble(Simulation& simulation, double dt) {
  Model& model = simulation.model;
  PeridigmNS::DegreesOfFreedomManager::self().setUnknowns({{"Displacement", 3}});
  if (!hasProbed_) couplesFamilies_ = someFamilyIsCoupled(model, dt);
  hasProbed_ = true;
  assembleOnce(simulation, dt);
  if (system_->graphIsTooSmall() && !couplesFamilies_) {
    couplesFamilies_ = true;
    system_.reset();
    assembleOnce(simulation, dt);
  }
  stiffenLoosePoints(model);
  damp(model);

  const double* displacement = model.field(fields_.displacement);
  const double* coordinates = model.field(fields_.coordinates);
  std::copy(displacement, displacement + isHeld_.size(), model.field(fields_.tangentDisplacement));
  const std::vector<double> diagonal = system_->diagonal();
  double farthest = 0.0, sum = 0.0;
  for (std::size_t i = 0; i < isHeld_.size(); ++i) {
    farthest = std::max(farthest, std::abs(coordinates[i]));
    if (!isHeld_[i]) sum += diagonal[i] * diagonal[i];
  }
  roundOff_ = std::numeric_limits<double>::epsilon() * model.comm().max(farthest) * std::sqrt(model.comm().sum(sum));
  hasTangent_ = true;
  ++nTangents;
}

/// A point that hangs on too few bonds (one, or some in a line) can move along some direction without force. Its own
/// stiffness is spread to those directions; equilibrium itself is not changed by that.
void Newton::stiffenLoosePoints(Model& model) {
  constexpr double negligible = 1e-6, added = 1e-4;  // of the point's largest stiffness
  const std::vector<double> blocks = system_->diagonalBlocks();
  nStiffenedPoints = 0;
  for (int point = 0; point < model.nOwned(); ++point) {
    const auto first = static_cast<std::size_t>(3 * point);
    std::vector<int> axes;
    for (int axis = 0; axis < 3; ++axis)
      if (!isHeld_[first + static_cast<std::size_t>(axis)]) axes.push_back(axis);
    if (axes.empty()) continue;
    std::vector<double> own;
    for (const int a : axes)
      for (const int b : axes)
        own.push_back(blocks[3 * (first + static_cast<std::size_t>(a)) + static_cast<std::size_t>(b)]);
    const SymmetricEigen eigen = symmetricEigen(own, static_cast<int>(axes.size()));
    if (eigen.values.front() > negligible * eigen.values.back()) continue;
    ++nStiffenedPoints;
    const double stiffness = std::max(std::abs(eigen.values.front()), std::abs(eigen.values.back()));
    for (const int axis : axes) system_->addToDiagonal(point, axis, stiffness > 0.0 ? added * stiffness : 1.0);
  }
}

void Newton::damp(Model& model) {
  if (settings_.diagonalScale == 1.0 && settings_.diagonalShift == 0.0) return;
  const std::vector<double> diagonal = system_->diagonal();
  double largest = 0.0;
  for (std::size_t i = 0; i < isHeld_.size(); ++i)
    if (!isHeld_[i]) largest = std::max(largest, std::abs(diagonal[i]));
  const double shift = settings_.diagonalShift * model.comm().max(largest);
  for (std::size_t i = 0; i < isHeld_.size(); ++i)
    if (!isHeld_[i])
      system_->addToDiagonal(static_cast<int>(i / 3), static_cast<int>(i % 3),
                             (settings_.diagonalScale - 1.0) * diagonal[i] + shift);
}

void Newton::prepareTangent(Simulation& simulation, double dt) {
  if (hasTangent_) return;
  simulation.model.updateCoordinates();
  simulation.model.evaluateForce(dt);  // materials may prepare their tangent in precompute()
  assemble(simulation, dt);
}

void Newton::restoreTangent(Simulation& simulation, double dt) {
  Model& model = simulation.model;
  double* displacement = model.field(fields_.displacement);
  const std::vector<double> present(displacement, displacement + isHeld_.size());
  const double* remembered = model.field(fields_.tangentDisplacement);
  std::copy(remembered, remembered + isHeld_.size(), displacement);
  hasTangent_ = false;
  prepareTangent(simulation, dt);
  std::copy(present.begin(), present.end(), displacement);
  model.updateCoordinates();
}

/// step_ = tangent^-1 residual_.
LinearSolveReport Newton::solveLinear(Simulation& simulation, double tolerance) {
  const Timers::Scope timer(simulation.model.timers(), "linear solve");
  if (settings_.linearTolerance > 0.0) tolerance = settings_.linearTolerance;
  step_.assign(residual_.size(), 0.0);
  LinearSolveReport report = system_->solve(residual_.data(), step_.data(), settings_.linearSolver,
                                            settings_.preconditioner, tolerance, settings_.maximumLinearIterations);
  nLinearIterations += report.iterations;
  if (report.method != settings_.linearSolver) ++nGmresFallbacks;
  largestLinearResidual = std::max(largestLinearResidual, report.relativeResidual);
  if (settings_.logsLinearSolves)
    simulation.output.log(fmt::format("{} ({}): {} iterations, relative residual {:.3g}, asked for {:.3g}",
                                      report.method, settings_.preconditioner, report.iterations,
                                      report.relativeResidual, tolerance));
  return report;
}

void Newton::followHeldPoints(Simulation& simulation, double dt, const std::vector<double>& externalForce) {
  Model& model = simulation.model;
  double* displacement = model.field(fields_.displacement);
  const double* start = model.fieldAtN("Displacement");
  const std::size_t n = isHeld_.size();
  std::vector<double> moved(n);
  double largest = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    moved[i] = displacement[i] - start[i];
    largest = std::max(largest, std::abs(moved[i]));
  }
  largest = model.comm().max(largest);
  if (largest == 0.0) return;
  // The forces that the held points would cause if the body were linear, by a small part of their motion: strains of
  // 1e-6 keep both nonlinear terms and round-off near 1e-6 of them.
  const double part = 1e-6 * model.discretization().shortestBond / largest;
  std::copy(start, start + n, displacement);
  evaluate(simulation, dt, externalForce);
  const std::vector<double> atStart = residual_;
  for (std::size_t i = 0; i < n; ++i) displacement[i] = start[i] + part * moved[i];
  evaluate(simulation, dt, externalForce);
  for (std::size_t i = 0; i < n; ++i) residual_[i] = atStart[i] + (residual_[i] - atStart[i]) / part;
  const LinearSolveReport report = solveLinear(simulation, 1e-5);
  const bool isUseful = report.relativeResidual < 0.5;
  for (std::size_t i = 0; i < n; ++i)
    displacement[i] = start[i] + moved[i] + (isUseful && !isHeld_[i] ? step_[i] : 0.0);
}

/// Moves along step_, halved until the residual decreases. Returns the reduction; 1 or more where there is none.
double Newton::search(Simulation& simulation, double dt, const std::vector<double>& externalForce, Balance& balance) {
  double* displacement = simulation.model.field(fields_.displacement);
  const std::vector<double> origin(displacement, displacement + isHeld_.size());
  const double before = balance.free;
  double length = 1.0;
  for (int halving = 0; halving <= 6; ++halving, length *= 0.5) {
    for (std::size_t i = 0; i < isHeld_.size(); ++i)
      if (!isHeld_[i]) displacement[i] = origin[i] + length * step_[i];
    balance = evaluate(simulation, dt, externalForce);
    if (std::isfinite(balance.free) && balance.free < (1.0 - 1e-4 * length) * before) return balance.free / before;
  }
  std::copy(origin.begin(), origin.end(), displacement);
  balance = evaluate(simulation, dt, externalForce);
  return 1.0;
}

NewtonOutcome Newton::solve(Simulation& simulation, double dt, const std::vector<double>& externalForce,
                            double largestScale) {
  NewtonOutcome outcome;
  Balance balance = evaluate(simulation, dt, externalForce);
  bool tangentIsNew = false;
  for (int iteration = 0;; ++iteration) {
    outcome.residuals.push_back(balance.free);
    outcome.scale = std::max(balance.scale, largestScale);
    const double asked = std::max(settings_.relativeTolerance * outcome.scale, settings_.absoluteTolerance);
    if (balance.free <= asked || balance.free <= roundOff_) {
      stoppedAtRoundOff = stoppedAtRoundOff || balance.free > asked;
      outcome.hasConverged = true;
      return outcome;
    }
    if (!std::isfinite(balance.free)) outcome.trouble = "the force is not finite";
    if (iteration == settings_.maximumIterations) outcome.trouble = "the iterations are used up";
    if (!outcome.trouble.empty()) return outcome;

    if (!hasTangent_) {
      assemble(simulation, dt);
      tangentIsNew = true;
    }
    // Nothing is gained by solving the linear problem better than the load step needs.
    const LinearSolveReport report =
        solveLinear(simulation, std::clamp(0.3 * std::max(asked, roundOff_) / balance.free, 1e-12, 0.1));
    if (!report.hasConverged && !(report.relativeResidual < 0.5)) {
      outcome.trouble =
          fmt::format("the linear solver {} ({}) stopped at a relative residual of {:.3g} after {} iterations",
                      report.method, settings_.preconditioner, report.relativeResidual, report.iterations);
      return outcome;
    }
    const double reduction = search(simulation, dt, externalForce, balance);
    ++nIterations;
    if (reduction >= 1.0 && tangentIsNew) {
      outcome.trouble = "no step along Newton's direction brings the forces nearer to balance";
      return outcome;
    }
    if (reduction > goodReduction) hasTangent_ = false;
    tangentIsNew = false;
  }
}

}  // namespace pd
