// The hook of Peridigm's ComputeManager, whose chain of `if`s has no last `else`.
#ifndef PD_UNKNOWN_COMPUTE_HPP
#define PD_UNKNOWN_COMPUTE_HPP

#include <string>
#include <vector>

#include "plugins.hpp"

namespace pd {

/// Appends the compute called `name` of this library to `computes`, unless the host has just made one of its own, which
/// `made` then points to. Null again on return, `made` is ready for the next name. A name that nobody knows is that of
/// a plain output variable. Throws std::invalid_argument where `params` are wrong.
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
