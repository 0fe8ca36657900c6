#include "point_graph.hpp"

#include <Teuchos_DefaultMpiComm.hpp>
#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <unordered_map>

#include "methods/tpetra_types.hpp"

namespace pd {

namespace {

/// Lists of different lengths, one after another.
struct Lists {
  std::vector<std::size_t> start{0};
  std::vector<int> items;

  const int* begin(int list) const { return items.data() + start[static_cast<std::size_t>(list)]; }
  const int* end(int list) const { return items.data() + start[static_cast<std::size_t>(list) + 1]; }
};

/// Each owned point with its neighbours (of images what they mirror), the point first.
Lists familiesOf(const Discretization& discretization) {
  Lists families;
  families.items.reserve(discretization.neighborhoodList.size());
  const int* list = discretization.neighborhoodList.data();
  for (int point = 0; point < discretization.nOwned; ++point) {
    const int count = *list++;
    families.items.push_back(point);
    for (int k = 0; k < count; ++k) families.items.push_back(discretization.sourceOf(list[k]));
    families.start.push_back(families.items.size());
    list += count;
  }
  return families;
}

/// For each local point, the owned points in whose families it is.
Lists centresOf(const Lists& families, int nOwned, int nPoints) {
  Lists centres;
  centres.start.assign(static_cast<std::size_t>(nPoints) + 1, 0);
  for (const int member : families.items) ++centres.start[static_cast<std::size_t>(member) + 1];
  std::partial_sum(centres.start.begin(), centres.start.end(), centres.start.begin());
  centres.items.resize(families.items.size());
  std::vector<std::size_t> next(centres.start.begin(), centres.start.end() - 1);
  for (int centre = 0; centre < nOwned; ++centre)
    for (const int* member = families.begin(centre); member != families.end(centre); ++member)
      centres.items[next[static_cast<std::size_t>(*member)]++] = centre;
  return centres;
}

/// Points (local ids, ascending) that this rank couples to `point`.
class RowBuilder {
 public:
  RowBuilder(const Discretization& discretization, bool couplesFamilies)
      : families_(familiesOf(discretization)),
        centres_(centresOf(families_, discretization.nOwned, discretization.firstImage())),
        isIn_(static_cast<std::size_t>(discretization.firstImage()), 0),
        nOwned_(discretization.nOwned),
        couplesFamilies_(couplesFamilies) {}

  const std::vector<int>& row(int point) {
    row_.clear();
    add(point);
    if (point < nOwned_) addFamily(point);
    for (const int* centre = centres_.begin(point); centre != centres_.end(point); ++centre) {
      if (couplesFamilies_)
        addFamily(*centre);
      else
        add(*centre);
    }
    for (const int member : row_) isIn_[static_cast<std::size_t>(member)] = 0;
    return row_;
  }

 private:
  void add(int point) {
    if (isIn_[static_cast<std::size_t>(point)]) return;
    isIn_[static_cast<std::size_t>(point)] = 1;
    row_.push_back(point);
  }
  void addFamily(int centre) {
    for (const int* member = families_.begin(centre); member != families_.end(centre); ++member) add(*member);
  }

