#include "trial_calibration.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <mutex>
#include <stdexcept>
#include <tuple>
#include <vector>

#include "bond_thresholds.hpp"

namespace pd {

namespace {

struct LatticeBond {
  std::array<int, 3> offset;
  double weight;  ///< share/|xi|^2
};

std::vector<LatticeBond> bondsOf(const TrialCase& trial) {
  const int reach = static_cast<int>(trial.horizon + 0.5);
  const auto reachAlong = [&](int axis) { return axis < trial.dimension ? reach : 0; };
  constexpr double roundOff = 1e-4;  // as TransportWeights
  std::vector<LatticeBond> bonds;
  for (int a = -reachAlong(0); a <= reachAlong(0); ++a)
    for (int b = -reachAlong(1); b <= reachAlong(1); ++b)
      for (int c = -reachAlong(2); c <= reachAlong(2); ++c) {
        const double length = trial.isBox ? std::max({std::abs(a), std::abs(b), std::abs(c)}) : std::hypot(a, b, c);
        const double share = kernels::volumeShare(trial.volumeCorrection, length, trial.horizon, 1.0);
        if (length > 0.0 && share > roundOff) bonds.push_back({{a, b, c}, share / (length * length)});
      }
  return bonds;
}

/// A front that moves along x through a strip of lattice, which repeats itself across. Every liquid point dissolves
/// alike, as at C = 0. Between events (a point turns liquid or comes loose) all rates are constant: steps end there.
class TrialFront {
 public:
  TrialFront(const std::vector<LatticeBond>& bonds, bool breaksBondsAtRandom, std::array<int, 3> size,
             int nLiquidLayers)
      : bonds_(bonds), isRandom_(breaksBondsAtRandom), size_(size) {
    const auto nPoints = static_cast<std::size_t>(size[0]) * static_cast<std::size_t>(nColumns());
    metal_.assign(nPoints, 1.0);
    for (auto* values : {&rate_, &effective_, &offered_}) values->assign(nPoints, 0.0);
    firstIntact_.assign(nPoints, 0);
    isLoose_.assign(nPoints, 0);
    for (int p = 0; p < nLiquidLayers * nColumns(); ++p) metal_[index(p)] = 0.0;
    for (int p = 0; p < nLiquidLayers * nColumns(); ++p) wet(p);
  }

  int nColumns() const { return size_[1] * size_[2]; }
  double time() const { return time_; }
  /// How far the front has moved, by what has dissolved.
  double depth() const { return dissolved_ / nColumns(); }
  void advanceTo(double depthWanted) {
    while (depth() < depthWanted) step();
  }

 private:
  static std::size_t index(int point) { return static_cast<std::size_t>(point); }

  struct Place {
    int x, y, z;
  };
  Place placeOf(int point) const { return {point / nColumns(), point / size_[2] % size_[1], point % size_[2]}; }

  /// -1 beyond the ends.
  int neighbor(const Place& place, const std::array<int, 3>& offset) const {
    const auto across = [](int at, int size) { return at < 0 ? at + size : at >= size ? at - size : at; };
    const int x = place.x + offset[0];
    if (x < 0 || x >= size_[0]) return -1;
    return (x * size_[1] + across(place.y + offset[1], size_[1])) * size_[2] + across(place.z + offset[2], size_[2]);
  }

  template <class Visit>
  void forEachSolidNeighbor(int point, Visit visit) const {
    const Place place = placeOf(point);
    for (const LatticeBond& bond : bonds_) {
      const int other = neighbor(place, bond.offset);
      if (other >= 0 && metal_[index(other)] > 0.0) visit(other, bond.weight);
    }
  }

  /// A liquid point dissolves what is around it.
  void wet(int liquid) {
    forEachSolidNeighbor(liquid, [&](int solid, double weight) {
      if (rate_[index(solid)] == 0.0) active_.push_back(solid);
      rate_[index(solid)] += weight;
    });
  }

  /// No bond to solid is left. (A bond breaks where the loss of either end exceeds that end's threshold, for good.)
  bool hasLostAllBonds(int point) {
    constexpr std::uint32_t seed = 0;
    const double loss = 1.0 - metal_[index(point)];
    const Place place = placeOf(point);
    for (std::size_t& k = firstIntact_[index(point)]; k < bonds_.size(); ++k) {
      const int other = neighbor(place, bonds_[k].offset);
      if (other < 0 || metal_[index(other)] == 0.0) continue;
      const kernels::BondThresholds thresholds = kernels::bondThresholds(seed, point, other);
      if (loss <= thresholds.ofFirst && 1.0 - metal_[index(other)] <= thresholds.ofSecond) return false;
    }
    return true;
  }

