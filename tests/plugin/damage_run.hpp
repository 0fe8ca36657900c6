// A host for a damage model: one or several ranks and blocks, the declared fields alone, steps as Peridigm takes them.
#ifndef PD_TESTS_DAMAGE_RUN_HPP
#define PD_TESTS_DAMAGE_RUN_HPP

#include <utility>

#include "material_run.hpp"

namespace pdtest {

/// Damage of points by global id, and state of bonds by the global ids of their ends (from, to).
struct DamageState {
  std::vector<double> damage;
  std::map<std::pair<int, int>, double> bonds;
  int nBroken() const;
  bool operator==(const DamageState& other) const { return damage == other.damage && bonds == other.bonds; }
};

class DamageRun {
 public:
  /// Creates and initialises the models. Some bonds are cut already.
  DamageRun(const Sample& sample, Layout layout);

  void initialize();
  /// Throws the models away and makes new ones, as Peridigm's Verlet does in each step: not initialised.
  void recreate();
  /// Sets Coordinates and evaluates damage, as often as an iterative solver may in one step.
  void evaluate(const Motion& motion, int nEvaluations = 1);
  /// The end of a step: what is new becomes old.
  void updateState();
  void step(const Motion& motion) {
    evaluate(motion);
    updateState();
  }
  /// Call it before updateState(): bonds at the end of the step.
  DamageState state();

  /// Overwrites bonds (both steps) and Damage, as a restart does, and initialises.
  void setState(const DamageState& state);
  /// Gives stepped scalars that the model reads values between 0 and `largest`.
  void fillScalars(int salt, double largest);

  bool callsPrecompute = true;  ///< Peridigm does not

  SmallBody& body(std::size_t rank = 0) { return *bodies_[rank]; }
  const Scene& scene() const { return scene_; }
  PeridigmNS::DamageModel& model() { return *models_.front().front(); }

 private:
  /// Owners' values to ghosts.
  void exchange(const std::vector<int>& fieldIds);

  Sample sample_;
  Scene scene_;
  std::vector<std::unique_ptr<SmallBody>> bodies_;
  std::vector<std::vector<Teuchos::RCP<PeridigmNS::DamageModel>>> models_;  ///< [rank][block]
};

/// Stretch that grows with `load`, noisy, so that bonds break one by one.
Motion pull(int dimension, double load);

}  // namespace pdtest

#endif
