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
/// Where a solver has it: what a flow carries is linear in the scalar, with the derivatives at these values of it.
inline FieldDescription limitedAt(const std::string& label) {
  return pointScalar(label + "_Limited_At", unitOfDeck, "Values at which slopes of what a flow carries are limited.");
}
/// Of bonds that begin at a point of the flow.
inline FieldDescription bondFlow() {
  FieldDescription field = bondScalar(
      "Bond_Flow", "1/s", "Volume that moves along the bond from its point, per second and volume of the point.");
  field.temporal = PeridigmNS::PeridigmField::CONSTANT;
  return field.state();
}
inline FieldDescription bondOpening() {
  FieldDescription field = bondScalar(
      "Bond_Opening", "1", "Share of the bond up to a wall; 1 within the flow, 0 beyond an outflow and at metal.");
  field.temporal = PeridigmNS::PeridigmField::CONSTANT;
  return field.state();
}

}  // namespace pd::fields

#endif
