// Planes of symmetry: what they make of values, and that a part of a body has the neighbourhoods that it has in the
// whole.
#include "driver/discretization/symmetry.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "driver/discretization/discretization.hpp"
#include "tests/support/scene_files.hpp"

namespace {

using pd::Reflection;
using pd::Symmetry;
using pd_test::deckText;
using pd_test::SceneFiles;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using Vector = Symmetry::Vector;

// ---- values ----

constexpr double cosine = 0.6, sine = 0.8;

/// Three planes that are turned about z and do not meet in the origin.
Symmetry turned() {
  Symmetry symmetry;
  symmetry.addPlane({1.0, -2.0, 0.5}, {cosine, sine, 0.0});
  symmetry.addPlane({0.0, 3.0, 0.0}, {-sine, cosine, 0.0});
  symmetry.addPlane({0.0, 0.0, -1.5}, {0.0, 0.0, 1.0});
  return symmetry;
}

Vector mirrored(const Symmetry& symmetry, int copy, Reflection rule, const Vector& v) {
  Vector result{};
  symmetry.reflect(copy, rule, 3, v.data(), result.data());
  return result;
}

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

void expectNear(const Vector& a, const Vector& b) {
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(a[k], b[k], 1e-13);
}

const Vector a{0.3, -1.2, 2.5}, b{1.7, 0.4, -0.9};

}  // namespace

TEST(Symmetry, CopiesOfCopiesAreCopies) {
  const Symmetry symmetry = turned();
  ASSERT_EQ(symmetry.nCopies(), 8);
  for (int c = 0; c < 8; ++c)
    for (int d = 0; d < 8; ++d)
      expectNear(symmetry.place(d, symmetry.place(c, a.data()).data()), symmetry.place(c ^ d, a.data()));
  // Half way to its image a point lies on the plane.
  const Vector image = symmetry.place(1, a.data());
  EXPECT_NEAR(cosine * (0.5 * (a[0] + image[0]) - 1.0) + sine * (0.5 * (a[1] + image[1]) + 2.0), 0.0, 1e-14);
}

TEST(Symmetry, PlanesThroughTheOriginAreExact) {
  Symmetry symmetry;
  symmetry.addPlane({}, {0.0, -1.0, 0.0});
  EXPECT_TRUE(symmetry.isAlongAxes());
  EXPECT_FALSE(turned().isAlongAxes());
  EXPECT_EQ(symmetry.place(1, a.data()), (Vector{a[0], -a[1], a[2]}));
}

TEST(Symmetry, RulesOfReflectionFitEachOther) {
  const Symmetry symmetry = turned();
  for (int c = 0; c < 8; ++c) {
    // A vector is the difference of two places, an axial vector the cross product of two vectors.
    const Vector va = mirrored(symmetry, c, Reflection::Vector, a), vb = mirrored(symmetry, c, Reflection::Vector, b);
    const Vector pa = mirrored(symmetry, c, Reflection::Position, a);
    const Vector pb = mirrored(symmetry, c, Reflection::Position, {a[0] + b[0], a[1] + b[1], a[2] + b[2]});
    expectNear({pb[0] - pa[0], pb[1] - pa[1], pb[2] - pa[2]}, vb);
    expectNear(mirrored(symmetry, c, Reflection::AxialVector, cross(a, b)), cross(va, vb));
    // The volume that three vectors span is odd.
    const Vector d{-0.2, 0.8, 0.1}, vd = mirrored(symmetry, c, Reflection::Vector, d);
    const auto volume = [](const Vector& u, const Vector& v, const Vector& w) {
      const Vector n = cross(u, v);
      return n[0] * w[0] + n[1] * w[1] + n[2] * w[2];
    };
    const double before = volume(a, b, d);
    double after = 0.0;
    symmetry.reflect(c, Reflection::Odd, 1, &before, &after);
    EXPECT_NEAR(after, volume(va, vb, vd), 1e-13);
  }
}

// ---- neighbourhoods ----

