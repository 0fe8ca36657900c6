#include "assembled_matrix.hpp"

#include <Teuchos_DefaultMpiComm.hpp>
#include <Tpetra_Import.hpp>
#include <algorithm>
#include <array>
#include <stdexcept>

namespace pd {

AssembledMatrix::AssembledMatrix(const Communicator& comm, const Discretization& discretization, int width,
                                 bool couplesFamilies)
    : comm_(comm),
      graph_(makePointGraph(comm, discretization, couplesFamilies)),
      width_(width),
      kept_(width == 3 ? discretization.dimension : width),
      symmetry_(discretization.symmetry) {
  placeOfGlobalId_.reserve(discretization.globalIds.size());
  for (std::size_t k = 0; k < discretization.globalIds.size(); ++k) {
    const int point = static_cast<int>(k);
    placeOfGlobalId_.emplace(discretization.globalIds[k],
                             Place{discretization.sourceOf(point), discretization.copyOf(point)});
  }
  ghostValues_.assign(graph_.ghostColumns.size() * pairs(), 0.0);
  makeMatrix();
}

void AssembledMatrix::makeMatrix() {
  using LocalMatrix = tpetra::Matrix::local_matrix_device_type;
  const auto teuchosComm = Teuchos::rcp(new Teuchos::MpiComm<int>(comm_.mpi()));
  std::vector<long long> numbers;
  for (const long long point : graph_.columnNumbers)
    for (int c = 0; c < kept_; ++c) numbers.push_back(point * kept_ + c);
  const auto unknownCount = Teuchos::OrdinalTraits<Tpetra::global_size_t>::invalid();
  const auto rowMap =
      Teuchos::rcp(new tpetra::Map(unknownCount, static_cast<std::size_t>(graph_.nOwned * kept_), 0, teuchosComm));
  const auto columnMap =
      Teuchos::rcp(new tpetra::Map(unknownCount, Teuchos::ArrayView<const long long>(numbers), 0, teuchosComm));

  nValues_ = graph_.columns.size() * pairs();
  LocalMatrix::row_map_type::non_const_type rowStart("row start", static_cast<std::size_t>(graph_.nOwned * kept_) + 1);
  LocalMatrix::index_type::non_const_type columns("columns", nValues_);
  LocalMatrix::values_type matrixValues("values", nValues_);
  std::size_t next = 0, row = 0;
  rowStart(0) = 0;
  for (std::size_t point = 0; point < static_cast<std::size_t>(graph_.nOwned); ++point)
    for (int c = 0; c < kept_; ++c) {
      for (std::size_t k = graph_.rowStart[point]; k < graph_.rowStart[point + 1]; ++k)
        for (int d = 0; d < kept_; ++d) columns(next++) = graph_.columns[k] * kept_ + d;
      rowStart(++row) = next;
    }
  matrix_ = Teuchos::rcp(new tpetra::Matrix(rowMap, columnMap, rowStart, columns, matrixValues));
  matrix_->expertStaticFillComplete(rowMap, rowMap);
  values_ = matrixValues.data();  // shared with the matrix: contributions go straight into it
}

Teuchos::RCP<tpetra::MultiVector> AssembledMatrix::makeNullspace(const Discretization& discretization) const {
  const int rotations = width_ == 3 ? kept_ * (kept_ - 1) / 2 : 0;
  const auto modes =
      Teuchos::rcp(new tpetra::MultiVector(matrix_->getRowMap(), static_cast<std::size_t>(kept_ + rotations)));
  std::array<double, 3> centre{};  // rotations about it are far from the translations, wherever the body is
  for (int mode = 0; mode < kept_; ++mode) {
    const auto out = modes->getDataNonConst(static_cast<std::size_t>(mode));
    double& sum = centre[static_cast<std::size_t>(mode)];
    for (int point = 0; point < graph_.nOwned; ++point) {
      out[point * kept_ + mode] = 1.0;
      sum += discretization.x[static_cast<std::size_t>(3 * point + mode)];
    }
    sum = comm_.sum(sum) / static_cast<double>(graph_.nGlobal);
  }
  std::size_t mode = static_cast<std::size_t>(kept_);
  for (int a = 0; a < kept_ && rotations > 0; ++a)
    for (int b = a + 1; b < kept_; ++b, ++mode) {
      const auto out = modes->getDataNonConst(mode);
      for (int point = 0; point < graph_.nOwned; ++point) {
        const double* x = &discretization.x[static_cast<std::size_t>(3 * point)];
        out[point * kept_ + a] = centre[static_cast<std::size_t>(b)] - x[b];
        out[point * kept_ + b] = x[a] - centre[static_cast<std::size_t>(a)];
      }
    }
  return modes;
}

void AssembledMatrix::fill(double value) {
  graphIsTooSmall_ = false;
  std::fill(values_, values_ + nValues_, value);
  std::fill(ghostValues_.begin(), ghostValues_.end(), 0.0);
}

void AssembledMatrix::scale(double factor) {
  for (std::size_t i = 0; i < nValues_; ++i) values_[i] *= factor;
  for (double& value : ghostValues_) value *= factor;
}

AssembledMatrix::PointRow AssembledMatrix::row(int point) {
  if (point < graph_.nOwned) {
    const std::size_t begin = graph_.rowStart[static_cast<std::size_t>(point)];
    const std::size_t end = graph_.rowStart[static_cast<std::size_t>(point) + 1];
    return {graph_.columns.data() + begin, end - begin, values_ + begin * pairs()};
  }
  const auto ghost = static_cast<std::size_t>(graph_.ghostRowOfPoint[static_cast<std::size_t>(point)]);
  const std::size_t begin = graph_.ghostRowStart[ghost], end = graph_.ghostRowStart[ghost + 1];
  return {graph_.ghostColumns.data() + begin, end - begin, ghostValues_.data() + begin * pairs()};
}

double* AssembledMatrix::entry(const PointRow& target, int component, const int* place, int columnComponent) const {
  return target.values +
         (static_cast<std::size_t>(component) * target.degree + static_cast<std::size_t>(place - target.columns)) *
             static_cast<std::size_t>(kept_) +
         columnComponent;
}

AssembledMatrix::Place AssembledMatrix::placeOf(int globalDegree) const {
  const auto found = placeOfGlobalId_.find(globalDegree / width_);
  if (globalDegree < 0 || found == placeOfGlobalId_.end())
    throw std::logic_error("contribution to the matrix at global degree of freedom " + std::to_string(globalDegree) +
                           ", whose point this rank does not hold");
  return found->second;
}

/// Groups the indices by point, in the order of columns; components that are left out get no place.
void AssembledMatrix::collectRuns(int numIndices, const int* globalIndices) {
  runs_.clear();
  components_.resize(static_cast<std::size_t>(numIndices));
  for (int i = 0; i < numIndices; ++i) {
    components_[static_cast<std::size_t>(i)] = globalIndices[i] % width_;
    if (i > 0 && globalIndices[i] / width_ == globalIndices[i - 1] / width_) {
      runs_.back().end = i + 1;
      continue;
    }
    const auto [point, copy] = placeOf(globalIndices[i]);
    runs_.push_back({point, copy, graph_.columnOfPoint[static_cast<std::size_t>(point)], i, i + 1});
  }
  std::sort(runs_.begin(), runs_.end(), [](const Run& a, const Run& b) { return a.column < b.column; });
}

/// A contribution to components that a plane of symmetry mixes must hold them all.
void AssembledMatrix::requireWholePoint(const Run& run) const {
  const Symmetry::Matrix& m = symmetry_.matrix(run.copy);
  for (int i = run.begin; i < run.end; ++i)
    for (int c = 0; c < 3; ++c) {
      const auto begin = components_.begin() + run.begin, end = components_.begin() + run.end;
      if (m[static_cast<std::size_t>(3 * c + components_[static_cast<std::size_t>(i)])] != 0.0 &&
          std::find(begin, end, c) == end)
        throw std::logic_error(
            "a contribution to the matrix lacks components of an image that a plane of symmetry mixes");
    }
}

/// The block as it is once rows and columns of images are turned back, M block M with M of their copies.
const double* const* AssembledMatrix::mirroredBack(int numIndices, const double* const* block) {
  const auto isTurned = [&](const Run& run) { return run.copy != 0; };
  if (width_ != 3 || std::none_of(runs_.begin(), runs_.end(), isTurned)) return block;
  const auto n = static_cast<std::size_t>(numIndices);
  for (const Run& run : runs_) requireWholePoint(run);
  // Turns the rows of images, and writes the transpose: twice, and rows and columns are.
  const auto turnRows = [&](const auto& entryAt, std::vector<double>& out) {
    out.assign(n * n, 0.0);
    for (const Run& run : runs_) {
      const Symmetry::Matrix& m = symmetry_.matrix(run.copy);
      for (auto i = static_cast<std::size_t>(run.begin); i < static_cast<std::size_t>(run.end); ++i)
        for (auto k = static_cast<std::size_t>(run.begin); k < static_cast<std::size_t>(run.end); ++k) {
          const double share = m[static_cast<std::size_t>(3 * components_[i] + components_[k])];
          for (std::size_t j = 0; j < n && share != 0.0; ++j) out[j * n + i] += share * entryAt(k, j);
        }
    }
  };
  turnRows([&](std::size_t k, std::size_t j) { return block[k][j]; }, half_);
  turnRows([&](std::size_t k, std::size_t j) { return half_[k * n + j]; }, mirrored_);
  mirroredRows_.resize(n);
  for (std::size_t i = 0; i < n; ++i) mirroredRows_[i] = &mirrored_[i * n];
  return mirroredRows_.data();
}

void AssembledMatrix::addRun(const Run& rowRun, bool onlyDiagonal, const double* const* block) {
  const PointRow target = row(rowRun.point);
  const int* const end = target.columns + target.degree;
  const int* place = target.columns;
  const bool isDense = runs_.size() * 8 > target.degree;  // then a merge is faster than searches
  for (const Run& run : runs_) {
    if (onlyDiagonal && run.point != rowRun.point) continue;
    if (isDense)
      while (place != end && *place < run.column) ++place;
    else
      place = std::lower_bound(place, end, run.column);
    const bool isMissing = place == end || *place != run.column;
    for (int i = rowRun.begin; i < rowRun.end; ++i) {
      const int c = components_[static_cast<std::size_t>(i)];
      if (c >= kept_) continue;
      for (int j = run.begin; j < run.end; ++j) {
        const int d = components_[static_cast<std::size_t>(j)];
        if (d >= kept_) continue;
        if (!isMissing)
          *entry(target, c, place, d) += block[i][j];
        else if (block[i][j] != 0.0)
          graphIsTooSmall_ = true;
      }
    }
  }
}

void AssembledMatrix::addBlock(int numIndices, const int* globalIndices, const double* const* block,
                               bool onlyDiagonal) {
  collectRuns(numIndices, globalIndices);
  const double* const* turned = mirroredBack(numIndices, block);
  for (const Run& run : runs_) addRun(run, onlyDiagonal, turned);
}

void AssembledMatrix::sendGhostRows() {
  if (comm_.size() == 1) return;
  const int scale = static_cast<int>(pairs());
  const std::size_t ranks = graph_.sentEntries.size();
  std::vector<int> sent(ranks), sentStart(ranks), received(ranks), receivedStart(ranks);
  int nSent = 0, nReceived = 0;
  for (std::size_t rank = 0; rank < ranks; ++rank) {
    sent[rank] = graph_.sentEntries[rank] * scale;
    received[rank] = graph_.receivedEntries[rank] * scale;
    sentStart[rank] = nSent;
    receivedStart[rank] = nReceived;
    nSent += sent[rank];
    nReceived += received[rank];
  }
  std::vector<double> incoming(static_cast<std::size_t>(nReceived));
  MPI_Alltoallv(ghostValues_.data(), sent.data(), sentStart.data(), MPI_DOUBLE, incoming.data(), received.data(),
                receivedStart.data(), MPI_DOUBLE, comm_.mpi());
  const double* value = incoming.data();
  for (std::size_t r = 0; r < graph_.receivedRows.size(); ++r) {
    const PointRow target = row(graph_.receivedRows[r]);
    for (int c = 0; c < kept_; ++c)
      for (std::size_t k = graph_.receivedRowStart[r]; k < graph_.receivedRowStart[r + 1]; ++k) {
        double* out = entry(target, c, target.columns + graph_.receivedPositions[k], 0);
        for (int d = 0; d < kept_; ++d) out[d] += *value++;
      }
  }
  std::fill(ghostValues_.begin(), ghostValues_.end(), 0.0);
}

/// 1 in the columns of constrained degrees of freedom, those of other ranks included.
Teuchos::RCP<tpetra::MultiVector> AssembledMatrix::eliminatedColumns(const std::vector<char>& isConstrained) const {
  const auto rows = Teuchos::rcp(new tpetra::MultiVector(matrix_->getDomainMap(), 1));
  {
    const auto out = rows->getDataNonConst(0);
    for (int point = 0; point < graph_.nOwned; ++point)
      for (int c = 0; c < kept_; ++c)
        out[point * kept_ + c] = isConstrained[static_cast<std::size_t>(point * width_ + c)] ? 1.0 : 0.0;
  }
  const auto import = matrix_->getGraph()->getImporter();
  if (import.is_null()) return rows;
  const auto columns = Teuchos::rcp(new tpetra::MultiVector(matrix_->getColMap(), 1));
  columns->doImport(*rows, *import, Tpetra::INSERT);
  return columns;
}

void AssembledMatrix::eliminate(const std::vector<char>& isConstrained) {
  const auto columns = eliminatedColumns(isConstrained);
  const auto isEliminated = columns->getData(0);  // owned rows come first among the columns
  for (int point = 0; point < graph_.nOwned; ++point) {
    const PointRow target = row(point);
    double* value = target.values;
    for (int c = 0; c < kept_; ++c) {
      const bool isIdentity = isEliminated[point * kept_ + c] != 0.0;
      for (std::size_t k = 0; k < target.degree; ++k)
        for (int d = 0; d < kept_; ++d, ++value) {
          if (isIdentity)
            *value = target.columns[k] == point && d == c ? 1.0 : 0.0;
          else if (isEliminated[target.columns[k] * kept_ + d] != 0.0)
            *value = 0.0;
        }
    }
  }
}

void AssembledMatrix::finish(const std::vector<char>& isConstrained) {
  sendGhostRows();
  eliminate(isConstrained);
  graphIsTooSmall_ = comm_.any(graphIsTooSmall_);
}

double& AssembledMatrix::ownEntry(int ownedPoint, int component, int columnComponent) {
  const PointRow target = row(ownedPoint);
  const int* place = std::lower_bound(target.columns, target.columns + target.degree, ownedPoint);
  return *entry(target, component, place, columnComponent);
}

void AssembledMatrix::addValue(int globalRow, int globalColumn, double value) {
  const Place rowPlace = placeOf(globalRow), columnPlace = placeOf(globalColumn);
  const int column = graph_.columnOfPoint[static_cast<std::size_t>(columnPlace.point)];
  const PointRow target = row(rowPlace.point);
  const int* place = std::lower_bound(target.columns, target.columns + target.degree, column);
  const bool isMissing = place == target.columns + target.degree || *place != column;
  const auto add = [&](int c, int d, double share) {
    if (c >= kept_ || d >= kept_ || share == 0.0) return;
    if (!isMissing)
      *entry(target, c, place, d) += share;
    else
      graphIsTooSmall_ = true;
  };
  const int rowComponent = globalRow % width_, columnComponent = globalColumn % width_;
  if (width_ != 3 || (rowPlace.copy == 0 && columnPlace.copy == 0)) return add(rowComponent, columnComponent, value);
  const Symmetry::Matrix &left = symmetry_.matrix(rowPlace.copy), &right = symmetry_.matrix(columnPlace.copy);
  for (int c = 0; c < 3; ++c)
    for (int d = 0; d < 3; ++d)
      add(c, d,
          left[static_cast<std::size_t>(3 * c + rowComponent)] * value *
              right[static_cast<std::size_t>(3 * columnComponent + d)]);
}

Teuchos::RCP<tpetra::MultiVector> AssembledMatrix::vectorOf(const double* full) const {
  const auto vector = Teuchos::rcp(new tpetra::MultiVector(matrix_->getRowMap(), 1));
  const auto out = vector->getDataNonConst(0);
  for (int point = 0; point < graph_.nOwned; ++point)
    for (int c = 0; c < kept_; ++c) out[point * kept_ + c] = full[point * width_ + c];
  return vector;
}

void AssembledMatrix::copyBack(const tpetra::MultiVector& vector, const double* droppedFrom, double* full) const {
  const auto in = vector.getData(0);
  for (int point = 0; point < graph_.nOwned; ++point) {
    for (int c = 0; c < kept_; ++c) full[point * width_ + c] = in[point * kept_ + c];
    for (int c = kept_; c < width_; ++c) full[point * width_ + c] = droppedFrom[point * width_ + c];
  }
}

}  // namespace pd
