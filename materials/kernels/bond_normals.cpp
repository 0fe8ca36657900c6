#include "bond_normals.hpp"

#include <Random123/philox.h>

#include <cmath>

#include "bond_name.hpp"

namespace pd::kernels {

namespace {

enum class Owner : std::uint32_t { Bond, Body };

Normals normalsOf(std::uint32_t seed, Owner owner, std::uint32_t first, std::uint32_t second) {
  constexpr double twoPi = 6.28318530717958647692;
  const r123::Philox4x32 generator;
  const auto bits = generator({{first, second, static_cast<std::uint32_t>(owner), 0}}, {{seed, 0}});
  Normals normals;
  for (std::size_t pair = 0; pair < 2; ++pair) {
    const double radius = std::sqrt(-2.0 * std::log((bits[2 * pair] + 0.5) / 4294967296.0));
    const double angle = twoPi * (bits[2 * pair + 1] + 0.5) / 4294967296.0;
    normals[2 * pair] = radius * std::cos(angle);
    normals[2 * pair + 1] = radius * std::sin(angle);
  }
  return normals;
}

}  // namespace

Normals bodyNormals(std::uint32_t seed) { return normalsOf(seed, Owner::Body, 0, 0); }

Normals bondNormals(std::uint32_t seed, int firstId, int secondId, int shift) {
  const BondName bond = bondName(firstId, secondId, shift);
  return normalsOf(seed, Owner::Bond, static_cast<std::uint32_t>(bond.low), static_cast<std::uint32_t>(bond.high));
}

}  // namespace pd::kernels
