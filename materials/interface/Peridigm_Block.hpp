// A block: points that share a material. What plug-ins use of Peridigm's Block.
#ifndef PERIDIGM_BLOCK_HPP
#define PERIDIGM_BLOCK_HPP

#include <string>

#include "Peridigm_DamageModel.hpp"
#include "Peridigm_Material.hpp"
#include "Peridigm_NeighborhoodData.hpp"

namespace PeridigmNS {

class Block {
 public:
  Block(std::string name, int id) : name_(std::move(name)), id_(id) {}

  std::string getName() { return name_; }
  int getID() { return id_; }
  int numPoints() { return neighborhood_->NumOwnedPoints(); }
  Teuchos::RCP<NeighborhoodData> getNeighborhoodData() { return neighborhood_; }
  Teuchos::RCP<DataManager> getDataManager() { return dataManager_; }
  Teuchos::RCP<FieldVector> getData(int fieldId, PeridigmField::Step step) {
    return dataManager_->getData(fieldId, step);
  }
  bool hasData(int fieldId, PeridigmField::Step step) { return dataManager_->hasData(fieldId, step); }
  Teuchos::RCP<const PointMap> getOwnedScalarPointMap() { return dataManager_->getOwnedScalarPointMap(); }
  Teuchos::RCP<const PointMap> getOverlapScalarPointMap() { return dataManager_->getOverlapScalarPointMap(); }
  Teuchos::RCP<const Material> getMaterialModel() { return material_; }
  Teuchos::RCP<const DamageModel> getDamageModel() { return damageModel_; }

  // Set once by the host.
  void setNeighborhoodData(Teuchos::RCP<NeighborhoodData> data) { neighborhood_ = data; }
  void setDataManager(Teuchos::RCP<DataManager> dataManager) { dataManager_ = dataManager; }
  void setMaterialModel(Teuchos::RCP<Material> material) { material_ = material; }
  void setDamageModel(Teuchos::RCP<DamageModel> damageModel) { damageModel_ = damageModel; }
  Teuchos::RCP<Material> getMutableMaterialModel() { return material_; }

 private:
  std::string name_;
  int id_;
  Teuchos::RCP<NeighborhoodData> neighborhood_;
  Teuchos::RCP<DataManager> dataManager_;
  Teuchos::RCP<Material> material_;
  Teuchos::RCP<DamageModel> damageModel_;
};

}  // namespace PeridigmNS

#endif
