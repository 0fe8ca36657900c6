#include "growth_trial.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>
#include <utility>

#include "growth_specimen.hpp"
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

/// Where bonds lose what the law says of their strains over dK / (E' sqrt(delta)), dK the same at any length of the
/// crack: life of all bonds of the body that may break, event by event.
Growth growthIn(GrowthBody body, const GrowthTrialCase& trial, const LossRate& law) {
  std::vector<double> lost(body.nBonds(), 0.0), rate;
  const int first = static_cast<int>(std::lround(firstGrowth * trial.horizon));
  const int last = static_cast<int>(std::lround(lastGrowth * trial.horizon));
  double cycles = 0.0, atFirst = 0.0;
  Growth growth;
  while (true) {
    const double unit = body.strainUnit();
    const std::vector<std::size_t>& bonds = body.bondsNear(trial.growthDamage);
    double next = std::numeric_limits<double>::infinity();
    rate.clear();
    for (const std::size_t b : bonds) {
      const double stretch = body.stretch(b);
      rate.push_back(stretch > 0.0 ? law(stretch / unit) : 0.0);
      if (rate.back() > 0.0) next = std::min(next, (1.0 - lost[b]) / rate.back());
    }
    if (!std::isfinite(next)) return {};
    cycles += next;
    for (std::size_t k = 0; k < bonds.size(); ++k) {
      const std::size_t b = bonds[k];
      lost[b] += next * rate[k];
      if (rate[k] == 0.0 || lost[b] < enoughLost) continue;
      body.breakBond(b);
      ++growth.nBroken;
    }
    const int tip = body.nColumnsOpen();
    if (atFirst == 0.0 && tip >= first) atFirst = cycles;
    if (tip < last) continue;
    growth.rate = (last - first) / (cycles - atFirst) / trial.horizon;
    return growth;
  }
}

/// Those that cracks grow through: strips of one and of two heights, or a specimen alone.
using Bodies = std::vector<GrowthBody>;

Bodies makeBodies(const GrowthTrialCase& trial) {
  if (trial.specimenWidth > 0.0) return {GrowthSpecimen(trial.bonds, trial.horizon, trial.specimenWidth, lastGrowth)};
  return {GrowthStrip(trial.bonds, trial.horizon, height, lastGrowth),
          GrowthStrip(trial.bonds, trial.horizon, 2.0 * height, lastGrowth)};
}

std::vector<double> keyOfLattice(const GrowthTrialCase& trial) {
  std::vector<double> key{trial.horizon, trial.specimenWidth};
  for (const LatticeBond& bond : trial.bonds)
    key.insert(key.end(), {double(bond.x), double(bond.y), bond.length, bond.stiffness, bond.count});
  return key;
}

/// Those of a lattice take longer to make than a crack to grow through them; the last are kept.
const Bodies& bodiesOf(const GrowthTrialCase& trial) {
  static std::vector<double> lastKey;
  static Bodies last;
  std::vector<double> key = keyOfLattice(trial);
  if (key != lastKey) {
    last = makeBodies(trial);
    lastKey = std::move(key);
  }
  return last;
}

/// In the specimen, or in a body large beside the horizon.
Growth growthInBody(const GrowthTrialCase& trial, const LossRate& law) {
  const Bodies& bodies = bodiesOf(trial);
  const Growth first = growthIn(bodies.front(), trial, law);
  if (bodies.size() == 1) return first;
  const Growth high = growthIn(bodies.back(), trial, law);
  if (first.rate == 0.0 || high.rate == 0.0) return {};
  return {2.0 * high.rate - first.rate, high.nBroken};
}

double standingStrainIn(const GrowthBody& body, const GrowthTrialCase& trial) {
  const auto grows = [&](double limit) {
    return growthIn(body, trial, lossRateOf(LifeLaw::power(1.0, trial.exponent, limit))).rate > 0.0;
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
  return (isLarge ? growthInBody(trial, lossRate) : growthIn(bodiesOf(trial).front(), trial, lossRate)).rate;
}

double standingStrain(const GrowthTrialCase& trial, TrialBody body) {
  const Bodies& bodies = bodiesOf(trial);
  const double first = standingStrainIn(bodies.front(), trial);
  if (body == TrialBody::Strip || bodies.size() == 1) return first;
  return 2.0 * standingStrainIn(bodies.back(), trial) - first;
}

}  // namespace pd
