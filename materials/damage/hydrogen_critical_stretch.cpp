// Critical stretch that falls with the coverage psi by hydrogen.
#include <Teuchos_Array.hpp>
#include <algorithm>
#include <stdexcept>

#include "critical_stretch.hpp"
#include "plugins.hpp"

namespace pd {

using PeridigmNS::DataManager;

namespace {

/// f(psi) = 1 - 1.0467 psi + 0.1687 psi^2: Serebrinsky, Carter & Ortiz, JMPS 52 (2004) 2403, after the first-principles
/// results of Jiang & Carter, Acta Mater. 52 (2004) 4801.
constexpr std::array<double, 4> decohesion = {1.0, -1.0467, 0.1687, 0.0};

constexpr const char* owner = "damage model Hydrogen Critical Stretch";

}  // namespace

class HydrogenCriticalStretch : public CriticalStretch {
 public:
  static void declareParameters(ParameterDeclarations& declare) {
    declareCommonParameters(declare);
    declare.real("Saturation Concentration", "unit of the concentration field", "Concentration at coverage 1.")
        .positive()
        .required();
    declare.text("Concentration Field", "Label of the concentration field.").defaultTo("Concentration");
    declare
        .text(
            "Degradation Law",
            "What f(psi) = 1 - 1.0467 psi + 0.1687 psi^2 scales: the critical stretch (then the fracture energy falls "
            "with f^2), the fracture energy (then the stretch falls with its root), or the stretch by the user's "
            "Polynomial. psi is the mean coverage of both ends, within [0, 1].")
        .oneOf({"Critical Stretch", "Fracture Energy", "Polynomial"})
        .defaultTo("Critical Stretch")
        .from("Serebrinsky, Carter & Ortiz, JMPS 52 (2004) 2403");
    declare.reals("Polynomial", "1", "Coefficients of 1, psi, psi^2, psi^3 (up to four) of the law Polynomial.");
  }

  explicit HydrogenCriticalStretch(const Teuchos::ParameterList& given)
      : CriticalStretch(completed<HydrogenCriticalStretch>(given, owner), tableOf(given)) {
    const auto params = completed<HydrogenCriticalStretch>(given, owner);
    saturation_ = params.get<double>("Saturation Concentration");
    const std::string law = params.get<std::string>("Degradation Law");
    law_.polynomial = decohesion;
    law_.scalesEnergy = law == "Fracture Energy";
    const bool isPolynomial = law == "Polynomial";
    if (isPolynomial != params.isParameter("Polynomial"))
      throw std::invalid_argument(std::string(owner) +
                                  ": \"Polynomial\" and \"Degradation Law: Polynomial\" go together");
    if (isPolynomial) setPolynomial(params.get<Teuchos::Array<double>>("Polynomial"));
  }

  static FieldTable describeFields() { return Fields("Concentration"); }

  std::string Name() const override { return "Hydrogen Critical Stretch"; }

 protected:
  bool coverage(DataManager& dataManager, kernels::PointArrays& psi) const override {
    const double* concentration = fields().concentration.of(dataManager);
    const int nPoints = fields().concentration.length(dataManager);
    psi.copy(concentration, nPoints);
    for (int i = 0; i < nPoints; ++i) psi[0][i] = std::clamp(concentration[i] / saturation_, 0.0, 1.0);
    return true;
  }

 private:
  static Fields tableOf(const Teuchos::ParameterList& given) {
    return Fields(completed<HydrogenCriticalStretch>(given, owner).get<std::string>("Concentration Field"));
  }
  void setPolynomial(const Teuchos::Array<double>& coefficients) {
    if (coefficients.size() == 0 || coefficients.size() > 4)
      throw std::invalid_argument(std::string(owner) + ": \"Polynomial\" takes 1 to 4 coefficients");
    law_.polynomial.fill(0.0);
    std::copy(coefficients.begin(), coefficients.end(), law_.polynomial.begin());
  }

  double saturation_ = 1.0;
};

PD_REGISTER_DAMAGE_MODEL(HydrogenCriticalStretch, "Hydrogen Critical Stretch",
                         "Critical stretch that falls with the coverage by hydrogen.")

}  // namespace pd
