// Points of dissolving metal that hang by no bond any more, and the bonds of a step that is not taken.
#ifndef PD_LOOSE_METAL_HPP
#define PD_LOOSE_METAL_HPP

#include <vector>

#include "../../model/model.hpp"

namespace pd {

/// Points that field Loose marks dissolve before those around them: of the metal that a step has taken from solid
/// points of their block in their neighbourhood, as much as they still have above saturation is taken from them
/// instead. What has dissolved remains the same, and no point holds more than before the step. Call it with phases and
/// ghosts up to date; leaves them so. `before`: Concentration before the step, [nOwned]. Does nothing where no plug-in
/// has such a field. Collective.
void dissolveLooseMetalFirst(Model& model, const std::vector<double>& before, double dt);

/// Bond_Damage and Loose of blocks whose bonds break at random, to be restored where a step is not taken.
class BondsBeforeStep {
 public:
  explicit BondsBeforeStep(Model& model);
  void restore();

 private:
  struct Row {
    std::size_t block, first;    ///< bond within the block
    std::vector<double> damage;  ///< of the bonds
  };
  template <class Visit>
  void forEachPoint(Visit visit);

  Model& model_;
  std::vector<Row> rows_;        ///< of points that have lost some but not all of their bonds
  std::vector<char> wasIntact_;  ///< [nOwned]
  std::vector<double> loose_;    ///< [nOwned]
};

}  // namespace pd

#endif
