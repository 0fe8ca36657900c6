// Places in a body, and what geometry asks of them.
#ifndef PD_DECOMPOSITION_PLACES_HPP
#define PD_DECOMPOSITION_PLACES_HPP

#include <array>
#include <cmath>

namespace pd::decomposition {

using Place = std::array<double, 3>;  ///< m; z is 0 in a plane

inline double dot(const Place& a, const Place& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline double lengthOf(const Place& a) { return std::sqrt(dot(a, a)); }
inline Place minus(const Place& a, const Place& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
/// a + factor b
inline Place plus(const Place& a, const Place& b, double factor = 1.0) {
  return {a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2]};
}
inline Place crossed(const Place& a, const Place& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

}  // namespace pd::decomposition

#endif
