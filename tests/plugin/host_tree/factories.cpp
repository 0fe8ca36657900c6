#include "factories.hpp"

#include "registry/peridigm_factories.hpp"

Teuchos::RCP<PeridigmNS::Material> createMaterial(const Teuchos::ParameterList& params) {
  const auto name = params.get<std::string>("Material Model");
  if (pd::MaterialRegistry::self().has(name)) return pd::MaterialRegistry::self().create(name, params);
  return Teuchos::null;
}

Teuchos::RCP<PeridigmNS::DamageModel> createDamageModel(const Teuchos::ParameterList& params) {
  const auto name = params.get<std::string>("Damage Model");
  if (pd::DamageModelRegistry::self().has(name)) return pd::keptDamageModel(name, params);
  return Teuchos::null;
}

// As Peridigm's ComputeManager: one `compute` for all names, set where the host has a class of that name.
std::vector<Teuchos::RCP<PeridigmNS::Compute>> createComputes(const std::vector<std::string>& names) {
  std::vector<Teuchos::RCP<PeridigmNS::Compute>> computes;
  Teuchos::RCP<PeridigmNS::Compute> compute;
  for (const std::string& name : names) {
    if (name == "Kinetic_Energy") {
      compute = Teuchos::rcp(new HostCompute);
      computes.push_back(compute);
    }
    pd::createUnknownCompute(name, Teuchos::null, Teuchos::null, Teuchos::null, compute, computes);
  }
  return computes;
}
