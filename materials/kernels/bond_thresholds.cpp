#include "bond_thresholds.hpp"

#include <Random123/philox.h>

#include <algorithm>

namespace pd::kernels {

namespace {

double uniform(std::uint32_t bits) { return (bits + 0.5) / 4294967296.0; }

}  // namespace

BondThresholds bondThresholds(std::uint32_t seed, int firstId, int secondId) {
  const r123::Philox2x32 generator;
  const auto [low, high] = std::minmax(firstId, secondId);
  const auto numbers = generator({{static_cast<std::uint32_t>(low), static_cast<std::uint32_t>(high)}}, {{seed}});
  const double ofLow = uniform(numbers[0]), ofHigh = uniform(numbers[1]);
  return firstId == low ? BondThresholds{ofLow, ofHigh} : BondThresholds{ofHigh, ofLow};
}

BondThresholds bondThresholds(std::uint32_t seed, int firstId, int imageId, int shift) {
  const int mirrored = imageId - shift;
  if (shift == 0 || firstId <= mirrored) return bondThresholds(seed, firstId, imageId);
  const BondThresholds numbers = bondThresholds(seed, mirrored, firstId + shift);
  return {numbers.ofSecond, numbers.ofFirst};
}

}  // namespace pd::kernels
