// Breakage by the energy of points, which falls with the coverage psi by hydrogen.
#include "hydrogen_degradation.hpp"
#include "nodal_energy.hpp"
#include "plugins.hpp"

namespace pd {

namespace {

constexpr const char* hydrogenNodalEnergy = "damage model Hydrogen Nodal Energy";

}  // namespace

class HydrogenNodalEnergy : public NodalEnergy {
 public:
  static void declareParameters(ParameterDeclarations& declare) {
    declareCommonParameters(declare);
    HydrogenDegradation::declareParameters(declare);
  }

  explicit HydrogenNodalEnergy(const Teuchos::ParameterList& given)
      : HydrogenNodalEnergy(completed<HydrogenNodalEnergy>(given, hydrogenNodalEnergy), IsCompleted()) {}

  static FieldTable describeFields() { return Fields("Concentration"); }

  std::string Name() const override { return "Hydrogen Nodal Energy"; }

 protected:
  bool coverage(PeridigmNS::DataManager& dataManager, kernels::PointArrays& psi) const override {
    hydrogen_.coverage(fields().concentration, dataManager, psi);
    return true;
  }

 private:
  struct IsCompleted {};
  HydrogenNodalEnergy(const Teuchos::ParameterList& params, IsCompleted)
      : NodalEnergy(params, Fields(HydrogenDegradation::fieldOf(params)), hydrogenNodalEnergy),
        hydrogen_(params, hydrogenNodalEnergy) {
    hydrogen_.applyTo(degradation_);
  }

  HydrogenDegradation hydrogen_;
};

PD_REGISTER_DAMAGE_MODEL(HydrogenNodalEnergy, "Hydrogen Nodal Energy",
                         "Nodal Energy with a fracture energy that falls with the coverage by hydrogen.")

}  // namespace pd
