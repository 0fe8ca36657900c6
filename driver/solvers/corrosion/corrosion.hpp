// Solver of dissolution: transport at given phases, then the change of phases.
#ifndef PD_CORROSION_HPP
#define PD_CORROSION_HPP

#include <limits>
#include <memory>

#include "../solver.hpp"
#include "flow_fields.hpp"
#include "surface_record.hpp"
#include "transport_step.hpp"

namespace pd {

class Corrosion : public Solver {
 public:
  static void declareParameters(ParameterDeclarations& declare);
  explicit Corrosion(const Teuchos::ParameterList& given);

  struct Fields : FieldTable {
    FieldHandle concentration, rate;
    FieldHandle damage = reads(pd::fields::damage());
    FieldHandle salt = writes(pd::fields::saltCoverage());
    FieldHandle demand = writes(pd::fields::dissolutionDemand());
    FieldHandle area = reads(pd::fields::interfaceAreaDensity());
    FieldHandle dissolution = reads(pd::fields::dissolutionRate());
    FieldHandle slope = reads(pd::fields::dissolutionRateSlope());
    FieldHandle solid = reads(pd::fields::solidConcentration());
    FieldHandle saturation = reads(pd::fields::saturationConcentration());
    FieldHandle current = reads(pd::fields::currentDensity());
    FieldHandle unknown =
        writes(pd::fields::pointScalar("Transport_Unknown", "1", "Of the linear system of a step, for its exchange."));
    FieldHandle lastRate = writes(pd::fields::pointScalar(
        "Last_Transport_Rate", "mol/(m3 s)", "Rate of liquid points in the step before; no number elsewhere."));
    FieldHandle limitedAt;
    explicit Fields(const std::string& ions = "Concentration") {
      limitedAt = writes(pd::fields::limitedAt(ions));
      concentration = writes(pd::fields::ionConcentration(ions));
      rate = reads(pd::fields::ionFluxDivergence(ions));
    }
  };
  const Fields& fields() const override { return fields_; }
  std::vector<std::string> fieldsWithFarField() const override { return {field_}; }
  double leastSteps(double t0, double t1) const override;
  void initialize(Simulation& simulation) override;
  int numberOfIncrements(Simulation&, double, double) override { return nIncrements_; }
  void advance(Simulation& simulation, double t, double dt) override;
  std::vector<std::string> summary() const override;
  void checkpointWritten() override { mustForgetFactors_ = true; }
  RestartState restartState() const override;
  void setRestartState(const RestartState& state) override;

 private:
  /// Takes one step of length h; false, with everything as before, where it must be shorter.
  bool step(Simulation& simulation, double t, double h);
  /// Largest share of a solid point's metal that the last step took.
  double frontAdvance(Simulation& simulation) const;
  double timeError(Simulation& simulation, double h) const;
  void evaluateDamage(Model& model, double h);
  /// Solid points that have given more than they can take the rest from solid points around them, and those that have
  /// given all become liquid. False where there is not that much metal.
  bool carryOver(Simulation& simulation, double h);
  double metal(Simulation& simulation) const;
  double nextStep(double h) const;

  std::string field_, rateField_;
  Fields fields_;
  int nIncrements_;
  bool isByNewton_ = true, mustForgetFactors_ = false;
  double fixedStep_ = 0.0, tolerance_, slack_, frontLimit_, largestStep_;
  std::unique_ptr<TransportStep> transport_;
  SurfaceRecord surface_;
  PhaseLists lists_;
  struct Solid {
    int point;
    double concentration;
  };
  std::vector<Solid> untouched_;                              ///< solid points before the step that it touches
  double ceiling_ = std::numeric_limits<double>::infinity();  ///< of steps, after one that failed
  double proposedStep_ = 0.0, shortestTried_ = 0.0, advance_ = 0.0, error_ = 0.0;
  double initialMetal_ = 0.0, outflow_ = 0.0, balance_ = 0.0;
  long long nSteps_ = 0, nRejected_ = 0;
  double shortest_ = 0.0, longest_ = 0.0;
};

}  // namespace pd

#endif
