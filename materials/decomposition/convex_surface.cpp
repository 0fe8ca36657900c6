// A convex surface of triangles, and what of it matters between two cells.
#include <cmath>

#include "convex_geometry.hpp"
#include "triangle_geometry.hpp"

namespace pd::decomposition {

namespace {

struct Face {
  Place origin, normal;
  double height(const Place& place) const { return dot(minus(place, origin), normal); }
};

class ConvexScreen;

/// Of a convex surface, without faces that no place of a cell sees or that all of another cell lies behind, and with
/// the edges that may be on its outline as seen from the first.
class NarrowedConvexScreen : public Screen {
 public:
  NarrowedConvexScreen(const ConvexScreen& whole, const Cell& a, const Cell& b);
  void hide(const Place& place, const Lines& lines, double* from, double* to) const override;
  bool isBetween(const Cell& a, const Cell& b) const override;
  Box box() const override;

 private:
  enum class Where { Below, Above, Across };
  /// Of the lines' cell, as to the half-space below a plane.
  Where whereIs(const Place& normal, const Place& origin) const;

  struct SomeFace {  ///< that some places see
    Face face;
    Where lines;
  };
  struct SomeEdge {
    Place from, to;
    std::size_t left, right;  ///< which of isSeen_ says whether its triangles are seen
  };
  const ConvexScreen& whole_;
  Cell ofLines_;
  std::vector<Face> always_;  ///< seen from everywhere
  std::vector<SomeFace> some_;
  std::vector<SomeEdge> edges_;
  bool seesAny_ = false;
  mutable std::vector<char> isSeen_;  ///< no, yes, and each of some_
};

class ConvexScreen : public Screen {
 public:
  ConvexScreen(const TriangleSurface& surface, std::vector<Edge> edges)
      : vertices_(surface.vertices), edges_(std::move(edges)), ball_(vertices_), tolerance_(1e-12 * ball_.radius) {
    for (const Triangle& triangle : surface.triangles)
      faces_.push_back({vertices_[triangle[0]], normalized(normalOf(surface, triangle))});
  }

  /// Hidden is what lies behind all faces that the place sees, within the cone over their common outline.
  void hide(const Place& place, const Lines& lines, double* from, double* to) const override {
    static thread_local std::vector<char> isSeen;
    isSeen.resize(faces_.size());
    Place apex = place;
    const std::size_t highest = look(apex, isSeen);
    if (isSeen[highest] == 0) {
      const double height = faces_[highest].height(apex);
      if (height < -tolerance_) return hideNothing(lines, from, to);
      apex = plus(place, faces_[highest].normal, 2.0 * tolerance_ - height);  // a place on the surface is outside
      isSeen[highest] = 1;
    }
    hideEverything(lines, from, to);
    for (std::size_t f = 0; f < faces_.size(); ++f)
      if (isSeen[f] != 0) keepBelow(faces_[f].normal, faces_[f].origin, 0.0, lines, from, to);
    for (const Edge& edge : edges_) {
      if (isSeen[edge.left] == isSeen[edge.right]) continue;
      const Place toFrom = minus(vertices_[edge.from], apex), toTo = minus(vertices_[edge.to], apex);
      keepBelow(isSeen[edge.left] != 0 ? crossed(toFrom, toTo) : crossed(toTo, toFrom), apex, 0.0, lines, from, to);
    }
  }

  bool isBetween(const Cell& a, const Cell& b) const override {
    if (areParted(vertices_, ball_, a, b)) return false;
    const Corners corners = cornersOf(a, b);
    return std::none_of(faces_.begin(), faces_.end(), [&](const Face& face) {
      return std::all_of(corners.begin(), corners.end(),
                         [&](const Place& corner) { return face.height(corner) > 0.0; });
    });
  }
  std::unique_ptr<Screen> narrowed(const Cell& a, const Cell& b) const override {
    return std::make_unique<NarrowedConvexScreen>(*this, a, b);
  }
  Box box() const override { return boxOf(vertices_); }

 private:
  friend class NarrowedConvexScreen;
  /// Which faces a place sees, and the one that it is highest above.
  std::size_t look(const Place& place, std::vector<char>& isSeen) const {
    std::size_t highest = 0;
    double most = -farthest;
    for (std::size_t f = 0; f < faces_.size(); ++f) {
      const double height = faces_[f].height(place);
      isSeen[f] = height > tolerance_ ? 1 : 0;
      if (height <= most) continue;
      most = height;
      highest = f;
    }
    return highest;
  }

