#include "event_window.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "cycle_fields.hpp"

namespace pd {

namespace {

// A point tires where its worst bond loses life at no less than this part of the rate of the worst of all.
constexpr double tiringShare = 0.1;
// Points of a window: while it is made it takes 8 bytes for the square of twice as many.
constexpr std::size_t usualPoints = 1700, usualWhereRead = 2600, mostPoints = 3600;
// How many times farther it reaches ahead of the tip, and behind it, than to its sides; less far ahead where computes
// look around the tip in directions that turn with it.
constexpr double aheadOfSides = 12.0, aheadWhereRead = 4.0, behindOfSides = 2.0;
// It has more points than usual where it would else reach less far to its sides, and so serve few events.
constexpr double leastReachInHorizons = 0.15;
constexpr double longestBondInHorizons = 1.1;
// Bonds of points that tire less than others break now and then, too, as far beside those.
constexpr double changingBesideInHorizons = 0.35;
constexpr int firstInterval = 8, longestInterval = 64;
// Of a life: what bonds outside may be misjudged by from one equilibrium of the whole body to the next.
constexpr double mostStale = 3e-4;
// What the whole body may differ from its window by, in parts of its displacements, beyond any tolerance of equilibria.
constexpr double mostDistance = 1e-3;
// A window that serves fewer events costs more than it saves; after so many of them no more are made.
constexpr int worthwhile = 60, mostShort = 3;

double* lossRatesOf(Model& model) { return model.field(fields::lifeLossRate().label); }

}  // namespace

EventWindow::EventWindow() : interval_(firstInterval) {}

void EventWindow::require(SpringTangent& springs) {
  if (const std::string obstacle = TipWindow::obstacle(springs.stiffness()); !obstacle.empty())
    throw RunError("Fatigue: \"Tip Window\" is of no use here: " + obstacle + "; leave it out");
}

void EventWindow::forget() {
  window_.reset();
  interval_ = firstInterval;
  isToJudge_ = false;
  nOfWindow_ = 0;
  whole_.clear();
}

RestartState EventWindow::restartState() const {
  return {{"misjudged life", misjudgedLife_}, {"given up", hasGivenUp_ ? 1.0 : 0.0}, {"short windows", 1.0 * nShort_}};
}

void EventWindow::setRestartState(const RestartState& state) {
  misjudgedLife_ = state["misjudged life"];
  hasGivenUp_ = state["given up"] != 0.0;
  nShort_ = static_cast<int>(state["short windows"]);
}

EventWindow::Wanted EventWindow::wantedOf(Simulation& simulation) const {
  Model& model = simulation.model;
  const auto n = static_cast<std::size_t>(model.nOwned());
  Wanted wanted{std::vector<char>(n, 0), std::vector<char>(n, 0), false};
  const double* rate = lossRatesOf(model);
  const double worst = *std::max_element(rate, rate + n);
  wanted.isAny = worst > 0.0;
  for (std::size_t i = 0; i < n; ++i) wanted.tires[i] = rate[i] > 0.0 && rate[i] >= tiringShare * worst ? 1 : 0;
  simulation.output.markRead(model, wanted.isRead);
  return wanted;
}

bool EventWindow::has(const std::vector<char>& isRead) const {
  if (!window_) return false;
  for (std::size_t i = 0; i < isRead.size(); ++i)
    if (isRead[i] != 0 && !window_->contains(static_cast<int>(i))) return false;
  return true;
}

bool EventWindow::holds(const Wanted& wanted) const {
  for (std::size_t i = 0; i < wanted.tires.size(); ++i)
    if (wanted.tires[i] != 0 && !window_->isInside(static_cast<int>(i))) return false;
  return has(wanted.isRead);
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
  if (!window_) return false;
  if (!loadsAreTheSame(simulation, externalForce)) {
    window_.reset();
    giveUp(simulation, "loads or prescribed displacements change");
    return false;
  }
  double* displacement = simulation.model.field("Displacement");
  const Timers::Scope timer(simulation.model.timers(), "window");
  if (!holds(wantedOf(simulation)) || !window_->takeUp(changed, displacement) || !window_->solve(displacement)) {
    window_.reset();
    nShort_ += nOfWindow_ < worthwhile ? 1 : 0;
    return false;
  }
  extrapolate(simulation.model);
  ++nOfWindow_;
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
  if (most > mostStale) interval_ = std::max(1, interval_ / 2);
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

namespace {

/// Along the way of the tip, and to its left.
using Place = std::array<double, 2>;

struct Box {
  Place low{HUGE_VAL, HUGE_VAL}, high{-HUGE_VAL, -HUGE_VAL};
  bool isEmpty() const { return low[0] > high[0]; }
  void add(const Place& place) {
    for (std::size_t c = 0; c < 2; ++c) {
      low[c] = std::min(low[c], place[c]);
      high[c] = std::max(high[c], place[c]);
    }
  }
  /// By which the box would have to grow to its sides to reach a place, `margin` beside it: it then grows by so many
  /// times as much ahead and behind.
  double distance(const Place& place, double margin, const Place& aheadAndBehind) const {
    const double ahead = (place[0] - high[0] - margin) / aheadAndBehind[0];
    const double behind = (low[0] - place[0] - margin) / aheadAndBehind[1];
    return std::max({0.0, ahead, behind, low[1] - place[1] - margin, place[1] - high[1] - margin});
  }
};

/// From the damaged to the intact ones of the points that tire; zero where that shows no direction.
Place directionOf(Model& model, const std::vector<char>& tires, double horizon) {
  const double *x = model.field("Model_Coordinates"), *damage = model.field("Damage");
  Place middle{}, broken{};
  double count = 0.0, weight = 0.0;
  for (std::size_t i = 0; i < tires.size(); ++i) {
    if (tires[i] == 0) continue;
    for (std::size_t c = 0; c < 2; ++c) {
      middle[c] += x[3 * i + c];
      broken[c] += damage[i] * x[3 * i + c];
    }
    count += 1.0;
    weight += damage[i];
  }
  if (weight <= 0.0) return {0.0, 0.0};
  const double dx = middle[0] / count - broken[0] / weight, dy = middle[1] / count - broken[1] / weight;
  const double length = std::hypot(dx, dy);
  return length > 0.05 * horizon ? Place{dx / length, dy / length} : Place{0.0, 0.0};
}

}  // namespace

/// The tip takes what is wanted with it as it grows: as far as the size of a window allows. Bonds break between points
/// that tire, and perhaps between them and their neighbours.
EventWindow::Places EventWindow::placesAround(Model& model, const Wanted& wanted) {
  const std::size_t n = wanted.tires.size();
  const double* x = model.field("Model_Coordinates");
  const double horizon =
      *std::max_element(model.discretization().horizon.begin(), model.discretization().horizon.end());
  Place along = directionOf(model, wanted.tires, horizon);
  const bool isDirected = along != Place{0.0, 0.0};
  if (!isDirected) along = {1.0, 0.0};
  std::vector<Place> places(n);
  Box tiring, read;
  for (std::size_t i = 0; i < n; ++i) {
    places[i] = {x[3 * i] * along[0] + x[3 * i + 1] * along[1], x[3 * i + 1] * along[0] - x[3 * i] * along[1]};
    if (wanted.tires[i] != 0) tiring.add(places[i]);
    if (wanted.isRead[i] != 0) read.add(places[i]);
  }
  const double bond = longestBondInHorizons * horizon;
  const Place growth =
      isDirected ? Place{read.isEmpty() ? aheadOfSides : aheadWhereRead, behindOfSides} : Place{1.0, 1.0};
  std::vector<std::pair<double, int>> byDistance;
  for (std::size_t i = 0; i < n; ++i)
    byDistance.emplace_back(std::min(tiring.distance(places[i], bond, growth), read.distance(places[i], 0.0, growth)),
                            static_cast<int>(i));
  std::sort(byDistance.begin(), byDistance.end());
  const std::size_t usual = read.isEmpty() ? usualPoints : usualWhereRead;
  Places found;
  double reach = 0.0;
  std::vector<int> all;
  for (const auto& [distance, point] : byDistance) {
    if (distance > 0.0 && all.size() >= (distance > leastReachInHorizons * horizon ? usual : mostPoints)) break;
    reach = distance;
    all.push_back(point);
  }
  std::sort(all.begin(), all.end());
  for (const int i : all) {
    const bool mayChange =
        tiring.distance(places[static_cast<std::size_t>(i)], changingBesideInHorizons * horizon, growth) <= reach;
    (mayChange ? found.changing : found.read).push_back(i);
  }
  return found;
}

void EventWindow::place(Simulation& simulation, SpringTangent& springs, const std::vector<double>& externalForce) {
  Model& model = simulation.model;
  if (nShort_ >= mostShort) return giveUp(simulation, "windows have served too few events each");
  const Wanted wanted = wantedOf(simulation);
  if (!wanted.isAny) return;
  const Places places = placesAround(model, wanted);
  if (const std::size_t size = places.read.size() + places.changing.size(); size > mostPoints)
    return giveUp(simulation,
                  fmt::format("it would have {} points, for the bonds that lose life and what computes look "
                              "at, and may have {}",
                              size, mostPoints));
  const Timers::Scope timer(model.timers(), "window set-up");
  const SpringOperator& stiffness = springs.stiffness();
  springs.takeChangedPoints();
  const double* displacement = model.field("Displacement");
  window_ = std::make_unique<TipWindow>(stiffness, places.read, places.changing, displacement);
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
      "{}: {} more equilibria in {} window(s) around the tip; lives outside, where strains were estimated for up to {} "
      "events, are off by {:.2g} of a life at most (estimates of each stretch, added up){}",
      solver, nFound_, nPlaced_, longestInterval, misjudgedLife_, hasGivenUp_ ? "; then none: " + whyGivenUp_ : "");
}

}  // namespace pd
