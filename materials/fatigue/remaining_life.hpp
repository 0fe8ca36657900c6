// Fatigue of bonds: each has a life, of which cycles of load take their part (Silling & Askari, SAND2014-18590).
#ifndef PD_REMAINING_LIFE_HPP
#define PD_REMAINING_LIFE_HPP

#include <memory>
#include <set>
#include <string>
#include <vector>

#include "bond_damage_model.hpp"
#include "cycle_fields.hpp"
#include "growth_coefficient.hpp"
#include "life_law.hpp"
#include "run_notes.hpp"

namespace pd {

/// With e = |(1 - R) s| the range of the strain of a bond whose largest stretch in a cycle is s:
///   I    away from cracks     d(lost life)/dN = A1 (e - limit)^m1, or 1/N of a strain-life table
///   II   near a crack tip     d(lost life)/dN = A2 e^m2
///   III  in any cycle         the bond breaks where its largest stretch is the critical one
/// and a bond without life is broken. A point is near a crack tip once it or a neighbour has lost `Growth Damage` of
/// its bonds; a bond where either end is. What points lost by the start of the step counts: exchanged by precompute().
/// A host says how many cycles a step has, and their load (cycle_fields.hpp), or the parameters do.
class RemainingLife : public BondDamageModel, public RunNotes {
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
  };
  static void declareParameters(ParameterDeclarations& declare);
  explicit RemainingLife(const Teuchos::ParameterList& given);

  std::string Name() const override { return "Remaining Life"; }
  const Fields& fields() const override { return fields_; }
  /// Throws std::invalid_argument where nobody says how many cycles a step has, or both do.
  void initialize(const double dt, const int numOwnedPoints, const int* ownedIDs, const int* neighborhoodList,
                  PeridigmNS::DataManager& data) const override;
  void precompute(const double dt, const int numOwnedPoints, const int* ownedIDs, const int* neighborhoodList,
                  PeridigmNS::DataManager& data) const override;
  void worsen(double dt, const Call& call, PeridigmNS::DataManager& data) const override;
  std::vector<std::string> runNotes() const override;

 private:
  struct Cycles {
    double number, range, peak;
  };
  Cycles cyclesOf(PeridigmNS::DataManager& data) const;
  void requireSpacing(const Call& call, PeridigmNS::DataManager& data) const;

  Fields fields_;
  bool hasOwnCycles_ = false;
  Cycles own_{0.0, 1.0, 1.0};
  bool seesOpeningAlone_ = true, hasInitiation_ = false, hasGrowth_ = false;
  double growthDamage_, lifeTolerance_, criticalStretch_;
  kernels::LifeLaw initiation_, growth_;
  std::unique_ptr<GrowthCoefficient> paris_;
  mutable std::set<const PeridigmNS::DataManager*> prepared_;  ///< blocks whose Growth_Phase is there
};

}  // namespace pd

#endif
