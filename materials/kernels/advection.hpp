// What a flow carries of a scalar from one end of a bond to the other.
#ifndef PD_ADVECTION_HPP
#define PD_ADVECTION_HPP

namespace pd::kernels {

/// The value that a bond carries, and its derivatives by what it is made of.
struct CarriedValue {
  double value, byUpwind, byDownwind, byFar;
};

/// Of the end that the flow comes from (upwind), with `share` 1 or more; between that and the mean of both ends.
CarriedValue upwindBiasedValue(double upwind, double downwind, double share);

/// Of second order where the scalar is smooth, of the first at its extremes: with `far` the value as far upwind of the
/// upwind end as the downwind end is downwind, a = upwind - far and b = downwind - upwind, upwind + a b/(a + b) where a
/// and b have one sign, else upwind (van Leer's limiter, J. Comput. Phys. 14 (1974) 361). Then
///   value - upwind = p (upwind - far),  value - upwind = q (downwind - upwind)   with 0 <= p <= 1, 0 <= q <= 1,
/// so that a point's rate is a sum of non-negative multiples of differences to others wherever flows are balanced, if
/// `far` lies between values of its neighbours: no value passes those around it (Jameson, Int. J. Comput. Fluid Dyn. 4
/// (1995) 171).
CarriedValue limitedValue(double far, double upwind, double downwind);

}  // namespace pd::kernels

#endif