  std::vector<Place> vertices_;
  std::vector<Edge> edges_;
  std::vector<Face> faces_;
  Ball ball_;
  double tolerance_;
};

NarrowedConvexScreen::NarrowedConvexScreen(const ConvexScreen& whole, const Cell& a, const Cell& b)
    : whole_(whole), ofLines_(b) {
  const Corners corners = a.corners();
  std::vector<std::size_t> slot;
  for (const Face& face : whole.faces_) {
    double low = farthest, high = -farthest;
    for (const Place& corner : corners) {
      const double height = face.height(corner);
      low = std::min(low, height);
      high = std::max(high, height);
    }
    // Twice: beyond rounding.
    slot.push_back(high < 0.0 ? 0 : low > 2.0 * whole.tolerance_ ? 1 : 2 + some_.size());
    if (slot.back() == 0) continue;
    const Where lines = whereIs(face.normal, face.origin);
    if (slot.back() > 1)
      some_.push_back({face, lines});
    else if (lines != Where::Below)
      always_.push_back(face);
    seesAny_ = seesAny_ || slot.back() == 1;
  }
  for (const Edge& edge : whole.edges_)
    if (slot[edge.left] != slot[edge.right])
      edges_.push_back({whole.vertices_[edge.from], whole.vertices_[edge.to], slot[edge.left], slot[edge.right]});
  isSeen_.assign(2 + some_.size(), 0);
  isSeen_[1] = 1;
}

NarrowedConvexScreen::Where NarrowedConvexScreen::whereIs(const Place& normal, const Place& origin) const {
  constexpr double surely = 1.0 + 1e-9;  // beyond rounding
  double reach = 0.0;
  for (const Place& edge : ofLines_.edges) reach += 0.5 * std::abs(dot(normal, edge));
  const double height = dot(normal, minus(ofLines_.center, origin));
  return height < -surely * reach ? Where::Below : height > surely * reach ? Where::Above : Where::Across;
}

void NarrowedConvexScreen::hide(const Place& place, const Lines& lines, double* from, double* to) const {
  bool seesAny = seesAny_;
  for (std::size_t k = 0; k < some_.size(); ++k) {
    isSeen_[2 + k] = some_[k].face.height(place) > whole_.tolerance_ ? 1 : 0;
    seesAny = seesAny || isSeen_[2 + k] != 0;
  }
  if (!seesAny) return whole_.hide(place, lines, from, to);  // it is on the surface, or within
  for (std::size_t k = 0; k < some_.size(); ++k)
    if (isSeen_[2 + k] != 0 && some_[k].lines == Where::Above) return hideNothing(lines, from, to);
  hideEverything(lines, from, to);
  for (const SomeEdge& edge : edges_) {
    if (isSeen_[edge.left] == isSeen_[edge.right]) continue;
    const Place toFrom = minus(edge.from, place), toTo = minus(edge.to, place);
    const Place normal = isSeen_[edge.left] != 0 ? crossed(toFrom, toTo) : crossed(toTo, toFrom);
    const Where where = whereIs(normal, place);
    if (where == Where::Above) return hideNothing(lines, from, to);
    if (where == Where::Across) keepBelow(normal, place, 0.0, lines, from, to);
  }
  for (const Face& face : always_) keepBelow(face.normal, face.origin, 0.0, lines, from, to);
  for (std::size_t k = 0; k < some_.size(); ++k)
    if (isSeen_[2 + k] != 0 && some_[k].lines == Where::Across)
      keepBelow(some_[k].face.normal, some_[k].face.origin, 0.0, lines, from, to);
}

bool NarrowedConvexScreen::isBetween(const Cell& a, const Cell& b) const { return whole_.isBetween(a, b); }
Box NarrowedConvexScreen::box() const { return whole_.box(); }

}  // namespace

std::unique_ptr<Screen> convexScreen(const TriangleSurface& surface, std::vector<Edge> edges) {
  return std::make_unique<ConvexScreen>(surface, std::move(edges));
}

}  // namespace pd::decomposition
