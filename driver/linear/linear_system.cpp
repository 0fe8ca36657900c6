#include "linear_system.hpp"

#include <Teuchos_DefaultMpiComm.hpp>
#include <Tpetra_Import.hpp>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <unordered_map>

#include "methods/direct_solver.hpp"
#include "methods/krylov.hpp"
#include "point_graph.hpp"

namespace pd {

namespace {

/// Entries of the row of a point: for each kept component c, `degree` blocks of `kept` values.
struct PointRow {
  const int* columns;
  std::size_t degree;
  double* values;
};

/// Consecutive indices of a contribution that belong to one point.
struct Run {
  int point, column, begin, end;
};

}  // namespace

struct LinearSystem::Implementation {
  Implementation(const Communicator& communicator, const Discretization& discretization, int width_,
                 bool couplesFamilies);

  const Communicator& comm;
  PointGraph graph;
  const int width;  ///< degrees of freedom a point, as callers see it
  const int kept;   ///< those of them that are in the matrix
  std::unordered_map<int, int> pointOfGlobalId;
  Teuchos::RCP<tpetra::Matrix> matrix;
  Teuchos::RCP<tpetra::MultiVector> nullspace;
  double* values = nullptr;  ///< of the matrix
  std::size_t nValues = 0;
  std::vector<double> ghostValues;
  bool graphIsTooSmall = false;
  std::vector<char> isConstrained;  ///< [kept nOwned] as of the last finish()

  std::vector<Run> runs;        // scratch of addValues
  std::vector<int> components;  // scratch of addValues

  Teuchos::RCP<tpetra::Operator> preconditioner;
  std::string preconditionerName;
  std::unique_ptr<DirectSolver> direct;

  void makeMatrix();
  void makeNullspace(const Discretization& discretization);
  std::size_t pairs() const { return static_cast<std::size_t>(kept) * static_cast<std::size_t>(kept); }
  void forgetFactors();

  PointRow row(int point);
  int pointOf(int globalDegree) const;
  void collectRuns(int numIndices, const int* globalIndices);
  void addRun(const Run& rowRun, bool onlyDiagonal, const double* const* block);
  void addBlock(int numIndices, const int* globalIndices, const double* const* block, bool onlyDiagonal);
  void sendGhostRows();
  void constrain(const std::vector<char>& flags);

