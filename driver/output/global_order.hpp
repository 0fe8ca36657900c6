// Point data in the order of global ids, so that files do not depend on the number of ranks.
#ifndef PD_GLOBAL_ORDER_HPP
#define PD_GLOBAL_ORDER_HPP

#include <vector>

#include "../parallel/communicator.hpp"

namespace pd {

/// Consecutive rows of a table that this rank holds.
struct RowRange {
  long long first = 0;
  long long count = 0;
  long long total = 0;  ///< rows of the whole table
};

/// Moves data between the ranks' own numbering of points and rows in the order of global ids 0 .. nGlobal-1, of
/// which each rank holds a consecutive range. All calls are collective; T is double, int or long long.
class GlobalOrder {
 public:
  /// `globalIds`: of the local points, of which the first nOwned are owned. Throws RunError on all ranks unless the
  /// owned ids of all ranks are 0 .. nGlobal-1, each once.
  GlobalOrder(const Communicator& comm, const std::vector<int>& globalIds, int nOwned, long long nGlobal);

  const RowRange& rows() const { return rows_; }
  const Communicator& comm() const { return comm_; }

  /// Rows of this rank from `values` [width nOwned].
  template <class T>
  std::vector<T> toRows(const T* values, int width) const;
  /// Owned points' values [width nOwned] from rows of this rank [width rows().count].
  template <class T>
  void toPoints(const std::vector<T>& rowValues, int width, T* values) const;

  /// The same for lists of differing lengths, one a point, stored one after another: `counts` holds the lengths in the
  /// order of owned points, `rowCounts` in the order of rows.
  template <class T>
  std::vector<T> listsToRows(const std::vector<T>& values, const std::vector<int>& counts,
                             const std::vector<int>& rowCounts) const;
  template <class T>
  std::vector<T> listsToPoints(const std::vector<T>& rowValues, const std::vector<int>& rowCounts,
                               const std::vector<int>& counts) const;

 private:
  // One point (or row) after another, in the order of the message, with how many go to or come from each rank.
  struct Side {
    std::vector<int> order;
    std::vector<int> pointsOfRank;
  };
  // From one side's order to the other's: `width` values a point, or lists of differing lengths.
  template <class T>
  void move(const T* values, int width, const Side& from, const Side& to, T* result) const;
  template <class T>
  std::vector<T> moveLists(const std::vector<T>& values, const std::vector<int>& counts, const Side& from,
                           const std::vector<int>& countsThere, const Side& to) const;
  template <class T>
  std::vector<T> exchange(const std::vector<T>& sent, const std::vector<int>& lengths,
                          const std::vector<int>& lengthsThere) const;

  const Communicator& comm_;
  RowRange rows_;
  Side points_, rowSide_;
};

}  // namespace pd

#endif
