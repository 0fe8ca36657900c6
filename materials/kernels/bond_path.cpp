#include "bond_path.hpp"

#include <algorithm>

namespace pd::kernels {

void BondPaths::startAt(double ownValue) {
  own_ = ownValue;
  for (std::vector<double>* values : {&x_, &y_, &z_, &square_, &value_}) values->clear();
}

void BondPaths::add(const std::array<double, 3>& xi, double value) {
  x_.push_back(xi[0]);
  y_.push_back(xi[1]);
  z_.push_back(xi[2]);
  square_.push_back(xi[0] * xi[0] + xi[1] * xi[1] + xi[2] * xi[2]);
  value_.push_back(value);
}

double BondPaths::mean(std::size_t k) {
  // A place of the bond, t xi, is as far from a neighbour as its distance squared says, t^2 |xi|^2 - 2 t along +
  // square. Nearer to it than to both ends are places only where square < along: in the ball whose diameter the bond
  // is.
  const double length2 = square_[k];
  near_.clear();
  bool isPassed = value_[k] != own_;
  for (std::size_t j = 0; j < square_.size(); ++j) {
    const double along = x_[j] * x_[k] + y_[j] * y_[k] + z_[j] * z_[k];
    if (square_[j] >= along || j == k) continue;
    near_.push_back({along, square_[j], value_[j]});
    isPassed = isPassed || value_[j] != own_;
  }
  if (!isPassed) return own_;
  near_.push_back({length2, length2, value_[k]});

  double sum = 0.0, from = 0.0;
  Place present{0.0, 0.0, own_};
  while (present.along < length2) {
    // Where the next point is nearer than this one; of several the furthest ahead.
    const Place* next = nullptr;
    double to = 1.0;
    for (const Place& place : near_) {
      if (place.along <= present.along) continue;
      const double meeting = 0.5 * (place.square - present.square) / (place.along - present.along);
      if (next != nullptr && (meeting > to || (meeting == to && place.along < next->along))) continue;
      next = &place;
      to = meeting;
    }
    if (to > from) {  // a place without length has no part, were its value infinite
      sum += (to - from) * present.value;
      from = to;
    }
    present = *next;
  }
  return from < 1.0 ? sum + (1.0 - from) * present.value : sum;
}

}  // namespace pd::kernels
