// What a spring contributes to the families of its ends.
#ifndef PD_SPRING_MEASURE_HPP
#define PD_SPRING_MEASURE_HPP

#include "spring_network.hpp"

namespace pd {

/// xi x eta (Rotation) or xi.eta (Dilatation), the s of a bond, and the gradient of t.s by eta.
template <int D, SpringNetwork::Family family>
struct SpringMeasure {
  using Family = SpringNetwork::Family;
  static constexpr int width = family == Family::None ? 0 : (family == Family::Rotation && D == 3 ? 3 : 1);

  template <class V, class W>
  static void add(const W* xi, const V* eta, V* s) {
    if constexpr (family == Family::Dilatation) {
      for (int d = 0; d < D; ++d) s[0] += xi[d] * eta[d];
    } else if constexpr (family == Family::Rotation && D == 2) {
      s[0] += xi[0] * eta[1] - xi[1] * eta[0];
    } else if constexpr (family == Family::Rotation && D == 3) {
      s[0] += xi[1] * eta[2] - xi[2] * eta[1];
      s[1] += xi[2] * eta[0] - xi[0] * eta[2];
      s[2] += xi[0] * eta[1] - xi[1] * eta[0];
    }
  }
  template <class V, class W>
  static void addGradient(const W* xi, const V* t, V* force) {
    if constexpr (family == Family::Dilatation) {
      for (int d = 0; d < D; ++d) force[d] += xi[d] * t[0];
    } else if constexpr (family == Family::Rotation && D == 2) {
      force[0] -= xi[1] * t[0];
      force[1] += xi[0] * t[0];
    } else if constexpr (family == Family::Rotation && D == 3) {
      force[0] += t[1] * xi[2] - t[2] * xi[1];
      force[1] += t[2] * xi[0] - t[0] * xi[2];
      force[2] += t[0] * xi[1] - t[1] * xi[0];
    }
  }
};

}  // namespace pd

#endif
