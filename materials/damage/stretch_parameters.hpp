// Keys by which damage models are told the stretch at which a bond breaks.
#ifndef PD_STRETCH_PARAMETERS_HPP
#define PD_STRETCH_PARAMETERS_HPP

#include "parameters.hpp"

namespace pd {

/// Critical Stretch, or Fracture Energy with the constants that it needs.
void declareCriticalStretch(ParameterDeclarations& declare);

/// From a completed list; Fracture Energy by the formulas of kernels::criticalStretch().
double criticalStretchFrom(const Teuchos::ParameterList& params);

}  // namespace pd

#endif
