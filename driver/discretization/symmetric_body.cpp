#include "symmetric_body.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pd {

namespace {

/// Does mirroring about the plane leave the distance that the horizon limits as it is?
bool mapsOntoItself(const kernels::HorizonShape& shape, const SymmetryPlane& plane) {
  if (shape.isBall()) return true;
  Symmetry mirror;
  mirror.addPlane({}, plane.normal);
  for (const std::array<double, 3>& direction :
       {std::array<double, 3>{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}, {1.0, 0.6, 0.3}, {0.3, -0.8, 1.0}}) {
    const auto lengthOf = [&](const double* v) { return shape.length(shape.mapped(shape.along(v))); };
    const double length = lengthOf(direction.data());
    if (std::abs(lengthOf(mirror.place(1, direction.data()).data()) - length) > 1e-6 * length) return false;
  }
  return true;
}

/// The points of a plane's wrong side, or too near to it.
struct Misplaced {
  int count = 0, first = -1;
  void add(int point) {
    if (count++ == 0) first = point;
  }
};

std::string placeOf(const MeshPoints& part, int point) {
  const double* x = part.at(point);
  return fmt::format("the point {} at ({:g}, {:g}, {:g})", part.place(point), x[0], x[1], x[2]);
}

class PlaneCheck {
 public:
  PlaneCheck(const MeshPoints& part, const MeshPoints& searched, const std::vector<double>& spacing,
             const SymmetryPlane& plane, int copy)
      : part_(part), plane_(plane) {
    constexpr double nearest = 0.25;  // spacings: the centre of a cell is 0.5 away, of a triangle of Gmsh's 0.4
    for (int i = 0; i < part.size(); ++i) {
      const double* x = searched.at(i);
      const double* image = searched.at(copy * part.size() + i);
      const double distance = 0.5 * std::hypot(image[0] - x[0], image[1] - x[1], image[2] - x[2]);
      const double inSpacings = distance / spacing[static_cast<std::size_t>(i)];
      if (distance < nearest_) {
        nearest_ = distance;
        nearestInSpacings_ = inSpacings;
        nearestPoint_ = i;
      }
      if (inSpacings < nearest)
        tooNear_.add(i);
      else
        (height(i) > 0.0 ? above_ : below_).add(i);
    }
  }

  void report(double reach, Deck const& deck) const {
    Mistakes& mistakes = deck.mistakes();
    if (tooNear_.count > 0)
      mistakes.add(plane_.place,
                   fmt::format("{}: {} point(s) lie on the plane or nearer to it than a quarter of a spacing, as {}; "
                               "points are centres of cells, and the plane is where their faces are: shift it by half "
                               "a spacing, or take another mesh",
                               plane_.path, tooNear_.count, placeOf(part_, tooNear_.first)));
    if (above_.count > 0 && below_.count > 0) {
      const Misplaced& fewer = above_.count < below_.count ? above_ : below_;
      mistakes.add(plane_.place,
                   fmt::format("{}: the plane cuts through the body: {} of {} points lie beyond it, as {}; the mesh "
                               "holds one side of a plane of symmetry alone: move the plane, or leave these points out",
                               plane_.path, fewer.count, part_.size(), placeOf(part_, fewer.first)));
    } else if (2.0 * nearest_ >= reach) {
      mistakes.add(plane_.place, fmt::format("{}: no point is near enough to the plane to have neighbours beyond it "
                                             "(the nearest is {}); move the plane, or leave it out",
                                             plane_.path, placeOf(part_, nearestPoint_)));
    } else if (constexpr double usual = 0.75; nearestInSpacings_ > usual) {
      deck.warnings().add(plane_.place,
                          fmt::format("{}: the nearest point is {:.3g} spacings from the plane, where half a spacing "
                                      "is usual: is the gap between the body and its images meant?",
                                      plane_.path, nearestInSpacings_));
    }
  }

 private:
  double height(int point) const {
    double result = 0.0;
    for (std::size_t k = 0; k < 3; ++k) result += (part_.at(point)[k] - plane_.point[k]) * plane_.normal[k];
    return result;
  }

  const MeshPoints& part_;
  const SymmetryPlane& plane_;
  Misplaced tooNear_, above_, below_;
  double nearest_ = std::numeric_limits<double>::infinity(), nearestInSpacings_ = 0.0;
  int nearestPoint_ = -1;
};

template <class Values>
void repeat(Values& values, int times) {
  const Values once = values;
  for (int k = 1; k < times; ++k) values.insert(values.end(), once.begin(), once.end());
}

}  // namespace

