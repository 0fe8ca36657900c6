// The factories of the small host.
#ifndef HOST_FACTORIES_HPP
#define HOST_FACTORIES_HPP

#include <string>
#include <vector>

#include "Peridigm_Compute.hpp"
#include "Peridigm_DamageModel.hpp"
#include "Peridigm_Material.hpp"

/// Null where nobody knows the "Material Model" or "Damage Model".
Teuchos::RCP<PeridigmNS::Material> createMaterial(const Teuchos::ParameterList& params);
Teuchos::RCP<PeridigmNS::DamageModel> createDamageModel(const Teuchos::ParameterList& params);
/// One compute for each name that somebody knows. The host itself knows Kinetic_Energy.
std::vector<Teuchos::RCP<PeridigmNS::Compute>> createComputes(const std::vector<std::string>& names);

/// The host's own compute.
struct HostCompute : PeridigmNS::Compute {
  HostCompute() : Compute(Teuchos::null, Teuchos::null, Teuchos::null) {}
  std::vector<int> FieldIds() const override { return {}; }
  int compute(Teuchos::RCP<std::vector<PeridigmNS::Block>>) const override { return 0; }
};

#endif
