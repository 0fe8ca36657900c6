// Voids in files: what is read, and mistakes with file and line.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cctype>
#include <cstring>
#include <numeric>

#include "driver/discretization/discretization.hpp"
#include "driver/discretization/stl_file.hpp"
#include "tests/support/scene_files.hpp"

namespace {

using pd_test::deckText;
using pd_test::latticeMesh;
using pd_test::SceneFiles;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

std::string voids(const std::string& entry) { return "  Voids:\n    Pore: {" + entry + "}\n"; }

struct Reading {
  std::string complaints, warnings;
  double volume = 0.0;
};

/// A lattice of unit cells, 6 each way, with one entry of Voids that reads `text`.
Reading readWith(const std::string& entry, const std::string& text, bool isPlane = false,
                 const std::string& more = "") {
  const SceneFiles files("void_files");
  files.write("mesh.txt", latticeMesh(6, 6, isPlane ? 1 : 6));
  files.write("pores", text);
  const pd::Deck deck =
      pd::Deck::read(files.write("deck.yaml", deckText("1.6", voids(entry + ", File Name: pores") + more)));
  Reading result;
  try {
    const pd::Discretization d = pd::readDiscretization(deck, pd::Communicator(MPI_COMM_SELF));
    deck.mistakes().report();
    result.volume = std::accumulate(d.volume.begin(), d.volume.end(), 0.0);
  } catch (const pd::DeckError& error) {
    result.complaints = error.what();
  }
  for (const std::string& line : deck.warnings().lines()) result.warnings += line + "\n";
  return result;
}

std::string facet(const std::array<std::array<double, 3>, 3>& corners) {
  std::string text = "facet normal 0 0 0\n outer loop\n";
  for (const auto& c : corners) text += fmt::format("  vertex {} {} {}\n", c[0], c[1], c[2]);
  return text + " endloop\nendfacet\n";
}

using Triangles = std::vector<std::array<std::array<double, 3>, 3>>;

/// With its corner at `low`; edges 1.
Triangles tetrahedron(const std::array<double, 3>& low) {
  const std::array<double, 3> o = low, x{low[0] + 1, low[1], low[2]}, y{low[0], low[1] + 1, low[2]},
                              z{low[0], low[1], low[2] + 1};
  return {{o, y, x}, {o, x, z}, {o, z, y}, {x, y, z}};
}

std::string asText(const Triangles& triangles) {
  std::string text = "solid pore\n";
  for (const auto& t : triangles) text += facet(t);
  return text + "endsolid pore\n";
}

std::string asBinary(const Triangles& triangles) {
  std::string text(80, ' ');
  text.replace(0, 5, "solid");  // as some programs begin binary files
  const auto add = [&](const auto& value) { text.append(reinterpret_cast<const char*>(&value), sizeof value); };
  add(static_cast<std::uint32_t>(triangles.size()));
  for (const auto& t : triangles) {
    for (int k = 0; k < 3; ++k) add(0.0F);
    for (const auto& c : t)
      for (const double value : c) add(static_cast<float>(value));
    add(std::uint16_t{0});
  }
  return text;
}

constexpr const char* surface = "Type: Surface";

}  // namespace

TEST(VoidFiles, SpheresTakeTheirVolume) {
  const Reading read = readWith("Type: Sphere List", "# x y z radius\n1.2 2.1 3 0.3\n4 4 2.6 0.01 # small\n");
  EXPECT_EQ(read.complaints, "");
  EXPECT_NEAR(216.0 - read.volume, 4.0 / 3.0 * 3.14159265358979 * (0.027 + 1e-6), 5e-4);
}

TEST(VoidFiles, MistakesInListsOfSpheres) {
  const Reading read = readWith("Type: Sphere List", "1 2 3 0.3\n1 2 3\n1 2 x 0.3\n1 2 3 -0.1\n");
  EXPECT_THAT(read.complaints, AllOf(HasSubstr("pores:2: a line has 4 numbers, x y z radius; this one has 3"),
                                     HasSubstr("pores:3: \"x\" is not a finite number"),
                                     HasSubstr("pores:4: the radius (fourth column) must be greater than 0 m"),
                                     Not(HasSubstr("pores:1:"))));
  const std::string once =
      readWith("Type: Sphere List", "1 2 3\n", false, "  Bond Decomposition: {Rule: Adaptive}\n").complaints;
  EXPECT_THAT(once, AllOf(HasSubstr("this one has 3"), Not(HasSubstr("Bond Decomposition"))));
  EXPECT_THAT(readWith("Type: Sphere List", "# nothing\n").complaints, HasSubstr("has no spheres"));
  EXPECT_THAT(readWith("Type: Sphere List", "1 2 3 0.3\n", true).complaints, HasSubstr("is a form in space"));
}

