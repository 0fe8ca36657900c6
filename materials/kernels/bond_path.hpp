// What lies along the bonds of a point.
#ifndef PD_BOND_PATH_HPP
#define PD_BOND_PATH_HPP

#include <array>
#include <vector>

namespace pd::kernels {

/// The neighbourhood of one point, whose points have values: every place has that of the point nearest to it.
class BondPaths {
 public:
  /// A neighbourhood without neighbours, of a point with this value. Memory is kept from one point to the next.
  void startAt(double ownValue);
  /// Adds a neighbour. `xi`: the bond to it, m.
  void add(const std::array<double, 3>& xi, double value);
  /// Mean value over the length of the bond to neighbour `k`, counted from 0. It is the point's own value to the last
  /// bit where the bond meets no other one. Both ends find the same, but for rounding, where both have all neighbours
  /// in the ball whose diameter the bond is.
  double mean(std::size_t k);

 private:
  struct Place {
    double along, square, value;  ///< product with the bond, square of the distance
  };
  double own_ = 0.0;
  std::vector<double> x_, y_, z_, square_, value_;
  std::vector<Place> near_;
};

}  // namespace pd::kernels

#endif
