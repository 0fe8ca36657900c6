// Two physics in turn, load step by load step: diffusion for the physical time, then mechanics at the new load.
#ifndef PD_STAGGERED_HPP
#define PD_STAGGERED_HPP

#include <Teuchos_RCP.hpp>
#include <string>
#include <vector>

#include "solver.hpp"

namespace pd {

/// A load step: (1) `Diffusion` advances its field by the physical time of the step; (2) the solver named in
/// `Mechanics` finds equilibrium at the load of the end of the step; (3) points of new crack faces become sources for
/// the next step. The parts are the registered solvers themselves.
class Staggered : public Solver {
 public:
  static void declareParameters(ParameterDeclarations& declare);
  explicit Staggered(const Teuchos::ParameterList& given);

  std::vector<int> fieldIds() const override;
  void initialize(Simulation& simulation) override;
  int numberOfIncrements(Simulation&, double, double) override { return nLoadSteps_; }
  void advance(Simulation& simulation, double t, double dt) override;
  std::vector<std::string> summary() const override;
  std::vector<double> restartState() const override;
  void setRestartState(const std::vector<double>& state) override;

 private:
  int nLoadSteps_;
  long long nNewSources_ = 0;
  Teuchos::RCP<Solver> diffusion_, mechanics_;
};

}  // namespace pd

#endif
