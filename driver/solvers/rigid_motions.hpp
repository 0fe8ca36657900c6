// Motions of a body that do not deform it.
#ifndef PD_RIGID_MOTIONS_HPP
#define PD_RIGID_MOTIONS_HPP

#include <array>

#include "../discretization/symmetry.hpp"

namespace pd {

/// A set of rigid-body motions: translations, then rotations about `centre` scaled by `radius`, so that all are of one
/// size: 1, 3 or 6 of them in 1, 2 or 3 dimensions.
struct RigidMotions {
  using Point = std::array<double, 3>;
  /// A value for each motion; unused ones are zero.
  using Mode = std::array<double, 6>;

  Point centre{};
  double radius = 0.0;  ///< m
  int dimension = 3;

  static int count(int dimension) { return dimension == 1 ? 1 : (dimension == 2 ? 3 : 6); }
  /// Displacement component `axis` at `place` in each motion.
  Mode at(const Point& place, int axis) const;
  /// The same of a point whose image in a copy of the body is at `place` and moves as the rigid body does. `copy`: the
  /// matrix of its mirror.
  Mode at(const Point& place, int axis, const Symmetry::Matrix& copy) const;
  /// Of what the motions do work with: the moment about the centre, N m, where `work` is in N.
  std::array<double, 3> moment(const Mode& work) const;
};

}  // namespace pd

#endif
