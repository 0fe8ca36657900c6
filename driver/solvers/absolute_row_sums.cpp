#include "absolute_row_sums.hpp"

#include <algorithm>
#include <cmath>

#include "../parallel/ghost_exchange.hpp"

namespace pd {

AbsoluteRowSums::AbsoluteRowSums(const PeridigmNS::PointMap& overlap)
    : overlap_(overlap),
      ownBlock_(9 * static_cast<std::size_t>(overlap.NumMyElements()), 0.0),
      otherSum_(3 * static_cast<std::size_t>(overlap.NumMyElements()), 0.0) {}

void AbsoluteRowSums::add(int point, int component, int globalCol, int globalPoint, double value) {
  const std::size_t row = 3 * static_cast<std::size_t>(point) + static_cast<std::size_t>(component);
  if (globalCol / 3 == globalPoint)
    ownBlock_[3 * row + static_cast<std::size_t>(globalCol % 3)] += value;
  else
    otherSum_[row] += std::abs(value);
}

void AbsoluteRowSums::addValue(int globalRow, int globalCol, double value) {
  const int point = overlap_.LID(globalRow / 3);
  if (point >= 0) add(point, globalRow % 3, globalCol, globalRow / 3, value);
}

void AbsoluteRowSums::addValues(int numIndices, const int* globalIndices, const double* const* values) {
  for (int i = 0; i < numIndices; ++i) {
    const int globalPoint = globalIndices[i] / 3, point = overlap_.LID(globalPoint);
    if (point < 0) continue;
    for (int j = 0; j < numIndices; ++j) add(point, globalIndices[i] % 3, globalIndices[j], globalPoint, values[i][j]);
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
