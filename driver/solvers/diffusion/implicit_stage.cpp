#include "implicit_stage.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "scalar_unknown.hpp"

namespace pd {

namespace {

constexpr int maximumStageIterations = 20;

}  // namespace

void ImplicitStage::declareParameters(ParameterDeclarations& declare) {
  declare.text("Linear Solver", "CG, GMRES, or Direct (sparse LU, gathered on one rank).")
      .defaultTo("CG")
      .oneOf({"CG", "GMRES", "Direct"});
  declare.text("Preconditioner", "Of CG and GMRES.")
      .defaultTo("Multigrid")
      .oneOf({"None", "Jacobi", "ILU", "Multigrid"});
  declare
      .real("Linear Tolerance", "1",
            "Residual of a stage relative to the largest value of the field. What rounding makes of the flux is always "
            "enough.")
      .defaultTo(1e-12)
      .strictlyBetween(0.0, 1.0);
  declare.integer("Maximum Linear Iterations", "Of one linear solve.").defaultTo(1000).atLeast(1);
}

ImplicitStage::ImplicitStage(const Teuchos::ParameterList& parameters)
    : linearSolver_(parameters.get<std::string>("Linear Solver")),
      preconditioner_(parameters.get<std::string>("Preconditioner")),
      linearTolerance_(parameters.get<double>("Linear Tolerance")),
      maximumLinearIterations_(parameters.get<int>("Maximum Linear Iterations")) {}

void ImplicitStage::begin(Simulation& simulation, const std::string& field) {
  const std::vector<char>& isHeld = simulation.conditions.valueIsPrescribed(field);
  // A point that has become a source on any rank changes the matrix of all.
  bool hasChanged = simulation.model.comm().any(isHeld != isHeld_);
  isHeld_ = isHeld;
  if (simulation.model.hasDamage()) {
    const double bondDamage = bondDamageSum_.of(simulation.model);
    hasChanged = hasChanged || bondDamage != bondDamage_;
    bondDamage_ = bondDamage;
  }
  if (hasChanged) hasMatrix_ = false;
}

void ImplicitStage::assemble(Simulation& simulation, const std::string& field, double h) {
  // A step that differs by rounding alone shares its matrix with the one before.
  if (!(std::abs(h - matrixStep_) <= 1e-9 * h)) matrixStep_ = h;
  stiffness_ = assembleFluxMatrix(simulation.model, field, matrixStep_, -matrixStep_, true, isHeld_, system_);
  hasMatrix_ = true;
  ++nMatrices_;
}

/// residual_ = V (right + h f(c) - c) at free points; returns its norm.
double ImplicitStage::residual(Simulation& simulation, ScalarRate& rate, double h, const std::vector<double>& right) {
  rate.evaluate(h);
  const double *volume = simulation.model.field("Volume"), *values = rate.values(), *change = rate.rate();
  residual_.resize(right.size());
  for (std::size_t i = 0; i < right.size(); ++i)
    residual_[i] = isHeld_[i] ? 0.0 : volume[i] * (right[i] + h * change[i] - values[i]);
  return normOverRanks(simulation.model.comm(), residual_);
}

void ImplicitStage::solve(Simulation& simulation, ScalarRate& rate, double t, double h,
                          const std::vector<double>& right) {
  Model& model = simulation.model;
  if (std::abs(h - matrixStep_) > 1e-9 * h) hasMatrix_ = false;
  if (!hasMatrix_) assemble(simulation, rate.field(), h);
  const std::vector<double> volumes(model.field("Volume"), model.field("Volume") + model.nOwned());
  const double volume = normOverRanks(model.comm(), volumes);
  bool matrixIsNew = false;
  double before = std::numeric_limits<double>::infinity(), part = 1.0;
  for (int iteration = 0;; ++iteration) {
    const double now = residual(simulation, rate, h, right);
    const double largest = std::max(rate.largestValue(), std::numeric_limits<double>::min());
    const double target =
        largest * std::max(linearTolerance_ * volume, 4.0 * std::numeric_limits<double>::epsilon() * stiffness_);
    if (now <= target) {
      largestResidual_ = std::max(largestResidual_, now / (largest * volume));
      return;
    }
    if (iteration == maximumStageIterations || !std::isfinite(now))
      throw RunError(fmt::format(
          "Diffusion: the implicit step to t = {:.6g} s does not converge: relative residual {:.3g} after {} "
          "iterations, "
          "asked for {:.3g} ({}, {}). Take shorter steps, or another Linear Solver or Preconditioner",
          t, now / (largest * volume), iteration, target / (largest * volume), linearSolver_, preconditioner_));
    // A flux that is not linear in the field needs the matrix of the present values.
    if (now > 0.1 * before && !matrixIsNew) {
      assemble(simulation, rate.field(), h);
      matrixIsNew = true;
    }
    // Fluxes with kinks may lead to and fro: then what lies between is better.
    part = !(now > 0.5 * before) ? std::min(1.0, 2.0 * part) : std::max(0.25, 0.7 * part);
    before = now;
    const Timers::Scope timer(model.timers(), "linear solve");
    step_.assign(right.size(), 0.0);
    const LinearSolveReport report =
        system_->solve(residual_.data(), step_.data(), linearSolver_, preconditioner_,
                       std::clamp(0.5 * target / now, 1e-13, 0.5), maximumLinearIterations_);
    nLinearIterations_ += report.iterations;
    ++nSolves_;
    double* values = rate.values();
    for (std::size_t i = 0; i < right.size(); ++i)
      if (!isHeld_[i]) values[i] += part * step_[i];
    model.importGhosts(rate.field());
    matrixIsNew = false;
  }
}

void ImplicitStage::smooth(std::vector<double>& values) {
  const std::vector<double> right = values;
  system_->solve(right.data(), values.data(), linearSolver_, preconditioner_, 1e-3, maximumLinearIterations_);
}

std::string ImplicitStage::summary() const {
  return fmt::format("{} linear solves ({}{}), {} iterations, {} matrices; largest residual of a stage {:.3g}",
                     nSolves_, linearSolver_, linearSolver_ == "Direct" ? "" : ", " + preconditioner_,
                     nLinearIterations_, nMatrices_, largestResidual_);
}

}  // namespace pd
