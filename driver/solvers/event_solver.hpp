// Solvers that find out by themselves when something happens next.
#ifndef PD_EVENT_SOLVER_HPP
#define PD_EVENT_SOLVER_HPP

#include <string>

#include "solver.hpp"

namespace pd {

/// In a run of its own such a solver ends an increment early where something has happened, so that it is written, and
/// may end the run. (As a part of Staggered it goes on to the end that it is asked for.)
class EventSolver : public Solver {
 public:
  /// Advances from t to the next event, or to `end` where none comes before. Returns the time reached. May have told
  /// the output that the state is settled.
  virtual double advanceToEvent(Simulation& simulation, double t, double end) = 0;
  /// Why there is nothing left to do; empty where there is. The run then ends with this increment.
  virtual std::string reasonToStop() const = 0;
  /// Whether advanceToEvent() has left fields as they were where nobody looked, and what makes up for it: before they
  /// are written, or others look at them.
  virtual bool fieldsAreComplete() const { return true; }
  virtual void completeFields(Simulation& /*simulation*/, double /*t*/) {}
  /// What its times are counted in.
  virtual const char* timeUnit() const { return "s"; }

  void advance(Simulation& simulation, double t, double dt) override {
    const double end = t + dt;
    while (t < end && reasonToStop().empty()) {
      t = advanceToEvent(simulation, t, end);
      simulation.output.stateHasChanged();
    }
    if (!fieldsAreComplete()) completeFields(simulation, t);
  }
};

/// What the times of a solver of either kind are counted in.
inline std::string timeUnitOf(const Solver& solver) {
  const auto* events = dynamic_cast<const EventSolver*>(&solver);
  return events == nullptr ? "s" : events->timeUnit();
}

}  // namespace pd

#endif
