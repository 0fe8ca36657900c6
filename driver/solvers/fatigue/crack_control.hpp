// Loads that follow a crack, and when it has grown enough.
#ifndef PD_CRACK_CONTROL_HPP
#define PD_CRACK_CONTROL_HPP

#include <memory>
#include <string>

#include "../../model/simulation.hpp"
#include "function_program.hpp"

namespace pd {

/// Looks at computes of the run in equilibrium at the load of its conditions. The stress intensity is K = sqrt(J E').
/// With a wanted range dK the largest load of a cycle is dK / ((1 - R) K) of that of the conditions: in a linear body
/// one equilibrium serves for all loads (S3 of the sources: P_n = P_0 dK_0/dK_n). Or it is a function of the crack
/// length, as in a test with a K-gradient.
class CrackControl {
 public:
  static void declareParameters(ParameterDeclarations& declare);
  /// From a completed list. Throws std::invalid_argument.
  explicit CrackControl(const Teuchos::ParameterList& parameters);

  struct Fields : FieldTable {
    FieldHandle range;  ///< of the stress intensity, where J is given
    explicit Fields(bool hasIntensity) {
      if (hasIntensity)
        range = writes(pd::fields::globalScalar("Stress_Intensity_Range", "Pa m^0.5", "Range of K in the cycles."));
    }
  };
  const Fields& fields() const { return fields_; }
  /// Throws RunError where computes are missing.
  void initialize(Model& model) const;

  struct Outcome {
    double peak;         ///< in parts of the load of the conditions
    std::string reason;  ///< to stop; empty: none
  };
  /// In equilibrium after t cycles; the cycles to come would have this peak without the control. Throws RunError where
  /// there is no stress intensity to follow. Collective.
  Outcome look(Simulation& simulation, double t, double peak, double loadRatio) const;
  /// Whether look() evaluates computes.
  bool looks() const { return isUsed_; }
  bool setsLoad() const { return wantedRange_ != nullptr || peak_ != nullptr; }

 private:
  double lengthOf(Model& model) const;
  double peakForRange(Model& model, double t, double intensity, double loadRatio) const;
  void requireCompute(Model& model, const std::string& label, const char* key) const;

  bool hasIntensity_ = false, isUsed_ = false;
  std::string energyLabel_, lengthLabel_, stopLabel_;
  double modulus_ = 0.0, toughness_ = 0.0, stopValue_ = 0.0;  ///< E', Pa; Pa sqrt(m), 0: none
  std::unique_ptr<FunctionProgram> wantedRange_, peak_;       ///< of the crack length
  Fields fields_;
};

}  // namespace pd

#endif
