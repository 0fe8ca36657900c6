// Cracks and voids that the points of a mesh do not resolve: what they hide of a place from another one.
#ifndef PD_DISCONTINUITIES_HPP
#define PD_DISCONTINUITIES_HPP

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "places.hpp"
#include "simd.hpp"

/// For what works on vectors throughout: all that it calls becomes part of it, since calls pass vectors through memory.
#define PD_INLINES [[gnu::flatten]]

namespace pd::decomposition {

/// From `low` to `high`; nothing where low >= high.
struct Range {
  double low, high;
};
constexpr double beyondAll = 1e300;

/// Up to 16 places: the corners of one cell or of two.
class Corners {
 public:
  void add(const Place& place) { places_[n_++] = place; }
  std::size_t size() const { return n_; }
  const Place* begin() const { return places_.data(); }
  const Place* end() const { return places_.data() + n_; }
  Place& operator[](std::size_t k) { return places_[k]; }
  const Place& operator[](std::size_t k) const { return places_[k]; }

 private:
  std::array<Place, 16> places_;
  std::size_t n_ = 0;
};

/// The parallelepiped that a point stands for: centre + sum of s_k edge_k, |s_k| <= 1/2. In a plane the third edge is
/// 0.
struct Cell {
  Place center;
  std::array<Place, 3> edges;
  int dimension = 3;
  /// Places of its corners, 4 in a plane and 8 in space.
  Corners corners() const;
};
/// The corners of two cells, between which all their connections are.
Corners cornersOf(const Cell& a, const Cell& b);

/// As many places as a vector of the processor has lanes.
using Places = std::array<kernels::Vector, 3>;

/// One straight line each: start + s step.
struct LinePerLane {
  Places start, step;
};

/// One range each; nothing where low >= high, but of what is flat where low > high.
struct RangePerLane {
  kernels::Vector low, high;
};

/// For each of several places, all x with normal . (x - origin) <= offset.
struct HalfSpace {
  Places normal;
  kernels::Vector offset;
};

/// Parallel straight lines of one length: line r is start_r + s step, 0 <= s <= 1.
struct Lines {
  std::array<std::vector<double>, 3> start;  ///< [3][lines] m
  Place step{};
  std::size_t size() const { return start[0].size(); }
};

struct Box {
  Place low, high;
  bool meets(const Box& other) const;
};
/// Of both cells, and all that is between them.
Box boxAround(const Cell& a, const Cell& b);

/// Rules by which a bond is cut as a whole where it passes the end of a crack (Liu & Bao, Aerospace 9 (2022) 641,
/// section 2.3.1): where the feet of both of its ends are beside the crack, or of one at least.
enum class TipRule { Both, Either };

/// A flat crack, or a convex body, that no straight connection may meet.
class Screen {
 public:
  virtual ~Screen() = default;
  /// Which part of each line `place` does not see, in s: an interval for convex screens; [lines] each, nothing where
  /// from >= to. A place on a crack belongs to the side that its normal points to.
  virtual void hide(const Place& place, const Lines& lines, double* from, double* to) const = 0;
  /// Adds half-spaces whose common part is what the places do not see behind it (not what is inside of it), with
  /// `origin` as theirs; false where that has another form. Where a place is inside, it sees nothing.
  virtual bool addShadow(const Places&, const Place& /*origin*/, std::vector<HalfSpace>&) const { return false; }
  /// As hide() for several places, [lines] each, but without what is inside of it; false where it cannot.
  virtual bool hideFromEach(const Places&, const Lines&, kernels::Vector* /*from*/, kernels::Vector* /*to*/) const {
    return false;
  }
  /// Of one in the plane: where each line in the plane, and its continuation, meets it, in s; at low = high where it is
  /// flat. Others throw.
  virtual RangePerLane meet(const LinePerLane& lines) const;
  /// Of one in the plane: the heights along `axis`, x . axis, from which to which it reaches. Others throw.
  virtual Range heights(const Place& axis) const;
  /// False only where no connection of the two cells meets it.
  virtual bool isBetween(const Cell& a, const Cell& b) const = 0;
  /// False only where it hides nothing from any place of the cell.
  virtual bool mayHideFrom(const Cell&) const { return true; }
  /// One that hides from places of `a` the same of lines within `b`, for less work, and lives no longer than this one;
  /// nothing where there is none.
  virtual std::unique_ptr<Screen> narrowed(const Cell& /*a*/, const Cell& /*b*/) const { return nullptr; }
  virtual Box box() const = 0;
  /// Of a flat crack: whether it cuts all of what is between the two cells in two, without an end there.
  virtual bool divides(const Cell&, const Cell&) const { return false; }
  /// Of a flat crack: whether a place is on the side that its normal points to.
  virtual bool isAbove(const Place&) const { return true; }
  /// By a rule for tips; nothing where the screen has none.
  virtual std::optional<bool> cuts(const Place&, const Place&, TipRule) const { return std::nullopt; }
};

/// A part of space without material.
class Void {
 public:
  virtual ~Void() = default;
  virtual bool contains(const Place& place) const = 0;
  /// Adds the ranges of s that it takes of the line start + s step.
  virtual void addWithin(const Place& start, const Place& step, std::vector<Range>& ranges) const = 0;
  /// Of one in the plane: adds what it takes of each line in the plane and its continuation. Others throw.
  virtual void addWithinEach(const LinePerLane& lines, std::vector<RangePerLane>& ranges) const;
  virtual Box box() const = 0;
  /// m: radius of the largest circle or ball within it. Of one with flat sides an estimate, which is exact where all
  /// sides touch that, and at most twice (in space three times) as large.
  virtual double inradius() const = 0;
  /// Heights along `axis` (of any length; height = place . axis) at which cross-sections change their form.
  virtual std::vector<double> heights(const Place& axis) const = 0;
};

/// What is wrong with the size of a crack, of whose sides' lengths their ends are known to some 1e-9, or of a void, of
/// which rounding makes anything where it is far thinner than a cell, however it is turned, beside cells of this
/// spacing, m. Follows its name; empty where nothing is.
std::string complaintOfCrack(const Box& box, int dimension, double spacing);
std::string complaintOfVoid(const Void& v, double spacing);

/// A segment of a crack in the plane from a to b.
std::unique_ptr<Screen> segmentScreen(const Place& a, const Place& b);
/// A flat, convex polygon in space, of three corners or more in turn.
std::unique_ptr<Screen> polygonScreen(const std::vector<Place>& corners);
/// A round crack in space. `normal`: of any length but 0.
std::unique_ptr<Screen> diskScreen(const Place& center, const Place& normal, double radius);

/// The ellipsoid |sum_k unit_k ((x - center).axis_k)/|axis_k|^2| < 1 with the half-axes axis_k, perpendicular to each
/// other. Axes that are left out are infinitely long: two of them make an elliptic hole in the plane, or a cylinder.
struct Ellipsoid {
  Place center{};
  std::vector<Place> halfAxes;
};
std::unique_ptr<Screen> ellipsoidScreen(const Ellipsoid& shape);
std::unique_ptr<Void> ellipsoidVoid(const Ellipsoid& shape);

/// The inside of a polygon in the plane, convex or not; its edges are screens of their own (segmentScreen).
std::unique_ptr<Void> polygonVoid(const std::vector<Place>& corners);

}  // namespace pd::decomposition

#endif
