// Several solvers in turn, load step by load step.
#ifndef PD_STAGGERED_HPP
#define PD_STAGGERED_HPP

#include <limits>
#include <string>
#include <vector>

#include "solver.hpp"
#include "staggered_part.hpp"

namespace pd {

/// In a load step each of `Solvers` runs in the order of the deck: any registered solvers, each with its own
/// increments, time scale and criterion (StaggeredPart). After one that moves or damages the body, points of new crack
/// faces become sources. `Diffusion` and `Mechanics` in place of `Solvers` are the two that run in each load step, in
/// this order.
class Staggered : public Solver {
 public:
  static void declareParameters(ParameterDeclarations& declare);
  explicit Staggered(const Teuchos::ParameterList& given);

  /// With the default field of diffusion.
  static FieldTable describeFields();
  const FieldTable& fields() const override;
  std::vector<std::string> fieldsWithFarField() const override;
  bool needsDensity() const override;
  double leastSteps(double t0, double t1) const override;
  void initialize(Simulation& simulation) override;
  void rehearse(Simulation& simulation, double t, double dt) override;
  int numberOfIncrements(Simulation& simulation, double t0, double t1) override;
  void advance(Simulation& simulation, double t, double dt) override;
  std::vector<std::string> summary() const override;
  RestartState restartState() const override;
  void checkpointWritten() override;
  void setRestartState(const RestartState& state) override;
  void modelHasChanged() override;

 private:
  /// Does the work with all parts before it throws what went wrong with any.
  template <class Work>
  void withEachPart(const Work& work);

  mutable FieldTable fields_;  ///< of the parts
  int nLoadSteps_;
  bool hasNames_;  ///< the parts have names that the deck gave them
  double endTime_ = std::numeric_limits<double>::infinity();
  long long loadStep_ = 0, nNewSources_ = 0;
  std::vector<StaggeredPart> parts_;
};

}  // namespace pd

#endif
