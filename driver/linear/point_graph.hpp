// Which points are coupled by a matrix, and which ranks contribute to which rows.
#ifndef PD_POINT_GRAPH_HPP
#define PD_POINT_GRAPH_HPP

#include <cstddef>
#include <vector>

#include "../discretization/discretization.hpp"
#include "../parallel/communicator.hpp"

namespace pd {

/// Rows of owned points as they are after all ranks have contributed, and rows of ghosts as this rank fills them.
/// Images have no rows and columns of their own: what they mirror stands for them. Points are numbered anew over all
/// ranks ("matrix numbers"): rank after rank, each in its local order, so that a rank's rows are contiguous. Columns
/// are local indices into `columnNumbers`, ascending in each row.
struct PointGraph {
  int nOwned = 0, nPoints = 0;           ///< nPoints: owned and ghosts
  long long firstNumber = 0;             ///< matrix number of the first owned point
  long long nGlobal = 0;                 ///< points of all ranks
  std::vector<long long> columnNumbers;  ///< matrix numbers: owned points, then all others ascending
  std::vector<int> columnOfPoint;        ///< [nPoints] column of a local point

  std::vector<std::size_t> rowStart;  ///< [nOwned + 1]
  std::vector<int> columns;

  std::vector<int> ghostRowOfPoint;  ///< [nPoints] row of a ghost among the ghost rows; -1 for owned points
  std::vector<std::size_t> ghostRowStart;
  std::vector<int> ghostColumns;

  // Messages that carry ghost rows to their owners: ghost rows are in the order in which they are sent.
  std::vector<int> sentEntries, receivedEntries;  ///< [ranks] (row, column) pairs of points
  std::vector<int> receivedRows;                  ///< owned points, one a received row
  std::vector<std::size_t> receivedRowStart;      ///< [received rows + 1] into receivedPositions
  std::vector<int> receivedPositions;             ///< place of a received entry in its owned row
};

/// The graph of the families: a point is coupled to its neighbours and to the points that have it as a neighbour;
/// with `couplesFamilies`, all points of each family are coupled to each other. Collective.
PointGraph makePointGraph(const Communicator& comm, const Discretization& discretization, bool couplesFamilies);

}  // namespace pd

#endif
