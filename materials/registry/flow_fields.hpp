// Fields of flows that materials, computes and solvers share.
#ifndef PD_FLOW_FIELDS_HPP
#define PD_FLOW_FIELDS_HPP

#include "fields.hpp"

namespace pd::fields {

inline FieldDescription viscosity() {
  return pointScalar("Viscosity", "Pa s", "Dynamic viscosity; 0 where no material is a fluid.");
}
inline FieldDescription fluidShare() {
  return pointScalar("Fluid", "1", "1 at points of the flow, 0 beyond its walls, inlets and outflows.");
}

}  // namespace pd::fields

#endif
