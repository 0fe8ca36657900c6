// Stability of the two-parameter bond model on a given neighbourhood.
#ifndef PD_LATTICE_STABILITY_HPP
#define PD_LATTICE_STABILITY_HPP

#include <array>
#include <vector>

#include "bond_constants.hpp"
#include "two_parameter_bond.hpp"

namespace pd::kernels {

/// A bond of the neighbourhood with its weight g V_j (influence, share of volume, surface factor, volume).
struct WeightedBond {
  std::array<double, 3> xi;
  double weight;
};

/// Smallest eigenvalue, relative to the largest, of the acoustic tensor
///   A(q) = sum_j (1 - cos q.xi) [(k_n - k_t) m m^T + k_t I] g V_j / |xi|  -  (rotation of the neighbourhood, objective
///   form)
/// over plane waves in many directions with wave numbers from the long-wave limit to pi over the shortest bond.
/// Positive: every plane wave in a body of such neighbourhoods stores energy.
double smallestRelativeStiffness(const std::vector<WeightedBond>& bonds, int dimension,
                                 const ElasticConstants& constants, TangentialForm form);

}  // namespace pd::kernels

#endif
