// The critical time step by Peridigm's rule, for decks that were written for it.
#ifndef PD_BULK_MODULUS_STEP_HPP
#define PD_BULK_MODULUS_STEP_HPP

#include "../model/model.hpp"

namespace pd {

/// min over points of sqrt(2 rho / sum_j c V_j / |xi_j|) with the prototype microelastic brittle constant
/// c = 18 K / (pi delta^4) of three dimensions (Silling & Askari, Comput. Struct. 83 (2005) 1526), as Peridigm takes it
/// for every material. Seconds; infinity where no point has a neighbour. Collective.
double bulkModulusCriticalStep(Model& model);

}  // namespace pd

#endif
