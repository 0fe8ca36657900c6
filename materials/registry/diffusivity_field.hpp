// The diffusivity of the points of all blocks, as a field: a plug-in sees its neighbours in other blocks, but not their
// materials.
#ifndef PD_DIFFUSIVITY_FIELD_HPP
#define PD_DIFFUSIVITY_FIELD_HPP

#include <string>

#include "fields.hpp"

namespace pd {

inline const std::string diffusivitySuffix = "_Diffusivity";

/// Of the scalar called `label`; 0 where it does not diffuse. A material writes its own as it is initialized; parts of
/// a block that have one scalar in common have the sum, as their rates add up.
inline FieldDescription diffusivityOf(const std::string& label) {
  return fields::pointScalar(label + diffusivitySuffix, "m2/s", "Diffusivity of " + label + ".");
}

inline bool isDiffusivity(const FieldDescription& field) {
  const std::string& label = field.label;
  return label.size() > diffusivitySuffix.size() &&
         label.compare(label.size() - diffusivitySuffix.size(), std::string::npos, diffusivitySuffix) == 0;
}

}  // namespace pd

#endif