void checkHalfSection(const Deck& deck, const MeshPoints& part, int dimension, const std::vector<double>& horizon,
                      std::vector<SymmetryPlane>& planes, Mistakes& mistakes) {
  const auto axis = axisPlane(deck);
  if (!axis) return;
  const DeckNode section = deck["Discretization"];
  for (const char* key : {"Cracks", "Voids"})
    if (section[key])
      mistakes.add(section[key].keyPlace(),
                   fmt::format("{} are shares of squares in a plane and of cubes, not of the rings of a body of "
                               "revolution; cut them out of the mesh, or leave out \"{}\"",
                               section[key].path(), axisOfRevolution));
  if (dimension != 2)
    mistakes.add(axis->place, fmt::format("{}: the points of {} must lie in the x-y plane, all at one z, beside the "
                                          "axis; those of a mesh in space are the body already",
                                          axis->path, part.fileName));
  const std::size_t radial = ringsOf(deck).radial();
  int nBeyond = 0, first = 0;
  double nearest = HUGE_VAL;
  for (int i = 0; i < part.size(); ++i) {
    const double r = part.at(i)[radial];
    nearest = std::min(nearest, r);
    if (!(r <= 0.0)) continue;
    if (nBeyond++ == 0) first = i;
  }
  if (nBeyond > 0)
    mistakes.add(axis->place,
                 fmt::format("{}: {} of {} points lie at {} <= 0, as the point {} at ({:g}, {:g}, {:g}); the mesh is "
                             "the half of the section at {} > 0, with the axis half a spacing from the nearest points",
                             axis->path, nBeyond, part.size(), "xy"[radial], part.place(first), part.at(first)[0],
                             part.at(first)[1], part.at(first)[2], "xy"[radial]));
  const bool reachesAxis =
      std::any_of(horizon.begin(), horizon.end(), [&](double value) { return 2.0 * nearest < value; });
  if (nBeyond > 0 || !reachesAxis)
    planes.erase(std::remove_if(planes.begin(), planes.end(),
                                [&](const SymmetryPlane& plane) { return plane.path == axis->path; }),
                 planes.end());
}

void makeRings(const Deck& deck, const std::vector<double>& x, std::vector<double>& volume) {
  const kernels::Rings rings = ringsOf(deck);
  if (!rings.areUsed()) return;
  for (std::size_t i = 0; i < volume.size(); ++i) volume[i] *= 2.0 * M_PI * rings.radius(x.data(), static_cast<int>(i));
}

Symmetry symmetryOf(const std::vector<SymmetryPlane>& planes, const MeshPoints& part, int dimension,
                    Mistakes& mistakes) {
  Symmetry symmetry;
  for (const SymmetryPlane& plane : planes) {
    const char* const bodies[] = {"lie on a line along x: Normal must be [1, 0, 0]",
                                  "lie in a plane of constant z: Normal must be [x, y, 0]"};
    for (int k = dimension; k < 3; ++k)
      if (plane.normal[static_cast<std::size_t>(k)] != 0.0) {
        mistakes.add(plane.place, plane.path + ": the points of the mesh " + bodies[dimension - 1]);
        break;
      }
    symmetry.addPlane(plane.point, plane.normal);
  }
  constexpr int unknownsOfAPoint = 3;  // which are numbered as points are
  const long long most = std::numeric_limits<int>::max() / unknownsOfAPoint / symmetry.nCopies();
  if (part.size() > most && !planes.empty())
    mistakes.add(planes.back().place, fmt::format("{} points beside {} plane(s) of symmetry are more than the {} whose "
                                                  "images have numbers; leave a plane out",
                                                  part.size(), planes.size(), most));
  return symmetry;
}

void checkHorizon(const std::vector<SymmetryPlane>& planes, const kernels::HorizonShape& shape, bool isBox,
                  Mistakes& mistakes) {
  for (const SymmetryPlane& plane : planes) {
    if (!mapsOntoItself(shape, plane))
      mistakes.add(plane.place, plane.path +
                                    ": the plane does not mirror the horizon onto itself; it must be perpendicular to "
                                    "one of the Horizon Axes of the material");
    Symmetry mirror;
    mirror.addPlane(plane.point, plane.normal);
    if (isBox && !mirror.isAlongAxes())
      mistakes.add(plane.place, plane.path +
                                    ": neighbourhoods are boxes along x, y and z, which the plane does not mirror onto "
                                    "themselves; set NeighborhoodType: Spherical");
  }
}

MeshPoints wholeBody(const MeshPoints& part, const Symmetry& symmetry) {
  MeshPoints whole = part;
  const int n = symmetry.nCopies();
  whole.x.reserve(part.x.size() * static_cast<std::size_t>(n));
  for (int copy = 1; copy < n; ++copy)
    for (int i = 0; i < part.size(); ++i) {
      const Symmetry::Vector x = symmetry.place(copy, part.at(i));
      whole.x.insert(whole.x.end(), x.begin(), x.end());
    }
  repeat(whole.volume, n);
  repeat(whole.blockId, n);
  repeat(whole.line, n);
  return whole;
}

std::vector<double> wholeBody(const std::vector<double>& part, const Symmetry& symmetry) {
  std::vector<double> whole = part;
  repeat(whole, symmetry.nCopies());
  return whole;
}

void checkBesidePlanes(const Deck& deck, const std::vector<SymmetryPlane>& planes, const MeshPoints& part,
                       const MeshPoints& searched, const std::vector<double>& spacing, const NeighborRule& rule) {
  for (std::size_t k = 0; k < planes.size(); ++k)
    PlaneCheck(part, searched, spacing, planes[k], 1 << k).report(rule.widest(), deck);
}

}  // namespace pd