  Lists families_, centres_;
  std::vector<char> isIn_;
  std::vector<int> row_;
  int nOwned_;
  bool couplesFamilies_;
};

/// Sends list `r` of `sent` to rank r; returns what the ranks sent here, and how much from each.
std::vector<long long> exchange(const Communicator& comm, const std::vector<std::vector<long long>>& sent,
                                std::vector<int>& receivedCounts) {
  const std::size_t ranks = sent.size();
  std::vector<int> sentCounts(ranks), sentStart(ranks), receivedStart(ranks);
  receivedCounts.assign(ranks, 0);
  std::vector<long long> outgoing;
  for (std::size_t rank = 0; rank < ranks; ++rank) {
    sentCounts[rank] = static_cast<int>(sent[rank].size());
    sentStart[rank] = static_cast<int>(outgoing.size());
    outgoing.insert(outgoing.end(), sent[rank].begin(), sent[rank].end());
  }
  MPI_Alltoall(sentCounts.data(), 1, MPI_INT, receivedCounts.data(), 1, MPI_INT, comm.mpi());
  int total = 0;
  for (std::size_t rank = 0; rank < ranks; ++rank) {
    receivedStart[rank] = total;
    total += receivedCounts[rank];
  }
  std::vector<long long> received(static_cast<std::size_t>(total));
  MPI_Alltoallv(outgoing.data(), sentCounts.data(), sentStart.data(), MPI_LONG_LONG, received.data(),
                receivedCounts.data(), receivedStart.data(), MPI_LONG_LONG, comm.mpi());
  return received;
}

/// Matrix numbers of all local points, and the owners of ghosts.
struct Numbering {
  std::vector<long long> numbers;  ///< [nPoints]
  std::vector<int> ownerOfGhost;   ///< [nPoints - nOwned]
};

Numbering numberPoints(const Communicator& comm, const Discretization& discretization, long long firstNumber) {
  const int nOwned = discretization.nOwned, nGhosts = discretization.firstImage() - nOwned;
  Numbering result;
  result.numbers.resize(static_cast<std::size_t>(discretization.firstImage()));
  result.ownerOfGhost.assign(static_cast<std::size_t>(nGhosts), comm.rank());
  std::iota(result.numbers.begin(), result.numbers.begin() + nOwned, firstNumber);
  if (comm.size() == 1) return result;

  std::vector<long long> firstNumbers(static_cast<std::size_t>(comm.size()));
  MPI_Allgather(&firstNumber, 1, MPI_LONG_LONG, firstNumbers.data(), 1, MPI_LONG_LONG, comm.mpi());
  const std::vector<long long> ids(discretization.globalIds.begin(), discretization.globalIds.end());
  const Teuchos::ArrayView<const long long> all(ids.data(), static_cast<Teuchos::Ordinal>(ids.size()));
  const tpetra::Map owned(Teuchos::OrdinalTraits<Tpetra::global_size_t>::invalid(), all.view(0, nOwned), 0,
                          Teuchos::rcp(new Teuchos::MpiComm<int>(comm.mpi())));
  std::vector<int> places(static_cast<std::size_t>(nGhosts));
  owned.getRemoteIndexList(all.view(nOwned, nGhosts), Teuchos::ArrayView<int>(result.ownerOfGhost),
                           Teuchos::ArrayView<int>(places));
  for (int ghost = 0; ghost < nGhosts; ++ghost) {
    const int owner = result.ownerOfGhost[static_cast<std::size_t>(ghost)];
    if (owner < 0) throw std::logic_error("a ghost point has no owner");
    result.numbers[static_cast<std::size_t>(nOwned + ghost)] =
        firstNumbers[static_cast<std::size_t>(owner)] + places[static_cast<std::size_t>(ghost)];
  }
  return result;
}

/// Ghosts in the order of their owners' ranks: the order of the ghost rows.
std::vector<int> ghostsByOwner(const Numbering& numbering, int nOwned) {
  std::vector<int> order(numbering.ownerOfGhost.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
    return numbering.ownerOfGhost[static_cast<std::size_t>(a)] < numbering.ownerOfGhost[static_cast<std::size_t>(b)];
  });
  for (int& ghost : order) ghost += nOwned;
  return order;
}

/// Rows of ghosts that other ranks fill, as [matrix number of the row, number of columns, columns...].
std::vector<long long> receiveGhostRows(const Communicator& comm, const Numbering& numbering, RowBuilder& rows,
                                        const std::vector<int>& ghosts, int nOwned, PointGraph& graph) {
  std::vector<std::vector<long long>> sent(static_cast<std::size_t>(comm.size()));
  graph.sentEntries.assign(sent.size(), 0);
  // The order of columns on this rank: owned points first.
  const auto comesFirst = [first = graph.firstNumber, last = graph.firstNumber + nOwned](long long a, long long b) {
    const bool aIsOther = a < first || a >= last, bIsOther = b < first || b >= last;
    return aIsOther != bIsOther ? bIsOther : a < b;
  };
  for (const int ghost : ghosts) {
    const auto owner = static_cast<std::size_t>(numbering.ownerOfGhost[static_cast<std::size_t>(ghost - nOwned)]);
    std::vector<long long> columns;
    for (const int column : rows.row(ghost)) columns.push_back(numbering.numbers[static_cast<std::size_t>(column)]);
    std::sort(columns.begin(), columns.end(), comesFirst);
    sent[owner].push_back(numbering.numbers[static_cast<std::size_t>(ghost)]);
    sent[owner].push_back(static_cast<long long>(columns.size()));
    sent[owner].insert(sent[owner].end(), columns.begin(), columns.end());
    graph.sentEntries[owner] += static_cast<int>(columns.size());
  }
  std::vector<int> counts;
  std::vector<long long> received = exchange(comm, sent, counts);
  graph.receivedEntries.assign(counts.size(), 0);
  std::size_t place = 0, end = 0;
  for (std::size_t rank = 0; rank < counts.size(); ++rank) {
    for (end += static_cast<std::size_t>(counts[rank]); place < end; place += 2 + received[place + 1])
      graph.receivedEntries[rank] += static_cast<int>(received[place + 1]);
  }
  return received;
}

using ColumnOfNumber = std::unordered_map<long long, int>;

/// Columns: owned points, then every other point that this rank's rows are coupled to, by matrix number.
ColumnOfNumber numberColumns(const Numbering& numbering, const std::vector<long long>& received, PointGraph& graph) {
  const long long first = graph.firstNumber, last = first + graph.nOwned;
  std::vector<long long> others(numbering.numbers.begin() + graph.nOwned, numbering.numbers.end());
  for (std::size_t place = 0; place < received.size(); place += 2 + received[place + 1])
    for (std::size_t k = 0; k < static_cast<std::size_t>(received[place + 1]); ++k) {
      const long long number = received[place + 2 + k];
      if (number < first || number >= last) others.push_back(number);
    }
  std::sort(others.begin(), others.end());
  others.erase(std::unique(others.begin(), others.end()), others.end());
  graph.columnNumbers.assign(numbering.numbers.begin(), numbering.numbers.begin() + graph.nOwned);
  graph.columnNumbers.insert(graph.columnNumbers.end(), others.begin(), others.end());

  ColumnOfNumber columnOfNumber;
  columnOfNumber.reserve(graph.columnNumbers.size());
  for (std::size_t column = 0; column < graph.columnNumbers.size(); ++column)
    columnOfNumber.emplace(graph.columnNumbers[column], static_cast<int>(column));
  graph.columnOfPoint.reserve(numbering.numbers.size());
  for (const long long number : numbering.numbers) graph.columnOfPoint.push_back(columnOfNumber.at(number));
  return columnOfNumber;
}

/// Received rows in terms of local columns.
void translateReceived(const std::vector<long long>& received, const ColumnOfNumber& columnOfNumber,
                       PointGraph& graph) {
  graph.receivedRowStart.push_back(0);
  for (std::size_t place = 0; place < received.size();) {
    graph.receivedRows.push_back(static_cast<int>(received[place] - graph.firstNumber));
    const auto count = static_cast<std::size_t>(received[place + 1]);
    for (std::size_t k = 0; k < count; ++k)
      graph.receivedPositions.push_back(columnOfNumber.at(received[place + 2 + k]));
    graph.receivedRowStart.push_back(graph.receivedPositions.size());
    place += 2 + count;
  }
}

void mergeOwnedRows(RowBuilder& rows, PointGraph& graph) {
  std::vector<std::vector<std::size_t>> receivedOf(static_cast<std::size_t>(graph.nOwned));
  for (std::size_t row = 0; row < graph.receivedRows.size(); ++row)
    receivedOf[static_cast<std::size_t>(graph.receivedRows[row])].push_back(row);
  graph.rowStart.push_back(0);
  std::vector<int> merged;
  for (int point = 0; point < graph.nOwned; ++point) {
    merged.clear();
    for (const int other : rows.row(point)) merged.push_back(graph.columnOfPoint[static_cast<std::size_t>(other)]);
    for (const std::size_t row : receivedOf[static_cast<std::size_t>(point)])
      merged.insert(merged.end(),
                    graph.receivedPositions.begin() + static_cast<std::ptrdiff_t>(graph.receivedRowStart[row]),
                    graph.receivedPositions.begin() + static_cast<std::ptrdiff_t>(graph.receivedRowStart[row + 1]));
    std::sort(merged.begin(), merged.end());
    merged.erase(std::unique(merged.begin(), merged.end()), merged.end());
    graph.columns.insert(graph.columns.end(), merged.begin(), merged.end());
    graph.rowStart.push_back(graph.columns.size());
  }
}

/// Turns the received columns into places in the merged rows.
void placeReceived(PointGraph& graph) {
  for (std::size_t row = 0; row < graph.receivedRows.size(); ++row) {
    const auto point = static_cast<std::size_t>(graph.receivedRows[row]);
    const auto begin = graph.columns.begin() + static_cast<std::ptrdiff_t>(graph.rowStart[point]);
    const auto end = graph.columns.begin() + static_cast<std::ptrdiff_t>(graph.rowStart[point + 1]);
    for (std::size_t k = graph.receivedRowStart[row]; k < graph.receivedRowStart[row + 1]; ++k)
      graph.receivedPositions[k] = static_cast<int>(std::lower_bound(begin, end, graph.receivedPositions[k]) - begin);
  }
}

}  // namespace

