// What Newton's method solves its linear problems with.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "../model/collective.hpp"
#include "../model/rates.hpp"
#include "Peridigm_DegreesOfFreedomManager.hpp"
#include "Peridigm_Field.hpp"
#include "newton.hpp"
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

// A first guess at how far the tangent changes with the displacements of a load step: strains of metals.
constexpr double firstNonlinearity = 1e-3;
// Products by difference quotients before a matrix is made after all.
constexpr int mostDifferences = 100;

}  // namespace

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
  std::copy(displacement, displacement + isHeld_.size(), model.field(fields_.tangentDisplacement));
  const std::vector<double> diagonal = system_->diagonal();
  double sum = 0.0;
  for (std::size_t i = 0; i < isHeld_.size(); ++i)
    if (!isHeld_[i]) sum += diagonal[i] * diagonal[i];
  normOfDiagonal_ = std::sqrt(model.comm().sum(sum));
  hasTangent_ = true;
  ++nTangents;
}

/// A point that hangs on too few bonds (one, or some in a line) can move along some direction without force. Its own
/// stiffness is spread to those directions, and forces along them are left out of the balance.
void Newton::stiffenLoosePoints(Model& model) {
  // Of the point's largest stiffness. A line of bonds that buckles under a strain e turns by (2 e)^0.5, and resists by
  // twice e across it.
  constexpr double negligible = 1e-4, added = 1e-4;
  const std::vector<double> blocks = system_->diagonalBlocks();
  nStiffenedPoints = 0;
  slack_.clear();
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
    for (std::size_t mode = 0; mode < axes.size(); ++mode) {
      if (eigen.values[mode] > negligible * eigen.values.back()) continue;
      SlackDirection& slack = slack_.emplace_back(SlackDirection{static_cast<std::size_t>(point), {}});
      for (std::size_t k = 0; k < axes.size(); ++k)
        slack.axis[static_cast<std::size_t>(axes[k])] = eigen.vectors[mode * axes.size() + k];
    }
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

std::string Newton::preconditionerName() const {
  if (tangent_ != Tangent::Assembled) return "Two Level";
  return settings_.preconditioner.empty() || settings_.preconditioner == "Two Level" ? "Multigrid"
                                                                                     : settings_.preconditioner;
}

void Newton::requireSprings(Model& model) const {
  if (settings_.preconditioner != "Two Level" && !settings_.hasSmallStrain) return;
  if (const std::string obstacle = SpringTangent::obstacle(model); !obstacle.empty())
    throw RunError(fmt::format(
        "\"{}\" takes the bonds of every material for springs, which PDHE, Elastic and Elastic Bond Based know how to "
        "give, one of the latter two kinds in a run; {}: leave it out",
        settings_.hasSmallStrain ? "Kinematics: Small Strain" : "Preconditioner: Two Level", obstacle));
}

void Newton::chooseTangent(Model& model) {
  if (hasChosen_) return;
  const bool isDamped = settings_.diagonalScale != 1.0 || settings_.diagonalShift != 0.0;
  const bool mayUseSprings = settings_.preconditioner.empty() || settings_.preconditioner == "Two Level";
  usesSprings_ = settings_.hasSmallStrain || (mayUseSprings && settings_.linearSolver == "CG" && !isDamped &&
                                              SpringTangent::obstacle(model).empty());
  tangent_ = usesSprings_ ? Tangent::Springs : Tangent::Assembled;
  hasChosen_ = true;
  if (!usesSprings_) return;
  const Timers::Scope timer(model.timers(), "springs");
  springs_ = std::make_unique<SpringTangent>(model, settings_.hasSmallStrain);
  springs_->hold(isHeld_);
  derivesFields_ = model.comm().any(std::any_of(model.blocks()->begin(), model.blocks()->end(), derivesFields));
}

void Newton::startIncrement(Model& model) {
  chooseTangent(model);
  if (!usesSprings_) return;
  hasTangent_ = false;
  tangent_ = Tangent::Springs;
  nonlinearity_ = firstNonlinearity;
}

bool Newton::improveTangent(Tangent better) {
  if (!usesSprings_ || settings_.hasSmallStrain || tangent_ >= better) return false;
  tangent_ = better;
  hasTangent_ = false;
  return true;
}

void Newton::makeTangent(Simulation& simulation, double dt) {
  chooseTangent(simulation.model);
  if (tangent_ == Tangent::Assembled) {
    assemble(simulation, dt);
    return;
  }
  const Timers::Scope timer(simulation.model.timers(), "two-level set-up");
  springs_->prepare();
  nStiffenedPoints = springs_->nStiffenedPoints();
  normOfDiagonal_ = springs_->normOfDiagonal();
  hasTangent_ = true;
}

/// Both parts of a place are rounded, and a body may move far from where it was made: what counts is where it is now.
void Newton::findFarthest(Model& model) {
  const double *x = model.field("Model_Coordinates"), *displacement = model.field(fields_.displacement);
  std::array<double, 3> farthest{};  // by component: none waits for another
  for (std::size_t i = 0; i < isHeld_.size(); i += 3)
    for (std::size_t d = 0; d < 3; ++d)
      farthest[d] = std::max(farthest[d], std::abs(x[i + d]) + std::abs(displacement[i + d]));
  farthest_ = model.comm().max(std::max({farthest[0], farthest[1], farthest[2]}));
}

double Newton::roundOff() const { return std::numeric_limits<double>::epsilon() * farthest_ * normOfDiagonal_; }

void Newton::springForce(Model& model) {
  chooseTangent(model);
  const Timers::Scope timer(model.timers(), "force of springs", model.nBonds());
  springs_->force(model.field(fields_.displacement), model.field(fields_.force), forceError_);
}

/// What materials derive from displacements beside forces follows from theirs; the forces are those of the springs
/// again.
void Newton::completeSmallStrain(Model& model, double dt) {
  model.updateCoordinates();
  if (derivesFields_) {
    model.evaluateForce(dt);
    springForce(model);
  }
  springs_->copyForceToBlocks();
}

void Newton::watchBondMotion(Model& model) {
  if (!settings_.hasSmallStrain) return;
  largestBondMotion_ = std::max(largestBondMotion_, springs_->meanBondMotion(model.field(fields_.displacement)));
}

std::vector<std::string> Newton::warnings() const {
  constexpr double mostBondMotion = 0.02;
  if (largestBondMotion_ <= mostBondMotion) return {};
  return {
      fmt::format("warning: bonds stretched or turned by {:.2g} in the mean of the body, which is too much for "
                  "Kinematics: Small Strain; results are those of a body that stays as it is. Use Finite",
                  largestBondMotion_)};
}

void Newton::prepareTangent(Simulation& simulation, double dt) {
  chooseTangent(simulation.model);
  if (hasTangent_) return;
  if (!settings_.hasSmallStrain) simulation.model.updateCoordinates();
  if (tangent_ == Tangent::Assembled)
    simulation.model.evaluateForce(dt);  // materials may prepare their tangent in precompute()
  makeTangent(simulation, dt);
}

void Newton::restoreTangent(Simulation& simulation, double dt) {
  Model& model = simulation.model;
  chooseTangent(model);
  if (usesSprings_) return;  // forgetHistory() has forgotten it at the checkpoint, too
  double* displacement = model.field(fields_.displacement);
  const std::vector<double> present(displacement, displacement + isHeld_.size());
  const double* remembered = model.field(fields_.tangentDisplacement);
  std::copy(remembered, remembered + isHeld_.size(), displacement);
  hasTangent_ = false;
  prepareTangent(simulation, dt);
  std::copy(present.begin(), present.end(), displacement);
  model.updateCoordinates();
}

/// A tangent of springs is that of the reference configuration: a step leaves some of the residual, however well it is
/// solved. How much, the steps before tell.
void Newton::learn(double reduction, double linearResidual) {
  if (tangent_ != Tangent::Springs) return;
  nonlinearity_ = reduction > 2.0 * linearResidual ? std::min(reduction, 1.0) : 0.1 * nonlinearity_;
}

/// step_ = tangent^-1 residual_.
LinearSolveReport Newton::solveLinear(Simulation& simulation, double dt, const std::vector<double>& externalForce,
                                      double tolerance) {
  const Timers::Scope timer(simulation.model.timers(), "linear solve");
  if (tangent_ == Tangent::Springs && !settings_.hasSmallStrain)
    tolerance = std::max(tolerance, std::min(0.3 * nonlinearity_, 0.1));
  if (settings_.linearTolerance > 0.0) tolerance = settings_.linearTolerance;
  step_.assign(residual_.size(), 0.0);
  LinearSolveReport report;
  const int most = settings_.maximumLinearIterations;
  if (tangent_ == Tangent::Springs) {
    report = springs_->solve(residual_.data(), step_.data(), tolerance, most);
    ++nSpringSolves;
  } else if (tangent_ == Tangent::Differences) {
    report = solveByDifferences(simulation, dt, externalForce, tolerance);
    ++nDifferenceSolves;
  } else {
    report =
        system_->solve(residual_.data(), step_.data(), settings_.linearSolver, preconditionerName(), tolerance, most);
  }
  nLinearIterations += report.iterations;
  if (report.method != settings_.linearSolver) ++nGmresFallbacks;
  if (tangent_ == Tangent::Assembled || report.hasConverged)
    largestLinearResidual = std::max(largestLinearResidual, report.relativeResidual);
  if (settings_.logsLinearSolves)
    simulation.output.log(fmt::format("{} ({}): {} iterations, relative residual {:.3g}, asked for {:.3g}",
                                      report.method, preconditionerName(), report.iterations, report.relativeResidual,
                                      tolerance));
  return report;
}

/// Products of the tangent at the present displacements as difference quotients of the forces, one evaluation each.
LinearSolveReport Newton::solveByDifferences(Simulation& simulation, double dt,
                                             const std::vector<double>& externalForce, double tolerance) {
  Model& model = simulation.model;
  double* displacement = model.field(fields_.displacement);
  const std::vector<double> right = residual_, origin(displacement, displacement + isHeld_.size());
  evaluate(simulation, dt, externalForce);
  const std::vector<double> atOrigin = residual_;
  const auto product = [&](const double* x, double* y) {
    double largest = 0.0;
    for (std::size_t i = 0; i < origin.size(); ++i) largest = std::max(largest, std::abs(x[i]));
    largest = model.comm().max(largest);
    // Strains of 1e-6 keep both nonlinear terms and round-off far below what a step needs.
    const double part = largest > 0.0 ? 1e-6 * model.discretization().shortestBond / largest : 0.0;
    for (std::size_t i = 0; i < origin.size(); ++i) displacement[i] = origin[i] + part * x[i];
    evaluate(simulation, dt, externalForce);
    for (std::size_t i = 0; i < origin.size(); ++i) y[i] = part > 0.0 ? (atOrigin[i] - residual_[i]) / part : 0.0;
  };
  const LinearSolveReport report =
      springs_->solve(right.data(), step_.data(), std::max(tolerance, 1e-6),
                      std::min(settings_.maximumLinearIterations, mostDifferences), product);
  std::copy(origin.begin(), origin.end(), displacement);
  residual_ = right;
  return report;
}

}  // namespace pd
