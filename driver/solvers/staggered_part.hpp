// One of the solvers that run in turn.
#ifndef PD_STAGGERED_PART_HPP
#define PD_STAGGERED_PART_HPP

#include <Teuchos_RCP.hpp>
#include <optional>
#include <string>
#include <vector>

#include "enough_change.hpp"
#include "solver.hpp"

namespace pd {

/// Runs in every load step, in each `Every`-th one, `When` a field has changed enough since it last ran, or where
/// either is so, and always in the last load step of the run. It then advances over all the time since it last ran, in
/// `Sub Steps` increments or as many as the solver itself chooses. Its solver counts `Time Scale` seconds where the run
/// counts one, and so do the plug-ins that it calls; conditions keep the time of the run.
class StaggeredPart {
 public:
  static void declareParameters(ParameterDeclarations& declare);
  /// Keys of solvers that the run as a whole sets, and its parts therefore do not have.
  static const std::vector<std::string>& keysOfTheRun();
  /// A part of the run that no key but the solver's own describes.
  StaggeredPart(std::string name, const std::string& solver, const Teuchos::ParameterList& parameters);
  /// From an entry of `Solvers`, completed.
  StaggeredPart(std::string name, const Teuchos::ParameterList& entry);

  const std::string& name() const { return name_; }
  Solver& solver() const { return *solver_; }
  /// Its solver's, and what remembers the field of `When` (which the check of a deck has looked for).
  FieldTable fields() const;
  /// How many steps it takes at least in that many load steps from t0 to t1.
  double leastSteps(int nLoadSteps, double t0, double t1) const;
  /// Whether its solver moves or damages the body.
  bool changesDamage() const;
  /// Whether another does the same on the same fields, so that the two would share what they keep there.
  bool isLike(const StaggeredPart& other) const;

  /// As Solver::initialize().
  void initialize(Simulation& simulation);
  /// As Solver::rehearse(), for the first load step in which it runs.
  void rehearse(Simulation& simulation, double t, double dt);
  /// Once, before the first load step of the run.
  void remember(Model& model);
  /// Load step `number` (from 1) from t to t + dt. Returns whether it ran.
  bool advance(Simulation& simulation, long long number, bool isLast, double t, double dt);

  std::vector<std::string> summary(long long nLoadSteps) const;
  RestartState restartState() const;
  void setRestartState(const RestartState& state);

 private:
  bool isDue(Model& model, long long number) const;
  double changeOf(Model& model) const;
  int numberOfIncrements(Simulation& simulation, double t0, double t1) const;
  std::string memoryField() const;

  std::string name_, solverName_;
  Teuchos::RCP<Solver> solver_;
  int nSubSteps_ = 0;  ///< 0: the solver chooses
  int every_ = 1;      ///< 0: only `When`
  double timeScale_ = 1.0;
  std::string watchedField_;  ///< of `When`; empty: none
  EnoughChange enough_;
  bool runsAtStart_ = false;
  bool isOfVolume_ = false;  ///< the change integrated over the body counts

  std::optional<double> behindSince_;  ///< since when it has not run; nothing where it is up to date
  long long nRuns_ = 0;
};

}  // namespace pd

#endif
