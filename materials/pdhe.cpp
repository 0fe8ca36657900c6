#include "pdhe.hpp"

#include <stdexcept>

#include "plugins.hpp"

namespace pd {

using PeridigmNS::DataManager;

void PDHE::declareParameters(ParameterDeclarations& declare) {
  declare.text("Material Model", "Name of this model.").defaultTo("PDHE");
  declare.real("Density", "kg/m3", "Mass density; needed by dynamic solvers.").positive();
  BondMechanics::declareParameters(declare);
  NonlocalDiffusion::declareParameters(declare);
  BondFamily::declareParameters(declare);
  declare.real("Finite Difference Probe Length", "m", "Step of finite-difference tangents; not used by this model.")
      .positive();
  declare.atLeastOneOf({"Young's Modulus", "Diffusivity"});
}

PDHE::PDHE(const Teuchos::ParameterList& given) : Material(given) {
  const Teuchos::ParameterList params = completed<PDHE>(given, "material PDHE");
  const std::string owner = "material PDHE";
  const BondFamily family(params, owner);
  if (params.isParameter("Density")) density_ = params.get<double>("Density");
  if (params.isParameter("Young's Modulus")) {
    mechanics_.emplace(params, family, owner);
    fields_.include(mechanics_->fields());
  }
  if (params.isParameter("Diffusivity")) {
    diffusion_.emplace(params, family, owner);
    fields_.include(diffusion_->fields());
  }
}

double PDHE::Density() const {
  if (density_ == 0.0) throw std::invalid_argument("material PDHE: \"Density\" is missing, and this solver needs it");
  return density_;
}

double PDHE::BulkModulus() const {
  return mechanics_ ? mechanics_->youngsModulus() / (3.0 * (1.0 - 2.0 * mechanics_->poissonsRatio())) : 0.0;
}

double PDHE::ShearModulus() const {
  return mechanics_ ? mechanics_->youngsModulus() / (2.0 * (1.0 + mechanics_->poissonsRatio())) : 0.0;
}

FieldTable PDHE::describeFields() {
  FieldTable table;
  table.include(BondMechanics::Fields(SurfaceCorrection::EnergyMethod));
  table.include(NonlocalDiffusion::Fields("Concentration"));
  return table;
}

void PDHE::initialize(const double, const int numOwnedPoints, const int* ownedIDs, const int* neighborhoodList,
                      DataManager& dataManager) {
  const Call call{numOwnedPoints, ownedIDs, neighborhoodList};
  if (mechanics_) mechanics_->initialize(call, dataManager);
  if (diffusion_) diffusion_->initialize(call, dataManager);
}

void PDHE::computeForce(const double, const int numOwnedPoints, const int* ownedIDs, const int* neighborhoodList,
                        DataManager& dataManager) const {
  if (mechanics_) mechanics_->computeForce({numOwnedPoints, ownedIDs, neighborhoodList}, dataManager);
}

void PDHE::computeFluxDivergence(const double, const int numOwnedPoints, const int* ownedIDs,
                                 const int* neighborhoodList, DataManager& dataManager) const {
  if (diffusion_) diffusion_->computeFluxDivergence({numOwnedPoints, ownedIDs, neighborhoodList}, dataManager);
}

void PDHE::computeStoredElasticEnergyDensity(const double, const int numOwnedPoints, const int* ownedIDs,
                                             const int* neighborhoodList, DataManager& dataManager) const {
  if (mechanics_)
    mechanics_->computeStoredElasticEnergyDensity({numOwnedPoints, ownedIDs, neighborhoodList}, dataManager);
}

void PDHE::computeJacobian(const double dt, const int numOwnedPoints, const int* ownedIDs, const int* neighborhoodList,
                           DataManager& dataManager, PeridigmNS::SerialMatrix& jacobian, JacobianType type) const {
  if (type == BLOCK_DIAGONAL) {
    Material::computeJacobian(dt, numOwnedPoints, ownedIDs, neighborhoodList, dataManager, jacobian, type);
    return;
  }
  const Call call{numOwnedPoints, ownedIDs, neighborhoodList};
  if (mechanics_) mechanics_->computeJacobian(call, dataManager, jacobian);
  if (diffusion_) diffusion_->computeJacobian(call, dataManager, jacobian);
}

void PDHE::stepTakenBack() const {
  if (mechanics_) mechanics_->forgetBonds();
  if (diffusion_) diffusion_->forgetBonds();
}

PD_REGISTER_MATERIAL(PDHE, "PDHE", "Hydrogen embrittlement: two-parameter bond mechanics and hydrogen diffusion.")

}  // namespace pd
