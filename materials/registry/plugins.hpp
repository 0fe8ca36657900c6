// The registries of the plug-in kinds that Peridigm knows.
#ifndef PD_PLUGINS_HPP
#define PD_PLUGINS_HPP

#include <Teuchos_Array.hpp>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "Peridigm_Compute.hpp"
#include "Peridigm_DamageModel.hpp"
#include "Peridigm_Material.hpp"
#include "registry.hpp"

namespace pd {

using MaterialRegistry = PluginRegistry<PeridigmNS::Material, const Teuchos::ParameterList&>;
using DamageModelRegistry = PluginRegistry<PeridigmNS::DamageModel, const Teuchos::ParameterList&>;
using ComputeRegistry = PluginRegistry<PeridigmNS::Compute, Teuchos::RCP<const Teuchos::ParameterList>,
                                       Teuchos::RCP<const Epetra_Comm>, Teuchos::RCP<const Teuchos::ParameterList>>;

/// The key by which the parameters of a plug-in name it.
inline const char* modelKey(const MaterialRegistry&) { return "Material Model"; }
inline const char* modelKey(const DamageModelRegistry&) { return "Damage Model"; }

/// Declares a sub-list for each part of a plug-in that combines others. `parts`: name and model of each. Throws
/// std::invalid_argument, naming `owner`.
template <class Registry>
void declareParts(ParameterDeclarations& declare, const Registry& registry,
                  const std::vector<std::pair<std::string, std::string>>& parts, const std::string& owner) {
  for (const auto& [name, model] : parts) {
    const auto* plugin = registry.find(model);
    if (plugin == nullptr || !plugin->partsKey.empty())
      throw std::invalid_argument(owner + ": part \"" + name +
                                  "\": " + (plugin == nullptr ? "unknown " : "parts have no parts, but its ") +
                                  modelKey(registry) + (plugin == nullptr ? "" : " is") + " \"" + model + "\"");
    if (declare.find(name) != nullptr || declare.findSublist(name) != nullptr)
      throw std::invalid_argument(owner + ": \"" + name + "\" is the name of two parts, or of a key; rename one");
    declare.sublist(name, plugin->brief) = plugin->declare();
  }
}

/// Parameters of a plug-in `Class` that combines others, completed with those of its parts.
template <class Class, class Registry>
Teuchos::ParameterList completedParts(const Registry& registry, const Teuchos::ParameterList& given,
                                      const std::string& owner) {
  ParameterDeclarations declarations;
  Class::declareParameters(declarations);
  const std::string key = Class::partsKey;
  std::vector<std::pair<std::string, std::string>> parts;
  if (given.isType<Teuchos::Array<std::string>>(key))
    for (const std::string& name : given.get<Teuchos::Array<std::string>>(key)) {
      const bool hasModel = given.isSublist(name) && given.sublist(name).isType<std::string>(modelKey(registry));
      if (!hasModel)
        throw std::invalid_argument(owner + ": part \"" + name +
                                    "\" needs a list of its own under its name, with a \"" + modelKey(registry) + "\"");
      parts.emplace_back(name, given.sublist(name).template get<std::string>(modelKey(registry)));
    }
  declareParts(declarations, registry, parts, owner);
  return declarations.complete(given, owner);
}

}  // namespace pd

#define PD_REGISTER_MATERIAL(Class, Name, Brief) PD_REGISTER(pd::MaterialRegistry, Class, Name, Brief)
#define PD_REGISTER_DAMAGE_MODEL(Class, Name, Brief) PD_REGISTER(pd::DamageModelRegistry, Class, Name, Brief)
#define PD_REGISTER_COMPUTE(Class, Name, Brief) PD_REGISTER(pd::ComputeRegistry, Class, Name, Brief)

#endif
