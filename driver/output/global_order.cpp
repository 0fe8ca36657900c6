#include "global_order.hpp"

#include <algorithm>
#include <numeric>

#include "../model/model.hpp"

namespace pd {

namespace {

MPI_Datatype typeOf(double) { return MPI_DOUBLE; }
MPI_Datatype typeOf(int) { return MPI_INT; }
MPI_Datatype typeOf(long long) { return MPI_LONG_LONG; }

long long firstRow(long long nGlobal, int rank, int nRanks) { return nGlobal * rank / nRanks; }

std::vector<int> startsOf(const std::vector<int>& counts) {
  std::vector<int> starts(counts.size() + 1, 0);
  std::partial_sum(counts.begin(), counts.end(), starts.begin() + 1);
  return starts;
}

std::vector<std::size_t> listStarts(const std::vector<int>& counts) {
  std::vector<std::size_t> starts(counts.size() + 1, 0);
  for (std::size_t i = 0; i < counts.size(); ++i) starts[i + 1] = starts[i] + static_cast<std::size_t>(counts[i]);
  return starts;
}

}  // namespace

GlobalOrder::GlobalOrder(const Communicator& comm, const std::vector<int>& globalIds, int nOwned, long long nGlobal)
    : comm_(comm) {
  rows_.first = firstRow(nGlobal, comm.rank(), comm.size());
  rows_.count = firstRow(nGlobal, comm.rank() + 1, comm.size()) - rows_.first;
  rows_.total = nGlobal;

  // Sorted by global id, points are sorted by the rank that holds their row, too.
  points_.order.resize(static_cast<std::size_t>(nOwned));
  std::iota(points_.order.begin(), points_.order.end(), 0);
  std::sort(points_.order.begin(), points_.order.end(), [&](int a, int b) {
    return globalIds[static_cast<std::size_t>(a)] < globalIds[static_cast<std::size_t>(b)];
  });
  std::vector<int> sentIds;
  for (const int point : points_.order) sentIds.push_back(globalIds[static_cast<std::size_t>(point)]);
  points_.pointsOfRank.assign(static_cast<std::size_t>(comm.size()), 0);
  bool isInRange = true;
  int rank = 0;
  for (const int id : sentIds) {
    isInRange = isInRange && id >= 0 && id < nGlobal;
    while (rank + 1 < comm.size() && id >= firstRow(nGlobal, rank + 1, comm.size())) ++rank;
    ++points_.pointsOfRank[static_cast<std::size_t>(rank)];
  }
  rowSide_.pointsOfRank.resize(static_cast<std::size_t>(comm.size()));
  MPI_Alltoall(points_.pointsOfRank.data(), 1, MPI_INT, rowSide_.pointsOfRank.data(), 1, MPI_INT, comm.mpi());

  const std::vector<int> sendStarts = startsOf(points_.pointsOfRank), receiveStarts = startsOf(rowSide_.pointsOfRank);
  std::vector<int> receivedIds(static_cast<std::size_t>(receiveStarts.back()));
  MPI_Alltoallv(sentIds.data(), points_.pointsOfRank.data(), sendStarts.data(), MPI_INT, receivedIds.data(),
                rowSide_.pointsOfRank.data(), receiveStarts.data(), MPI_INT, comm.mpi());
  std::vector<char> isThere(static_cast<std::size_t>(rows_.count), 0);
  bool isComplete = isInRange && receivedIds.size() == isThere.size();
  for (const int id : receivedIds) {
    const long long row = id - rows_.first;
    rowSide_.order.push_back(static_cast<int>(row));
    if (row >= 0 && row < rows_.count)
      isThere[static_cast<std::size_t>(row)] = 1;
    else
      isComplete = false;
  }
  isComplete = isComplete && std::find(isThere.begin(), isThere.end(), 0) == isThere.end();
  if (comm.any(!isComplete)) throw RunError("global ids of the points are not 0 .. n-1, each on one rank");
}

/// What the ranks send to this one, from what it sends to them: as much as `lengths` and `lengthsThere` say.
template <class T>
std::vector<T> GlobalOrder::exchange(const std::vector<T>& sent, const std::vector<int>& lengths,
                                     const std::vector<int>& lengthsThere) const {
  const std::vector<int> starts = startsOf(lengths), startsThere = startsOf(lengthsThere);
  std::vector<T> received(static_cast<std::size_t>(startsThere.back()));
  MPI_Alltoallv(sent.data(), lengths.data(), starts.data(), typeOf(T()), received.data(), lengthsThere.data(),
                startsThere.data(), typeOf(T()), comm_.mpi());
  return received;
}

template <class T>
void GlobalOrder::move(const T* values, int width, const Side& from, const Side& to, T* result) const {
  const auto lengthsOfRanks = [&](const Side& side) {
    std::vector<int> lengths = side.pointsOfRank;
    for (int& length : lengths) length *= width;
    return lengths;
  };
  std::vector<T> sent(from.order.size() * static_cast<std::size_t>(width));
  auto end = sent.begin();
  for (const int i : from.order) end = std::copy_n(values + static_cast<std::ptrdiff_t>(i) * width, width, end);
  const std::vector<T> received = exchange(sent, lengthsOfRanks(from), lengthsOfRanks(to));
  const T* next = received.data();
  for (const int i : to.order) {
    std::copy_n(next, width, result + static_cast<std::ptrdiff_t>(i) * width);
    next += width;
  }
}

template <class T>
std::vector<T> GlobalOrder::moveLists(const std::vector<T>& values, const std::vector<int>& counts, const Side& from,
                                      const std::vector<int>& countsThere, const Side& to) const {
  const auto lengthsOfRanks = [](const Side& side, const std::vector<int>& lengths) {
    std::vector<int> result;
    std::size_t next = 0;
    for (const int nPoints : side.pointsOfRank) {
      int sum = 0;
      for (int i = 0; i < nPoints; ++i) sum += lengths[static_cast<std::size_t>(side.order[next++])];
      result.push_back(sum);
    }
    return result;
  };
  const std::vector<std::size_t> starts = listStarts(counts), startsThere = listStarts(countsThere);
  std::vector<T> sent, result(startsThere.back());
  sent.reserve(values.size());
  for (const int i : from.order)
    sent.insert(sent.end(), values.begin() + static_cast<std::ptrdiff_t>(starts[static_cast<std::size_t>(i)]),
                values.begin() + static_cast<std::ptrdiff_t>(starts[static_cast<std::size_t>(i) + 1]));
  const std::vector<T> received = exchange(sent, lengthsOfRanks(from, counts), lengthsOfRanks(to, countsThere));
  auto next = received.begin();
  for (const int i : to.order) {
    const auto count = static_cast<std::ptrdiff_t>(countsThere[static_cast<std::size_t>(i)]);
    std::copy(next, next + count,
              result.begin() + static_cast<std::ptrdiff_t>(startsThere[static_cast<std::size_t>(i)]));
    next += count;
  }
  return result;
}

template <class T>
std::vector<T> GlobalOrder::toRows(const T* values, int width) const {
  std::vector<T> rowValues(rowSide_.order.size() * static_cast<std::size_t>(width));
  move(values, width, points_, rowSide_, rowValues.data());
  return rowValues;
}

template <class T>
void GlobalOrder::toPoints(const std::vector<T>& rowValues, int width, T* values) const {
  move(rowValues.data(), width, rowSide_, points_, values);
}

template <class T>
std::vector<T> GlobalOrder::listsToRows(const std::vector<T>& values, const std::vector<int>& counts,
                                        const std::vector<int>& rowCounts) const {
  return moveLists(values, counts, points_, rowCounts, rowSide_);
}

template <class T>
std::vector<T> GlobalOrder::listsToPoints(const std::vector<T>& rowValues, const std::vector<int>& rowCounts,
                                          const std::vector<int>& counts) const {
  return moveLists(rowValues, rowCounts, rowSide_, counts, points_);
}

#define PD_INSTANTIATE(T)                                                                            \
  template std::vector<T> GlobalOrder::toRows(const T*, int) const;                                  \
  template void GlobalOrder::toPoints(const std::vector<T>&, int, T*) const;                         \
  template std::vector<T> GlobalOrder::listsToRows(const std::vector<T>&, const std::vector<int>&,   \
                                                   const std::vector<int>&) const;                   \
  template std::vector<T> GlobalOrder::listsToPoints(const std::vector<T>&, const std::vector<int>&, \
                                                     const std::vector<int>&) const;
PD_INSTANTIATE(double)
PD_INSTANTIATE(int)
PD_INSTANTIATE(long long)
#undef PD_INSTANTIATE

}  // namespace pd