PointGraph makePointGraph(const Communicator& comm, const Discretization& discretization, bool couplesFamilies) {
  PointGraph graph;
  graph.nOwned = discretization.nOwned;
  graph.nPoints = discretization.firstImage();
  const long long nOwned = graph.nOwned;
  MPI_Exscan(&nOwned, &graph.firstNumber, 1, MPI_LONG_LONG, MPI_SUM, comm.mpi());
  if (comm.isRoot()) graph.firstNumber = 0;
  graph.nGlobal = comm.sum(nOwned);

  const Numbering numbering = numberPoints(comm, discretization, graph.firstNumber);
  const std::vector<int> ghosts = ghostsByOwner(numbering, graph.nOwned);
  RowBuilder rows(discretization, couplesFamilies);
  const std::vector<long long> received = receiveGhostRows(comm, numbering, rows, ghosts, graph.nOwned, graph);
  const ColumnOfNumber columnOfNumber = numberColumns(numbering, received, graph);
  translateReceived(received, columnOfNumber, graph);
  mergeOwnedRows(rows, graph);
  placeReceived(graph);

  graph.ghostRowOfPoint.assign(static_cast<std::size_t>(graph.nPoints), -1);
  graph.ghostRowStart.push_back(0);
  for (std::size_t row = 0; row < ghosts.size(); ++row) {
    graph.ghostRowOfPoint[static_cast<std::size_t>(ghosts[row])] = static_cast<int>(row);
    for (const int other : rows.row(ghosts[row]))
      graph.ghostColumns.push_back(graph.columnOfPoint[static_cast<std::size_t>(other)]);
    std::sort(graph.ghostColumns.begin() + static_cast<std::ptrdiff_t>(graph.ghostRowStart.back()),
              graph.ghostColumns.end());
    graph.ghostRowStart.push_back(graph.ghostColumns.size());
  }
  return graph;
}

}  // namespace pd
