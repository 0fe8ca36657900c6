// Critical stretch that falls with the coverage psi by hydrogen.
#include "critical_stretch.hpp"
#include "hydrogen_degradation.hpp"
#include "plugins.hpp"

namespace pd {

namespace {

constexpr const char* hydrogenCriticalStretch = "damage model Hydrogen Critical Stretch";

}  // namespace

class HydrogenCriticalStretch : public CriticalStretch {
 public:
  static void declareParameters(ParameterDeclarations& declare) {
    declareCommonParameters(declare);
    HydrogenDegradation::declareParameters(declare);
  }

  explicit HydrogenCriticalStretch(const Teuchos::ParameterList& given)
      : HydrogenCriticalStretch(completed<HydrogenCriticalStretch>(given, hydrogenCriticalStretch), IsCompleted()) {}

  static FieldTable describeFields() { return Fields("Concentration"); }

  std::string Name() const override { return "Hydrogen Critical Stretch"; }

 protected:
  bool coverage(PeridigmNS::DataManager& dataManager, kernels::PointArrays& psi) const override {
    degradation_.coverage(fields().concentration, dataManager, psi);
    return true;
  }

 private:
  struct IsCompleted {};
  HydrogenCriticalStretch(const Teuchos::ParameterList& params, IsCompleted)
      : CriticalStretch(params, Fields(HydrogenDegradation::fieldOf(params))),
        degradation_(params, hydrogenCriticalStretch) {
    degradation_.applyTo(law_);
  }

  HydrogenDegradation degradation_;
};

PD_REGISTER_DAMAGE_MODEL(HydrogenCriticalStretch, "Hydrogen Critical Stretch",
                         "Critical stretch that falls with the coverage by hydrogen.")

}  // namespace pd
