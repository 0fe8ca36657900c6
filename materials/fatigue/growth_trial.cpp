#include "growth_trial.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>

#include "growth_strip.hpp"

namespace pd {

namespace {

constexpr double firstGrowth = 1.5, lastGrowth = 3.0;  ///< horizons between which growth is steady and measured
constexpr double enoughLost = 1.0 - 1e-3;              ///< of a life: bonds that fail nearly together fail together

/// Life of all bonds of the strip that may break, event by event.
double factorOf(const GrowthTrialCase& trial, double height, int& nBroken) {
  GrowthStrip strip(trial.bonds, trial.horizon, height, lastGrowth);
  const double unit = strip.strainUnit();
  const std::size_t n = strip.nBonds();
  std::vector<double> lost(n, 0.0), rate(n);
  const int first = static_cast<int>(std::lround(firstGrowth * trial.horizon));
  const int last = static_cast<int>(std::lround(lastGrowth * trial.horizon));
  double cycles = 0.0, atFirst = 0.0;
  nBroken = 0;
  while (true) {
    const std::vector<char> nearTip = strip.pointsNear(trial.growthDamage);
    double next = std::numeric_limits<double>::infinity();
    for (std::size_t b = 0; b < n; ++b) {
      const bool wears = !strip.isBroken(b) && strip.stretch(b) > 0.0 && strip.hasEndIn(nearTip, b);
      rate[b] = wears ? std::pow(strip.stretch(b) / unit, trial.exponent) : 0.0;
      if (wears) next = std::min(next, (1.0 - lost[b]) / rate[b]);
    }
    if (!std::isfinite(next)) throw std::runtime_error("no crack grows in the trial that finds the growth coefficient");
    cycles += next;
    for (std::size_t b = 0; b < n; ++b) {
      lost[b] += next * rate[b];
      if (rate[b] == 0.0 || lost[b] < enoughLost) continue;
      strip.breakBond(b);
      ++nBroken;
    }
    const int tip = strip.nColumnsOpen();
    if (atFirst == 0.0 && tip >= first) atFirst = cycles;
    if (tip >= last) return (last - first) / (cycles - atFirst) / trial.horizon;
  }
}

std::vector<double> keyOf(const GrowthTrialCase& trial) {
  std::vector<double> key{trial.horizon, trial.exponent, trial.growthDamage};
  for (const LatticeBond& bond : trial.bonds)
    key.insert(key.end(), {double(bond.x), double(bond.y), bond.length, bond.stiffness, bond.count});
  return key;
}

}  // namespace

double planeModulus(const std::vector<LatticeBond>& bonds) {
  double c11 = 0.0, c12 = 0.0;
  for (const LatticeBond& bond : bonds) {
    const double l4 = std::pow(bond.length, 4), x2 = bond.x * bond.x, y2 = bond.y * bond.y;
    c11 += 0.5 * bond.stiffness * x2 * x2 / l4;
    c12 += 0.5 * bond.stiffness * x2 * y2 / l4;
  }
  return (c11 * c11 - c12 * c12) / c11;
}

const GrowthTrialResult& growthTrial(const GrowthTrialCase& trial) {
  static std::map<std::vector<double>, GrowthTrialResult> known;
  const std::vector<double> key = keyOf(trial);
  const auto found = known.find(key);
  if (found != known.end()) return found->second;
  GrowthTrialResult result;
  constexpr double height = 8.0;  // horizons
  const double low = factorOf(trial, height, result.nBroken);
  const double high = factorOf(trial, 2.0 * height, result.nBroken);
  result.factor = 2.0 * high - low;
  return known.emplace(key, result).first->second;
}

}  // namespace pd
