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

/// Where a host has planes of symmetry: the global id of an image less that of the point that it mirrors; 0 of points.
constexpr const char* imageShiftField = "Image_Shift";

}  // namespace pd

#endif
