// What damage models that break bonds share.
#ifndef PD_BOND_DAMAGE_MODEL_HPP
#define PD_BOND_DAMAGE_MODEL_HPP

#include <vector>

#include "Peridigm_DamageModel.hpp"
#include "fields.hpp"
#include "neighborhood_cache.hpp"

namespace pd {

/// Largest Damage of a solid point where Damage 1 says that a point is liquid.
constexpr double mostDamagedSolid = 1.0 - 1e-12;

/// A damage model writes worsen() alone: bonds of NP1 start as they were at N, whatever the storage of the host and
/// however often a step is evaluated. In a block with several damage models each worsens what the others have left.
class BondDamageModel : public PeridigmNS::DamageModel, public FieldUser {
 public:
  /// For the tables of derived models.
  struct Fields : FieldTable {
    FieldHandle damage = worsens(pd::fields::damage());
    FieldHandle bondDamage;
    FieldHandle noFailure = readsIfThere(pd::fields::noFailure());
    FieldHandle interactionShare = readsIfThere(pd::fields::interactionShare());
    FieldHandle countedBonds = readsIfThere(pd::fields::countedBonds());
    /// Where it does not bring bonds, it breaks those that others bring.
    explicit Fields(bool bringsBonds = true) {
      bondDamage = bringsBonds ? worsens(pd::fields::bondDamage()) : worsensIfThere(pd::fields::bondDamage());
    }
  };

  using DamageModel::DamageModel;
  const Fields& fields() const override = 0;
  std::vector<int> FieldIds() const override { return fields().ids(); }
  std::vector<int> FieldIdsForSynchronizationAfterInitialize() const override {
    return fields().ids(Ghosts::AfterInitialize);
  }
  std::vector<int> FieldIdsForSynchronizationAfterPrecompute() const override {
    return fields().ids(Ghosts::AfterPrecompute);
  }

  /// Damage of bonds that were cut before the run.
  void initialize(const double, const int numOwnedPoints, const int* ownedIDs, const int* neighborhoodList,
                  PeridigmNS::DataManager& dataManager) const override;
  void computeDamage(const double dt, const int numOwnedPoints, const int* ownedIDs, const int* neighborhoodList,
                     PeridigmNS::DataManager& dataManager) const final;

  /// Bond_Damage and Damage of NP1 become those of N. Nothing to do where a host shares their memory, or in a block
  /// whose bonds have no state.
  static void carryOver(const Fields& fields, const Call& call, PeridigmNS::DataManager& dataManager);
  /// Where cracks and voids of the deck take a part of bonds, Damage of points becomes the lost share of what counts
  /// (Counted_Bonds).
  static void weighBonds(const Fields& fields, const Call& call, PeridigmNS::DataManager& dataManager);

  /// Raises Bond_Damage of NP1 for both ends of bonds alike, and Damage of the points whose bonds it has changed
  /// (shareOfBroken). Other histories of the model: NP1 from N and dt.
  virtual void worsen(double dt, const Call& call, PeridigmNS::DataManager& dataManager) const = 0;
  /// Does it set Damage to 1 where a point is liquid, for good? Solid points then have less, broken bonds or not.
  virtual bool marksLiquid() const { return false; }
};

/// Which points are liquid in a block where Damage 1 says so, kept while broken bonds are counted.
class LiquidPoints {
 public:
  LiquidPoints(const Call& call, const double* damage);
  /// Damage 1 of these, less of all other points.
  void restore(const Call& call, double* damage) const;

 private:
  std::vector<int> points_;  ///< local ids in the order of the call
};

/// Damage of a point: the mean of its `count` bonds; 0 without bonds.
double shareOfBroken(const double* bondDamage, int count);

/// That of all points of the call.
void countBrokenBonds(const Call& call, const double* bondDamage, double* damage);

}  // namespace pd

#endif
