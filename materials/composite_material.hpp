// Several materials of one block as one: each does its own physics and adds to shared fields.
#ifndef PD_COMPOSITE_MATERIAL_HPP
#define PD_COMPOSITE_MATERIAL_HPP

#include <functional>
#include <string>
#include <vector>

#include "Peridigm_Material.hpp"
#include "asymmetric_rate.hpp"
#include "fields.hpp"
#include "flow_law.hpp"
#include "linear_bonds.hpp"
#include "parameters.hpp"
#include "run_notes.hpp"
#include "separate_rates.hpp"
#include "share_bringer.hpp"
#include "step_listener.hpp"

namespace pd {

/// `Materials` names the parts; each has a sub-list of its parameters under its name. pdrun makes it of a list of names
/// in a block. What a point has dissolved into carries no load: where one part follows Damage and another has forces,
/// the composite asks for Bond_Damage, in which the damage model Dissolution then breaks the bonds of liquid points.
class CompositeMaterial : public PeridigmNS::Material,
                          public FieldUser,
                          public StepListener,
                          public RunNotes,
                          public SeparateRates,
                          public LinearBonds,
                          public FlowMaterial,
                          public AsymmetricRate,
                          public ShareBringer {
 public:
  static constexpr const char* partsKey = "Materials";
  static void declareParameters(ParameterDeclarations& declare);
  /// Throws std::invalid_argument where a part refuses its parameters, two parts claim one field or differ in Density,
  /// a part with forces knows no broken bonds beside one that dissolves, or parts look beyond the horizon in a mesh of
  /// which another one says that its volumes are not those of cells.
  explicit CompositeMaterial(const Teuchos::ParameterList& params);

  std::string Name() const override { return "Combined"; }
  /// That of the parts with forces; else of the first part that has one. Throws std::invalid_argument where none has.
  double Density() const override;
  /// Parts with forces are springs side by side: their moduli add up.
  double BulkModulus() const override;
  double ShearModulus() const override;
  double lookupMaterialProperty(const std::string keyname) const override;
  const FieldTable& fields() const override { return fields_; }
  std::vector<int> FieldIds() const override { return fields_.ids(); }
  std::vector<int> FieldIdsForSynchronizationAfterInitialize() const override;
  std::vector<int> FieldIdsForSynchronizationAfterPrecompute() const override;
  std::vector<std::string> runNotes() const override;

  void initialize(const double dt, const int numOwnedPoints, const int* ownedIDs, const int* neighborhoodList,
                  PeridigmNS::DataManager& dataManager) override;
  void precompute(const double dt, const int numOwnedPoints, const int* ownedIDs, const int* neighborhoodList,
                  PeridigmNS::DataManager& dataManager) const override;
  void computeForce(const double dt, const int numOwnedPoints, const int* ownedIDs, const int* neighborhoodList,
                    PeridigmNS::DataManager& dataManager) const override;
  void computeFluxDivergence(const double dt, const int numOwnedPoints, const int* ownedIDs,
                             const int* neighborhoodList, PeridigmNS::DataManager& dataManager) const override;
  void computeStoredElasticEnergyDensity(const double dt, const int numOwnedPoints, const int* ownedIDs,
                                         const int* neighborhoodList,
                                         PeridigmNS::DataManager& dataManager) const override;
  /// Of each part, for the unknowns whose rates it gives.
  void computeJacobian(const double dt, const int numOwnedPoints, const int* ownedIDs, const int* neighborhoodList,
                       PeridigmNS::DataManager& dataManager, PeridigmNS::SerialMatrix& jacobian,
                       JacobianType jacobianType = FULL_MATRIX) const override;
  void prepareRate(int rateField, double dt, const Call& call, PeridigmNS::DataManager& data) const override;
  void computeRate(int rateField, double dt, const Call& call, PeridigmNS::DataManager& data) const override;
  void stepAccepted(const Call& call, PeridigmNS::DataManager& data, double time, double dt) const override;
  void stepTakenBack() const override;
  /// Those of the one part that has forces.
  bool hasSprings() const override { return springPart() != nullptr; }
  std::string springsObstacle() const override;
  LinearSprings::Family springFamily() const override { return springPart()->springFamily(); }
  LinearSprings springs(const Call& call, PeridigmNS::DataManager& data) const override {
    return springPart()->springs(call, data);
  }

  const FlowLaw* flowLaw() const override;
  bool isAsymmetric(const std::string& label) const override;
  std::string sourceOfShares() const override;

 private:
  struct Part {
    std::string name;
    Teuchos::RCP<PeridigmNS::Material> material;
    FieldTable table;
    bool adds(int field) const;
    bool hasForce() const;
    bool bringsShares() const;
  };
  struct Fields : FieldTable {
    void bringBondDamage() { reads(pd::fields::bondDamage()); }
  };

  /// Null where several parts have forces, or the one has no springs.
  const LinearBonds* springPart() const;
  void checkDensities() const;
  /// Refuses parts that look beyond the horizon by volumes of the mesh which are not those of cells.
  static void checkVolumeCorrections(const Teuchos::ParameterList& params);
  /// Refuses parts that do not know shares of bonds.
  void requireSharesKnown() const;
  /// Bond_Damage where a part dissolves what another one loads.
  void bringBonds();
  void findSharedSums();
  /// Sum over parts of what `of` asks of each, in fields that several of them zero before they add.
  void addUp(const std::function<bool(const Part&)>& isAsked, const std::function<void(const Part&)>& work,
             PeridigmNS::DataManager& data) const;

  std::vector<Part> parts_;
  Fields fields_;
  std::vector<int> sharedSums_;                   ///< that two parts or more add to
  std::vector<FieldHandle> sharedDiffusivities_;  ///< that two parts or more write as they are initialized
};

}  // namespace pd

#endif
