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

/// Sum of Bond_Damage over the directed bonds of all ranks: it grows whenever a bond breaks. Collective.
double totalBondDamage(Model& model);

}  // namespace pd

#endif
