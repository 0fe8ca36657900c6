// Declarations made from those of other plug-ins, for solvers that are made of parts.
#ifndef PD_SOLVER_DECLARATIONS_HPP
#define PD_SOLVER_DECLARATIONS_HPP

#include <string>
#include <vector>

#include "../../materials/registry/parameters.hpp"

namespace pd {

/// Adds the parameters, sub-lists and rules of `from` to `to`, but for those named in `except` (rules that mention one
/// are left out too). What `to` has already is kept; std::logic_error where the two differ in type or default.
void addDeclarations(ParameterDeclarations& to, const ParameterDeclarations& from,
                     const std::vector<std::string>& except = {});

/// The entries of `given` that `declarations` knows.
Teuchos::ParameterList entriesKnownTo(const ParameterDeclarations& declarations, const Teuchos::ParameterList& given);

/// Two names of one key: ours and Peridigm's.
template <class T>
T either(const Teuchos::ParameterList& parameters, const char* name, const char* peridigmName, T fallback) {
  if (parameters.isParameter(name)) return parameters.get<T>(name);
  if (parameters.isParameter(peridigmName)) return parameters.get<T>(peridigmName);
  return fallback;
}

}  // namespace pd

#endif
