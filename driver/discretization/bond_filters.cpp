#include "bond_filters.hpp"

#include <array>
#include <cmath>
#include <functional>

#include "../deck/vector3.hpp"
#include "exodus_surface.hpp"
#include "mesh_geometry.hpp"

namespace pd {

namespace {

// ---- filters ----

/// Cuts bonds that meet a part of a plane.
class PlaneFilter : public BondFilter {
 public:
  /// `covers`: whether a point of the plane belongs to the surface.
  PlaneFilter(const MeshPoints& points, const Vector3& origin, const Vector3& normal, double tolerance,
              std::function<bool(const Vector3&)> covers)
      : points_(points), covers_(std::move(covers)), height_(points.volume.size()) {
    for (int i = 0; i < points.size(); ++i) {
      const double height = dot(difference(at(i), origin), normal);
      height_[i] = std::abs(height) <= tolerance ? 0.0 : height;
    }
  }

  bool cuts(int a, int b) const override {
    if (a > b) std::swap(a, b);  // the same arithmetic from either end
    const double heightA = height_[a], heightB = height_[b];
    const bool isOnOneSide = (heightA > 0.0 && heightB > 0.0) || (heightA < 0.0 && heightB < 0.0);
    if (isOnOneSide || heightA == heightB) return false;
    const double t = heightA / (heightA - heightB);
    const Vector3 xa = at(a), xb = at(b);
    return covers_({xa[0] + t * (xb[0] - xa[0]), xa[1] + t * (xb[1] - xa[1]), xa[2] + t * (xb[2] - xa[2])});
  }

 private:
  Vector3 at(int point) const {
    const double* x = points_.at(point);
    return {x[0], x[1], x[2]};
  }

  const MeshPoints& points_;
  std::function<bool(const Vector3&)> covers_;
  std::vector<double> height_;  ///< over the plane, m
};

/// Cuts bonds from a point of one set to a point of the other.
class NodeSetPairFilter : public BondFilter {
 public:
  NodeSetPairFilter(int nPoints, const std::vector<int>& first, const std::vector<int>& second)
      : membership_(static_cast<std::size_t>(nPoints), 0) {
    for (const int id : first) membership_[id] |= 1;
    for (const int id : second) membership_[id] |= 2;
  }

  bool cuts(int a, int b) const override {
    const int setsA = setsOf(a), setsB = setsOf(b);
    return ((setsA & 1) != 0 && (setsB & 2) != 0) || ((setsA & 2) != 0 && (setsB & 1) != 0);
  }

 private:
  /// An image is where its source is.
  int setsOf(int point) const { return membership_[static_cast<std::size_t>(point) % membership_.size()]; }

  std::vector<unsigned char> membership_;  ///< bit 0: in the first set, bit 1: in the second
};

class BlockFilter : public BondFilter {
 public:
  explicit BlockFilter(const MeshPoints& points) : points_(points) {}
  bool cuts(int a, int b) const override { return points_.blockId[a] != points_.blockId[b]; }

 private:
  const MeshPoints& points_;
};

class BoxFilter : public BondFilter {
 public:
  BoxFilter(const MeshPoints& points, const Vector3& box) : points_(points), box_(box) {}
  bool cuts(int a, int b) const override {
    for (std::size_t k = 0; k < 3; ++k)
      if (std::abs(points_.at(a)[k] - points_.at(b)[k]) > box_[k]) return true;
    return false;
  }

 private:
  const MeshPoints& points_;
  const Vector3 box_;
};

// ---- reading ----

double positive(const DeckNode& node, const std::string& key) {
  const DeckNode value = required(node, key);
  if (!(value.real() > 0.0)) throw DeckError(value.place() + ": " + value.path() + " must be greater than 0 m");
  return value.real();
}

/// The three values <stem>_X, <stem>_Y, <stem>_Z.
Vector3 vectorOf(const DeckNode& node, const std::string& stem) {
  return {required(node, stem + "_X").real(), required(node, stem + "_Y").real(), required(node, stem + "_Z").real()};
}

Vector3 directionOf(const DeckNode& node, const std::string& stem) {
  Vector3 direction = vectorOf(node, stem);
  const double norm = length(direction);
  if (!(norm > 0.0))
    throw DeckError(node[stem + "_X"].place() + ": " + node.path() + ": " + stem +
                    " is a zero vector, not a direction");
  for (double& component : direction) component /= norm;
  return direction;
}

class FilterReader {
 public:
  FilterReader(const Deck& deck, const Communicator& comm, const MeshPoints& points, const NodeSets& nodeSets)
      : deck_(deck),
        comm_(comm),
        points_(points),
        nodeSets_(nodeSets),
        isPeridigmDeck_(deck.isPeridigmDeck()),
        tolerance_(geometricTolerance(boundingBox(points))) {}

  std::unique_ptr<BondFilter> read(const DeckNode& node) const {
    const std::string type = required(node, "Type").text();
    if (type == "Rectangular_Plane") return rectangle(node);
    if (type == "Disk") return disk(node);
    if (type == "Node Set Pair") return nodeSetPair(node);
    if (type == "Exodus Mesh") return surface(node);
    throw DeckError(node["Type"].place() + ": unknown bond filter \"" + type +
                    "\"; there are Rectangular_Plane, Disk, Node Set Pair, Exodus Mesh");
  }

