#include "window_places.hpp"

#include <algorithm>

namespace pd {

namespace {

// Points of a window.
constexpr std::size_t usualPoints = 1700, usualWhereRead = 3000;
// Points of a corridor: what it costs is by those of its rim.
constexpr std::size_t corridorPoints = 5000, corridorWhereRead = 8000;
// How many times farther it reaches ahead of the tip, and behind it, than to its sides; less far ahead where computes
// look around the tip in directions that turn with it.
constexpr double aheadOfSides = 12.0, aheadWhereRead = 4.0, behindOfSides = 1.0;
constexpr double corridorAhead = 4.0, corridorBehind = 0.5;
// It has more points than usual where it would else reach less far to its sides, and so serve few events.
constexpr double leastReachInHorizons = 0.15;
// Where the direction of a tip is looked for.
constexpr double aroundInHorizons = 4.0;
constexpr double longestBondInHorizons = 1.1;
// Bonds of points that tire less than others break now and then, too, as far beside those.
constexpr double changingBesideInHorizons = 0.35;
// Where they may, and what costs most of a window, reaches to its sides by this part of what the window does.
constexpr double changingOfSides = 0.5;

}  // namespace

void TipBox::add(const Place& place) {
  for (std::size_t c = 0; c < 2; ++c) {
    low[c] = std::min(low[c], place[c]);
    high[c] = std::max(high[c], place[c]);
  }
}

void TipBox::grow(double ahead, double behind, double sides) {
  low[0] -= behind;
  high[0] += ahead;
  low[1] -= sides;
  high[1] += sides;
}

bool TipBox::contains(const Place& place) const {
  return place[0] >= low[0] && place[0] <= high[0] && place[1] >= low[1] && place[1] <= high[1];
}

double TipBox::distance(const Place& place, double margin, const Place& aheadAndBehind) const {
  const double ahead = (place[0] - high[0] - margin) / aheadAndBehind[0];
  const double behind = (low[0] - place[0] - margin) / aheadAndBehind[1];
  return std::max({0.0, ahead, behind, low[1] - place[1] - margin, place[1] - high[1] - margin});
}

RestartState TipBox::restartState() const {
  return {{"along x", along[0]}, {"along y", along[1]}, {"behind", low[0]},
          {"ahead", high[0]},    {"right", low[1]},     {"left", high[1]}};
}

void TipBox::setRestartState(const RestartState& state) {
  along = {state["along x"], state["along y"]};
  low = {state["behind"], state["right"]};
  high = {state["ahead"], state["left"]};
}

WindowPlaces::WindowPlaces(Model& model, const WindowNeeds& needs)
    : model_(model),
      needs_(needs),
      horizon_(*std::max_element(model.discretization().horizon.begin(), model.discretization().horizon.end())) {
  const TipBox::Place along = directionOf();
  isDirected_ = along != TipBox::Place{0.0, 0.0};
  if (isDirected_) tiring_.along = read_.along = along;
  const double* x = model.field("Model_Coordinates");
  for (std::size_t i = 0; i < needs.tires.size(); ++i) {
    if (needs.tires[i] != 0) tiring_.add(tiring_.placeOf(&x[3 * i]));
    if (needs.isRead[i] != 0) read_.add(read_.placeOf(&x[3 * i]));
  }
  if (isDirected_) growth_ = {read_.isEmpty() ? aheadOfSides : aheadWhereRead, behindOfSides};
  for (std::size_t i = 0; i < needs.tires.size(); ++i) reach_.push_back(reachTo(i));
}

/// From the middle of what is damaged around to that of what tires; zero where that shows no direction.
TipBox::Place WindowPlaces::directionOf() const {
  const double *x = model_.field("Model_Coordinates"), *damage = model_.field("Damage");
  TipBox::Place middle{}, broken{};
  double count = 0.0, weight = 0.0;
  for (std::size_t i = 0; i < needs_.tires.size(); ++i)
    if (needs_.tires[i] != 0) {
      for (std::size_t c = 0; c < 2; ++c) middle[c] += x[3 * i + c];
      count += 1.0;
    }
  for (double& each : middle) each /= count;
  for (std::size_t i = 0; i < needs_.tires.size(); ++i) {
    if (std::hypot(x[3 * i] - middle[0], x[3 * i + 1] - middle[1]) > aroundInHorizons * horizon_) continue;
    for (std::size_t c = 0; c < 2; ++c) broken[c] += damage[i] * x[3 * i + c];
    weight += damage[i];
  }
  if (weight <= 0.0) return {0.0, 0.0};
  const double dx = middle[0] - broken[0] / weight, dy = middle[1] - broken[1] / weight;
  const double length = std::hypot(dx, dy);
  return length > 0.2 * horizon_ ? TipBox::Place{dx / length, dy / length} : TipBox::Place{0.0, 0.0};
}

double WindowPlaces::reachTo(std::size_t point) const {
  const TipBox::Place place = tiring_.placeOf(&model_.field("Model_Coordinates")[3 * point]);
  return std::min(tiring_.distance(place, longestBondInHorizons * horizon_, growth_),
                  read_.distance(place, 0.0, growth_));
}

/// Bonds break between points that tire, and perhaps between them and their neighbours.
WindowPlaces::Points WindowPlaces::window(const std::vector<char>& corridor) const {
  std::vector<std::pair<double, int>> byReach;
  for (std::size_t i = 0; i < reach_.size(); ++i)
    if (corridor[i] != 0) byReach.emplace_back(reach_[i], static_cast<int>(i));
  std::sort(byReach.begin(), byReach.end());
  const std::size_t usual = read_.isEmpty() ? usualPoints : usualWhereRead;
  double reach = 0.0;
  std::vector<int> all;
  for (const auto& [distance, point] : byReach) {
    if (distance > 0.0 && all.size() >= (distance > leastReachInHorizons * horizon_ ? usual : mostPoints)) break;
    reach = distance;
    all.push_back(point);
  }
  std::sort(all.begin(), all.end());
  const double* x = model_.field("Model_Coordinates");
  const TipBox::Place growth = {growth_[0] / changingOfSides, growth_[1]};
  Points found;
  for (const int i : all) {
    const TipBox::Place place = tiring_.placeOf(&x[3LL * i]);
    const bool mayChange =
        tiring_.distance(place, changingBesideInHorizons * horizon_, growth) <= changingOfSides * reach;
    (mayChange ? found.changing : found.read).push_back(i);
  }
  return found;
}

bool WindowPlaces::fits(const std::vector<char>& corridor) const {
  for (std::size_t i = 0; i < reach_.size(); ++i)
    if (reach_[i] <= leastReachInHorizons * horizon_ && corridor[i] == 0) return false;
  return true;
}

TipBox WindowPlaces::corridor() const {
  TipBox box = tiring_;
  box.grow(longestBondInHorizons * horizon_, longestBondInHorizons * horizon_, longestBondInHorizons * horizon_);
  if (!read_.isEmpty()) {
    box.add(read_.low);
    box.add(read_.high);
  }
  const double least = leastReachInHorizons * horizon_;
  box.grow(growth_[0] * least, growth_[1] * least, least);
  const TipBox::Place growth = isDirected_ ? TipBox::Place{corridorAhead, corridorBehind} : TipBox::Place{1.0, 1.0};
  const double* x = model_.field("Model_Coordinates");
  std::vector<double> distances;
  for (std::size_t i = 0; i < reach_.size(); ++i)
    distances.push_back(box.distance(box.placeOf(&x[3 * i]), 0.0, growth));
  const std::size_t last = std::min(read_.isEmpty() ? corridorPoints : corridorWhereRead, distances.size()) - 1;
  std::nth_element(distances.begin(), distances.begin() + static_cast<std::ptrdiff_t>(last), distances.end());
  const double reach = distances[last];
  box.grow(growth[0] * reach, growth[1] * reach, reach);
  return box;
}

std::vector<char> WindowPlaces::pointsIn(Model& model, const TipBox& box) {
  const double* x = model.field("Model_Coordinates");
  std::vector<char> isIn;
  for (int i = 0; i < model.nOwned(); ++i) isIn.push_back(box.contains(box.placeOf(&x[3LL * i])) ? 1 : 0);
  return isIn;
}

}  // namespace pd
