#include "growth_trial.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <stdexcept>
#include <utility>

#include "growth_strip.hpp"
#include "life_law.hpp"

namespace pd {

using kernels::LifeLaw;

namespace {

constexpr double firstGrowth = 2.0, lastGrowth = 4.0;  ///< horizons between which growth is steady and measured
constexpr double height = 12.0;                        ///< horizons, of the smaller strip
const char* const noGrowth = "no crack grows in the trial that finds the growth coefficient";
constexpr double enoughLost = 1.0 - 1e-3;  ///< of a life: bonds that fail nearly together fail together

LossRate lossRateOf(const LifeLaw& law) {
  return [law](double strain) { return law.rate(strain); };
}

struct Growth {
  double rate = 0.0;  ///< horizons a cycle; 0 where the crack stands
  int nBroken = 0;
};

/// Where bonds lose what the law says of their strains over dK / (E' sqrt(delta)): life of all bonds of the strip that
/// may break, event by event.
Growth growthIn(GrowthStrip strip, const GrowthTrialCase& trial, const LossRate& law) {
  const double unit = strip.strainUnit();
  std::vector<double> lost(strip.nBonds(), 0.0), rate;
  const int first = static_cast<int>(std::lround(firstGrowth * trial.horizon));
  const int last = static_cast<int>(std::lround(lastGrowth * trial.horizon));
  double cycles = 0.0, atFirst = 0.0;
  Growth growth;
  while (true) {
    const std::vector<std::size_t>& bonds = strip.bondsNear(trial.growthDamage);
    double next = std::numeric_limits<double>::infinity();
    rate.clear();
    for (const std::size_t b : bonds) {
      const double stretch = strip.stretch(b);
      rate.push_back(stretch > 0.0 ? law(stretch / unit) : 0.0);
      if (rate.back() > 0.0) next = std::min(next, (1.0 - lost[b]) / rate.back());
    }
    if (!std::isfinite(next)) return {};
    cycles += next;
    for (std::size_t k = 0; k < bonds.size(); ++k) {
      const std::size_t b = bonds[k];
      lost[b] += next * rate[k];
      if (rate[k] == 0.0 || lost[b] < enoughLost) continue;
      strip.breakBond(b);
      ++growth.nBroken;
    }
    const int tip = strip.nColumnsOpen();
    if (atFirst == 0.0 && tip >= first) atFirst = cycles;
    if (tip < last) continue;
    growth.rate = (last - first) / (cycles - atFirst) / trial.horizon;
    return growth;
  }
}

/// Of one and of two heights.
struct Strips {
  GrowthStrip low, high;
  explicit Strips(const GrowthTrialCase& trial)
      : low(trial.bonds, trial.horizon, height, lastGrowth),
        high(trial.bonds, trial.horizon, 2.0 * height, lastGrowth) {}
};

std::vector<double> keyOfLattice(const GrowthTrialCase& trial) {
  std::vector<double> key{trial.horizon};
  for (const LatticeBond& bond : trial.bonds)
    key.insert(key.end(), {double(bond.x), double(bond.y), bond.length, bond.stiffness, bond.count});
  return key;
}

/// Those of a lattice take longer to make than a crack to grow through them; the last are kept.
const Strips& stripsOf(const GrowthTrialCase& trial) {
  static std::vector<double> lastKey;
  static std::unique_ptr<Strips> last;
  std::vector<double> key = keyOfLattice(trial);
  if (key != lastKey) {
    last = std::make_unique<Strips>(trial);
    lastKey = std::move(key);
  }
  return *last;
}

/// In a body large beside the horizon.
Growth growthInBody(const GrowthTrialCase& trial, const LossRate& law) {
  const Strips& strips = stripsOf(trial);
  const Growth low = growthIn(strips.low, trial, law), high = growthIn(strips.high, trial, law);
  if (low.rate == 0.0 || high.rate == 0.0) return {};
  return {2.0 * high.rate - low.rate, high.nBroken};
}

double standingStrainIn(const GrowthStrip& strip, const GrowthTrialCase& trial) {
  const auto grows = [&](double limit) {
    return growthIn(strip, trial, lossRateOf(LifeLaw::power(1.0, trial.exponent, limit))).rate > 0.0;
  };
  double growing = 0.0, standing = 2.0;
  while (grows(standing)) standing *= 2.0;
  while (standing - growing > 2e-3 * standing) {
    const double middle = 0.5 * (growing + standing);
    (grows(middle) ? growing : standing) = middle;
  }
  return growing;
}

}  // namespace

std::vector<double> keyOf(const GrowthTrialCase& trial) {
  std::vector<double> key = keyOfLattice(trial);
  key.insert(key.end(), {trial.exponent, trial.growthDamage});
  return key;
}

double PlaneStiffness::fractureModulus() const {
  const double determinant = c11 * c11 - c12 * c12, a11 = c11 / determinant, a12 = -c12 / determinant, a66 = 1.0 / c12;
  return 1.0 / (a11 * std::sqrt(0.5 * (1.0 + (2.0 * a12 + a66) / (2.0 * a11))));
}

PlaneStiffness planeStiffness(const std::vector<LatticeBond>& bonds) {
  PlaneStiffness sum;
  for (const LatticeBond& bond : bonds) {
    const double l4 = std::pow(bond.length, 4), x2 = bond.x * bond.x, y2 = bond.y * bond.y;
    sum.c11 += 0.5 * bond.stiffness * x2 * x2 / l4;
    sum.c12 += 0.5 * bond.stiffness * x2 * y2 / l4;
  }
  return sum;
}

const GrowthTrialResult& growthTrial(const GrowthTrialCase& trial) {
  static std::map<std::vector<double>, GrowthTrialResult> known;
  const std::vector<double> key = keyOf(trial);
  const auto found = known.find(key);
  if (found != known.end()) return found->second;
  const Growth growth = growthInBody(trial, lossRateOf(LifeLaw::power(1.0, trial.exponent, 0.0)));
  if (growth.rate == 0.0) throw std::runtime_error(noGrowth);
  return known.emplace(key, GrowthTrialResult{growth.rate, growth.nBroken}).first->second;
}

double trialGrowth(const GrowthTrialCase& trial, const LossRate& lossRate, TrialBody body) {
  const bool isLarge = body == TrialBody::Large;
  return (isLarge ? growthInBody(trial, lossRate) : growthIn(stripsOf(trial).low, trial, lossRate)).rate;
}

double standingStrain(const GrowthTrialCase& trial, TrialBody body) {
  const Strips& strips = stripsOf(trial);
  const double low = standingStrainIn(strips.low, trial);
  return body == TrialBody::Strip ? low : 2.0 * standingStrainIn(strips.high, trial) - low;
}

}  // namespace pd