 private:
  std::unique_ptr<BondFilter> rectangle(const DeckNode& node) const {
    const Vector3 normal = directionOf(node, "Normal"), corner = vectorOf(node, "Lower_Left_Corner");
    const double bottomLength = positive(node, "Bottom_Length"), sideLength = positive(node, "Side_Length");
    Vector3 bottom = directionOf(node, "Bottom_Unit_Vector");
    if (isPeridigmDeck_) {
      // Peridigm takes the vector as it is, of which the part within the plane counts.
      bottom = vectorOf(node, "Bottom_Unit_Vector");
      const double outOfPlane = dot(normal, bottom);
      for (std::size_t k = 0; k < 3; ++k) bottom[k] -= outOfPlane * normal[k];
    } else if (std::abs(dot(normal, bottom)) > 1e-6)
      throw DeckError(node["Bottom_Unit_Vector_X"].place() + ": " + node.path() +
                      ": Bottom_Unit_Vector must be perpendicular to Normal");
    const Vector3 side = cross(bottom, normal);
    const double tolerance = tolerance_;
    return std::make_unique<PlaneFilter>(points_, corner, normal, tolerance, [=](const Vector3& x) {
      const double alongBottom = dot(difference(x, corner), bottom), alongSide = dot(difference(x, corner), side);
      return alongBottom >= -tolerance && alongBottom <= bottomLength + tolerance && alongSide >= -tolerance &&
             alongSide <= sideLength + tolerance;
    });
  }

  std::unique_ptr<BondFilter> disk(const DeckNode& node) const {
    const Vector3 center = vectorOf(node, "Center"), normal = directionOf(node, "Normal");
    // Peridigm cuts what meets the inside of the disk, we its rim too.
    const double reach = positive(node, "Radius") + (isPeridigmDeck_ ? -tolerance_ : tolerance_);
    return std::make_unique<PlaneFilter>(points_, center, normal, tolerance_, [=](const Vector3& x) {
      const Vector3 distance = difference(x, center);
      return dot(distance, distance) <= reach * reach;
    });
  }

  std::unique_ptr<BondFilter> nodeSetPair(const DeckNode& node) const {
    return std::make_unique<NodeSetPairFilter>(points_.nRows, nodeSet(node, "First Node Set"),
                                               nodeSet(node, "Second Node Set"));
  }

  std::unique_ptr<BondFilter> surface(const DeckNode& node) const {
    const DeckNode name = required(node, "File Name");
    return std::make_unique<SurfaceFilter>(points_,
                                           readExodusSurface(deck_.resolvePath(name.text()), name.place(), comm_));
  }

  const std::vector<int>& nodeSet(const DeckNode& node, const std::string& key) const {
    const DeckNode name = required(node, key);
    if (const std::vector<int>* ids = findNodeSet(nodeSets_, name.text())) return *ids;
    std::string known;
    for (const auto& entry : nodeSets_) known += (known.empty() ? "" : ", ") + entry.first;
    throw DeckError(name.place() + ": no node set \"" + name.text() + "\" in Boundary Conditions" +
                    (known.empty() ? "" : " (there are: " + known + ")"));
  }

  const Deck& deck_;
  const Communicator& comm_;
  const MeshPoints& points_;
  const NodeSets& nodeSets_;
  bool isPeridigmDeck_;
  double tolerance_;
};

}  // namespace

BondFilters::BondFilters(const Deck& deck, const Communicator& comm, const MeshPoints& points,
                         const NodeSets& nodeSets) {
  const DeckNode section = deck["Discretization"];
  const FilterReader reader(deck, comm, points, nodeSets);
  for (const auto& item : section["Bond Filters"].entries()) {
    try {
      filters_.push_back({reader.read(item.second), item.second.flag("Count In Damage", false), item.second.keyPlace(),
                          item.second.path()});
    } catch (const DeckError& error) {
      deck.mistakes().add("", error.what());
    }
  }
  const std::string omitted = section.text("Omit Bonds Between Blocks", "None");
  if (omitted == "All")
    filters_.push_back({std::make_unique<BlockFilter>(points), false, section["Omit Bonds Between Blocks"].keyPlace(),
                        section["Omit Bonds Between Blocks"].path()});
  else if (omitted != "None")
    deck.mistakes().add(section["Omit Bonds Between Blocks"].place(),
                        "Omit Bonds Between Blocks must be None or All, not \"" + omitted + "\"");
}

void BondFilters::keepWithin(const std::array<double, 3>& box, const MeshPoints& points) {
  // It shapes neighbourhoods, so that it is no cut that a user waits for.
  filters_.push_back({std::make_unique<BoxFilter>(points, box), false, "", "", true});
}

bool BondFilters::canMark() const {
  for (const Entry& entry : filters_)
    if (entry.countsInDamage) return true;
  return false;
}

BondFilters::Verdict BondFilters::judge(int a, int b) {
  Verdict verdict = Verdict::keep;
  for (Entry& entry : filters_) {
    if ((verdict == Verdict::remove && entry.hasCut) || !entry.filter->cuts(a, b)) continue;
    entry.hasCut = true;
    if (!entry.countsInDamage)
      verdict = Verdict::remove;
    else if (verdict == Verdict::keep)
      verdict = Verdict::mark;
  }
  return verdict;
}

void BondFilters::warnOfIdle(const Communicator& comm, Mistakes& warnings) const {
  for (const Entry& entry : filters_)
    if (!comm.any(entry.hasCut))
      warnings.add(entry.place, entry.path + " cuts no bond; is it beside the body, or between points that have none?");
}

}  // namespace pd
