// Whether a body fills the rectangle around the tip of a crack over which J is taken.
#ifndef PD_RECTANGLE_COVER_HPP
#define PD_RECTANGLE_COVER_HPP

#include <Epetra_Comm.h>

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace pd {

/// The rectangle in cells, each of which holds several points. A free side of the body that runs along the crack does
/// no harm to J, nor does a notch that the crack starts from; one across it, or a hole, does.
class RectangleCover {
 public:
  /// From the tip, m; `reach`: of a bond, m, no longer than any of them.
  RectangleCover(double ahead, double behind, double above, double below, double reach);
  /// A point, by how far it is ahead of the tip and above it, m; `area` of its cell, m2.
  void add(double ahead, double above, double area);
  /// Of the points of all ranks: where the body ends ahead of, behind or within the rectangle, as in add(); nothing
  /// where it does not. Collective.
  std::optional<std::array<double, 2>> gap(const Epetra_Comm& comm) const;

 private:
  std::array<double, 2> low_, size_;  ///< m, size_: of a cell
  std::array<std::size_t, 2> n_;
  std::vector<double> area_;  ///< [cells] in parts of a cell
};

}  // namespace pd

#endif
