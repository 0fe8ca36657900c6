// Field labels that plug-ins and hosts must agree on beyond Peridigm's own.
#ifndef PD_FIELD_NAMES_HPP
#define PD_FIELD_NAMES_HPP

#include <string>

namespace pd {

/// The field that computeFluxDivergence adds to for the scalar field that it advances: the rate of `field`, so that
/// d(field)/dt = flux divergence. Peridigm's ImplicitDiffusion pairs Temperature with Flux_Divergence.
inline std::string fluxDivergenceField(const std::string& field) {
  return field == "Temperature" ? "Flux_Divergence" : field + "_Flux_Divergence";
}

}  // namespace pd

#endif
