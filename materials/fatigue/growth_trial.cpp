#include "growth_trial.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
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

/// Growth in a cycle over A delta (dK / (E' sqrt(delta)))^M, where bonds lose what the law says of their strains over
/// dK / (E' sqrt(delta)): life of all bonds of the strip that may break, event by event. 0 where the crack stands.
double growthIn(GrowthStrip strip, const GrowthTrialCase& trial, const LifeLaw& law, int& nBroken) {
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
      rate[b] = wears ? law.rate(strip.stretch(b) / unit) : 0.0;
      if (rate[b] > 0.0) next = std::min(next, (1.0 - lost[b]) / rate[b]);
    }
    if (!std::isfinite(next)) return 0.0;
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

GrowthStrip stripOf(const GrowthTrialCase& trial, double height) {
  return {trial.bonds, trial.horizon, height, lastGrowth};
}

/// Growth in the smaller strip with a limit of strain ranges.
class LimitedGrowth {
 public:
  explicit LimitedGrowth(const GrowthTrialCase& trial) : trial_(trial), strip_(stripOf(trial, height)) {}

  double at(double limit, double sharpness) const {
    int nBroken = 0;
    return growthIn(strip_, trial_, LifeLaw::power(1.0, trial_.exponent, limit, sharpness), nBroken);
  }

  /// The limit at which the crack stands, to 2e-3 of it.
  double largestLimit() const {
    double grows = 0.0, stands = 2.0;
    while (at(stands, 1.0) > 0.0) stands *= 2.0;
    while (stands - grows > 2e-3 * stands) {
      const double middle = 0.5 * (grows + stands);
      (at(middle, 1.0) > 0.0 ? grows : stands) = middle;
    }
    return grows;
  }

  /// How far growth is from that with a threshold: largest |log| of their ratio at some ranges of K.
  double deviation(double largestLimit, double sharpness, double unlimited) const {
    double largest = 0.0;
    for (const double share : {0.25, 0.5, 0.75}) {  // of dK that is dK_th
      const double found = at(share * largestLimit, sharpness) / unlimited;
      largest = std::max(largest, std::abs(std::log(found) - trial_.exponent * std::log(1.0 - share)));
    }
    return largest;
  }

 private:
  const GrowthTrialCase& trial_;
  GrowthStrip strip_;
};

/// The sharpness whose growth is nearest to the law, by golden sections of its logarithm.
GrowthThreshold findThreshold(const GrowthTrialCase& trial) {
  const LimitedGrowth growth(trial);
  const double unlimited = growth.at(0.0, 1.0), limit = growth.largestLimit();
  if (unlimited == 0.0) throw std::runtime_error(noGrowth);
  const auto deviation = [&](double logSharpness) {
    return growth.deviation(limit, std::exp(logSharpness), unlimited);
  };
  const double golden = 0.5 * (std::sqrt(5.0) - 1.0);
  double low = std::log(0.5), high = std::log(4.0);
  double a = high - golden * (high - low), b = low + golden * (high - low), atA = deviation(a), atB = deviation(b);
  while (high - low > 0.2) {
    if (atA < atB) {
      high = std::exchange(b, a);
      a = high - golden * (high - low);
      atB = std::exchange(atA, deviation(a));
    } else {
      low = std::exchange(a, b);
      b = low + golden * (high - low);
      atA = std::exchange(atB, deviation(b));
    }
  }
  return {limit, std::exp(atA < atB ? a : b), std::exp(std::min(atA, atB)) - 1.0};
}

std::vector<double> keyOf(const GrowthTrialCase& trial) {
  std::vector<double> key{trial.horizon, trial.exponent, trial.growthDamage};
  for (const LatticeBond& bond : trial.bonds)
    key.insert(key.end(), {double(bond.x), double(bond.y), bond.length, bond.stiffness, bond.count});
  return key;
}

}  // namespace

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
  GrowthTrialResult result;
  const LifeLaw law = LifeLaw::power(1.0, trial.exponent, 0.0);
  const double low = growthIn(stripOf(trial, height), trial, law, result.nBroken);
  const double high = growthIn(stripOf(trial, 2.0 * height), trial, law, result.nBroken);
  if (low == 0.0 || high == 0.0) throw std::runtime_error(noGrowth);
  result.factor = 2.0 * high - low;
  return known.emplace(key, result).first->second;
}

const GrowthThreshold& growthThreshold(const GrowthTrialCase& trial) {
  static std::map<std::vector<double>, GrowthThreshold> known;
  const std::vector<double> key = keyOf(trial);
  const auto found = known.find(key);
  return found != known.end() ? found->second : known.emplace(key, findThreshold(trial)).first->second;
}

}  // namespace pd
