#include "absolute_row_sums.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace pd {

AbsoluteRowSums::AbsoluteRowSums(const Model& model)
    : model_(model),
      overlap_(model.blocks()->front().getDataManager()->getOverlapScalarPointMap()),
      ownBlock_(9 * static_cast<std::size_t>(overlap_->NumMyElements()), 0.0),
      otherSum_(3 * static_cast<std::size_t>(overlap_->NumMyElements()), 0.0) {}

AbsoluteRowSums::Run AbsoluteRowSums::runFrom(int first, int numIndices, const int* globalIndices) const {
  int last = first + 1;
  while (last < numIndices && globalIndices[last] / 3 == globalIndices[first] / 3) ++last;
  return {first, last, overlap_->LID(globalIndices[first] / 3)};
}

/// The block of one point's rows and one point's columns, as it is where the row is that of what an image mirrors.
void AbsoluteRowSums::addMirrored(const Run& rows, const Run& columns, const int* globalIndices,
                                  const double* const* values) {
  const Discretization& points = model_.discretization();
  const Symmetry::Matrix& left = points.symmetry.matrix(points.copyOf(rows.point));
  const Symmetry::Matrix& right = points.symmetry.matrix(columns.point < 0 ? 0 : points.copyOf(columns.point));
  for (std::size_t c = 0; c < 3; ++c)
    for (std::size_t d = 0; d < 3; ++d) {
      double value = 0.0;
      for (int i = rows.first; i < rows.last; ++i)
        for (int j = columns.first; j < columns.last; ++j)
          value += left[3 * c + static_cast<std::size_t>(globalIndices[i] % 3)] * values[i][j] *
                   right[3 * static_cast<std::size_t>(globalIndices[j] % 3) + d];
      const std::size_t entry = 3 * static_cast<std::size_t>(points.sourceOf(rows.point)) + c;
      if (columns.point == rows.point)
        ownBlock_[3 * entry + d] += value;
      else
        otherSum_[entry] += std::abs(value);
    }
}

void AbsoluteRowSums::addRun(const Run& rows, int numIndices, const int* globalIndices, const double* const* values) {
  for (int i = rows.first; i < rows.last; ++i) {
    const double* row = values[i];
    double sum = 0.0;
    for (int j = 0; j < rows.first; ++j) sum += std::abs(row[j]);
    for (int j = rows.last; j < numIndices; ++j) sum += std::abs(row[j]);
    const std::size_t entry = 3 * static_cast<std::size_t>(rows.point) + static_cast<std::size_t>(globalIndices[i] % 3);
    otherSum_[entry] += sum;
    for (int j = rows.first; j < rows.last; ++j)
      ownBlock_[3 * entry + static_cast<std::size_t>(globalIndices[j] % 3)] += row[j];
  }
}

void AbsoluteRowSums::addValue(int globalRow, int globalCol, double value) {
  const Run row{0, 1, overlap_->LID(globalRow / 3)}, column{1, 2, overlap_->LID(globalCol / 3)};
  if (row.point < 0) return;
  const int indices[] = {globalRow, globalCol};
  const double padded[] = {0.0, value};
  const double* const values[] = {padded, padded};
  addMirrored(row, column, indices, values);
}

void AbsoluteRowSums::addValues(int numIndices, const int* globalIndices, const double* const* values) {
  const bool hasImages = !model_.discretization().symmetry.empty();
  for (int first = 0, last = 0; first < numIndices; first = last) {
    const Run rows = runFrom(first, numIndices, globalIndices);
    last = rows.last;
    if (rows.point < 0) continue;
    if (!hasImages) {
      addRun(rows, numIndices, globalIndices, values);
      continue;
    }
    for (int j = 0; j < numIndices;) {
      const Run columns = runFrom(j, numIndices, globalIndices);
      addMirrored(rows, columns, globalIndices, values);
      j = columns.last;
    }
  }
}

void AbsoluteRowSums::addBlockDiagonalValues(int numIndices, const int* globalIndices, const double* const* values) {
  for (int i = 0; i < numIndices; ++i)
    for (int j = 0; j < numIndices; ++j)
      if (globalIndices[i] / 3 == globalIndices[j] / 3) addValue(globalIndices[i], globalIndices[j], values[i][j]);
}

void AbsoluteRowSums::putScalar(double value) {
  std::fill(ownBlock_.begin(), ownBlock_.end(), value);
  std::fill(otherSum_.begin(), otherSum_.end(), std::abs(value));
}

std::vector<double> AbsoluteRowSums::ownedSums() const {
  std::vector<double> blocks(ownBlock_), sums(otherSum_);
  model_.exchange().exportAdd(blocks.data(), 9, std::nullopt);
  model_.exchange().exportAdd(sums.data(), 3, std::nullopt);
  sums.resize(3 * static_cast<std::size_t>(model_.nOwned()));
  for (std::size_t row = 0; row < sums.size(); ++row)
    for (std::size_t k = 0; k < 3; ++k) sums[row] += std::abs(blocks[3 * row + k]);
  return sums;
}

}  // namespace pd
