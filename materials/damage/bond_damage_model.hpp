// What damage models that break bonds share.
#ifndef PD_BOND_DAMAGE_MODEL_HPP
#define PD_BOND_DAMAGE_MODEL_HPP

#include "Peridigm_DamageModel.hpp"
#include "fields.hpp"
#include "neighborhood_cache.hpp"

namespace pd {

/// A damage model writes worsen() alone: bonds of NP1 start as they were at N, whatever the storage of the host and
/// however often a step is evaluated. In a block with several damage models each worsens what the others have left.
class BondDamageModel : public PeridigmNS::DamageModel, public FieldUser {
 public:
  /// For the tables of derived models.
  struct Fields : FieldTable {
    FieldHandle damage = worsens(pd::fields::damage());
    FieldHandle bondDamage = worsens(pd::fields::bondDamage());
    FieldHandle noFailure = readsIfThere(pd::fields::noFailure());
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

  /// Bond_Damage and Damage of NP1 become those of N. Nothing to do where a host shares their memory.
  static void carryOver(const Fields& fields, const Call& call, PeridigmNS::DataManager& dataManager);

  /// Raises Bond_Damage of NP1 for both ends of bonds alike, and Damage of the points whose bonds it has changed
  /// (shareOfBroken). Other histories of the model: NP1 from N and dt.
  virtual void worsen(double dt, const Call& call, PeridigmNS::DataManager& dataManager) const = 0;
};

/// Damage of a point: the mean of its `count` bonds; 0 without bonds.
double shareOfBroken(const double* bondDamage, int count);

/// That of all points of the call.
void countBrokenBonds(const Call& call, const double* bondDamage, double* damage);

}  // namespace pd

#endif
