// Columns of points behind a surface, as seen along the direction into it.
#ifndef PD_COLUMN_LAYOUT_HPP
#define PD_COLUMN_LAYOUT_HPP

#include <array>
#include <vector>

namespace pd {

using Place2 = std::array<double, 2>;

/// Divides the plane across a direction among columns.
class ColumnLayout {
 public:
  ColumnLayout() = default;
  /// One column for each different place; those closer along both axes than `tolerance` are one. A column reaches to
  /// the points nearest to it that lie within 3/4 of the distance to the column next to it: of a lattice, to those in
  /// line with it; of other meshes of about even spacing, over half the way to the next.
  ColumnLayout(std::vector<Place2> places, double tolerance);
  /// Square columns of this width, wherever one of `places` lies, a first one amid the bin at the lowest coordinates.
  static ColumnLayout bins(const std::vector<Place2>& places, double width);

  int count() const { return static_cast<int>(places_.size()); }
  const Place2& place(int column) const { return places_[static_cast<std::size_t>(column)]; }
  /// The column that a place belongs to, or -1.
  int columnOf(const Place2& place) const;

 private:
  using Bin = std::array<long long, 2>;
  Bin binOf(const Place2& place) const;
  /// The nearest place but number `except`, no further than `distance`, which becomes its distance; -1: none.
  int nearest(const Place2& place, int except, double& distance) const;

  std::vector<Place2> places_;  ///< sorted
  std::vector<double> reach_;
  double tolerance_ = 0.0, longestReach_ = 0.0;
  double width_ = 0.0;  ///< 0: no bins
  Place2 origin_{};
  std::vector<Bin> bins_;  ///< sorted
};

}  // namespace pd

#endif