TEST(VoidFiles, TooSmall) {
  EXPECT_THAT(readWith("Type: Sphere List", "1.2 2 3 0.3\n1 2 3 1e-200\n1 2 3 1e-7\n").complaints,
              AllOf(HasSubstr("pores:2: Discretization/Voids/Pore is too small"), HasSubstr("(and of 1 more)")));
  EXPECT_EQ(readWith("Type: Sphere List", "1.2 2 3 0.3\n1 2 3 1e-5\n").complaints, "");
}

TEST(VoidFiles, SomeOfManyMayLieOutside) {
  const Reading some = readWith("Type: Sphere List", "1 2 3 0.3\n90 2 3 0.3\n91 2 3 0.3\n");
  EXPECT_EQ(some.complaints, "");
  EXPECT_THAT(some.warnings, HasSubstr("2 of its 3 forms meet no cell and no bond of the body"));
  EXPECT_THAT(some.warnings, HasSubstr("pores:2"));
  EXPECT_THAT(readWith("Type: Sphere List", "90 2 3 0.3\n").complaints,
              HasSubstr("meets no cell and no bond of the body"));
}

/// As the deck that a run writes, with all defaults.
TEST(VoidFiles, DefaultsOfOtherRulesMayBeWrittenOut) {
  const std::string rule = "  Bond Decomposition: {Rule: Uniform, Partitions: 4, Tolerance: ";
  EXPECT_EQ(readWith("Type: Sphere List", "1.2 2 3 0.3\n", false, rule + "0.001}\n").complaints, "");
  EXPECT_THAT(readWith("Type: Sphere List", "1.2 2 3 0.3\n", false, rule + "0.01}\n").complaints,
              HasSubstr("Tolerance is of the rule Adaptive"));
}

TEST(VoidFiles, PolygonsTakeTheirArea) {
  const Reading read =
      readWith("Type: Polygon List", "1 1.1 1.2\n1 1.9 1.2\n1 1.1 1.8\n7 3 3\n7 4 3\n7 4 4\n7 3 4\n", true);
  EXPECT_EQ(read.complaints, "");
  EXPECT_NEAR(36.0 - read.volume, 0.24 + 1.0, 1e-3);
}

TEST(VoidFiles, MistakesInListsOfPolygons) {
  const std::string bow = "1 1 1\n1 2 2\n1 2 1\n1 1 2\n", two = "2 4 4\n2 4 5\n";
  EXPECT_THAT(readWith("Type: Polygon List", bow + two, true).complaints,
              AllOf(HasSubstr("pores:1: polygon 1 crosses or touches itself: its sides 1 and 3"),
                    HasSubstr("pores:5: polygon 2 has less than three corners")));
  EXPECT_THAT(readWith("Type: Polygon List", "1 1 1\n1 2 1\n1 2 2\n2 4 4\n2 5 4\n2 4 5\n1 1 2\n", true).complaints,
              HasSubstr("pores:7: polygon 1 goes on here, after another one"));
  EXPECT_THAT(readWith("Type: Polygon List", "1 1 1\n1 2 1\n1 2 2\n1 1 1\n", true).complaints,
              HasSubstr("closes by itself"));
  EXPECT_THAT(readWith("Type: Polygon List", "", true).complaints, HasSubstr("has no polygons"));
}

TEST(VoidFiles, SurfacesInTextAndBinary) {
  Triangles both = tetrahedron({1.2, 1.1, 1.3});
  for (const auto& t : tetrahedron({3.6, 3.3, 3.1})) both.push_back(t);
  for (const std::string& text : {asText(both), asBinary(both)}) {
    const Reading read = readWith(surface, text);
    EXPECT_EQ(read.complaints, "");
    EXPECT_NEAR(216.0 - read.volume, 2.0 / 6.0, 2e-3);
  }
  std::string capitals = asText(both);
  for (char& c : capitals) c = static_cast<char>(std::toupper(c));
  EXPECT_NEAR(216.0 - readWith(surface, capitals).volume, 2.0 / 6.0, 2e-3);
  EXPECT_THAT(
      readWith("Type: Surface, Scale: 1000, Shift: [-100, -100, -100]", asText(tetrahedron({0, 0, 0}))).complaints,
      HasSubstr("leave nothing of the body; of a Surface see its Scale"));
  const Reading moved = readWith("Type: Surface, Scale: 0.5, Shift: [2.0, 2.0, 2.0]", asText(tetrahedron({0, 0, 0})));
  EXPECT_EQ(moved.complaints, "");
  EXPECT_NEAR(216.0 - moved.volume, 0.125 / 6.0, 2e-4);
}

