// Whether damage has changed since somebody last looked.
#ifndef PD_DAMAGE_WATCH_HPP
#define PD_DAMAGE_WATCH_HPP

#include <vector>

#include "../model/model.hpp"

namespace pd {

/// Points whose Damage changes from one look to the next.
class DamageMonitor {
 public:
  /// Remembers the present damage.
  void remember(Model& model);
  /// How many points (all ranks) differ from what was remembered; remembers the new state. Collective.
  long long countChanged(Model& model);

 private:
  std::vector<double> damage_;
};

/// Sum of Bond_Damage over the directed bonds of all ranks: it grows whenever a bond breaks.
class BondDamageSum {
 public:
  /// Reads the bonds of points whose Damage is another than when it was last asked for. Collective.
  double of(Model& model);

 private:
  std::vector<double> seen_, sums_;  ///< [nOwned] Damage, and the sum over the point's bonds
};

}  // namespace pd

#endif
