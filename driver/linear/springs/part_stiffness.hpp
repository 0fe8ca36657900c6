// The stiffness of part of a body.
#ifndef PD_PART_STIFFNESS_HPP
#define PD_PART_STIFFNESS_HPP

#include <cstddef>
#include <vector>

#include "spring_operator.hpp"

namespace pd {

/// Over the degrees of freedom of some owned points that are not held, point after point, for springs along their bonds
/// alone, in one piece. In units of the network. Places count points as they are listed here.
class PartStiffness {
 public:
  /// Refers to the stiffness.
  PartStiffness(const SpringOperator& stiffness, std::vector<int> points);

  /// The springs as damage has left them for whose ends takesPart(i, j), both of them points of the part.
  template <class TakesPart>
  void addSprings(const TakesPart& takesPart) {
    stiffness_.network().forEachSpringIn([&](int i) { return has(i); },
                                         [&](int i, int j, const double* xi, const SpringConstants<double>& spring) {
                                           if (has(j) && takesPart(i, j)) addSpring(i, j, xi, spring.radial);
                                         });
  }
  /// What the stiffness adds to the diagonal at the points of which takesPart(point).
  template <class TakesPart>
  void addAdditions(const TakesPart& takesPart) {
    for (const SpringOperator::Addition& each : stiffness_.additions())
      if (has(each.point) && takesPart(each.point))
        ofPoint(placeOf(each.point), each.component, each.component) += each.value;
  }
  /// A symmetric matrix over the degrees of freedom of `points` that are not held, in their order. Refers to it. Once.
  void add(const std::vector<int>& points, const std::vector<double>& values);

  struct Spring {
    int from, to;  ///< places, from < to
    double radial;
  };
  const std::vector<Spring>& springs() const { return springs_; }
  /// What add() was given: places of the points, their degrees of freedom, and the matrix.
  const std::vector<int>& densePlaces() const { return densePlaces_; }
  const std::vector<int>& denseUnknowns() const { return denseUnknowns_; }
  double denseValue(std::size_t row, std::size_t column) const {
    return (*denseValues_)[column * denseUnknowns_.size() + row];
  }

  std::size_t nPoints() const { return points_.size(); }
  int placeOf(int point) const { return placeOf_[static_cast<std::size_t>(point)]; }
  /// Of the first degree of freedom of the point at a place that is not held; one more than there are points.
  int firstUnknown(std::size_t place) const { return firstUnknown_[place]; }
  /// Of points of the part, in their order.
  std::vector<int> unknownsOf(const std::vector<int>& points) const;
  int nUnknowns() const { return firstUnknown_.back(); }
  /// Calls f(row, column, value) for what lies below the diagonal of the columns of the point `spring.from`.
  template <class F>
  void forEachEntry(const Spring& spring, const F& f) const;
  /// And for the lower triangle of what is at a point itself, without the matrix of add().
  template <class F>
  void forEachEntryOfPoint(std::size_t place, const F& f) const;

 private:
  bool has(int point) const { return placeOf(point) >= 0; }
  bool isHeld(int place, int component) const {
    return stiffness_.isHeld(points_[static_cast<std::size_t>(place)], component);
  }
  double& ofPoint(int place, int c, int d) {
    return diagonal_[(static_cast<std::size_t>(place) * width_ + static_cast<std::size_t>(c)) * width_ +
                     static_cast<std::size_t>(d)];
  }
  void addSpring(int i, int j, const double* xi, double radial);

  const SpringOperator& stiffness_;
  std::size_t width_;                  ///< degrees of freedom of a point
  std::vector<int> points_, placeOf_;  ///< placeOf_ [nOwned]; -1: none
  std::vector<int> firstUnknown_;      ///< [points + 1]
  std::vector<Spring> springs_;
  std::vector<double> diagonal_;  ///< [points][width][width]
  std::vector<int> densePlaces_, denseUnknowns_;
  const std::vector<double>* denseValues_ = nullptr;
};

template <class F>
void PartStiffness::forEachEntry(const Spring& spring, const F& f) const {
  const PointVector<double>& x = stiffness_.network().places<double>();
  const int width = static_cast<int>(width_), i = points_[static_cast<std::size_t>(spring.from)],
            j = points_[static_cast<std::size_t>(spring.to)];
  int column = firstUnknown(static_cast<std::size_t>(spring.from));
  for (int d = 0; d < width; ++d) {
    if (isHeld(spring.from, d)) continue;
    int row = firstUnknown(static_cast<std::size_t>(spring.to));
    for (int c = 0; c < width; ++c)
      if (!isHeld(spring.to, c)) f(row++, column, -spring.radial * (x[c][j] - x[c][i]) * (x[d][j] - x[d][i]));
    ++column;
  }
}

template <class F>
void PartStiffness::forEachEntryOfPoint(std::size_t place, const F& f) const {
  const int width = static_cast<int>(width_), at = static_cast<int>(place);
  int column = firstUnknown(place);
  for (int d = 0; d < width; ++d) {
    if (isHeld(at, d)) continue;
    int row = column;
    for (int c = d; c < width; ++c)
      if (!isHeld(at, c))
        f(row++, column,
          diagonal_[(place * width_ + static_cast<std::size_t>(c)) * width_ + static_cast<std::size_t>(d)]);
    ++column;
  }
}

}  // namespace pd

#endif
