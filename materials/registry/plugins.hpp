// The registries of the plug-in kinds that Peridigm knows.
#ifndef PD_PLUGINS_HPP
#define PD_PLUGINS_HPP

#include "Peridigm_Compute.hpp"
#include "Peridigm_DamageModel.hpp"
#include "Peridigm_Material.hpp"
#include "registry.hpp"

namespace pd {

using MaterialRegistry = PluginRegistry<PeridigmNS::Material, const Teuchos::ParameterList&>;
using DamageModelRegistry = PluginRegistry<PeridigmNS::DamageModel, const Teuchos::ParameterList&>;
using ComputeRegistry = PluginRegistry<PeridigmNS::Compute, Teuchos::RCP<const Teuchos::ParameterList>,
                                       Teuchos::RCP<const Epetra_Comm>, Teuchos::RCP<const Teuchos::ParameterList>>;

}  // namespace pd

#define PD_REGISTER_MATERIAL(Class, Name, Brief) PD_REGISTER(pd::MaterialRegistry, Class, Name, Brief)
#define PD_REGISTER_DAMAGE_MODEL(Class, Name, Brief) PD_REGISTER(pd::DamageModelRegistry, Class, Name, Brief)
#define PD_REGISTER_COMPUTE(Class, Name, Brief) PD_REGISTER(pd::ComputeRegistry, Class, Name, Brief)

#endif
