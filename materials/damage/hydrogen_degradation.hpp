// How hydrogen weakens bonds: the law of decohesion that damage models share.
#ifndef PD_HYDROGEN_DEGRADATION_HPP
#define PD_HYDROGEN_DEGRADATION_HPP

#include <string>

#include "fields.hpp"
#include "parameters.hpp"
#include "point_arrays.hpp"
#include "stretch_kernel.hpp"

namespace pd {

/// f(psi) = 1 - 1.0467 psi + 0.1687 psi^2 of Serebrinsky, Carter & Ortiz, JMPS 52 (2004) 2403, after the
/// first-principles results of Jiang & Carter, Acta Mater. 52 (2004) 4801, or a polynomial of the user.
class HydrogenDegradation {
 public:
  static void declareParameters(ParameterDeclarations& declare);
  /// Label of the concentration field that a completed list names.
  static std::string fieldOf(const Teuchos::ParameterList& params) {
    return params.get<std::string>("Concentration Field");
  }
  /// `params`: completed. Throws std::invalid_argument, naming `owner`.
  HydrogenDegradation(const Teuchos::ParameterList& params, const std::string& owner);

  /// Gives `law` the dependence on the coverage.
  void applyTo(kernels::CriticalStretchLaw& law) const;
  /// Coverage psi in [0, 1] of all local points.
  void coverage(const FieldHandle& concentration, PeridigmNS::DataManager& data, kernels::PointArrays& psi) const;

 private:
  double saturation_;
  std::array<double, 4> polynomial_;
  bool scalesEnergy_;
};

}  // namespace pd

#endif
