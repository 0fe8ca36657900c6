#include "hydrogen_degradation.hpp"

#include <Teuchos_Array.hpp>
#include <algorithm>
#include <stdexcept>

namespace pd {

void HydrogenDegradation::declareParameters(ParameterDeclarations& declare) {
  declare.real("Saturation Concentration", "unit of the concentration field", "Concentration at coverage 1.")
      .positive()
      .required();
  declare.text("Concentration Field", "Label of the concentration field.").defaultTo("Concentration");
  declare
      .text("Degradation Law",
            "What f(psi) = 1 - 1.0467 psi + 0.1687 psi^2 scales: the critical stretch (then the fracture energy falls "
            "with f^2), the fracture energy (then the stretch falls with its root), or the stretch by the user's "
            "Polynomial. psi is the mean coverage of both ends, within [0, 1].")
      .oneOf({"Critical Stretch", "Fracture Energy", "Polynomial"})
      .defaultTo("Critical Stretch")
      .from("Serebrinsky, Carter & Ortiz, JMPS 52 (2004) 2403");
  declare.reals("Polynomial", "1", "Coefficients of 1, psi, psi^2, psi^3 (up to four) of the law Polynomial.");
}

HydrogenDegradation::HydrogenDegradation(const Teuchos::ParameterList& params, const std::string& owner)
    : saturation_(params.get<double>("Saturation Concentration")), polynomial_{1.0, -1.0467, 0.1687, 0.0} {
  const std::string law = params.get<std::string>("Degradation Law");
  scalesEnergy_ = law == "Fracture Energy";
  const bool isPolynomial = law == "Polynomial";
  if (isPolynomial != params.isParameter("Polynomial"))
    throw std::invalid_argument(owner + ": \"Polynomial\" and \"Degradation Law: Polynomial\" go together");
  if (!isPolynomial) return;
  const auto coefficients = params.get<Teuchos::Array<double>>("Polynomial");
  if (coefficients.size() == 0 || coefficients.size() > 4)
    throw std::invalid_argument(owner + ": \"Polynomial\" takes 1 to 4 coefficients");
  polynomial_.fill(0.0);
  std::copy(coefficients.begin(), coefficients.end(), polynomial_.begin());
}

void HydrogenDegradation::applyTo(kernels::CriticalStretchLaw& law) const {
  law.polynomial = polynomial_;
  law.scalesEnergy = scalesEnergy_;
}

void HydrogenDegradation::coverage(const FieldHandle& concentration, PeridigmNS::DataManager& data,
                                   kernels::PointArrays& psi) const {
  const double* values = concentration.of(data);
  const int nPoints = concentration.length(data);
  psi.copy(values, nPoints);
  for (int i = 0; i < nPoints; ++i) psi[0][i] = std::clamp(values[i] / saturation_, 0.0, 1.0);
}

}  // namespace pd