  Teuchos::RCP<tpetra::MultiVector> vectorOf(const double* full) const;
  void copyBack(const tpetra::MultiVector& vector, const double* droppedFrom, double* full) const;
  double relativeResidual(const tpetra::MultiVector& b, const tpetra::MultiVector& x) const;
  void solveDirectly(const tpetra::MultiVector& b, tpetra::MultiVector& x, double tolerance, LinearSolveReport& report);
  void solveByKrylov(const Teuchos::RCP<tpetra::MultiVector>& b, const Teuchos::RCP<tpetra::MultiVector>& x,
                     double tolerance, int maximumIterations, LinearSolveReport& report);
};

LinearSystem::Implementation::Implementation(const Communicator& communicator, const Discretization& discretization,
                                             int width_, bool couplesFamilies)
    : comm(communicator),
      graph(makePointGraph(communicator, discretization, couplesFamilies)),
      width(width_),
      kept(width_ == 3 ? discretization.dimension : width_) {
  pointOfGlobalId.reserve(discretization.globalIds.size());
  for (std::size_t point = 0; point < discretization.globalIds.size(); ++point)
    pointOfGlobalId.emplace(discretization.globalIds[point], static_cast<int>(point));
  ghostValues.assign(graph.ghostColumns.size() * pairs(), 0.0);
  isConstrained.assign(static_cast<std::size_t>(graph.nOwned * kept), 0);
  makeMatrix();
  makeNullspace(discretization);
}

void LinearSystem::Implementation::makeMatrix() {
  using LocalMatrix = tpetra::Matrix::local_matrix_device_type;
  const auto teuchosComm = Teuchos::rcp(new Teuchos::MpiComm<int>(comm.mpi()));
  std::vector<long long> numbers;
  for (const long long point : graph.columnNumbers)
    for (int c = 0; c < kept; ++c) numbers.push_back(point * kept + c);
  const auto unknownCount = Teuchos::OrdinalTraits<Tpetra::global_size_t>::invalid();
  const auto rowMap =
      Teuchos::rcp(new tpetra::Map(unknownCount, static_cast<std::size_t>(graph.nOwned * kept), 0, teuchosComm));
  const auto columnMap =
      Teuchos::rcp(new tpetra::Map(unknownCount, Teuchos::ArrayView<const long long>(numbers), 0, teuchosComm));

  nValues = graph.columns.size() * pairs();
  LocalMatrix::row_map_type::non_const_type rowStart("row start", static_cast<std::size_t>(graph.nOwned * kept) + 1);
  LocalMatrix::index_type::non_const_type columns("columns", nValues);
  LocalMatrix::values_type matrixValues("values", nValues);
  std::size_t next = 0, row = 0;
  rowStart(0) = 0;
  for (std::size_t point = 0; point < static_cast<std::size_t>(graph.nOwned); ++point)
    for (int c = 0; c < kept; ++c) {
      for (std::size_t k = graph.rowStart[point]; k < graph.rowStart[point + 1]; ++k)
        for (int d = 0; d < kept; ++d) columns(next++) = graph.columns[k] * kept + d;
      rowStart(++row) = next;
    }
  matrix = Teuchos::rcp(new tpetra::Matrix(rowMap, columnMap, rowStart, columns, matrixValues));
  matrix->expertStaticFillComplete(rowMap, rowMap);
  values = matrixValues.data();  // shared with the matrix: contributions go straight into it
}

/// Constants for a scalar; translations and linear rotations for displacements.
void LinearSystem::Implementation::makeNullspace(const Discretization& discretization) {
  const bool isMechanical = width == 3;
  const int rotations = isMechanical ? kept * (kept - 1) / 2 : 0;
  nullspace = Teuchos::rcp(new tpetra::MultiVector(matrix->getRowMap(), static_cast<std::size_t>(kept + rotations)));
  for (int mode = 0; mode < kept; ++mode) {
    const auto out = nullspace->getDataNonConst(static_cast<std::size_t>(mode));
    for (int point = 0; point < graph.nOwned; ++point) out[point * kept + mode] = 1.0;
  }
  // Rotation in the plane of axes a and b about the centre of the rank's own points; any centre spans the same space.
  int mode = kept;
  for (int a = 0; a < kept && isMechanical; ++a)
    for (int b = a + 1; b < kept; ++b, ++mode) {
      const auto out = nullspace->getDataNonConst(static_cast<std::size_t>(mode));
      for (int point = 0; point < graph.nOwned; ++point) {
        out[point * kept + a] = -discretization.x[static_cast<std::size_t>(3 * point + b)];
        out[point * kept + b] = discretization.x[static_cast<std::size_t>(3 * point + a)];
      }
    }
}

void LinearSystem::Implementation::forgetFactors() {
  preconditioner = Teuchos::null;
  preconditionerName.clear();
  direct.reset();
}

PointRow LinearSystem::Implementation::row(int point) {
  if (point < graph.nOwned) {
    const std::size_t begin = graph.rowStart[static_cast<std::size_t>(point)];
    const std::size_t end = graph.rowStart[static_cast<std::size_t>(point) + 1];
    return {graph.columns.data() + begin, end - begin, values + begin * pairs()};
  }
  const auto ghost = static_cast<std::size_t>(graph.ghostRowOfPoint[static_cast<std::size_t>(point)]);
  const std::size_t begin = graph.ghostRowStart[ghost], end = graph.ghostRowStart[ghost + 1];
  return {graph.ghostColumns.data() + begin, end - begin, ghostValues.data() + begin * pairs()};
}

int LinearSystem::Implementation::pointOf(int globalDegree) const {
  const auto found = pointOfGlobalId.find(globalDegree / width);
  if (globalDegree < 0 || found == pointOfGlobalId.end())
    throw std::logic_error("contribution to the matrix at global degree of freedom " + std::to_string(globalDegree) +
                           ", whose point this rank does not hold");
  return found->second;
}

/// Groups the indices by point, in the order of columns; components that are left out get no place.
void LinearSystem::Implementation::collectRuns(int numIndices, const int* globalIndices) {
  runs.clear();
  components.resize(static_cast<std::size_t>(numIndices));
  for (int i = 0; i < numIndices; ++i) {
    components[static_cast<std::size_t>(i)] = globalIndices[i] % width;
    if (i > 0 && globalIndices[i] / width == globalIndices[i - 1] / width) {
      runs.back().end = i + 1;
      continue;
    }
    const int point = pointOf(globalIndices[i]);
    runs.push_back({point, graph.columnOfPoint[static_cast<std::size_t>(point)], i, i + 1});
  }
  std::sort(runs.begin(), runs.end(), [](const Run& a, const Run& b) { return a.column < b.column; });
}

void LinearSystem::Implementation::addRun(const Run& rowRun, bool onlyDiagonal, const double* const* block) {
  const PointRow target = row(rowRun.point);
  const int* const end = target.columns + target.degree;
  const int* place = target.columns;
  const bool isDense = runs.size() * 8 > target.degree;  // then a merge is faster than searches
  for (const Run& run : runs) {
    if (onlyDiagonal && run.point != rowRun.point) continue;
    if (isDense)
      while (place != end && *place < run.column) ++place;
    else
      place = std::lower_bound(place, end, run.column);
    const bool isMissing = place == end || *place != run.column;
    const std::size_t k = static_cast<std::size_t>(place - target.columns) * kept;
    for (int i = rowRun.begin; i < rowRun.end; ++i) {
      const int c = components[static_cast<std::size_t>(i)];
      if (c >= kept) continue;
      for (int j = run.begin; j < run.end; ++j) {
        const int d = components[static_cast<std::size_t>(j)];
        if (d >= kept) continue;
        if (!isMissing)
          target.values[static_cast<std::size_t>(c) * target.degree * kept + k + d] += block[i][j];
        else if (block[i][j] != 0.0)
          graphIsTooSmall = true;
      }
    }
  }
}

void LinearSystem::Implementation::addBlock(int numIndices, const int* globalIndices, const double* const* block,
                                            bool onlyDiagonal) {
  collectRuns(numIndices, globalIndices);
  for (const Run& run : runs) addRun(run, onlyDiagonal, block);
}

void LinearSystem::Implementation::sendGhostRows() {
  if (comm.size() == 1) return;
  const int scale = static_cast<int>(pairs());
  const std::size_t ranks = graph.sentEntries.size();
  std::vector<int> sent(ranks), sentStart(ranks), received(ranks), receivedStart(ranks);
  int nSent = 0, nReceived = 0;
  for (std::size_t rank = 0; rank < ranks; ++rank) {
    sent[rank] = graph.sentEntries[rank] * scale;
    received[rank] = graph.receivedEntries[rank] * scale;
    sentStart[rank] = nSent;
    receivedStart[rank] = nReceived;
    nSent += sent[rank];
    nReceived += received[rank];
  }
  std::vector<double> incoming(static_cast<std::size_t>(nReceived));
  MPI_Alltoallv(ghostValues.data(), sent.data(), sentStart.data(), MPI_DOUBLE, incoming.data(), received.data(),
                receivedStart.data(), MPI_DOUBLE, comm.mpi());
  const double* value = incoming.data();
  for (std::size_t r = 0; r < graph.receivedRows.size(); ++r) {
    const PointRow target = row(graph.receivedRows[r]);
    for (int c = 0; c < kept; ++c)
      for (std::size_t k = graph.receivedRowStart[r]; k < graph.receivedRowStart[r + 1]; ++k) {
        double* out =
            target.values +
            (static_cast<std::size_t>(c) * target.degree + static_cast<std::size_t>(graph.receivedPositions[k])) * kept;
        for (int d = 0; d < kept; ++d) out[d] += *value++;
      }
  }
  std::fill(ghostValues.begin(), ghostValues.end(), 0.0);
}

void LinearSystem::Implementation::constrain(const std::vector<char>& flags) {
  const auto ownFlags = Teuchos::rcp(new tpetra::MultiVector(matrix->getDomainMap(), 1));
  {
    const auto out = ownFlags->getDataNonConst(0);
    for (int point = 0; point < graph.nOwned; ++point)
      for (int c = 0; c < kept; ++c) {
        isConstrained[static_cast<std::size_t>(point * kept + c)] = flags[static_cast<std::size_t>(point * width + c)];
        out[point * kept + c] = flags[static_cast<std::size_t>(point * width + c)] ? 1.0 : 0.0;
      }
  }
  Teuchos::RCP<tpetra::MultiVector> columnFlags = ownFlags;
  if (const auto import = matrix->getGraph()->getImporter(); !import.is_null()) {
    columnFlags = Teuchos::rcp(new tpetra::MultiVector(matrix->getColMap(), 1));
    columnFlags->doImport(*ownFlags, *import, Tpetra::INSERT);
  }
  const auto isEliminated = columnFlags->getData(0);
  for (int point = 0; point < graph.nOwned; ++point) {
    const PointRow target = row(point);
    double* value = target.values;
    for (int c = 0; c < kept; ++c) {
      const bool isIdentity = isEliminated[point * kept + c] != 0.0;
      for (std::size_t k = 0; k < target.degree; ++k)
        for (int d = 0; d < kept; ++d, ++value) {
          if (isIdentity)
            *value = target.columns[k] == point && d == c ? 1.0 : 0.0;
          else if (isEliminated[target.columns[k] * kept + d] != 0.0)
            *value = 0.0;
        }
    }
  }
}

LinearSystem::LinearSystem(const Communicator& comm, const Discretization& discretization, int width,
                           bool couplesFamilies)
    : implementation_(std::make_unique<Implementation>(comm, discretization, width, couplesFamilies)) {}

LinearSystem::~LinearSystem() = default;

void LinearSystem::putScalar(double value) {
  Implementation& self = *implementation_;
  self.forgetFactors();
  self.graphIsTooSmall = false;
  std::fill(self.values, self.values + self.nValues, value);
  std::fill(self.ghostValues.begin(), self.ghostValues.end(), 0.0);
}

void LinearSystem::addValue(int globalRow, int globalCol, double value) {
  Implementation& self = *implementation_;
  const int rowComponent = globalRow % self.width, columnComponent = globalCol % self.width;
  const int rowPoint = self.pointOf(globalRow);
  const int column = self.graph.columnOfPoint[static_cast<std::size_t>(self.pointOf(globalCol))];
  if (rowComponent >= self.kept || columnComponent >= self.kept) return;
  const PointRow target = self.row(rowPoint);
  const int* place = std::lower_bound(target.columns, target.columns + target.degree, column);
  if (place != target.columns + target.degree && *place == column)
    target.values[(static_cast<std::size_t>(rowComponent) * target.degree +
                   static_cast<std::size_t>(place - target.columns)) *
                      self.kept +
                  columnComponent] += value;
  else if (value != 0.0)
    self.graphIsTooSmall = true;
}

void LinearSystem::addValues(int numIndices, const int* globalIndices, const double* const* values) {
  implementation_->addBlock(numIndices, globalIndices, values, false);
}

void LinearSystem::addBlockDiagonalValues(int numIndices, const int* globalIndices, const double* const* values) {
  implementation_->addBlock(numIndices, globalIndices, values, true);
}

void LinearSystem::addToDiagonal(int ownedPoint, int component, double value) {
  Implementation& self = *implementation_;
  if (component >= self.kept) return;
  const PointRow target = self.row(ownedPoint);
  const int* place = std::lower_bound(target.columns, target.columns + target.degree, ownedPoint);
  target
      .values[(static_cast<std::size_t>(component) * target.degree + static_cast<std::size_t>(place - target.columns)) *
                  self.kept +
              component] += value;
  self.forgetFactors();
}

void LinearSystem::scale(double factor) {
  Implementation& self = *implementation_;
  self.forgetFactors();
  for (std::size_t i = 0; i < self.nValues; ++i) self.values[i] *= factor;
  for (double& value : self.ghostValues) value *= factor;
}

void LinearSystem::finish(const std::vector<char>& isConstrained) {
  Implementation& self = *implementation_;
  self.forgetFactors();
  self.sendGhostRows();
  self.constrain(isConstrained);
  self.graphIsTooSmall = self.comm.any(self.graphIsTooSmall);
}

bool LinearSystem::graphIsTooSmall() const { return implementation_->graphIsTooSmall; }

std::vector<double> LinearSystem::diagonal() const {
  Implementation& self = *implementation_;
  std::vector<double> result(static_cast<std::size_t>(self.graph.nOwned * self.width), 1.0);
  for (int point = 0; point < self.graph.nOwned; ++point) {
    const PointRow target = self.row(point);
    const auto place = static_cast<std::size_t>(
        std::lower_bound(target.columns, target.columns + target.degree, point) - target.columns);
    for (int c = 0; c < self.kept; ++c)
      result[static_cast<std::size_t>(point * self.width + c)] =
          target.values[(static_cast<std::size_t>(c) * target.degree + place) * self.kept + c];
  }
  return result;
}

void LinearSystem::apply(const double* x, double* y) const {
  const Implementation& self = *implementation_;
  const auto in = self.vectorOf(x);
  tpetra::MultiVector out(self.matrix->getRangeMap(), 1);
  self.matrix->apply(*in, out);
  self.copyBack(out, x, y);
}

Teuchos::RCP<tpetra::MultiVector> LinearSystem::Implementation::vectorOf(const double* full) const {
  const auto vector = Teuchos::rcp(new tpetra::MultiVector(matrix->getRowMap(), 1));
  const auto out = vector->getDataNonConst(0);
  for (int point = 0; point < graph.nOwned; ++point)
    for (int c = 0; c < kept; ++c) out[point * kept + c] = full[point * width + c];
  return vector;
}

/// The components that are not in the matrix are copied from `droppedFrom`: their rows are those of the identity.
void LinearSystem::Implementation::copyBack(const tpetra::MultiVector& vector, const double* droppedFrom,
                                            double* full) const {
  const auto in = vector.getData(0);
  for (int point = 0; point < graph.nOwned; ++point) {
    for (int c = 0; c < kept; ++c) full[point * width + c] = in[point * kept + c];
    for (int c = kept; c < width; ++c) full[point * width + c] = droppedFrom[point * width + c];
  }
}

double LinearSystem::Implementation::relativeResidual(const tpetra::MultiVector& b,
                                                      const tpetra::MultiVector& x) const {
  tpetra::MultiVector residual(b, Teuchos::Copy);
  matrix->apply(x, residual, Teuchos::NO_TRANS, -1.0, 1.0);
  Teuchos::Array<double> normOfB(1), norm(1);
  b.norm2(normOfB());
  residual.norm2(norm());
  if (normOfB[0] == 0.0) return norm[0] == 0.0 ? 0.0 : HUGE_VAL;
  return norm[0] / normOfB[0];
}

void LinearSystem::Implementation::solveDirectly(const tpetra::MultiVector& b, tpetra::MultiVector& x, double tolerance,
                                                 LinearSolveReport& report) {
  if (!direct) direct = std::make_unique<DirectSolver>(comm.mpi(), *matrix);
  x.putScalar(0.0);
  report.relativeResidual = 1.0;
  // One solve, and at most two of its residual where rounding has left too much of it.
  for (int pass = 0; pass < 3 && report.relativeResidual > tolerance; ++pass) {
    tpetra::MultiVector residual(b, Teuchos::Copy), correction(x.getMap(), 1);
    matrix->apply(x, residual, Teuchos::NO_TRANS, -1.0, 1.0);
    if (!direct->solve(residual.getData(0).getRawPtr(), correction.getDataNonConst(0).getRawPtr())) return;
    tpetra::MultiVector improved(x, Teuchos::Copy);
    improved.update(1.0, correction, 1.0);
    const double achieved = relativeResidual(b, improved);
    if (pass > 0 && !(achieved < report.relativeResidual)) return;
    x.assign(improved);
    report.relativeResidual = achieved;
    report.iterations = pass + 1;
  }
}

void LinearSystem::Implementation::solveByKrylov(const Teuchos::RCP<tpetra::MultiVector>& b,
                                                 const Teuchos::RCP<tpetra::MultiVector>& x, double tolerance,
                                                 int maximumIterations, LinearSolveReport& report) {
  // The recurrence drifts away from the true residual; then the method starts again from what it has.
  double before = HUGE_VAL;
  while (report.iterations < maximumIterations) {
    const auto attempt = Teuchos::rcp(new tpetra::MultiVector(*x, Teuchos::Copy));
    const KrylovResult result =
        runKrylov(report.method, matrix, preconditioner, b, attempt, tolerance, maximumIterations - report.iterations);
    report.iterations += result.iterations;
    if (result.hasBrokenDown) {
      if (report.method == "GMRES") break;
      report.method = "GMRES";
      continue;
    }
    report.relativeResidual = relativeResidual(*b, *attempt);
    if (std::isfinite(report.relativeResidual)) x->assign(*attempt);
    if (report.relativeResidual <= tolerance || !(report.relativeResidual < 0.5 * before) || result.iterations == 0)
      break;
    before = report.relativeResidual;
  }
}

LinearSolveReport LinearSystem::solve(const double* b, double* x, const std::string& method,
                                      const std::string& preconditioner, double relativeTolerance,
                                      int maximumIterations) {
  Implementation& self = *implementation_;
  if (method != "CG" && method != "GMRES" && method != "Direct")
    throw std::invalid_argument("unknown linear solver \"" + method + "\" (known: CG, GMRES, Direct)");
  LinearSolveReport report;
  report.method = method;
  const auto rightSide = self.vectorOf(b);
  const auto solution = self.vectorOf(x);
  Teuchos::Array<double> normOfB(1);
  rightSide->norm2(normOfB());
  if (normOfB[0] == 0.0) {
    solution->putScalar(0.0);
  } else if (method == "Direct") {
    self.solveDirectly(*rightSide, *solution, relativeTolerance, report);
  } else {
    if (self.preconditionerName != preconditioner) {
      self.preconditioner = makePreconditioner(preconditioner, self.matrix, self.kept, self.nullspace);
      self.preconditionerName = preconditioner;
    }
    report.relativeResidual = 1.0;
    self.solveByKrylov(rightSide, solution, relativeTolerance, maximumIterations, report);
  }
  report.hasConverged = report.relativeResidual <= relativeTolerance;
  self.copyBack(*solution, b, x);
  return report;
}

}  // namespace pd
