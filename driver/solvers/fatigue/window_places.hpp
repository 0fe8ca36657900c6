// Where the windows of fatigue lie, and the corridors that they are taken from.
#ifndef PD_WINDOW_PLACES_HPP
#define PD_WINDOW_PLACES_HPP

#include <array>
#include <cmath>
#include <vector>

#include "../../model/model.hpp"
#include "../../model/restart_state.hpp"

namespace pd {

/// What a window has to hold: points whose bonds lose life, and those that computes look at. [nOwned]
struct WindowNeeds {
  std::vector<char> tires, isRead;
  bool isAny = false;
};

/// A rectangle along the way of a tip: along `along`, a unit vector, and to its left. m
struct TipBox {
  using Place = std::array<double, 2>;
  Place along{1.0, 0.0};
  Place low{HUGE_VAL, HUGE_VAL}, high{-HUGE_VAL, -HUGE_VAL};

  bool isEmpty() const { return low[0] > high[0]; }
  Place placeOf(const double* x) const {
    return {x[0] * along[0] + x[1] * along[1], x[1] * along[0] - x[0] * along[1]};
  }
  void add(const Place& place);
  void grow(double ahead, double behind, double sides);
  bool contains(const Place& place) const;
  /// By which the box would have to grow to its sides to reach a place, `margin` beside it: it then grows by so many
  /// times as much ahead and behind.
  double distance(const Place& place, double margin, const Place& aheadAndBehind) const;
  RestartState restartState() const;
  void setRestartState(const RestartState& state);
};

/// How the tip stands that takes the needs with it as it grows.
class WindowPlaces {
 public:
  /// Refers to the model and the needs, of which there are some.
  WindowPlaces(Model& model, const WindowNeeds& needs);

  /// The most points that a window may have.
  static constexpr std::size_t mostPoints = 3600;
  struct Points {
    std::vector<int> read, changing;  ///< rising; bonds may break between changing ones alone
    std::size_t size() const { return read.size() + changing.size(); }
  };
  /// As far ahead of the tip as the size of a window allows; inside of the corridor [nOwned].
  Points window(const std::vector<char>& corridor) const;
  /// For many windows, one after the other.
  TipBox corridor() const;
  /// Whether a window in it would be worth its while.
  bool fits(const std::vector<char>& corridor) const;
  static std::vector<char> pointsIn(Model& model, const TipBox& box);

 private:
  TipBox::Place directionOf() const;
  /// By which a window has to reach to its sides for the point.
  double reachTo(std::size_t point) const;

  Model& model_;
  const WindowNeeds& needs_;
  double horizon_;
  bool isDirected_ = false;
  TipBox tiring_, read_;
  TipBox::Place growth_{1.0, 1.0};
  std::vector<double> reach_;  ///< [nOwned] m, reachTo()
};

}  // namespace pd

#endif
