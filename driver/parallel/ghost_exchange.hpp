// Movement of point data between the owner of a point and the ranks that hold it as a ghost.
#ifndef PD_GHOST_EXCHANGE_HPP
#define PD_GHOST_EXCHANGE_HPP

#include <memory>
#include <vector>

#include "communicator.hpp"

namespace pd {

/// Arrays are over the overlap (owned points first, then ghosts), `width` values a point, point after point.
/// Implemented with one Tpetra import object over the owned and the overlap map. On one rank both calls do nothing.
class GhostExchange {
 public:
  /// `globalIds`: of owned points, of which there are nOwned, and ghosts. Collective.
  GhostExchange(const Communicator& comm, const std::vector<int>& globalIds, int nOwned);
  ~GhostExchange();

  /// Overwrites ghosts with their owners' values.
  void import(double* values, int width) const;
  /// Adds ghosts' values to their owners'; ghosts are left as they were.
  void exportAdd(double* values, int width) const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace pd

#endif