/// Each is a convex obstacle of its own: one screen.
TEST(VoidFiles, PartsThatTouchInAVertexAreTwoBodies) {
  Triangles both = tetrahedron({1, 1, 1});
  for (const auto& t : tetrahedron({2, 1, 1})) both.push_back(t);
  const auto parts = pd::readStl(asText(both), "pores", 1.0, {});
  ASSERT_EQ(parts.size(), 2u);
  for (const auto& part : parts) {
    EXPECT_EQ(part.triangles.size(), 4u);
    EXPECT_EQ(pd::decomposition::surfaceScreens(part).size(), 1u);
  }
}

TEST(VoidFiles, SurfacesMustBeClosedAndTheirOutsideOut) {
  Triangles open = tetrahedron({1, 1, 1});
  open.pop_back();
  EXPECT_THAT(
      readWith(surface, asText(open)).complaints,
      AllOf(HasSubstr("pores:2: the edge from (1, 2, 1) m to (2, 1, 1) m belongs to no other triangle in the opposite"),
            HasSubstr("pores:9:"), HasSubstr("pores:16:")));
  EXPECT_THAT(readWith(surface, asBinary(open)).complaints, HasSubstr("pores: triangle 1: the edge from"));
  Triangles turned = tetrahedron({1, 1, 1});
  std::swap(turned[3][0], turned[3][1]);
  EXPECT_THAT(readWith(surface, asText(turned)).complaints, HasSubstr("in the same direction"));
  Triangles inward = tetrahedron({1, 1, 1});
  for (auto& t : inward) std::swap(t[0], t[1]);
  EXPECT_THAT(readWith(surface, asText(inward)).complaints, HasSubstr("is turned inside out (volume -0.167 m3)"));
  Triangles flat = tetrahedron({1, 1, 1});
  flat.push_back({flat[0][0], flat[0][0], flat[0][1]});
  EXPECT_THAT(readWith(surface, asText(flat)).complaints, HasSubstr("pores:30: this triangle has no area"));
}

TEST(VoidFiles, SurfacesMustNotPassThroughThemselves) {
  // A prism whose apex has been pulled through its base: a bipyramid with both tips on one side, one beside the other.
  const std::array<double, 3> a{1, 1, 1}, b{4, 1, 1}, c{1, 4, 1}, high{1.5, 1.5, 3.5}, low{2.4, 2.4, 2.0};
  const Triangles crossing{{a, b, high}, {b, c, high}, {c, a, high}, {b, a, low}, {c, b, low}, {a, c, low}};
  EXPECT_THAT(readWith(surface, asText(crossing)).complaints, HasSubstr("passes through triangle"));
}

TEST(VoidFiles, WhatIsNoStl) {
  EXPECT_THAT(readWith(surface, "x y z\n").complaints, HasSubstr("is no STL file: it begins with no \"solid\""));
  EXPECT_THAT(readWith(surface, std::string(90, '\1')).complaints, HasSubstr("has 842150534 bytes, not 90"));
  EXPECT_THAT(readWith(surface, "solid a\nfacet normal 0 0 0\nouter loop\nvertex 0 0\n").complaints,
              HasSubstr("pores:4: a vertex has three finite numbers"));
  EXPECT_THAT(readWith(surface, "solid a\nfacet normal 0 0 0\nouter loop\nvertex 0 0 1\n").complaints,
              HasSubstr("the file ends within a triangle"));
  std::string longer = asBinary(tetrahedron({1, 1, 1}));
  longer[80] = 5;
  EXPECT_THAT(readWith(surface, longer).complaints,
              HasSubstr("pores: is a damaged STL file: a binary one of 5 triangles has 334 bytes, not 284"));
  EXPECT_THAT(readWith(surface, "solid a\nfoo\n").complaints, HasSubstr("pores:2: expected \"facet normal\""));
  EXPECT_THAT(readWith(surface, "solid a\nendsolid a\n").complaints, HasSubstr("has no triangles"));
}
