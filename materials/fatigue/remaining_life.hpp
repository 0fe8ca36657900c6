// Fatigue of bonds by powers of their strain ranges (Silling & Askari, SAND2014-18590).
#ifndef PD_REMAINING_LIFE_HPP
#define PD_REMAINING_LIFE_HPP

#include <memory>
#include <string>
#include <vector>

#include "cyclic_damage.hpp"
#include "growth_coefficient.hpp"
#include "life_law.hpp"

namespace pd {

/// With e the strain range of a bond:
///   I    away from cracks     d(lost life)/dN = A1 (e - limit)^m1, or 1/N of a strain-life table
///   II   near a crack tip     d(lost life)/dN = A2 e^m2
///   III  in any cycle         the bond breaks where its largest stretch is the critical one
class RemainingLife : public CyclicDamage {
 public:
  static void declareParameters(ParameterDeclarations& declare);
  explicit RemainingLife(const Teuchos::ParameterList& given);

  void initialize(const double dt, const int numOwnedPoints, const int* ownedIDs, const int* neighborhoodList,
                  PeridigmNS::DataManager& data) const override;
  void worsen(double dt, const Call& call, PeridigmNS::DataManager& data) const override;
  std::vector<std::string> runNotes() const override;

 private:
  kernels::LifeLaw initiation_, growth_;
  std::unique_ptr<GrowthCoefficient> paris_;
};

}  // namespace pd

#endif
