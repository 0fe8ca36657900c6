#include "event_window.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "cycle_fields.hpp"

namespace pd {

namespace {

// A point tires where its worst bond loses life at no less than this part of the rate of the worst of all.
constexpr double tiringShare = 0.1;
constexpr int firstInterval = 8, longestInterval = 64;
// Of a life: what bonds outside may be misjudged by from one equilibrium of the whole body to the next.
constexpr double mostStale = 3e-4;
constexpr double fastestFall = 0.125;  ///< of the interval
// What the whole body may differ from its window by, in parts of its displacements, beyond any tolerance of equilibria.
constexpr double mostDistance = 1e-3;
// A corridor that serves fewer events costs more than it saves, or a window of one; after so many of them, of windows
// in a row, no more are made.
constexpr int worthwhile = 60, worthwhileOfWindow = 8, mostShort = 3;

double* lossRatesOf(Model& model) { return model.field(fields::lifeLossRate().label); }

}  // namespace

EventWindow::EventWindow() : interval_(firstInterval) {}

void EventWindow::start(SpringTangent& springs) {
  if (const std::string obstacle = TipWindow::obstacle(springs.stiffness()); !obstacle.empty())
    throw RunError("Fatigue: \"Tip Window\" is of no use here: " + obstacle + "; leave it out");
  springs.takeChangedPoints();
}

void EventWindow::forget() {
  window_.reset();
  if (!keepsCorridor()) clearCorridor();
  interval_ = firstInterval;
  isToJudge_ = false;
  nOfWindow_ = 0;
  whole_.clear();
}

/// Over a checkpoint: made again from its box, of a body outside that is as it was, it is the same to the last bit.
bool EventWindow::keepsCorridor() const { return hasCorridor() && (!corridor_ || corridor_->fitsAfter({})); }

RestartState EventWindow::restartState() const {
  RestartState state{{"misjudged life", misjudgedLife_},          {"given up", hasGivenUp_ ? 1.0 : 0.0},
                     {"short corridors", 1.0 * nShortCorridors_}, {"short windows", 1.0 * nShortWindows_},
                     {"of corridor", 1.0 * nOfCorridor_},         {"has corridor", keepsCorridor() ? 1.0 : 0.0}};
  TipBox none;
  none.low = none.high = {0.0, 0.0};
  state.addPart("corridor", (keepsCorridor() ? box_ : none).restartState());
  return state;
}

void EventWindow::setRestartState(const RestartState& state) {
  misjudgedLife_ = state["misjudged life"];
  hasGivenUp_ = state["given up"] != 0.0;
  nShortCorridors_ = static_cast<int>(state["short corridors"]);
  nShortWindows_ = static_cast<int>(state["short windows"]);
  nOfCorridor_ = static_cast<int>(state["of corridor"]);
  if (state["has corridor"] != 0.0) box_.setRestartState(state.part("corridor"));
}

WindowNeeds EventWindow::needsOf(Simulation& simulation) {
  Model& model = simulation.model;
  const auto n = static_cast<std::size_t>(model.nOwned());
  WindowNeeds needs{std::vector<char>(n, 0), std::vector<char>(n, 0), false};
  const double* rate = lossRatesOf(model);
  const double worst = *std::max_element(rate, rate + n);
  needs.isAny = worst > 0.0;
  for (std::size_t i = 0; i < n; ++i) needs.tires[i] = rate[i] > 0.0 && rate[i] >= tiringShare * worst ? 1 : 0;
  simulation.output.markRead(model, needs.isRead);
  return needs;
}

bool EventWindow::has(const std::vector<char>& isRead) const {
  if (!window_) return false;
  for (std::size_t i = 0; i < isRead.size(); ++i)
    if (isRead[i] != 0 && !window_->contains(static_cast<int>(i))) return false;
  return true;
}

bool EventWindow::holds(const WindowNeeds& needs) const {
  for (std::size_t i = 0; i < needs.tires.size(); ++i)
    if (needs.tires[i] != 0 && !window_->isInside(static_cast<int>(i))) return false;
  return has(needs.isRead);
}

bool EventWindow::breaksOutside(Model& model) const {
  const double *damage = model.field("Damage"), *before = model.fieldAtN("Damage");
  for (std::size_t i = 0; i < isInside_.size(); ++i)
    if (damage[i] != before[i] && isInside_[i] == 0) return true;
  return false;
}

bool EventWindow::loadsAreTheSame(Simulation& simulation, const std::vector<double>& externalForce) const {
  if (externalForce != force_) return false;
  const double* displacement = simulation.model.field("Displacement");
  const std::vector<char>& isPrescribed = simulation.conditions.displacementIsPrescribed();
  for (std::size_t d = 0; d < prescribed_.size(); ++d)
    if (isPrescribed[d] != 0 && displacement[d] != prescribed_[d]) return false;
  return true;
}

bool EventWindow::find(Simulation& simulation, SpringTangent& springs, const std::vector<double>& externalForce) {
  springs.stiffness();  // with the bonds that there are
  const std::vector<int> changed = springs.takeChangedPoints();
  nChanges_ += static_cast<double>(changed.size());
  judge(simulation);
  if (corridor_ && !corridor_->fitsAfter(changed)) {
    window_.reset();
    dropCorridor();
  }
  if (!window_) return false;
  if (!loadsAreTheSame(simulation, externalForce)) {
    window_.reset();
    giveUp(simulation, "loads or prescribed displacements change");
    return false;
  }
  double* displacement = simulation.model.field("Displacement");
  const Timers::Scope timer(simulation.model.timers(), "window");
  if (!holds(needsOf(simulation)) || !window_->takeUp(changed, displacement) || !window_->solve(displacement)) {
    dropWindow();
    return false;
  }
  extrapolate(simulation.model);
  ++nOfWindow_;
  ++nOfCorridor_;
  ++nFound_;
  ++nSinceWhole_;
  return true;
}

void EventWindow::extrapolate(Model& model) {
  if (slope_.empty()) return;
  double* displacement = model.field("Displacement");
  const SpringOperator& stiffness = window_->stiffness();
  for (int i = 0; i < model.nOwned(); ++i) {
    if (window_->contains(i)) continue;
    for (int c = 0; c < 2; ++c) {
      const auto d = static_cast<std::size_t>(3 * i + c);
      if (!stiffness.isHeld(i, c)) displacement[d] = whole_[d] + nChanges_ * slope_[d];
    }
  }
}

/// Rates of lives outside before and after the whole body was found: half their difference, times the cycles between,
/// is what they were wrong by, of what was left of a life. A bond that loses r of that a cycle has no more left than
/// 1/(1 + r cycles) of the whole, since it has lost the rest in these cycles or before. The window between may be gone.
void EventWindow::judge(Simulation& simulation) {
  if (!isToJudge_) return;
  isToJudge_ = false;
  const double* rate = lossRatesOf(simulation.model);
  double most = 0.0;
  for (std::size_t i = 0; i < staleRates_.size(); ++i)
    if (staleInside_[i] == 0)
      most = std::max(most,
                      0.5 * staleCycles_ * std::abs(rate[i] - staleRates_[i]) / (1.0 + staleRates_[i] * staleCycles_));
  misjudgedLife_ += most;
  if (most > mostStale)
    interval_ = std::max(1, static_cast<int>(interval_ * std::max(fastestFall, 0.5 * mostStale / most)));
  if (most < 0.25 * mostStale) interval_ = std::min(longestInterval, 2 * interval_);
}

void EventWindow::wholeIsFound(Simulation& simulation, SpringTangent& springs, const std::vector<double>& externalForce,
                               double t) {
  Model& model = simulation.model;
  const double *rate = lossRatesOf(model), *displacement = model.field("Displacement");
  const auto n = static_cast<std::size_t>(model.nOwned());
  if (window_ && nSinceWhole_ > 0) {
    if (const double distance = window_->distanceFrom(displacement); distance > mostDistance) {
      window_.reset();
      giveUp(simulation, fmt::format("displacements in it were off by {:.2g} of the largest", distance));
    }
  }
  isToJudge_ = nSinceWhole_ > 0;
  if (isToJudge_) {
    staleRates_.assign(rate, rate + n);
    staleInside_ = isInside_;
    staleCycles_ = t - timeOfWhole_;
  }
  slope_.assign(whole_.empty() || nChanges_ == 0.0 ? 0 : 3 * n, 0.0);
  for (std::size_t d = 0; d < slope_.size(); ++d) slope_[d] = (displacement[d] - whole_[d]) / nChanges_;
  whole_.assign(displacement, displacement + 3 * n);
  nChanges_ = 0.0;
  timeOfWhole_ = t;
  nSinceWhole_ = 0;
  if (!window_ && !hasGivenUp_) place(simulation, springs, externalForce);
  releasedAtWhole_ = window_ ? window_->releasedEnergy() : 0.0;
}

void EventWindow::giveUp(Simulation& simulation, const std::string& why) {
  hasGivenUp_ = true;
  whyGivenUp_ = why;
  simulation.output.log("Fatigue: no Tip Window from here on: " + why + "; events are solved in the whole body");
}

void EventWindow::dropWindow() {
  window_.reset();
  nShortWindows_ = nOfWindow_ < worthwhileOfWindow ? nShortWindows_ + 1 : 0;
}

void EventWindow::clearCorridor() {
  corridor_.reset();
  isInCorridor_.clear();
  box_ = TipBox();
}

void EventWindow::dropCorridor() {
  clearCorridor();
  nShortCorridors_ += nOfCorridor_ < worthwhile ? 1 : 0;
}

/// Returns why there is none; empty where there is.
std::string EventWindow::prepareCorridor(Model& model, const SpringOperator& stiffness, const WindowPlaces& places) {
  if (hasCorridor() && isInCorridor_.empty()) isInCorridor_ = WindowPlaces::pointsIn(model, box_);
  if (hasCorridor() && !places.fits(isInCorridor_)) dropCorridor();
  if (corridor_) return "";
  if (nShortCorridors_ >= mostShort) return "corridors have served too few events each";
  const Timers::Scope timer(model.timers(), "corridor set-up");
  if (!hasCorridor()) {
    box_ = places.corridor();
    isInCorridor_ = WindowPlaces::pointsIn(model, box_);
    nOfCorridor_ = 0;
  }
  std::vector<int> points;
  for (std::size_t i = 0; i < isInCorridor_.size(); ++i)
    if (isInCorridor_[i] != 0) points.push_back(static_cast<int>(i));
  corridor_ = std::make_unique<Corridor>(stiffness, points);
  ++nCorridors_;
  return corridor_->trouble();
}

void EventWindow::place(Simulation& simulation, SpringTangent& springs, const std::vector<double>& externalForce) {
  Model& model = simulation.model;
  if (nShortWindows_ >= mostShort) return giveUp(simulation, "windows have served too few events each");
  const WindowNeeds needs = needsOf(simulation);
  if (!needs.isAny) return;
  const WindowPlaces places(model, needs);
  const SpringOperator& stiffness = springs.stiffness();
  if (const std::string trouble = prepareCorridor(model, stiffness, places); !trouble.empty())
    return giveUp(simulation, trouble);
  const WindowPlaces::Points points = places.window(isInCorridor_);
  if (points.size() > WindowPlaces::mostPoints)
    return giveUp(simulation,
                  fmt::format("it would have {} points, for the bonds that lose life and what computes look "
                              "at, and may have {}",
                              points.size(), WindowPlaces::mostPoints));
  const Timers::Scope timer(model.timers(), "window set-up");
  springs.takeChangedPoints();
  const double* displacement = model.field("Displacement");
  window_ = std::make_unique<TipWindow>(stiffness, *corridor_, points.read, points.changing, displacement);
  if (!window_->trouble().empty()) {
    const std::string trouble = window_->trouble();
    window_.reset();
    return giveUp(simulation, trouble);
  }
  force_ = externalForce;
  prescribed_.assign(displacement, displacement + 3LL * model.nOwned());
  isInside_.resize(static_cast<std::size_t>(model.nOwned()));
  for (int i = 0; i < model.nOwned(); ++i) isInside_[static_cast<std::size_t>(i)] = window_->isInside(i) ? 1 : 0;
  nOfWindow_ = 0;
  ++nPlaced_;
}

std::string EventWindow::summary(const std::string& solver) const {
  if (nFound_ == 0)
    return solver + ": no equilibrium in a window around the tip" + (hasGivenUp_ ? ": " + whyGivenUp_ : "");
  return fmt::format(
      "{}: {} more equilibria in {} window(s) around the tip, of {} corridor(s); lives outside, where strains were "
      "estimated for up to {} "
      "events, are off by {:.2g} of a life at most (estimates of each stretch, added up){}",
      solver, nFound_, nPlaced_, nCorridors_, longestInterval, misjudgedLife_,
      hasGivenUp_ ? "; then none: " + whyGivenUp_ : "");
}

}  // namespace pd
