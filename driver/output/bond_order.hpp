// The bonds of all ranks in an order that does not depend on the ranks.
#ifndef PD_BOND_ORDER_HPP
#define PD_BOND_ORDER_HPP

#include <string>
#include <vector>

#include "../model/model.hpp"
#include "global_order.hpp"

namespace pd {

/// Directed bonds by the global id of the point that holds them, then of the other end.
class BondOrder {
 public:
  /// Collective.
  BondOrder(Model& model, const GlobalOrder& order);

  /// Neighbours of each row's point, and the global ids of those, for this rank's rows.
  const std::vector<int>& rowCounts() const { return rowCounts_; }
  std::vector<int> neighborRows() const;
  /// This rank's part of a table with a row a bond.
  const RowRange& bondRows() const { return bondRows_; }

  /// Values of a bond field of all blocks in that order [width x bonds of the rank's rows]; zero in blocks without it.
  std::vector<double> toRows(int fieldId, int width) const;
  /// The reverse. Collective.
  void fromRows(const std::vector<double>& rowValues, int fieldId, int width) const;

  /// Whether rows of another run name the same bonds as this model. Same on all ranks. Collective.
  bool isSame(const std::vector<int>& rowCounts, const std::vector<int>& neighborRows) const;

 private:
  double* blockValues(PeridigmNS::Block& block, int fieldId) const;
  /// Calls visit(value of the bond in its block's array, place of the bond in `sorted` order).
  template <class Visit>
  void forEachBond(int fieldId, int width, const Visit& visit) const;

  Model& model_;
  const GlobalOrder& order_;
  std::vector<int> counts_;       ///< neighbours of owned points
  std::vector<int> neighbors_;    ///< their global ids, ascending for each point
  std::vector<int> sortedPlace_;  ///< [bonds] place in `neighbors_` of each bond of the discretization
  std::vector<int> rowCounts_;
  RowRange bondRows_;
};

/// Consecutive ranges of `count` rows of each rank. Collective.
RowRange consecutiveRows(const Communicator& comm, long long count);

}  // namespace pd

#endif
