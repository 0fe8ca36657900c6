// The elastic energy that the materials report: what Strain_Energy, Stored_Elastic_Energy and
// Stored_Elastic_Energy_Density have in common.
#ifndef PD_STORED_ENERGY_HPP
#define PD_STORED_ENERGY_HPP

#include "compute_support.hpp"

namespace pd {

/// Has every material fill Stored_Elastic_Energy_Density (J/m3) at the owned points of its blocks. A material that
/// does not compute it leaves zeros.
inline void fillStoredEnergyDensity(const Blocks& blocks) {
  for (PeridigmNS::Block& block : *blocks) {
    const auto neighborhood = block.getNeighborhoodData();
    block.getMaterialModel()->computeStoredElasticEnergyDensity(
        0.0, neighborhood->NumOwnedPoints(), neighborhood->OwnedIDs(), neighborhood->NeighborhoodList(),
        *block.getDataManager());
  }
}

}  // namespace pd

#endif
