// Whether a body fills the ring around the tip of a crack over which J is taken.
#ifndef PD_RING_COVER_HPP
#define PD_RING_COVER_HPP

#include <Epetra_Comm.h>

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace pd {

/// The ring in rows along the crack, each in two halves, ahead of the tip and behind it. Along a half row q, which is 1
/// within the ring and 0 beyond it, falls by as much as it has at the row's middle where the body is whole, by less
/// where that ends. A free side along the crack does no harm to J, nor does a notch that the crack starts from; an end
/// across it, or a hole, does.
class RingCover {
 public:
  /// Radii of the ring and distance of points, m.
  RingCover(double inner, double outer, double spacing);
  /// A point, by how far it is ahead of the tip and above it, m; `area` of its cell, m2.
  void add(double ahead, double above, double area);
  /// Of the points of all ranks: where the body does not fill the ring, as in add(); nothing where it does. Collective.
  std::optional<std::array<double, 2>> gap(const Epetra_Comm& comm) const;

 private:
  std::size_t nRows() const { return whole_.size(); }

  double inner_, outer_, width_;  ///< m, width_: of a row
  std::vector<double> whole_;     ///< [rows] m2, integral over a row of q at its middle
  std::vector<double> fallen_;    ///< [2 rows] behind, ahead: m2, by what q falls along them
  std::vector<double> area_;      ///< [rows] m2, of all points in the circle
};

}  // namespace pd

#endif