namespace {

/// Points of a part with x and y > 0, nearly a lattice of unit spacing, cells of different volume and of two blocks.
std::vector<std::array<double, 5>> part(int nx, int ny) {
  std::vector<std::array<double, 5>> points;
  for (int j = 0; j < ny; ++j)
    for (int i = 0; i < nx; ++i)
      points.push_back({i + 0.5 + 0.11 * std::sin(5.0 * i + 3.0 * j), j + 0.5 + 0.13 * std::cos(4.0 * i + j), 0.0,
                        i < nx / 2 ? 1.0 : 2.0, 1.0 + 0.1 * std::sin(i + 2.0 * j)});
  return points;
}

std::string meshText(const std::vector<std::array<double, 5>>& points, bool isWhole) {
  std::string text;
  for (const int signX : {1, -1})
    for (const int signY : {1, -1})
      for (const auto& p : points)
        if (isWhole || (signX == 1 && signY == 1))
          text += fmt::format("{:.17g} {:.17g} 0 {} {:.17g}\n", signX * p[0], signY * p[1], p[3], p[4]);
  return text;
}

const std::string bothPlanes =
    "  Symmetry:\n    Left: {Point: [0.0, 7.0, 0.0], Normal: [1.0, 0.0, 0.0]}\n"
    "    Bottom: {Point: [0.0, 0.0, 0.0], Normal: [0.0, -3.0, 0.0]}\n";

/// One of two blocks.
std::string deckWith(const std::string& discretization, const std::string& conditions = "") {
  std::string deck = deckText("3.015", discretization, conditions);
  return deck.replace(deck.find("block_1"), 7, "block_1 block_2");
}

std::string deckFor(const std::string& discretization, const std::string& mesh) {
  std::string deck =
      deckWith(discretization, "  Some Node Set: 1 2 3 4 5 6 7 8 9 10\n  Others Node Set: 11 12 13 14 15 16\n");
  return deck.replace(deck.find("mesh.txt"), 8, mesh);
}

/// Places of the neighbours of each point of the part, in units of 1e-9, and whether a filter marks the bond.
std::vector<std::set<std::array<long long, 3>>> bondsOf(const pd::Discretization& d, int nPart) {
  std::vector<std::set<std::array<long long, 3>>> bonds(static_cast<std::size_t>(nPart));
  long long bond = 0;
  for (int i = 0; i < d.nOwned; ++i) {
    const int* entry = &d.neighborhoodList[static_cast<std::size_t>(d.neighborhoodStart[static_cast<std::size_t>(i)])];
    for (int k = 1; k <= *entry; ++k, ++bond) {
      const double* x = &d.x[3 * static_cast<std::size_t>(entry[k])];
      const long long isCut = d.bondIsCut.empty() ? 0 : d.bondIsCut[static_cast<std::size_t>(bond)];
      if (const int id = d.globalIds[static_cast<std::size_t>(i)]; id < nPart)
        bonds[static_cast<std::size_t>(id)].insert({std::llround(1e9 * x[0]), std::llround(1e9 * x[1]), isCut});
    }
  }
  return bonds;
}

std::string segment(const std::string& name, const Vector& corner, const Vector& normal, const Vector& bottom,
                    double length, bool counts) {
  std::string text = "    " + name + ":\n      Type: Rectangular_Plane\n      Side_Length: 2.0\n";
  text += fmt::format("      Bottom_Length: {}\n      Count In Damage: {}\n", length, counts);
  const char* const axes[] = {"X", "Y", "Z"};
  for (std::size_t k = 0; k < 3; ++k)
    text += fmt::format("      Normal_{0}: {1}\n      Lower_Left_Corner_{0}: {2}\n      Bottom_Unit_Vector_{0}: {3}\n",
                        axes[k], normal[k], corner[k], bottom[k]);
  return text;
}

struct Bodies {
  explicit Bodies(const std::string& partDiscretization, const std::string& wholeDiscretization = "") {
    const SceneFiles files("symmetry");
    const auto points = part(7, 6);
    n = static_cast<int>(points.size());
    files.write("part.txt", meshText(points, false));
    files.write("whole.txt", meshText(points, true));
    const pd::Communicator comm(MPI_COMM_SELF);
    half = pd::readDiscretization(
        pd::Deck::read(files.write("part.yaml", deckFor(bothPlanes + partDiscretization, "part.txt"))), comm);
    whole = pd::readDiscretization(pd::Deck::read(files.write("whole.yaml", deckFor(wholeDiscretization, "whole.txt"))),
                                   comm);
  }
  int n;
  pd::Discretization half, whole;
};

}  // namespace

