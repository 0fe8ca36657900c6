// Normally distributed random numbers that belong to bonds, or to a body.
#ifndef PD_BOND_NORMALS_HPP
#define PD_BOND_NORMALS_HPP

#include <array>
#include <cstdint>

namespace pd::kernels {

using Normals = std::array<double, 4>;

/// Independent standard normal numbers, by Box and Muller from uniform ones that are multiples of 2^-33, which end 6.8
/// standard deviations away. They depend on the seed alone. Philox 4x32 (bond_thresholds.hpp).
Normals bodyNormals(std::uint32_t seed);

/// They depend on the seed and on the two ids alone, in either order. `shift`: of an image (bond_name.hpp).
Normals bondNormals(std::uint32_t seed, int firstId, int secondId, int shift = 0);

}  // namespace pd::kernels

#endif
