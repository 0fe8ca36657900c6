// Peridynamic hydrogen embrittlement: two-parameter bond mechanics and hydrogen diffusion in one material.
#ifndef PD_PDHE_HPP
#define PD_PDHE_HPP

#include <optional>
#include <string>
#include <vector>

#include "Peridigm_Material.hpp"
#include "bond_mechanics.hpp"
#include "linear_bonds.hpp"
#include "nonlocal_diffusion.hpp"
#include "step_listener.hpp"

namespace pd {

/// Mechanics where Young's Modulus is given, diffusion where Diffusivity is; at least one of them. The embrittlement
/// itself, the critical stretch that falls with hydrogen, is the damage model Hydrogen Critical Stretch.
class PDHE : public PeridigmNS::Material, public FieldUser, public StepListener, public LinearBonds {
 public:
  static FieldTable describeFields();

  static void declareParameters(ParameterDeclarations& declare);
  explicit PDHE(const Teuchos::ParameterList& params);

  std::string Name() const override { return "PDHE"; }
  /// Throws std::invalid_argument where no density was given.
  double Density() const override;
  double BulkModulus() const override;
  double ShearModulus() const override;
  const FieldTable& fields() const override { return fields_; }
  std::vector<int> FieldIds() const override { return fields_.ids(); }
  std::vector<int> FieldIdsForSynchronizationAfterInitialize() const override {
    return fields_.ids(Ghosts::AfterInitialize);
  }

  void initialize(const double, const int numOwnedPoints, const int* ownedIDs, const int* neighborhoodList,
                  PeridigmNS::DataManager& dataManager) override;
  void computeForce(const double, const int numOwnedPoints, const int* ownedIDs, const int* neighborhoodList,
                    PeridigmNS::DataManager& dataManager) const override;
  void computeFluxDivergence(const double, const int numOwnedPoints, const int* ownedIDs, const int* neighborhoodList,
                             PeridigmNS::DataManager& dataManager) const override;
  void computeStoredElasticEnergyDensity(const double, const int numOwnedPoints, const int* ownedIDs,
                                         const int* neighborhoodList,
                                         PeridigmNS::DataManager& dataManager) const override;
  void computeJacobian(const double dt, const int numOwnedPoints, const int* ownedIDs, const int* neighborhoodList,
                       PeridigmNS::DataManager& dataManager, PeridigmNS::SerialMatrix& jacobian,
                       JacobianType jacobianType = FULL_MATRIX) const override;
  void stepTakenBack() const override;
  bool hasSprings() const override { return mechanics_.has_value(); }
  LinearSprings::Family springFamily() const override { return mechanics_->springFamily(); }
  LinearSprings springs(const Call& call, PeridigmNS::DataManager& data) const override {
    return mechanics_->springs(call, data);
  }

 private:
  double density_ = 0.0;
  std::optional<BondMechanics> mechanics_;
  std::optional<NonlocalDiffusion> diffusion_;
  FieldTable fields_;
};

}  // namespace pd

#endif
