// Transient flow of a fluid that is slightly compressible, by explicit steps.
#ifndef PD_WEAKLY_COMPRESSIBLE_FLOW_HPP
#define PD_WEAKLY_COMPRESSIBLE_FLOW_HPP

#include <memory>
#include <string>
#include <vector>

#include "../load_steps.hpp"
#include "../solver.hpp"
#include "flow_fields.hpp"
#include "flow_time_step.hpp"

namespace pd {

/// Velocity and pressure of the operators of Steady Flow with the density of Tait's equation (flow_kernel.hpp), by the
/// classic Runge-Kutta method of fourth order. A load step is cut into equal steps below the critical one of this very
/// model, which holds for all velocities that the run admits. It is the independent check of Steady Flow, and finds
/// flows that start up and oscillate.
class WeaklyCompressibleFlow : public Solver {
 public:
  struct Fields : FieldTable {
    FieldHandle volume = reads(pd::fields::volume());
    FieldHandle velocity = writes(pd::fields::velocity());
    FieldHandle pressure = writes(pd::fields::pressure());
    FieldHandle fluid = writes(pd::fields::fluidShare());
    FieldHandle viscosity = reads(pd::fields::viscosity());
  };
  static void declareParameters(ParameterDeclarations& declare);
  explicit WeaklyCompressibleFlow(const Teuchos::ParameterList& given);

  const Fields& fields() const override { return fields_; }
  double leastSteps(double t0, double t1) const override;
  void initialize(Simulation& simulation) override;
  void rehearse(Simulation& simulation, double t, double dt) override;
  int numberOfIncrements(Simulation&, double t0, double t1) override { return loadSteps_.count(t0, t1); }
  double incrementEnd(int increment, int nIncrements, double t0, double t1) const override {
    return loadSteps_.end(increment, nIncrements, t0, t1);
  }
  void advance(Simulation& simulation, double t, double dt) override;
  std::vector<std::string> summary() const override;
  RestartState restartState() const override;
  void setRestartState(const RestartState& state) override;
  void modelHasChanged() override { criticalStep_ = 0.0; }

 private:
  void prepare(Simulation& simulation, double t);
  void findCriticalStep(Simulation& simulation);
  int numberOfSteps(double dt) const;
  std::string numbers(double step) const;
  void requireStableStep(double step) const;
  void requireMach(double speed, const std::string& what, double t) const;
  void requireBalance(double t) const;
  void step(Timers& timers, double t, double dt);
  void watch(Model& model, double t);

  const Teuchos::ParameterList parameters_;
  Fields fields_;
  LoadSteps loadSteps_;
  kernels::TaitFluid fluid_{};
  double timeStep_ = 0.0;  ///< 0: not given
  double largestMach_, safetyFactor_;
  bool allowUnstableStep_;

  const FlowLaw* law_ = nullptr;
  std::vector<int> flowBlocks_;
  std::vector<char> isSolid_;  ///< [points] of geometry_
  std::unique_ptr<FlowGeometry> geometry_;
  std::unique_ptr<FlowRates> rates_;
  kernels::FlowState state_, stage_, sum_, change_;
  FlowTimeSteps limits_{};
  double criticalStep_ = 0.0;                 ///< s; 0: not known yet
  double speed_ = 0.0, highestMach_ = 0.0;    ///< largest at the last watch(), m/s; of the run
  double usedStep_ = 0.0, massChange_ = 0.0;  ///< largest, s; of a load step, of the mass
  long long nSteps_ = 0, nLoadSteps_ = 0;
};

}  // namespace pd

#endif
