#include "bond_order.hpp"

#include <algorithm>
#include <numeric>

namespace pd {

using namespace PeridigmNS;

RowRange consecutiveRows(const Communicator& comm, long long count) {
  RowRange rows;
  rows.count = count;
  MPI_Exscan(&count, &rows.first, 1, MPI_LONG_LONG, MPI_SUM, comm.mpi());
  if (comm.isRoot()) rows.first = 0;  // MPI leaves it undefined there
  rows.total = comm.sum(count);
  return rows;
}

BondOrder::BondOrder(Model& model, const GlobalOrder& order) : model_(model), order_(order) {
  const Discretization& points = model.discretization();
  sortedPlace_.resize(static_cast<std::size_t>(points.nBonds()));
  for (int i = 0; i < points.nOwned; ++i) {
    const int* list = points.neighborhoodList.data() + points.neighborhoodStart[static_cast<std::size_t>(i)];
    const int count = *list++;
    const auto globalId = [&](int n) { return points.globalIds[static_cast<std::size_t>(list[n])]; };
    std::vector<int> sorted(static_cast<std::size_t>(count));
    std::iota(sorted.begin(), sorted.end(), 0);
    std::sort(sorted.begin(), sorted.end(), [&](int a, int b) { return globalId(a) < globalId(b); });
    const std::size_t first = neighbors_.size();
    for (const int n : sorted) {
      sortedPlace_[first + static_cast<std::size_t>(n)] = static_cast<int>(neighbors_.size());
      neighbors_.push_back(globalId(n));
    }
    counts_.push_back(count);
  }
  rowCounts_ = order_.toRows(counts_.data(), 1);
  bondRows_ = consecutiveRows(order_.comm(), std::accumulate(rowCounts_.begin(), rowCounts_.end(), 0LL));
}

std::vector<int> BondOrder::neighborRows() const { return order_.listsToRows(neighbors_, counts_, rowCounts_); }

double* BondOrder::blockValues(Block& block, int fieldId) const {
  const bool isConstant = FieldManager::self().getFieldSpec(fieldId).temporal == PeridigmField::CONSTANT;
  const PeridigmField::Step step = isConstant ? PeridigmField::STEP_NONE : PeridigmField::STEP_NP1;
  if (!block.hasData(fieldId, step)) return nullptr;
  double* values = nullptr;
  block.getData(fieldId, step)->ExtractView(&values);
  return values;
}

template <class Visit>
void BondOrder::forEachBond(int fieldId, int width, const Visit& visit) const {
  const Discretization& points = model_.discretization();
  for (Block& block : *model_.blocks()) {
    double* values = blockValues(block, fieldId);
    if (values == nullptr) continue;
    const auto neighborhood = block.getNeighborhoodData();
    for (int k = 0; k < neighborhood->NumOwnedPoints(); ++k) {
      const auto point = static_cast<std::size_t>(neighborhood->OwnedIDs()[k]);
      // Bonds are numbered as the list without the counts that stand before each point's neighbours.
      const auto first = static_cast<std::size_t>(points.neighborhoodStart[point]) - point;
      for (std::size_t n = 0; n < static_cast<std::size_t>(counts_[point]); ++n, values += width)
        visit(values, static_cast<std::size_t>(sortedPlace_[first + n]));
    }
  }
}

namespace {

std::vector<int> times(std::vector<int> counts, int width) {
  for (int& count : counts) count *= width;
  return counts;
}

}  // namespace

std::vector<double> BondOrder::toRows(int fieldId, int width) const {
  std::vector<double> sorted(neighbors_.size() * static_cast<std::size_t>(width), 0.0);
  forEachBond(fieldId, width, [&](const double* values, std::size_t place) {
    std::copy(values, values + width, sorted.data() + place * static_cast<std::size_t>(width));
  });
  return order_.listsToRows(sorted, times(counts_, width), times(rowCounts_, width));
}

void BondOrder::fromRows(const std::vector<double>& rowValues, int fieldId, int width) const {
  const std::vector<double> sorted = order_.listsToPoints(rowValues, times(rowCounts_, width), times(counts_, width));
  forEachBond(fieldId, width, [&](double* values, std::size_t place) {
    const double* stored = sorted.data() + place * static_cast<std::size_t>(width);
    std::copy(stored, stored + width, values);
  });
}

bool BondOrder::isSame(const std::vector<int>& rowCounts, const std::vector<int>& neighborRows) const {
  const Communicator& comm = order_.comm();
  if (comm.any(rowCounts != rowCounts_)) return false;
  return !comm.any(neighborRows != this->neighborRows());
}

}  // namespace pd
