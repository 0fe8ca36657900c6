// What a host with cycles of load tells damage models of them, and what they answer: one number each for the whole body
// or a point, so that neither knows the other.
#ifndef PD_CYCLE_FIELDS_HPP
#define PD_CYCLE_FIELDS_HPP

#include "fields.hpp"

namespace pd::fields {

// Of the host. Bonds are seen at the load of the conditions, which the cycles are multiples of.
inline FieldDescription cycleIncrement() { return globalScalar("Cycle_Increment", "1", "Cycles of load in the step."); }
inline FieldDescription loadRange() {
  return globalScalar("Load_Range", "1",
                      "Largest less smallest load of a cycle, in parts of the load of the conditions.");
}
inline FieldDescription peakLoad() {
  return globalScalar("Peak_Load", "1", "Largest load of a cycle, in parts of the load of the conditions.");
}

// Of the damage model.
inline FieldDescription lifeLossRate() {
  return pointScalar("Life_Loss_Rate", "1",
                     "Largest part of its remaining life that an unbroken bond of the point loses in a cycle.");
}
inline FieldDescription overdrawnLife() {
  return pointScalar("Overdrawn_Life", "1",
                     "Largest part of a life by which cycles of the step came after a bond of the point had failed.");
}
inline FieldDescription lifeLeft() {
  return pointScalar("Life_Left", "1",
                     "Of bonds of the point that cycles of the step broke: the sum of what was left of their lives.");
}
inline FieldDescription rateOfFailed() {
  return pointScalar("Rate_Of_Failed", "1",
                     "Of the same bonds: the sum of the parts of their lives that a cycle takes.");
}
inline FieldDescription overdrawRate() {
  return pointScalar("Overdraw_Rate", "1",
                     "Of the same bonds: the largest part that a cycle takes of what one has until it is overdrawn by "
                     "the Life Tolerance.");
}

}  // namespace pd::fields

#endif
