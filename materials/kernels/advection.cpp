#include "advection.hpp"

namespace pd::kernels {

CarriedValue upwindBiasedValue(double upwind, double downwind, double share) {
  const double ofDownwind = 0.5 * (1.0 - share);
  return {upwind + ofDownwind * (downwind - upwind), 1.0 - ofDownwind, ofDownwind, 0.0};
}

CarriedValue limitedValue(double far, double upwind, double downwind) {
  const double behind = upwind - far, ahead = downwind - upwind, both = behind + ahead;
  if (!(behind * ahead > 0.0)) return {upwind, 1.0, 0.0, 0.0};
  const double ofBehind = ahead / both, ofAhead = behind / both;  // derivatives of the mean are their squares
  return {upwind + behind * ofBehind, 1.0 + ofBehind * ofBehind - ofAhead * ofAhead, ofAhead * ofAhead,
          -ofBehind * ofBehind};
}

}  // namespace pd::kernels
