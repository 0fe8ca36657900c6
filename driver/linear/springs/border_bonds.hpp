// Bonds to points of other ranks and to images, as the lists of their other ends have them.
#ifndef PD_BORDER_BONDS_HPP
#define PD_BORDER_BONDS_HPP

#include <cstddef>
#include <vector>

#include "../../discretization/point_exchange.hpp"

namespace pd {

/// The bonds of owned points that lead to ghosts and images, in the order in which they come in the neighbourhoods. The
/// other end of one has it in its own list, on its rank, unless horizons differ.
class BorderBonds {
 public:
  /// Collective, as the rest.
  BorderBonds(const Communicator& comm, const PointExchange& exchange, const Discretization& points);

  /// Whether each is in the list of its other end, on all ranks.
  bool areMutual() const { return areMutual_; }
  /// Where they are mutual: of values [bonds, in the order of the discretization] those of the other ends, one for each
  /// border bond.
  std::vector<double> ofOtherEnds(const std::vector<double>& ofBonds) const;

 private:
  /// For each rank, entries that it is sent or sends: how many, and from where on.
  struct Shares {
    std::vector<int> counts, starts;
    explicit Shares(const std::vector<int>& countOfRank);
    std::size_t total() const { return static_cast<std::size_t>(starts.back() + counts.back()); }
  };

  const Communicator& comm_;
  std::vector<std::size_t> place_;   ///< [border bonds] among the values that other ranks send
  std::vector<std::size_t> served_;  ///< bonds whose values other ranks want, rank after rank
  Shares wanted_, given_;
  bool areMutual_ = true;
};

}  // namespace pd

#endif