  /// Loose points give what points around them would, as in driver/solvers/corrosion/dissolve_loose_metal.hpp.
  void findEffectiveRates() {
    for (const int p : active_) effective_[index(p)] = rate_[index(p)];
    if (nLoose_ == 0) return;
    for (const int p : active_)
      if (isLoose_[index(p)] != 0)
        forEachSolidNeighbor(p, [&](int other, double) { offered_[index(other)] += metal_[index(p)]; });
    for (const int p : active_)
      if (isLoose_[index(p)] != 0)
        forEachSolidNeighbor(p, [&](int other, double) {
          if (isLoose_[index(other)] == 0)
            effective_[index(p)] += rate_[index(other)] * metal_[index(p)] / offered_[index(other)];
        });
    for (const int p : active_) {
      if (offered_[index(p)] > 0.0 && isLoose_[index(p)] == 0) effective_[index(p)] = 0.0;
      offered_[index(p)] = 0.0;
    }
    // Neighbours that do not dissolve yet.
    for (const int p : active_)
      if (isLoose_[index(p)] != 0) forEachSolidNeighbor(p, [&](int other, double) { offered_[index(other)] = 0.0; });
  }

  void step() {
    findEffectiveRates();
    constexpr double mostLoss = 0.02, rounding = 1e-12;
    double h = 1e300;
    for (const int p : active_)
      if (effective_[index(p)] > 0.0)
        h = std::min(h, std::min(metal_[index(p)], isRandom_ ? mostLoss : 1.0) / effective_[index(p)]);
    time_ += h;
    std::vector<int> dissolvedNow;
    for (const int p : active_) {
      double& metal = metal_[index(p)];
      const double loss = std::min(h * effective_[index(p)], metal);
      dissolved_ += loss;
      metal -= loss;
      if (metal <= rounding) {
        metal = 0.0;
        dissolvedNow.push_back(p);
      }
    }
    active_.erase(std::remove_if(active_.begin(), active_.end(), [&](int p) { return metal_[index(p)] == 0.0; }),
                  active_.end());
    for (const int p : dissolvedNow) {
      nLoose_ -= isLoose_[index(p)];
      wet(p);
    }
    if (!isRandom_) return;
    for (const int p : active_)
      if (isLoose_[index(p)] == 0 && hasLostAllBonds(p)) {
        isLoose_[index(p)] = 1;
        ++nLoose_;
      }
  }

  const std::vector<LatticeBond>& bonds_;
  bool isRandom_;
  std::array<int, 3> size_;
  std::vector<double> metal_, rate_, effective_, offered_;
  std::vector<std::size_t> firstIntact_;  ///< bonds before it are broken
  std::vector<int> isLoose_, active_;     ///< active: solid within reach of liquid
  int nLoose_ = 0;
  double time_ = 0.0, dissolved_ = 0.0;
};

TrialResult runTrial(const TrialCase& trial) {
  if (trial.volumeCorrection == kernels::VolumeCorrection::EveryNeighbor)
    throw std::invalid_argument(
        "a trial calibration needs neighbourhoods that end at the horizon: another \"Volume Correction\" than Every "
        "Neighbor");
  const std::vector<LatticeBond> bonds = bondsOf(trial);
  double firstMoment = 0.0;
  for (const LatticeBond& bond : bonds) firstMoment += 0.5 * std::abs(bond.offset[0]) * bond.weight;
  if (firstMoment == 0.0) throw std::invalid_argument("the horizon must reach over more spacings; usually four");

  // As many columns as a neighbourhood is wide, or bonds would meet themselves; where they break at random, enough for
  // a mean.
  const int reach = static_cast<int>(trial.horizon + 0.5);
  const int widths[] = {1, 64, 10}, depths[] = {400, 40, 12};
  const auto d = static_cast<std::size_t>(trial.dimension - 1);
  const int width = std::max(trial.breaksBondsAtRandom ? widths[d] : 1, 2 * reach + 1);
  const double depth = trial.breaksBondsAtRandom ? depths[d] : 12.0, before = 10.0 + 2.0 * reach;
  const int nLayers = static_cast<int>(before + depth) + 4 * reach + 10;
  TrialFront front(bonds, trial.breaksBondsAtRandom,
                   {nLayers, trial.dimension > 1 ? width : 1, trial.dimension > 2 ? width : 1}, reach + 1);
  front.advanceTo(before);
  const double startTime = front.time(), start = front.depth();
  front.advanceTo(before + depth);
  const double moved = front.depth() - start;
  return {(front.time() - startTime) / moved, firstMoment, moved};
}

}  // namespace

std::string TrialCase::description() const {
  char text[120];
  std::snprintf(text, sizeof text, "%dD, %s of %.6g spacings, bonds %s", dimension, isBox ? "box" : "ball", horizon,
                breaksBondsAtRandom ? "that break at random" : "that do not break at random");
  return text;
}

const TrialResult& trialCalibration(const TrialCase& trial) {
  using Key = std::tuple<int, double, bool, kernels::VolumeCorrection, bool>;
  static std::map<Key, TrialResult> known;
  static std::mutex mutex;
  const std::lock_guard<std::mutex> lock(mutex);
  const Key key{trial.dimension, trial.horizon, trial.isBox, trial.volumeCorrection, trial.breaksBondsAtRandom};
  const auto found = known.find(key);
  return found != known.end() ? found->second : known.emplace(key, runTrial(trial)).first->second;
}

}  // namespace pd
