#include "bond_thresholds.hpp"

#include <Random123/philox.h>

#include "bond_name.hpp"

namespace pd::kernels {

namespace {

double uniform(std::uint32_t bits) { return (bits + 0.5) / 4294967296.0; }

}  // namespace

BondThresholds bondThresholds(std::uint32_t seed, int firstId, int secondId, int shift) {
  const r123::Philox2x32 generator;
  const BondName bond = bondName(firstId, secondId, shift);
  const auto numbers =
      generator({{static_cast<std::uint32_t>(bond.low), static_cast<std::uint32_t>(bond.high)}}, {{seed}});
  const double ofLow = uniform(numbers[0]), ofHigh = uniform(numbers[1]);
  return bond.isLowTheFirst ? BondThresholds{ofLow, ofHigh} : BondThresholds{ofHigh, ofLow};
}

}  // namespace pd::kernels