TEST(SymmetryNeighborhoods, AreThoseOfTheWholeBody) {
  const Bodies bodies("");
  const pd::Discretization& d = bodies.half;
  EXPECT_EQ(bondsOf(d, bodies.n), bondsOf(bodies.whole, bodies.n));
  EXPECT_EQ(d.nGlobal, bodies.n);
  EXPECT_EQ(d.nOwned, bodies.n);
  EXPECT_EQ(d.firstImage(), bodies.n);
  EXPECT_GT(d.nPoints, bodies.n + 2 * 13);
  EXPECT_DOUBLE_EQ(d.shortestBond, bodies.whole.shortestBond);
  std::set<int> ids(d.globalIds.begin(), d.globalIds.end());
  EXPECT_EQ(ids.size(), d.globalIds.size());
  for (int i = d.firstImage(); i < d.nPoints; ++i) {
    const auto image = static_cast<std::size_t>(i), source = static_cast<std::size_t>(d.sourceOf(i));
    EXPECT_LT(d.sourceOf(i), bodies.n);
    EXPECT_EQ(d.globalIds[image], d.nGlobal * d.copyOf(i) + d.globalIds[source]);
    EXPECT_EQ(d.x[3 * image], (d.copyOf(i) & 1 ? -1.0 : 1.0) * d.x[3 * source]);
    EXPECT_EQ(d.x[3 * image + 1], (d.copyOf(i) & 2 ? -1.0 : 1.0) * d.x[3 * source + 1]);
    EXPECT_EQ(d.volume[image], d.volume[source]);
    EXPECT_EQ(d.horizon[image], d.horizon[source]);
    EXPECT_EQ(d.blockId[image], d.blockId[source]);
  }
  for (const auto& set : d.nodeSets)
    for (const int point : set.second) EXPECT_FALSE(d.isImage(point)) << set.first;
}

TEST(SymmetryNeighborhoods, FiltersCutAsTheyAndTheirImagesDoInTheWholeBody) {
  // A crack on the plane y = 0 up to x = 2.3, of which the part holds one half; a slanting one inside, and one across
  // the plane x = 0.
  const Vector up{0.0, 1.0, 0.0}, along{1.0, 0.0, 0.0};
  const auto slanting = [](double sx, double sy) {
    return std::pair(Vector{-0.8 * sx * sy, 0.6, 0.0}, Vector{0.6 * sx, 0.8 * sy, 0.0});
  };
  // The other side of a rectangle is bottom x normal: up from z = -1, or down from 1.
  const auto inside = [&](const std::string& name, double sx, double sy) {
    const auto [normal, bottom] = slanting(sx, sy);
    return segment(name, {2.0 * sx, 1.1 * sy, sx > 0.0 ? -1.0 : 1.0}, normal, bottom, 2.0, true);
  };
  const auto flat = [&](const std::string& name, double from, double to, double y, bool counts) {
    return segment(name, {from, y, -1.0}, up, along, to - from, counts);
  };
  const std::string filters = "  Bond Filters:\n";
  const Bodies bodies(
      filters + flat("A", 0.0, 2.3, 0.0, true) + inside("B", 1.0, 1.0) + flat("C", 0.0, 1.7, 3.1, false),
      filters + flat("A", -2.3, 2.3, 0.0, true) + inside("B", 1.0, 1.0) + inside("B2", -1.0, 1.0) +
          inside("B3", 1.0, -1.0) + inside("B4", -1.0, -1.0) + flat("C", -1.7, 1.7, 3.1, false) +
          flat("C2", -1.7, 1.7, -3.1, false));
  const auto found = bondsOf(bodies.half, bodies.n), expected = bondsOf(bodies.whole, bodies.n);
  EXPECT_EQ(found, expected);
  const Bodies uncut("");
  EXPECT_LT(bodies.half.nBonds(), uncut.half.nBonds() - 20);
  EXPECT_GT(std::count(bodies.half.bondIsCut.begin(), bodies.half.bondIsCut.end(), 1), 40);
}

TEST(SymmetryNeighborhoods, BondsToImagesAreCutAsWhatTheyMirror) {
  const std::string pair =
      "  Bond Filters:\n    Pair: {Type: Node Set Pair, First Node Set: Some Node Set, Second Node Set: Others Node "
      "Set}\n";
  const Bodies bodies(pair + "  Omit Bonds Between Blocks: All\n");
  const pd::Discretization& d = bodies.half;
  const auto isIn = [](int id, int low, int high) { return id >= low && id < high; };
  int nBonds = 0;
  for (int i = 0; i < d.nOwned; ++i) {
    const int* entry = &d.neighborhoodList[static_cast<std::size_t>(d.neighborhoodStart[static_cast<std::size_t>(i)])];
    for (int k = 1; k <= *entry; ++k) {
      const auto own = static_cast<std::size_t>(i), other = static_cast<std::size_t>(d.sourceOf(entry[k]));
      const int one = d.globalIds[own], two = d.globalIds[other];
      EXPECT_EQ(d.blockId[own], d.blockId[other]);
      EXPECT_FALSE((isIn(one, 0, 10) && isIn(two, 10, 16)) || (isIn(two, 0, 10) && isIn(one, 10, 16)));
      nBonds += d.isImage(entry[k]) ? 1 : 0;
    }
  }
  EXPECT_GT(nBonds, 100);
}

