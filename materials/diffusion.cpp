// Nonlocal diffusion of the temperature under Peridigm's name, with its constants.
#include "Peridigm_Material.hpp"
#include "nonlocal_diffusion.hpp"
#include "plugins.hpp"

namespace pd {

using PeridigmNS::DataManager;

/// Flux_Divergence_i = sum_j Coefficient 6/(pi delta^4 |xi|) (T_j - T_i) V_j: the kernel "Inverse" of PDHE in three
/// dimensions, in a plane or a bar with the constants of these, without a volume correction. Bonds between blocks as
/// those of PDHE; or, as in Peridigm, each end with the constants of its own block, which leaves the flux unbalanced
/// where these differ.
class DiffusionMaterial : public PeridigmNS::Material, public FieldUser {
 public:
  static void declareParameters(ParameterDeclarations& declare) {
    declare.text("Material Model", "Name of this model.").defaultTo("Diffusion");
    declare.real("Coefficient", "m2/s", "Diffusivity: d(Temperature)/dt = Coefficient x its Laplacian.")
        .positive()
        .required();
    declare
        .flag("Use Improved Quadrature",
              "Weights fitted to each neighbourhood in place of volumes: quadratic fields have their exact Laplacian "
              "everywhere, at faces and on irregular meshes too; fluxes are no longer balanced.")
        .defaultTo(false)
        .from("Trask, You, Yu & Parks, CMAME 343 (2019) 151");
    declare.real("Horizon", "m", "Radius of the neighbourhood; given by the block.").positive();
    BondFamily::declareSection(declare);
    BondFamily::declareAxis(declare);
    declare.text("Volume Correction", "As of PDHE; by default none, as in Peridigm.")
        .oneOf({"Ramp Beyond Horizon", "Ramp To Horizon", "None", "Every Neighbor"})
        .defaultTo("None");
    declare
        .text(
            "Interface Flux",
            "What a bond between blocks of different Coefficient carries: what the resistances along it in series let "
            "through, to both ends (Series); or to each end what the constants of its own block say, as in Peridigm, "
            "which ignores the jump: what leaves one block is not what enters the other one (Own Constants).")
        .oneOf({"Series", "Own Constants"})
        .defaultTo("Series");
    declare.real("Finite Difference Probe Length", "m", "Step of finite-difference tangents; not used by this model.")
        .positive();
  }

  explicit DiffusionMaterial(const Teuchos::ParameterList& given) : Material(given), diffusion_(diffusionFrom(given)) {}

  std::string Name() const override { return "Diffusion"; }
  // It has no mechanics; Peridigm asks every material for these.
  double Density() const override { return 1.0; }
  double BulkModulus() const override { return 0.0; }
  double ShearModulus() const override { return 0.0; }
  const FieldTable& fields() const override { return diffusion_.fields(); }
  std::vector<int> FieldIds() const override { return fields().ids(); }
  std::vector<int> FieldIdsForSynchronizationAfterInitialize() const override {
    return fields().ids(Ghosts::AfterInitialize);
  }
  static FieldTable describeFields() { return NonlocalDiffusion::Fields("Temperature"); }

  void initialize(const double, const int numOwnedPoints, const int* ownedIDs, const int* neighborhoodList,
                  DataManager& dataManager) override {
    diffusion_.initialize({numOwnedPoints, ownedIDs, neighborhoodList}, dataManager);
  }
  void computeFluxDivergence(const double, const int numOwnedPoints, const int* ownedIDs, const int* neighborhoodList,
                             DataManager& dataManager) const override {
    diffusion_.computeFluxDivergence({numOwnedPoints, ownedIDs, neighborhoodList}, dataManager);
  }
  void computeJacobian(const double dt, const int numOwnedPoints, const int* ownedIDs, const int* neighborhoodList,
                       DataManager& dataManager, PeridigmNS::SerialMatrix& jacobian, JacobianType type) const override {
    if (type == BLOCK_DIAGONAL)
      Material::computeJacobian(dt, numOwnedPoints, ownedIDs, neighborhoodList, dataManager, jacobian, type);
    else
      diffusion_.computeJacobian({numOwnedPoints, ownedIDs, neighborhoodList}, dataManager, jacobian);
  }

 private:
  static NonlocalDiffusion diffusionFrom(const Teuchos::ParameterList& given) {
    const std::string owner = "material Diffusion";
    ParameterDeclarations own, shared;
    declareParameters(own);
    const Teuchos::ParameterList params = own.complete(given, owner);
    BondFamily::declareParameters(shared);
    BondFamily::declareAxis(shared);
    NonlocalDiffusion::declareParameters(shared);
    Teuchos::ParameterList list;
    for (const char* key : {"Horizon", "Plane Stress", "Plane Strain", "Thickness", "One Dimensional",
                            "Cross Section Area", "Volume Correction", axisOfRevolution})
      if (params.isParameter(key)) list.setEntry(key, params.getEntry(key));
    list.set("Diffusivity", params.get<double>("Coefficient"));
    list.set<std::string>("Diffusion Kernel", "Inverse");
    list.set<std::string>("Diffusing Field", "Temperature");
    list = shared.complete(list, owner);
    if (params.isParameter(axisOfRevolution) && params.get<bool>("Use Improved Quadrature"))
      throw std::invalid_argument(
          owner +
          ": the improved quadrature fits weights to neighbourhoods in a plane or in space, and this is a body "
          "of revolution; leave \"Use Improved Quadrature\" out");
    return NonlocalDiffusion(list, BondFamily(list, owner), owner,
                             params.get<std::string>("Interface Flux") == "Series"
                                 ? NonlocalDiffusion::Interface::Series
                                 : NonlocalDiffusion::Interface::OwnConstants,
                             params.get<bool>("Use Improved Quadrature") ? NonlocalDiffusion::Quadrature::Fitted
                                                                         : NonlocalDiffusion::Quadrature::Volumes);
  }

  NonlocalDiffusion diffusion_;
};

PD_REGISTER_MATERIAL(DiffusionMaterial, "Diffusion", "Diffusion of temperature with the constants of Peridigm.")

}  // namespace pd
