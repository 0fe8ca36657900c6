#include "absolute_row_sums.hpp"

#include <algorithm>
#include <cmath>

#include "../parallel/ghost_exchange.hpp"

namespace pd {

AbsoluteRowSums::AbsoluteRowSums(const PeridigmNS::PointMap& overlap)
    : overlap_(overlap),
      ownBlock_(9 * static_cast<std::size_t>(overlap.NumMyElements()), 0.0),
      otherSum_(3 * static_cast<std::size_t>(overlap.NumMyElements()), 0.0) {}

void AbsoluteRowSums::addValue(int globalRow, int globalCol, double value) {
  const int point = overlap_.LID(globalRow / 3);
  if (point < 0) return;
  const std::size_t entry = 3 * static_cast<std::size_t>(point) + static_cast<std::size_t>(globalRow % 3);
  if (globalCol / 3 == globalRow / 3)
    ownBlock_[3 * entry + static_cast<std::size_t>(globalCol % 3)] += value;
  else
    otherSum_[entry] += std::abs(value);
}

void AbsoluteRowSums::addValues(int numIndices, const int* globalIndices, const double* const* values) {
  const auto pointOf = [&](int index) { return globalIndices[index] / 3; };
  for (int first = 0, last = 0; first < numIndices; first = last) {
    // A run of indices of one point: the columns in which its rows couple it to itself.
    while (last < numIndices && pointOf(last) == pointOf(first)) ++last;
    const int point = overlap_.LID(pointOf(first));
    if (point < 0) continue;
    for (int i = first; i < last; ++i) {
      const double* row = values[i];
      double sum = 0.0;
      for (int j = 0; j < first; ++j) sum += std::abs(row[j]);
      for (int j = last; j < numIndices; ++j) sum += std::abs(row[j]);
      const std::size_t entry = 3 * static_cast<std::size_t>(point) + static_cast<std::size_t>(globalIndices[i] % 3);
      otherSum_[entry] += sum;
      for (int j = first; j < last; ++j)
        ownBlock_[3 * entry + static_cast<std::size_t>(globalIndices[j] % 3)] += row[j];
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

std::vector<double> AbsoluteRowSums::ownedSums(const Model& model) const {
  std::vector<double> blocks(ownBlock_), sums(otherSum_);
  if (model.comm().size() > 1) {
    const GhostExchange ghosts(model.comm(), model.discretization().globalIds, model.nOwned());
    ghosts.exportAdd(blocks.data(), 9);
    ghosts.exportAdd(sums.data(), 3);
  }
  sums.resize(3 * static_cast<std::size_t>(model.nOwned()));
  for (std::size_t row = 0; row < sums.size(); ++row)
    for (std::size_t k = 0; k < 3; ++k) sums[row] += std::abs(blocks[3 * row + k]);
  return sums;
}

}  // namespace pd