// ---- mistakes ----

namespace {

std::string complaints(const std::string& mesh, const std::string& symmetry, std::string* warnings = nullptr,
                       const std::string& horizon = "2.0") {
  const SceneFiles files("symmetry_mistakes");
  files.write("mesh.txt", mesh);
  const pd::Deck deck = pd::Deck::read(files.write("deck.yaml", deckText(horizon, "  Symmetry:\n" + symmetry)));
  std::string text = "no error";
  try {
    pd::readDiscretization(deck, pd::Communicator(MPI_COMM_SELF));
  } catch (const pd::DeckError& error) {
    text = error.what();
  }
  if (warnings != nullptr)
    for (const std::string& line : deck.warnings().lines()) *warnings += line + "\n";
  return text;
}

/// Points from (0, 0), one apart.
const std::string square = pd_test::latticeMesh(5, 4, 1), row = pd_test::latticeMesh(6, 1, 1);

}  // namespace

TEST(SymmetryMistakes, PlanesLieBesideThePoints) {
  EXPECT_EQ(complaints(square, "    Left: {Point: [-0.5, 0, 0], Normal: [1, 0, 0]}\n"), "no error");
  EXPECT_THAT(
      complaints(square, "    Left: {Point: [0, 0, 0], Normal: [1, 0, 0]}\n"),
      AllOf(HasSubstr("deck.yaml:5:5: Discretization/Symmetry/Left: 4 point(s) lie on the plane or nearer to it than "
                      "a quarter of a spacing, as the point "),
            HasSubstr("mesh.txt:2 at (0, 0, 0); points are centres of cells"), Not(HasSubstr("cuts through"))));
  EXPECT_THAT(complaints(square, "    Left: {Point: [-0.2, 0, 0], Normal: [1, 0, 0]}\n"),
              HasSubstr("4 point(s) lie on"));
  EXPECT_THAT(complaints(square, "    Top: {Point: [0, 2.5, 0], Normal: [0, -1, 0]}\n"),
              HasSubstr("Symmetry/Top: the plane cuts through the body: 5 of 20 points lie beyond it, as the point "));
  EXPECT_THAT(complaints(square, "    Far: {Point: [-1.3, 0, 0], Normal: [1, 0, 0]}\n"),
              HasSubstr("Symmetry/Far: no point is near enough to the plane"));
  std::string warnings;
  EXPECT_EQ(complaints(square, "    Gap: {Point: [-0.9, 0, 0], Normal: [1, 0, 0]}\n", &warnings), "no error");
  EXPECT_THAT(warnings, HasSubstr("Symmetry/Gap: the nearest point is 0.9 spacings from the plane"));
}

TEST(SymmetryMistakes, PlanesMakeAFiniteBody) {
  const std::string left = "    Left: {Point: [-0.5, 0, 0], Normal: [1, 0, 0]}\n";
  EXPECT_THAT(
      complaints(square, left + "    Right: {Point: [4.5, 0, 0], Normal: [1, 0, 0]}\n"),
      HasSubstr("deck.yaml:6:5: Discretization/Symmetry/Right is not perpendicular to Discretization/Symmetry/Left"));
  EXPECT_THAT(complaints(square, left + "    Slant: {Point: [-0.5, -0.5, 0], Normal: [1, 1, 0]}\n"),
              HasSubstr("Symmetry/Slant is not perpendicular to"));
  EXPECT_THAT(
      complaints(square, left + "    Back: {Point: [0, 0, -0.5], Normal: [0, 0, 1]}\n"),
      HasSubstr("Symmetry/Back: the points of the mesh lie in a plane of constant z: Normal must be [x, y, 0]"));
  EXPECT_THAT(complaints(row, "    Below: {Point: [0, -0.5, 0], Normal: [0, 1, 0]}\n"),
              HasSubstr("the points of the mesh lie on a line along x: Normal must be [1, 0, 0]"));
}

TEST(SymmetryMistakes, VectorsOfPlanes) {
  EXPECT_THAT(complaints(square, "    Left: {Point: [-0.5, 0], Normal: [0, 0, 0]}\n"),
              HasSubstr("Symmetry/Left/Point must be three numbers, [x, y, z]"));
  EXPECT_THAT(complaints(square, "    Left: {Point: [-0.5, 0, 0], Normal: [0, 0, 0]}\n"),
              HasSubstr("Symmetry/Left: the normal has no length"));
  EXPECT_THAT(complaints(square, "    Left: {Point: [-0.5, 0, 0]}\n"),
              HasSubstr("Symmetry/Left needs Normal: [x, y, z]"));
}
