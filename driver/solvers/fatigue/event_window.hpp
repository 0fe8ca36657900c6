// Which equilibria of fatigue are found around the tip of a crack alone.
#ifndef PD_EVENT_WINDOW_HPP
#define PD_EVENT_WINDOW_HPP

#include <memory>
#include <string>
#include <vector>

#include "../../linear/springs/tip_window.hpp"
#include "../../model/simulation.hpp"
#include "../spring_tangent.hpp"
#include "window_places.hpp"

namespace pd {

/// Places a TipWindow around the bonds that lose life and the points that computes look at, as far ahead of them as its
/// size allows, and another one when they come to its sides: of a corridor of the body, and of another one when they
/// come to the sides of that. Outside, displacements go on from the last equilibrium of
/// the whole body as they went to it, by the bonds that break. How much of a life that is off by is estimated at the
/// next one, which comes the sooner the more it is.
class EventWindow {
 public:
  EventWindow();
  /// Throws RunError where the bonds of the run are none that it is for.
  void start(SpringTangent& springs);

  /// Tries to find the equilibrium of `externalForce` [3 nOwned] in the window, and writes the displacements. False
  /// where it takes the whole body.
  bool find(Simulation& simulation, SpringTangent& springs, const std::vector<double>& externalForce);
  /// The whole body has been found in equilibrium after t cycles: there may be another window.
  void wholeIsFound(Simulation& simulation, SpringTangent& springs, const std::vector<double>& externalForce, double t);
  /// Whether the whole body is due again; after `share` of the usual number of events, 0 to 1.
  bool isDue(double share) const { return nSinceWhole_ >= share * interval_; }
  /// J, by which the energy of the body and its loads has fallen since it was found, where there is still a window.
  double releasedSinceWhole() const { return window_ ? window_->releasedEnergy() - releasedAtWhole_ : 0.0; }
  /// Whether displacements are right at all points marked. [nPoints]
  bool has(const std::vector<char>& isRead) const;
  /// Whether Damage has changed, in the present step, at a point whose bonds the window does not know.
  bool breaksOutside(Model& model) const;

  /// What follows depends on the restart state alone, not on what else has been.
  void forget();
  RestartState restartState() const;
  void setRestartState(const RestartState& state);
  std::string summary(const std::string& solver) const;

 private:
  static WindowNeeds needsOf(Simulation& simulation);
  bool holds(const WindowNeeds& needs) const;
  bool loadsAreTheSame(Simulation& simulation, const std::vector<double>& externalForce) const;
  void judge(Simulation& simulation);
  void extrapolate(Model& model);
  void place(Simulation& simulation, SpringTangent& springs, const std::vector<double>& externalForce);
  void giveUp(Simulation& simulation, const std::string& why);
  std::string prepareCorridor(Model& model, const SpringOperator& stiffness, const WindowPlaces& places);
  bool hasCorridor() const { return !box_.isEmpty(); }
  bool keepsCorridor() const;
  void clearCorridor();
  void dropCorridor();  ///< and counts it
  void dropWindow();

  TipBox box_;                          ///< of the corridor; empty: none
  std::vector<char> isInCorridor_;      ///< [nOwned]; empty: not found out yet
  std::unique_ptr<Corridor> corridor_;  ///< null after a restart
  std::unique_ptr<TipWindow> window_;
  std::vector<char> isInside_;              ///< [nOwned] of the last window: its points whose neighbours are all in it
  std::vector<double> force_, prescribed_;  ///< [3 nOwned] N/m3, m: when the window was made
  int interval_, nSinceWhole_ = 0;          ///< events from one equilibrium of the whole body to the next
  double releasedAtWhole_ = 0.0;            ///< J, by this window
  double timeOfWhole_ = 0.0;                ///< cycles
  std::vector<double> whole_, slope_;       ///< [3 nOwned] m: its displacements, and by how much a change moves them
  double nChanges_ = 0.0;                   ///< since then
  bool isToJudge_ = false;
  double staleCycles_ = 0.0;        ///< between the last two
  std::vector<double> staleRates_;  ///< [nOwned] of lives, before the last of them
  std::vector<char> staleInside_;   ///< isInside_ between them
  double misjudgedLife_ = 0.0;      ///< outside, parts of a life: at most, since the worst of each interval are added
  bool hasGivenUp_ = false;
  std::string whyGivenUp_ = "before the restart";
  int nOfWindow_ = 0, nOfCorridor_ = 0;                  ///< equilibria of this window, and of windows of this corridor
  int nShortWindows_ = 0, nShortCorridors_ = 0;          ///< that were not worth it; windows: in a row
  long long nFound_ = 0, nPlaced_ = 0, nCorridors_ = 0;  ///< over the run
};

}  // namespace pd

#endif
