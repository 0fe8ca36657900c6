#include "compact_jacobian.hpp"

#include <algorithm>
#include <cmath>

namespace pd {

namespace {

/// Of a row's diagonal, below which entries of farther points are small.
constexpr double smallShare = 0.02;

}  // namespace

void PointUnknowns::number(Model& model, const std::vector<double>& isFreeHere) {
  const Discretization& mesh = model.discretization();
  if (localId.empty()) {
    localId.assign(static_cast<std::size_t>(mesh.nGlobal), -1);
    for (int i = 0; i < mesh.firstImage(); ++i)
      localId[static_cast<std::size_t>(mesh.globalIds[static_cast<std::size_t>(i)])] = i;
  }
  const auto own = static_cast<long long>(mesh.nOwned);
  MPI_Exscan(&own, &first, 1, MPI_LONG_LONG, MPI_SUM, model.comm().mpi());
  if (model.comm().isRoot()) first = 0;
  column.assign(static_cast<std::size_t>(mesh.nPoints), 0.0);
  isFree.assign(column.size(), 0.0);
  for (std::size_t i = 0; i < static_cast<std::size_t>(mesh.nOwned); ++i) {
    column[i] = static_cast<double>(first) + static_cast<double>(i);
    isFree[i] = isFreeHere[i];
  }
  model.exchange().import(column.data(), 1, Reflection::Even);
  model.exchange().import(isFree.data(), 1, Reflection::Even);
}

CompactJacobian::CompactJacobian(const PointUnknowns& unknowns, const Discretization& mesh, double reach)
    : unknowns_(unknowns), mesh_(mesh), reach_(reach), rows_(static_cast<std::size_t>(mesh.nOwned)) {}

/// Images count as what they mirror.
int CompactJacobian::localOf(int globalId) const {
  return unknowns_.localId[static_cast<std::size_t>(globalId % mesh_.nGlobal)];
}

double CompactJacobian::squareOf(int point, int other) const {
  const double *a = &mesh_.x[3 * static_cast<std::size_t>(point)], *b = &mesh_.x[3 * static_cast<std::size_t>(other)];
  return (b[0] - a[0]) * (b[0] - a[0]) + (b[1] - a[1]) * (b[1] - a[1]) + (b[2] - a[2]) * (b[2] - a[2]);
}

void CompactJacobian::addValue(int globalRow, int globalColumn, double value) {
  const int point = localOf(globalRow), other = localOf(globalColumn);
  const auto i = static_cast<std::size_t>(point), j = static_cast<std::size_t>(other);
  if (unknowns_.isFree[i] == 0.0 || unknowns_.isFree[j] == 0.0 || value == 0.0) return;
  if (point >= mesh_.nOwned) {
    foreign_.insert(foreign_.end(), {unknowns_.column[i], unknowns_.column[j], value});
    return;
  }
  Row& row = rows_[i];
  if (point == other) {
    row.diagonal += value;
    return;
  }
  const auto column = static_cast<long long>(unknowns_.column[j]);
  if (globalColumn >= mesh_.nGlobal)
    row.near.push_back({-1, column, value});
  else if (std::isinf(reach_) ||
           squareOf(point, other) < std::pow(reach_ * std::pow(mesh_.volume[i], 1.0 / mesh_.dimension), 2))
    row.near.push_back({other, column, value});
  else
    row.far.push_back({other, static_cast<float>(value)});
}

void CompactJacobian::addValues(int n, const int* ids, const double* const* values) {
  for (int a = 0; a < n; ++a)
    for (int b = 0; b < n; ++b) addValue(ids[a], ids[b], values[a][b]);
}

void CompactJacobian::addForeign(const Communicator& comm) {
  const std::vector<double> all = comm.gather(foreign_);
  const auto first = static_cast<double>(unknowns_.first), end = first + static_cast<double>(rows_.size());
  for (std::size_t k = 0; k < all.size(); k += 3)
    if (all[k] >= first && all[k] < end) {
      Row& row = rows_[static_cast<std::size_t>(all[k] - first)];
      if (all[k] == all[k + 1])
        row.diagonal += all[k + 2];
      else
        row.near.push_back({-1, static_cast<long long>(all[k + 1]), all[k + 2]});
    }
}

void CompactJacobian::makeCompact(std::size_t r) {
  Row& row = rows_[r];
  const int point = static_cast<int>(r);
  const double large = smallShare * std::abs(row.diagonal);
  double squares = 0.0, moment = 0.0, sum = 0.0;
  std::vector<int> nearest;
  for (const Near& entry : row.near)
    if (entry.point >= 0) nearest.push_back(entry.point);
  std::sort(nearest.begin(), nearest.end());
  nearest.erase(std::unique(nearest.begin(), nearest.end()), nearest.end());
  for (const int other : nearest) squares += squareOf(point, other);
  const auto keep = [&](int other, double value) {
    row.near.push_back({other, static_cast<long long>(unknowns_.column[static_cast<std::size_t>(other)]), value});
  };
  for (const Far& entry : row.far) {
    if (squares == 0.0 || std::abs(entry.value) > large) {
      keep(entry.point, entry.value);
      continue;
    }
    moment += entry.value * squareOf(point, entry.point);
    sum += entry.value;
  }
  row.far = {};
  if (moment == 0.0) return;
  for (const int other : nearest) keep(other, moment / squares);
  row.diagonal += sum - static_cast<double>(nearest.size()) * moment / squares;
}

SparseRows CompactJacobian::finish(const Communicator& comm, const std::vector<double>& factor,
                                   const std::vector<double>& diagonal) {
  addForeign(comm);
  SparseRows result;
  std::vector<std::pair<long long, double>> entries;
  for (std::size_t r = 0; r < rows_.size(); ++r) {
    makeCompact(r);
    entries.clear();
    for (const Near& entry : rows_[r].near) entries.emplace_back(entry.column, factor[r] * entry.value);
    entries.emplace_back(unknowns_.first + static_cast<long long>(r), factor[r] * rows_[r].diagonal + diagonal[r]);
    result.addRow(entries);
    rows_[r] = {};
  }
  return result;
}

}  // namespace pd
