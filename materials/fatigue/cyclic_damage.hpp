// What damage models of fatigue share: each bond has a life, of which cycles of load take their part.
#ifndef PD_CYCLIC_DAMAGE_HPP
#define PD_CYCLIC_DAMAGE_HPP

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <string>

#include "bond_damage_model.hpp"
#include "bond_family.hpp"
#include "cycle_fields.hpp"
#include "partial_writer.hpp"
#include "run_notes.hpp"
#include "step_listener.hpp"
#include "tiring_points.hpp"

namespace pd {

/// A bond whose largest stretch in a cycle is s has the strain range e = |(1 - R) s|. A derived model says what part of
/// its life a cycle takes of it, by one law away from cracks and by another near a crack tip. A bond without life is
/// broken; so is one whose largest stretch is the critical one, in any cycle. A point is near a crack tip once it or a
/// neighbour has lost `Growth Damage` of its bonds; a bond where either end is. What points lost by the start of the
/// step counts: exchanged by precompute(). A host says how many cycles a step has, and their load (cycle_fields.hpp),
/// or the parameters do.
class CyclicDamage : public BondDamageModel, public RunNotes, public StepListener, public PartialWriter {
 public:
  struct Fields : BondDamageModel::Fields {
    FieldHandle modelCoordinates = reads(pd::fields::modelCoordinates());
    FieldHandle coordinates = reads(pd::fields::coordinates());
    FieldHandle cycles = readsIfThere(pd::fields::cycleIncrement());
    FieldHandle range = readsIfThere(pd::fields::loadRange());
    FieldHandle peak = readsIfThere(pd::fields::peakLoad());
    FieldHandle lostLife = writes(pd::fields::bondScalar(
        "Lost_Life", "1", "Share of a bond's life that is gone: 1 - remaining life; 1 where it is broken."));
    FieldHandle nearTip = writes(pd::fields::pointScalar("Growth_Phase", "1", "1 at points near the tip of a crack."),
                                 Ghosts::AfterPrecompute);
    FieldHandle lossRate = writes(pd::fields::lifeLossRate());
    FieldHandle overdrawn = writes(pd::fields::overdrawnLife());
    FieldHandle lifeLeft = writes(pd::fields::lifeLeft());
    FieldHandle rateOfFailed = writes(pd::fields::rateOfFailed());
    FieldHandle overdrawRate = writes(pd::fields::overdrawRate());
  };

  std::string Name() const override { return name_; }
  const Fields& fields() const override { return fields_; }
  /// Throws std::invalid_argument where nobody says how many cycles a step has, or both do.
  void initialize(const double dt, const int numOwnedPoints, const int* ownedIDs, const int* neighborhoodList,
                  PeridigmNS::DataManager& data) const override;
  void precompute(const double dt, const int numOwnedPoints, const int* ownedIDs, const int* neighborhoodList,
                  PeridigmNS::DataManager& data) const override;
  void stepTakenBack() const override { points_.clear(); }
  std::map<int, std::vector<BondRange>> bondsWritten(PeridigmNS::DataManager& data) const override;

 protected:
  /// All parameters but those of the laws.
  static void declareCommonParameters(ParameterDeclarations& declare);
  /// From a completed list; `name`: as registered.
  CyclicDamage(const Teuchos::ParameterList& params, const Fields& fields, const std::string& name);
  std::string owner() const { return "damage model " + name_; }

  /// Which of the two laws there are; without one for tips that of other bonds holds there, too. Strain ranges that
  /// take no life of a bond: `restingRange` away from cracks, `restingNearTips`.
  void haveLaws(bool awayFromCracks, bool nearTips, double restingRange, double restingNearTips = 0.0) {
    constexpr double all = std::numeric_limits<double>::infinity();
    hasInitiation_ = awayFromCracks;
    hasGrowth_ = nearTips;
    restingRange_ = awayFromCracks ? restingRange : all;
    restingNearTips_ = nearTips ? restingNearTips : all;
  }
  /// What worsen() does: takes lossRate(isNearTip, strainRange, i, j) of the life of the bond i-j a cycle, the same of
  /// j-i, and breaks bonds. Throws std::runtime_error where neighbours are ghosts and precompute() has not been called.
  template <class LossRate>
  void loseLife(double dt, const Call& call, PeridigmNS::DataManager& data, LossRate lossRate) const;

 private:
  struct Cycles {
    double number, range, peak;
  };
  Cycles cyclesOf(PeridigmNS::DataManager& data) const;
  void requirePrecompute(double dt, const Call& call, PeridigmNS::DataManager& data) const;
  TiringPoints& pointsOf(const Call& call, PeridigmNS::DataManager& data) const;
  /// Up to which nothing happens to a bond, of any law.
  double restingStretch(const Cycles& cycles) const;

