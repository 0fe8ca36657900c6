// The initial and boundary conditions of a run.
#ifndef PD_BOUNDARY_CONDITIONS_HPP
#define PD_BOUNDARY_CONDITIONS_HPP

#include <Teuchos_RCP.hpp>
#include <map>
#include <string>
#include <vector>

#include "../deck/deck.hpp"
#include "../model/model.hpp"
#include "far_field.hpp"

namespace pd {

class Condition;

/// All conditions (driver/boundary/condition.hpp) of a deck: the entries of section Boundary Conditions that are no
/// node sets. Their values are numbers, functions of x, y, z (reference place, m) and t (s), or tables in time.
class BoundaryConditions {
 public:
  using FarField = pd::FarField;

  /// Allocates the fields that the conditions need in `model`. Throws DeckError with all that is wrong with them: sets
  /// without points of this name, loads along axes on which nothing moves, fields that nothing in the run uses, and two
  /// conditions that prescribe, or start from, different values of one field at a point (in Peridigm's decks the later
  /// one holds, as there). Collective.
  BoundaryConditions(const Deck& deck, Model& model);
  ~BoundaryConditions();

  /// Each of them, in the order of the deck: for what a solver asks of one kind alone.
  const std::vector<Teuchos::RCP<Condition>>& all() const { return conditions_; }

  /// What the log should say of them, a line each.
  std::vector<std::string> notes() const;

  /// From now on the solver at work counts `scale` seconds where the run counts one. Times that it hands over are its
  /// own; values are those of the run's time, t / scale, and velocities those in its seconds.
  void setTimeScale(double scale);
  /// Time of the run at a time of the solver at work.
  double runTime(double ownTime) const { return timeScale_ == 1.0 ? ownTime : ownTime / timeScale_; }
  /// Initial displacements, velocities and values; ghosts included.
  void applyInitial();
  /// Sets prescribed displacements and values for time t in the fields' NP1, ghosts included, and, where there is a
  /// Velocity, the mean velocity of prescribed displacements since the time of the last call.
  void applyPrescribed(double t);
  /// Sets the prescribed values of one scalar field alone (what a diffusion solver asks for in each stage).
  void applyPrescribedValue(const std::string& field, double t);
  /// Of a scalar field at time t; valid until the next call.
  const FarField& farField(const std::string& field, double t);
  /// Whether a prescribed value of this field changes with time.
  bool prescribedValueDependsOnTime(const std::string& field) const;
  /// Adds External_Force_Density (of all loads) at time t to `forceDensity` [3 nOwned].
  void addExternalForce(double t, double* forceDensity) const;
  bool hasExternalForce() const;

  /// Tells conditions that damage has changed; those that follow it take the time last applied. Returns how many points
  /// are newly prescribed (all ranks). Damage of ghosts must be up to date (Model::evaluateDamage does it).
  long long updateDamageSources();

  /// As Model::beginStep() and takeBackStep(), of what conditions keep beside the fields (Simulation calls both).
  void beginStep();
  void takeBackStep();

  /// Takes up what conditions keep from one time to the next from fields that a restart at time t has filled; marks of
  /// No Failure are those of the deck.
  void resume(double t);

  /// [3 nPoints] 1 where that displacement component is prescribed.
  const std::vector<char>& displacementIsPrescribed() const;
  /// [nPoints] 1 where the scalar field is prescribed (sources included).
  const std::vector<char>& valueIsPrescribed(const std::string& field) const;

 private:
  void markNoFailure();
  template <class Hook>
  void callEach(const Hook& hook) const;

  Model& model_;
  double initialTime_ = 0.0;
  double timeScale_ = 1.0;  ///< seconds of the solver at work in one of the run
  double appliedAt_ = 0.0;  ///< time of the run at the last applyPrescribed()
  double appliedBeforeStep_ = 0.0;
  std::vector<Teuchos::RCP<Condition>> conditions_;
  std::map<std::string, std::vector<char>> isPrescribed_;  ///< [width nPoints] by field
  std::vector<char> nowhere_;                              ///< [nPoints] of a field without conditions
  FarField farField_;
};

}  // namespace pd

#endif
