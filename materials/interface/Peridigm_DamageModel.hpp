// The base class of damage models, with the names and signatures of Peridigm's.
// Inside a Peridigm tree Peridigm's own header of this name is found instead.
#ifndef PERIDIGM_DAMAGEMODEL_HPP
#define PERIDIGM_DAMAGEMODEL_HPP

#include <Teuchos_ParameterList.hpp>
#include <string>
#include <vector>

#include "Peridigm_DataManager.hpp"

namespace PeridigmNS {

class DamageModel {
 public:
  explicit DamageModel(const Teuchos::ParameterList&) {}
  virtual ~DamageModel() = default;

  virtual std::string Name() const = 0;
  virtual std::vector<int> FieldIds() const = 0;
  virtual std::vector<int> FieldIdsForSynchronizationAfterInitialize() const { return {}; }
  virtual std::vector<int> FieldIdsForSynchronizationAfterPrecompute() const { return {}; }

  virtual void initialize(const double, const int, const int*, const int*, DataManager&) const {}
  virtual void precompute(const double, const int, const int*, const int*, DataManager&) const {}
  virtual void computeDamage(const double dt, const int numOwnedPoints, const int* ownedIDs,
                             const int* neighborhoodList, DataManager& dataManager) const = 0;
};

}  // namespace PeridigmNS

#endif
