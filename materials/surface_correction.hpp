// The field by which materials stiffen bonds near free surfaces, and what others make of it.
#ifndef PD_SURFACE_CORRECTION_HPP
#define PD_SURFACE_CORRECTION_HPP

#include "fields.hpp"

namespace pd {

/// Of the energy method; the bulk of a lattice, whose stiffness is not quite that of the integrals, is corrected, too.
inline FieldDescription surfaceCorrectionFactor() {
  return fields::pointVector("Surface_Correction_Factor", "1",
                             "Stiffness along each axis of the bulk over that of the point.")
      .reflected(Reflection::Even);
}

}  // namespace pd

#endif
