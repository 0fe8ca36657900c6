// Which points of a dissolving body take part: the liquid ones, and the solid ones next to them.
#ifndef PD_PHASE_LISTS_HPP
#define PD_PHASE_LISTS_HPP

#include <vector>

#include "../../model/model.hpp"

namespace pd {

/// Kept up to date point by point, so that what a step costs does not depend on how much intact solid there is. Points
/// of blocks that do not dissolve (Saturation_Concentration 0) are in no list.
class PhaseLists {
 public:
  /// Looks at all points (field Damage, ghosts included; 1 is liquid).
  void reset(Model& model);
  /// Takes up points that have turned liquid since: points of dissolving() and ghosts alone can have. Returns the
  /// points that are new in dissolving().
  std::vector<int> update(Model& model);

  const std::vector<int>& liquid() const { return liquid_; }          ///< owned points, local ids that rise
  const std::vector<int>& dissolving() const { return dissolving_; }  ///< owned solid points with a liquid neighbour

 private:
  enum class State : char { Wall, Intact, Dissolving, Liquid };
  void markNeighborsOf(const Discretization& d, int point);

  std::vector<State> state_;                   ///< by local id
  std::vector<std::vector<int>> aroundGhost_;  ///< owned points around each ghost
  std::vector<int> liquid_, dissolving_;
};

}  // namespace pd

#endif
