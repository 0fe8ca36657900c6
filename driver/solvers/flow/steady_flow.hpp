// Steady flow of an incompressible fluid, load step by load step.
#ifndef PD_STEADY_FLOW_HPP
#define PD_STEADY_FLOW_HPP

#include <memory>
#include <string>
#include <vector>

#include "../../linear/operator_system.hpp"
#include "../load_steps.hpp"
#include "../solver.hpp"
#include "bond_flows.hpp"
#include "flow_factor.hpp"
#include "flow_fields.hpp"
#include "outflow_watch.hpp"

namespace pd {

/// At the end of each load step velocity and pressure satisfy the steady equations (flow_equations.hpp) with the
/// velocities of walls and inlets at that time, by Newton's method for both together. The first step from rest is
/// Stokes flow; later load steps start from the last flow, unless little of what drove it is left. Linear systems are
/// solved by GMRES without their matrix, with the factor of an earlier one (FlowFactor) until that takes many
/// iterations. Where metal dissolves, operators are made anew beside it alone.
class SteadyFlow : public Solver {
 public:
  struct Fields : FieldTable {
    FieldHandle volume = reads(pd::fields::volume());
    FieldHandle velocity = writes(pd::fields::velocity());
    FieldHandle pressure = writes(pd::fields::pressure());
    FieldHandle fluid = writes(pd::fields::fluidShare());
    FieldHandle viscosity = reads(pd::fields::viscosity());
    FieldHandle flow = writesIfThere(pd::fields::bondFlow());
    FieldHandle opening = writesIfThere(pd::fields::bondOpening());
  };
  static void declareParameters(ParameterDeclarations& declare);
  explicit SteadyFlow(const Teuchos::ParameterList& given);

  const Fields& fields() const override { return fields_; }
  double leastSteps(double t0, double t1) const override { return loadSteps_.count(t0, t1); }
  void initialize(Simulation& simulation) override;
  void rehearse(Simulation& simulation, double t, double dt) override;
  int numberOfIncrements(Simulation&, double t0, double t1) override { return loadSteps_.count(t0, t1); }
  double incrementEnd(int increment, int nIncrements, double t0, double t1) const override {
    return loadSteps_.end(increment, nIncrements, t0, t1);
  }
  void advance(Simulation& simulation, double t, double dt) override;
  std::vector<std::string> summary() const override;
  void checkpointWritten() override { mustRenew_ = true; }
  RestartState restartState() const override {
    return {{"load steps", static_cast<double>(nLoadSteps_)}, {"drive", drive_}};
  }
  void setRestartState(const RestartState& state) override {
    nLoadSteps_ = static_cast<long long>(state["load steps"]);
    drive_ = state["drive"];
  }

 private:
  void takeUpPhases(Simulation& simulation);
  bool wantsFactor(Simulation& simulation) const;
  double linearTolerance(double expectedChange) const;
  std::vector<double> newtonStep(Simulation& simulation, bool isStokes, bool mayKeepFactor, double tolerance,
                                 const std::vector<double>& residual);
  GmresReport solveByFactor(Simulation& simulation, bool isStokes, bool mayKeepFactor, double tolerance,
                            const std::vector<double>& rightSide, std::vector<double>& change);
  void makeFactor(Simulation& simulation, bool isStokes);
  GmresReport solveByIteration(Simulation& simulation, bool isStokes, double tolerance,
                               const std::vector<double>& rightSide, std::vector<double>& change);
  double largestVelocity(const std::vector<double>& change) const;
  double takeStep(Simulation& simulation, const std::vector<double>& change, double normBefore);
  bool isStokesFlowFound(const Communicator& comm, double normBefore) const;
  double scaleOfSpeed() const;
  double restingSpeed() const;
  void takeUpSpeed();
  [[noreturn]] void giveUp(double t, int iterations, double change, const std::string& why) const;

  const Teuchos::ParameterList parameters_;
  Fields fields_;
  LoadSteps loadSteps_;
  double tolerance_;
  int maximumIterations_;

  const FlowLaw* law_ = nullptr;
  std::vector<int> flowBlocks_;
  std::vector<char> isSolid_;  ///< [points] of equations_
  bool wantsFlows_ = false, mustRenew_ = false, hasFactor_ = true, convectsPressure_ = true;
  std::unique_ptr<FlowEquations> equations_;
  std::unique_ptr<FlowFactor> factor_;
  FactorPrecision precision_ = FactorPrecision::Single;  ///< Double where that does not do
  OutflowWatch outflows_;
  std::unique_ptr<BondFlows> flows_;  ///< where a material asks for them
  std::size_t nComponents_ = 0;
  double fastest_ = 0.0;            ///< scale of speed of all flows so far, m/s
  double drive_ = 0.0;              ///< FlowEquations::drive() of the last flow, m/s
  double changePerResidual_ = 0.0;  ///< the largest so far, of the largest velocity of a change and the norm
  long long nLoadSteps_ = 0, nNewtonSteps_ = 0, nFactors_ = 0, nLinearIterations_ = 0, nUnknowns_ = 0;
  double largestResidual_ = 0.0, largestFactor_ = 0.0, cellReynolds_ = 0.0, leakage_ = 0.0, divergence_ = 0.0;
};

}  // namespace pd

#endif