  std::string name_;
  Fields fields_;
  bool hasOwnCycles_ = false;
  Cycles own_{0.0, 1.0, 1.0};
  bool seesOpeningAlone_ = true, hasInitiation_ = false, hasGrowth_ = false;
  double growthDamage_, lifeTolerance_, criticalStretch_, restingRange_ = 0.0, restingNearTips_ = 0.0;
  mutable std::set<const PeridigmNS::DataManager*> prepared_;              ///< blocks whose Growth_Phase is there
  mutable std::map<const PeridigmNS::DataManager*, TiringPoints> points_;  ///< of blocks
};

template <class LossRate>
void CyclicDamage::loseLife(double dt, const Call& call, PeridigmNS::DataManager& data, LossRate lossRate) const {
  requirePrecompute(dt, call, data);
  const Cycles cycles = cyclesOf(data);
  const double *x = fields_.modelCoordinates.of(data), *y = fields_.coordinates.of(data);
  const double *lostBefore = fields_.lostLife.before(data), *nearTip = fields_.nearTip.of(data);
  const double* noFailure = fields_.noFailure.ifIn(data);
  double *lost = fields_.lostLife.of(data), *bondDamage = fields_.bondDamage.of(data);
  double *worstRate = fields_.lossRate.of(data), *overdrawn = fields_.overdrawn.of(data);
  double *lifeLeft = fields_.lifeLeft.of(data), *rateOfFailed = fields_.rateOfFailed.of(data);
  double* overdrawRate = fields_.overdrawRate.of(data);
  TiringPoints& points = pointsOf(call, data);
  for (double* sums : {worstRate, overdrawn, lifeLeft, rateOfFailed, overdrawRate}) points.clear(sums);
  points.startFrom(lostBefore, lost);
  const TiringPoints::Limits limits{std::abs(cycles.range), restingRange_, cycles.peak, criticalStretch_};
  const auto& tiring = points.find(hasGrowth_ ? nearTip : nullptr, x, y, fields_.damage.length(data), limits);
  // Away from cracks nothing happens to a bond where neither a law nor a largest stretch holds there.
  const bool isIdleElsewhere = !hasInitiation_ && std::isinf(criticalStretch_);
  // Which bonds have broken in an earlier call of the step cannot be seen: those without life at N are broken. Returns
  // whether this one breaks.
  TiringPoints::Known* known = points.known(x, y, fields_.damage.length(data), cycles.range, cycles.peak);
  const double resting = restingStretch(cycles);
  std::size_t at = 0;  // in what is known
  // Bonds are looked at several times at the same places: their strains and rates are found once.
  const auto once = [&](std::vector<double>* values, const auto& find) {
    if (values == nullptr) return find();
    double& value = (*values)[at];
    return std::isnan(value) ? value = find() : value;
  };
  bool isIdle = false;  // the point: none of its bonds loses life
  const auto passCycles = [&](int i, int j, std::size_t bond) {
    const bool grows = hasGrowth_ && (nearTip[i] != 0.0 || nearTip[j] != 0.0);
    if (!grows && isIdleElsewhere) return false;
    if (lost[bond] >= 1.0 || (noFailure != nullptr && (noFailure[i] != 0.0 || noFailure[j] != 0.0))) return false;
    const double stretch = once(known == nullptr ? nullptr : &known->stretches,
                                [&] { return ReferenceBond(y, i, j).length / ReferenceBond(x, i, j).length - 1.0; });
    double rate = 0.0;
    if ((stretch > 0.0 || !seesOpeningAlone_) && (grows || hasInitiation_))
      rate = once(known == nullptr ? nullptr : &known->rates,
                  [&] { return lossRate(grows, std::abs(cycles.range * stretch), i, j); });
    isIdle = isIdle && rate == 0.0;
    lost[bond] += cycles.number * rate;
    if (lost[bond] < 1.0 - lifeTolerance_ && cycles.peak * stretch < criticalStretch_) {
      if (bondDamage[bond] < 1.0) worstRate[i] = std::max(worstRate[i], rate / (1.0 - lost[bond]));
      return false;
    }
    overdrawn[i] = std::max(overdrawn[i], lost[bond] - 1.0);
    if (lost[bond] >= 1.0 - lifeTolerance_) {
      const double left = 1.0 - lost[bond];
      lifeLeft[i] += left;
      rateOfFailed[i] += rate;
      overdrawRate[i] = std::max(overdrawRate[i], rate / std::max(lifeTolerance_ + left, 1e-3 * lifeTolerance_));
    }
    lost[bond] = bondDamage[bond] = 1.0;
    return true;
  };
  for (const std::size_t p : tiring) {
    if (known != nullptr && !points.mayStretch(p, y, resting)) {
      points.leaveOut(p);
      continue;
    }
    const std::size_t first = points.firstBond(p);
    const int i = call.ownedIds[p], count = points.nBonds(p);
    bool hasBroken = false;
    isIdle = true;
    if (known != nullptr) at = points.firstKnown(p);
    for (int k = 0; k < count; ++k, ++at) {
      const std::size_t bond = first + static_cast<std::size_t>(k);
      hasBroken = passCycles(i, points.neighbor(bond, p), bond) || hasBroken;
    }
    if (hasBroken) fields_.damage.of(data)[i] = shareOfBroken(bondDamage + first, count);
    if (known != nullptr && isIdle && !hasBroken) points.leaveOut(p);
  }
}

}  // namespace pd

#endif
