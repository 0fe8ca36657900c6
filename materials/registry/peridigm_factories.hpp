// What Peridigm's factories call for the names that they do not know, where the registries alone do not do.
#ifndef PD_PERIDIGM_FACTORIES_HPP
#define PD_PERIDIGM_FACTORIES_HPP

#include <string>
#include <utility>
#include <vector>

#include "plugins.hpp"

namespace pd {

/// The damage model called `name`. Peridigm's Verlet asks for it anew in every step; a damage model has no state but
/// caches, so the one that was made of equal parameters serves, and its caches last. Throws std::invalid_argument where
/// `params` are wrong.
inline Teuchos::RCP<PeridigmNS::DamageModel> keptDamageModel(const std::string& name,
                                                             const Teuchos::ParameterList& params) {
  static std::vector<std::pair<Teuchos::ParameterList, Teuchos::RCP<PeridigmNS::DamageModel>>> kept;
  for (const auto& [knownParams, model] : kept)
    if (knownParams == params) return model;
  const auto made = DamageModelRegistry::self().create(name, params);
  kept.emplace_back(params, made);
  return made;
}

/// Appends the compute called `name` to `computes`, unless the host has just made one of its own, which `made` then
/// points to. Null again on return, `made` is ready for the next name. A name that nobody knows is that of a plain
/// output variable. Throws std::invalid_argument where `params` are wrong.
inline void createUnknownCompute(const std::string& name, Teuchos::RCP<const Teuchos::ParameterList> params,
                                 Teuchos::RCP<const Epetra_Comm> comm,
                                 Teuchos::RCP<const Teuchos::ParameterList> globalData,
                                 Teuchos::RCP<PeridigmNS::Compute>& made,
                                 std::vector<Teuchos::RCP<PeridigmNS::Compute>>& computes) {
  const auto& registry = ComputeRegistry::self();
  if (made.is_null() && registry.has(name)) computes.push_back(registry.create(name, params, comm, globalData));
  made = Teuchos::null;
}

}  // namespace pd

#endif
