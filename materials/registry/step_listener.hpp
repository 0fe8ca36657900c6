// Plug-ins that do something once for each step of a run, and only where the step is accepted.
#ifndef PD_STEP_LISTENER_HPP
#define PD_STEP_LISTENER_HPP

#include <map>

#include "Peridigm_DataManager.hpp"
#include "call.hpp"

namespace pd {

/// What pdrun tells a plug-in that derives from it. NP1 follows from N and dt however often a call is repeated within a
/// step, so that most histories need none of this: it is for sums over steps, notes and caches.
class StepListener {
 public:
  virtual ~StepListener() = default;
  /// A step of `dt` s in which this plug-in was called has been accepted: its values at the end, at `time` s, are at
  /// STEP_N (in pdrun at STEP_NP1 too). One-step fields of its own may be changed.
  virtual void stepAccepted(const Call&, PeridigmNS::DataManager&, double time, double dt) const {
    static_cast<void>(time);
    static_cast<void>(dt);
  }
  /// The host has put back fields of one step and bond fields that only grow: notes about them are out of date.
  virtual void stepTakenBack() const {}
};

/// Tells a plug-in, if it listens.
template <class Plugin>
void tellStepAccepted(const Plugin& plugin, const Call& call, PeridigmNS::DataManager& data, double time, double dt) {
  if (const auto* listener = dynamic_cast<const StepListener*>(&plugin)) listener->stepAccepted(call, data, time, dt);
}
template <class Plugin>
void tellStepTakenBack(const Plugin& plugin) {
  if (const auto* listener = dynamic_cast<const StepListener*>(&plugin)) listener->stepTakenBack();
}

/// Tells a damage model of accepted steps in a host that has no such call: Peridigm swaps N and NP1 at the end of a
/// step. Times are counted from 0. A damage model calls it first thing in computeDamage(); in pdrun it does nothing.
class StepWatch {
 public:
  /// `before`: STEP_N of a two-step bond field of the model.
  void look(const StepListener& listener, const Call& call, PeridigmNS::DataManager& data, const double* before,
            double dt) {
    Seen& seen = seen_[&data];
    if (seen.before != nullptr && seen.before != before) {
      seen.time += seen.dt;
      listener.stepAccepted(call, data, seen.time, seen.dt);
    }
    seen.before = before;
    seen.dt = dt;
  }

 private:
  struct Seen {
    const double* before = nullptr;
    double time = 0.0, dt = 0.0;
  };
  std::map<const PeridigmNS::DataManager*, Seen> seen_;
};

}  // namespace pd

#endif
