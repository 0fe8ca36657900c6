#include "assembled_stage.hpp"

#include <algorithm>
#include <cmath>

#include "../diffusion/scalar_unknown.hpp"

namespace pd {

namespace {

bool isFactored(const Discretization& mesh) { return isWorthFactoring(mesh.dimension, mesh.nGlobal); }

}  // namespace

/// Entries of the Jacobian by unknown; those of other ranks' rows are kept apart.
class AssembledStage::Collector : public PeridigmNS::SerialMatrix {
 public:
  using Entry = std::pair<long long, double>;
  Collector(const AssembledStage& stage, const Discretization& mesh)
      : stage_(stage), mesh_(mesh), rows_(static_cast<std::size_t>(mesh.nOwned)) {}

  void addValue(int globalRow, int globalColumn, double value) override {
    const int row = localOf(globalRow), column = localOf(globalColumn);
    const auto i = static_cast<std::size_t>(row), j = static_cast<std::size_t>(column);
    if (stage_.isFree_[i] == 0.0 || stage_.isFree_[j] == 0.0 || value == 0.0) return;
    const double own = stage_.column_[i], other = stage_.column_[j];
    if (row < mesh_.nOwned)
      add(own, other, value);
    else
      foreign_.insert(foreign_.end(), {own, other, value});
  }
  void addValues(int n, const int* ids, const double* const* values) override {
    for (int a = 0; a < n; ++a)
      for (int b = 0; b < n; ++b) addValue(ids[a], ids[b], values[a][b]);
  }
  void addBlockDiagonalValues(int, const int*, const double* const*) override {}
  void putScalar(double) override {}

  /// Brings entries to the ranks that have their rows. Collective.
  std::vector<std::vector<Entry>>& finish(const Communicator& comm) {
    const std::vector<double> all = comm.gather(foreign_);
    const auto first = static_cast<double>(stage_.first_), end = first + static_cast<double>(rows_.size());
    for (std::size_t k = 0; k < all.size(); k += 3)
      if (all[k] >= first && all[k] < end) add(all[k], all[k + 1], all[k + 2]);
    return rows_;
  }

 private:
  /// Images count as what they mirror.
  int localOf(int globalId) const { return stage_.localId_[static_cast<std::size_t>(globalId % mesh_.nGlobal)]; }
  void add(double row, double column, double value) {
    rows_[static_cast<std::size_t>(row - static_cast<double>(stage_.first_))].emplace_back(
        static_cast<long long>(column), value);
  }

  const AssembledStage& stage_;
  const Discretization& mesh_;
  std::vector<std::vector<Entry>> rows_;
  std::vector<double> foreign_;  ///< row, column, value
};

void AssembledStage::number(StageEquation& equation) {
  Model& model = equation.model();
  const Discretization& mesh = model.discretization();
  if (localId_.empty()) {
    localId_.assign(static_cast<std::size_t>(mesh.nGlobal), -1);
    for (int i = 0; i < mesh.firstImage(); ++i)
      localId_[static_cast<std::size_t>(mesh.globalIds[static_cast<std::size_t>(i)])] = i;
  }
  const auto own = static_cast<long long>(mesh.nOwned);
  MPI_Exscan(&own, &first_, 1, MPI_LONG_LONG, MPI_SUM, model.comm().mpi());
  if (model.comm().isRoot()) first_ = 0;
  column_.assign(static_cast<std::size_t>(mesh.nPoints), 0.0);
  isFree_.assign(column_.size(), 0.0);
  for (std::size_t i = 0; i < static_cast<std::size_t>(mesh.nOwned); ++i)
    column_[i] = static_cast<double>(first_) + static_cast<double>(i);
  for (std::size_t k = 0; k < equation.ids().size(); ++k)
    if (equation.isFree()[k] != 0) isFree_[static_cast<std::size_t>(equation.ids()[k])] = 1.0;
  model.exchange().import(column_.data(), 1, Reflection::Even);
  model.exchange().import(isFree_.data(), 1, Reflection::Even);
}

SparseRows AssembledStage::assemble(StageEquation& equation, const std::vector<double>& slope) {
  Model& model = equation.model();
  number(equation);
  Collector collector(*this, model.discretization());
  {
    const ScalarUnknown unknown(equation.fields().label);
    model.assembleJacobian(equation.h(), collector);
  }
  const Timers::Scope timer(model.timers(), "matrix assembly");
  std::vector<std::vector<Collector::Entry>>& rows = collector.finish(model.comm());
  std::vector<double> diagonal(rows.size(), 0.0);
  for (std::size_t k = 0; k < equation.ids().size(); ++k)
    if (equation.isFree()[k] != 0)
      diagonal[static_cast<std::size_t>(equation.ids()[k])] = 1.0 + equation.h() * (equation.exchange(k) - slope[k]);
  SparseRows result;
  const double ofOthers = largestDiagonal_;
  largestDiagonal_ = 1.0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const long long own = first_ + static_cast<long long>(i);
    double sum = diagonal[i];
    for (Collector::Entry& entry : rows[i]) {
      entry.second *= -equation.h() / equation.fields().volume[static_cast<int>(i)];
      if (entry.first == own) sum += entry.second;
    }
    rows[i].emplace_back(own, isFree_[i] != 0.0 ? diagonal[i] : ofOthers);
    result.addRow(rows[i]);
    largestDiagonal_ = std::max(largestDiagonal_, sum);
  }
  largestDiagonal_ = model.comm().max(largestDiagonal_);
  return result;
}

bool AssembledStage::factor(const Discretization& mesh) {
  if (isFactored(mesh))
    trouble_ = system_->factor();
  else
    system_->precondition("ILU");
  if (trouble_.empty()) ++nFactors_;
  return trouble_.empty();
}

bool AssembledStage::solve(StageEquation& equation, const std::vector<double>& slope, double tolerance,
                           std::vector<double>& step) {
  const Discretization& mesh = equation.model().discretization();
  // What is incomplete takes some iterations from the start.
  const int keptIterations = isFactored(mesh) ? 12 : 50, newIterations = isFactored(mesh) ? 50 : 200;
  constexpr double enough = 0.1;  // what is left is for the next of Newton's steps
  if (!system_) system_ = std::make_unique<RowSystem>(equation.model().comm());
  system_->setMatrix(assemble(equation, slope));
  std::vector<double> right(static_cast<std::size_t>(equation.model().nOwned()), 0.0), solution;
  for (std::size_t k = 0; k < equation.ids().size(); ++k)
    if (equation.isFree()[k] != 0) right[static_cast<std::size_t>(equation.ids()[k])] = equation.residual()[k];
  const Timers::Scope timer(equation.model().timers(), "linear solve");
  RowSolveReport report;
  if (system_->hasFactor()) {
    solution.assign(right.size(), 0.0);
    report = system_->solve(right, solution, tolerance, keptIterations);
    nIterations_ += report.iterations;
  }
  if (!report.hasConverged) {
    if (!factor(mesh)) return false;
    solution.assign(right.size(), 0.0);
    report = system_->solve(right, solution, tolerance, newIterations);
    nIterations_ += report.iterations;
  }
  for (std::size_t k = 0; k < equation.ids().size(); ++k)
    step[k] = equation.isFree()[k] != 0 ? solution[static_cast<std::size_t>(equation.ids()[k])] : 0.0;
  return report.relativeResidual <= std::max(tolerance, enough);
}

}  // namespace pd
