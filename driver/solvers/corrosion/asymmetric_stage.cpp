#include "asymmetric_stage.hpp"

#include <algorithm>
#include <cmath>

#include "../diffusion/scalar_unknown.hpp"

namespace pd {

namespace {

bool isFactored(const Discretization& mesh) { return isWorthFactoring(mesh.dimension, mesh.nGlobal); }

}  // namespace

bool AsymmetricStage::makeInverse(StageEquation& equation, const std::vector<double>& slope) {
  Model& model = equation.model();
  const Discretization& mesh = model.discretization();
  const std::vector<int>& ids = equation.ids();
  const auto nOwned = static_cast<std::size_t>(mesh.nOwned);
  std::vector<double> isFree(nOwned, 0.0), factor(nOwned), diagonal(nOwned, largestDiagonal(equation.h()));
  for (std::size_t i = 0; i < nOwned; ++i) factor[i] = -equation.h() / equation.fields().volume[static_cast<int>(i)];
  for (std::size_t k = 0; k < ids.size(); ++k) {
    if (equation.isFree()[k] == 0) continue;
    isFree[static_cast<std::size_t>(ids[k])] = 1.0;
    diagonal[static_cast<std::size_t>(ids[k])] = 1.0 + equation.h() * (equation.exchange(k) - slope[k]);
  }
  unknowns_.number(model, isFree);
  CompactJacobian jacobian = isFactored(mesh) ? CompactJacobian(unknowns_, mesh, HUGE_VAL)  // factors do not save
                                              : CompactJacobian(unknowns_, mesh);
  {
    const ScalarUnknown unknown(equation.fields().label);
    model.assembleJacobian(equation.h(), jacobian);
  }
  SparseRows rows;
  {
    const Timers::Scope timer(model.timers(), "matrix assembly");
    rows = jacobian.finish(model.comm(), factor, diagonal);
  }
  double largest = 1.0;
  for (std::size_t i = 0; i < nOwned; ++i)
    for (std::size_t k = rows.start[i]; k < rows.start[i + 1] && isFree[i] != 0.0; ++k)
      if (rows.columns[k] == unknowns_.first + static_cast<long long>(i)) largest = std::max(largest, rows.values[k]);
  largestRate_ = (model.comm().max(largest) - 1.0) / equation.h();
  const Timers::Scope timer(model.timers(), "transport factor");
  inverse_.reset();  // its memory goes first
  leastPerDigit_ = excess_ = 0.0;
  auto made = std::make_unique<RowInverse>(model.comm());
  if (isFactored(mesh))
    trouble_ = made->factor(rows, FactorPrecision::Single);
  else
    made->precondition("ILU", rows);
  if (!trouble_.empty()) return false;
  inverse_ = std::move(made);
  ++nFactors_;
  return true;
}

GmresReport AsymmetricStage::iterate(StageEquation& equation, const std::vector<double>& slope, double tolerance,
                                     int mostIterations, std::vector<double>& solution) {
  constexpr int keptVectors = 60;
  const std::vector<int>& ids = equation.ids();
  const auto nOwned = static_cast<std::size_t>(equation.model().nOwned());
  std::vector<double> right(nOwned, 0.0), direction(ids.size()), image(ids.size());
  for (std::size_t k = 0; k < ids.size(); ++k)
    if (equation.isFree()[k] != 0) right[static_cast<std::size_t>(ids[k])] = equation.residual()[k];
  const double atOthers = largestDiagonal(equation.h());
  const auto product = [&](const double* x, double* y) {
    for (std::size_t k = 0; k < ids.size(); ++k) direction[k] = equation.isFree()[k] != 0 ? x[ids[k]] : 0.0;
    equation.applyJacobian(slope, direction, image);
    for (std::size_t i = 0; i < nOwned; ++i) y[i] = atOthers * x[i];
    for (std::size_t k = 0; k < ids.size(); ++k)
      if (equation.isFree()[k] != 0) y[ids[k]] = image[k];
  };
  const auto precondition = [&](const double* r, double* z) { inverse_->apply(r, z); };
  const Timers::Scope timer(equation.model().timers(), "linear solve");
  solution.assign(nOwned, 0.0);
  const GmresReport report = solveByGmres(equation.model().comm(), product, precondition, right, solution, tolerance,
                                          mostIterations, keptVectors);
  nIterations_ += report.iterations;
  return report;
}

/// Where old inverses fail one after the other, as limits of what a flow carries change in each of Newton's steps, they
/// are tried more and more seldom.
void AsymmetricStage::learnFromKept(bool hasConverged) {
  constexpr int mostFailures = 5;
  nFailures_ = hasConverged ? 0 : std::min(nFailures_ + 1, mostFailures);
  nUntilTry_ = nFailures_ > 0 ? (1 << (nFailures_ - 1)) - 1 : 0;
}

/// The inverse is made again where the iterations that an old one has cost are worth a new one.
bool AsymmetricStage::solve(StageEquation& equation, const std::vector<double>& slope, double tolerance,
                            std::vector<double>& step) {
  constexpr int keptIterations = 50, newIterations = 200;
  constexpr int patience = 25;    // iterations that an inverse costs, about
  constexpr double enough = 0.1;  // what is left is for the next of Newton's steps
  trouble_.clear();
  const bool isKept = inverse_ != nullptr && excess_ <= patience && nUntilTry_ == 0;
  if (nUntilTry_ > 0) --nUntilTry_;
  if (!isKept && !makeInverse(equation, slope)) return false;
  const int most = !isKept ? newIterations : nFailures_ > 0 ? patience / 2 : keptIterations;
  std::vector<double> solution;
  GmresReport report = iterate(equation, slope, tolerance, most, solution);
  if (isKept) learnFromKept(report.hasConverged);
  if (!report.hasConverged && isKept) {
    if (!makeInverse(equation, slope)) return false;
    report = iterate(equation, slope, tolerance, newIterations, solution);
  }
  const double digits = std::max(1.0, -std::log10(tolerance)), perDigit = report.iterations / digits;
  leastPerDigit_ = leastPerDigit_ == 0.0 ? perDigit : std::min(leastPerDigit_, perDigit);
  excess_ += report.iterations - leastPerDigit_ * digits;
  for (std::size_t k = 0; k < equation.ids().size(); ++k)
    step[k] = equation.isFree()[k] != 0 ? solution[static_cast<std::size_t>(equation.ids()[k])] : 0.0;
  return report.relativeResidual <= std::max(tolerance, enough);
}

}  // namespace pd
