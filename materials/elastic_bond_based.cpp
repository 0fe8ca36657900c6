// Bond-based peridynamics under Peridigm's name: the two-parameter model with k_t = 0 and the constants of Peridigm.
#include <stdexcept>

#include "Peridigm_Material.hpp"
#include "bond_mechanics.hpp"
#include "plugins.hpp"
#include "step_listener.hpp"

namespace pd {

using PeridigmNS::DataManager;

/// One elastic constant is given; Poisson's ratio is that of bond-based peridynamics.
class ElasticBondBased : public PeridigmNS::Material, public FieldUser, public StepListener, public LinearBonds {
 public:
  static void declareParameters(ParameterDeclarations& declare) {
    declare.text("Material Model", "Name of this model.").defaultTo("Elastic Bond Based");
    declare.real("Density", "kg/m3", "Mass density.").positive().required();
    declare.real("Young's Modulus", "Pa", "Young's modulus; it or the bulk modulus is given.").positive();
    declare.real("Bulk Modulus", "Pa", "Bulk modulus of the solid, at Poisson's ratio 1/4, in plane stress 1/3.")
        .positive();
    declare
        .flag("Plane Stress",
              "Plate in the x-y plane. As in Peridigm the bond constant is then 12 K/(pi h delta^3), which is 4/3 of "
              "what gives Young's modulus; PDHE has the right one.")
        .defaultTo(false);
    declare
        .flag("Plane Strain",
              "Slice of a thick body. As in Peridigm the bond constant is then 12 K/(pi h delta^3), which is 5/6 of "
              "what gives Young's modulus; PDHE has the right one.")
        .defaultTo(false);
    declare.real("Height", "m", "Thickness of a plane problem.").positive();
    declare.real("Horizon", "m", "Radius of the neighbourhood; given by the block.").positive();
    declare
        .text("Volume Correction",
              "As of PDHE; by default none, as in Peridigm. The influence function applies, unlike in Peridigm.")
        .oneOf({"Ramp Beyond Horizon", "Ramp To Horizon", "None", "Every Neighbor"})
        .defaultTo("None");
    declare.real("Finite Difference Probe Length", "m", "Step of finite-difference tangents; not used by this model.")
        .positive();
    declare.flag("Apply Automatic Differentiation Jacobian",
                 "Accepted for decks of Peridigm, where it chooses between two ways to the same tangent.");
    declare.exactlyOneOf({"Young's Modulus", "Bulk Modulus"});
    declare.atMostOneOf({"Plane Stress", "Plane Strain"});
  }

  explicit ElasticBondBased(const Teuchos::ParameterList& given)
      : Material(given), params_(checked(given)), mechanics_(mechanicsFrom(params_)) {
    const double nu = poissonsRatio(params_);
    bulkModulus_ = bulkModulus(params_);
    shearModulus_ = 1.5 * bulkModulus_ * (1.0 - 2.0 * nu) / (1.0 + nu);
  }

  std::string Name() const override { return "Elastic Bond Based"; }
  double Density() const override { return params_.get<double>("Density"); }
  double BulkModulus() const override { return bulkModulus_; }
  double ShearModulus() const override { return shearModulus_; }
  const FieldTable& fields() const override { return mechanics_.fields(); }
  std::vector<int> FieldIds() const override { return fields().ids(); }
  static FieldTable describeFields() { return BondMechanics::Fields(SurfaceCorrection::None); }

  void initialize(const double, const int numOwnedPoints, const int* ownedIDs, const int* neighborhoodList,
                  DataManager& dataManager) override {
    mechanics_.initialize({numOwnedPoints, ownedIDs, neighborhoodList}, dataManager);
  }
  void computeForce(const double, const int numOwnedPoints, const int* ownedIDs, const int* neighborhoodList,
                    DataManager& dataManager) const override {
    mechanics_.computeForce({numOwnedPoints, ownedIDs, neighborhoodList}, dataManager);
  }
  void computeStoredElasticEnergyDensity(const double, const int numOwnedPoints, const int* ownedIDs,
                                         const int* neighborhoodList, DataManager& dataManager) const override {
    mechanics_.computeStoredElasticEnergyDensity({numOwnedPoints, ownedIDs, neighborhoodList}, dataManager);
  }
  void computeJacobian(const double dt, const int numOwnedPoints, const int* ownedIDs, const int* neighborhoodList,
                       DataManager& dataManager, PeridigmNS::SerialMatrix& jacobian, JacobianType type) const override {
    if (type == BLOCK_DIAGONAL)
      Material::computeJacobian(dt, numOwnedPoints, ownedIDs, neighborhoodList, dataManager, jacobian, type);
    else
      mechanics_.computeJacobian({numOwnedPoints, ownedIDs, neighborhoodList}, dataManager, jacobian);
  }
  void stepTakenBack() const override { mechanics_.forgetBonds(); }
  LinearSprings::Family springFamily() const override { return mechanics_.springFamily(); }
  LinearSprings springs(const Call& call, DataManager& data) const override { return mechanics_.springs(call, data); }

 private:
  static Teuchos::ParameterList checked(const Teuchos::ParameterList& given) {
    const auto params = completed<ElasticBondBased>(given, "material Elastic Bond Based");
    const bool isPlane = params.get<bool>("Plane Stress") || params.get<bool>("Plane Strain");
    if (isPlane != params.isParameter("Height"))
      throw std::invalid_argument(
          "material Elastic Bond Based: \"Height\" goes with \"Plane Stress: true\" or \"Plane Strain: true\"");
    return params;
  }
  static double poissonsRatio(const Teuchos::ParameterList& params) {
    return params.get<bool>("Plane Stress") ? 1.0 / 3.0 : 0.25;
  }
  static double bulkModulus(const Teuchos::ParameterList& params) {
    return params.isParameter("Bulk Modulus")
               ? params.get<double>("Bulk Modulus")
               : params.get<double>("Young's Modulus") / (3.0 * (1.0 - 2.0 * poissonsRatio(params)));
  }
  static BondMechanics mechanicsFrom(const Teuchos::ParameterList& params) {
    const std::string owner = "material Elastic Bond Based";
    ParameterDeclarations declarations;
    BondFamily::declareParameters(declarations);
    BondMechanics::declareParameters(declarations);
    Teuchos::ParameterList list;
    for (const char* name : {"Plane Stress", "Plane Strain"}) list.set(name, params.get<bool>(name));
    list.set("Volume Correction", params.get<std::string>("Volume Correction"));
    if (params.isParameter("Height")) list.set("Thickness", params.get<double>("Height"));
    if (params.isParameter("Horizon")) list.set("Horizon", params.get<double>("Horizon"));
    const double nu = poissonsRatio(params);
    // Young's modulus for which the right constants (c = 9 E, 9.6 E and 12 E over pi h delta^3, or pi delta^4) are
    // Peridigm's (12 K and 18 K).
    const double ratio = params.get<bool>("Plane Stress")   ? 12.0 / 9.0
                         : params.get<bool>("Plane Strain") ? 12.0 / 9.6
                                                            : 18.0 / 12.0;
    list.set("Young's Modulus", ratio * bulkModulus(params));
    list.set("Poisson's Ratio", nu);
    list = declarations.complete(list, owner);
    return BondMechanics(list, BondFamily(list, owner), owner);
  }

  Teuchos::ParameterList params_;
  BondMechanics mechanics_;
  double bulkModulus_ = 0.0, shearModulus_ = 0.0;
};

PD_REGISTER_MATERIAL(ElasticBondBased, "Elastic Bond Based", "Bond-based peridynamics with the constants of Peridigm.")

}  // namespace pd
