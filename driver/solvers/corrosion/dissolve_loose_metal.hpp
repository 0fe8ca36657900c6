// Points of dissolving metal that hang by no bond any more.
#ifndef PD_DISSOLVE_LOOSE_METAL_HPP
#define PD_DISSOLVE_LOOSE_METAL_HPP

#include <string>
#include <vector>

#include "../../model/model.hpp"

namespace pd {

/// Points that field Loose marks dissolve before those around them: of the metal that a step has taken from solid
/// points of their block in their neighbourhood, as much as they still have above saturation is taken from them
/// instead. What has dissolved remains the same, and no point holds more than before the step. Call it with phases and
/// ghosts up to date; leaves them so. `before`: the concentration before the step, [nOwned]. Does nothing where no
/// plug-in has such a field. Collective.
void dissolveLooseMetalFirst(Model& model, const std::string& concentrationField, const std::vector<double>& before,
                             double dt);

}  // namespace pd

#endif
