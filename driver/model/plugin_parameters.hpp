// What the driver hands to a plug-in's constructor, made from the deck and the plug-in's declarations.
#ifndef PD_PLUGIN_PARAMETERS_HPP
#define PD_PLUGIN_PARAMETERS_HPP

#include <Teuchos_ParameterList.hpp>
#include <string>

#include "../deck/deck.hpp"

namespace pd {

/// The deck's list `node` of a plug-in, converted and completed by `declarations`, with the entries of `injected`
/// that the plug-in declares. An injected key must not stand in the deck. `kindKey` ("Material Model", "Damage Model",
/// "Compute Class") names the plug-in; it is handed over only if it is declared. Throws DeckError.
Teuchos::ParameterList pluginParameters(const DeckNode& node, const ParameterDeclarations& declarations,
                                        const std::string& kindKey, const Teuchos::ParameterList& injected);

}  // namespace pd

#endif
