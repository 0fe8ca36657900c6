// Meshes from Exodus files and from a description in the deck: points, volumes, node sets, neighbourhoods, mistakes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <numeric>
#include <random>
#include <set>
#include <sstream>

#include "driver/discretization/discretization.hpp"
#include "driver/discretization/element_geometry.hpp"
#include "driver/discretization/mesh_reader.hpp"
#include "tests/support/exodus_file.hpp"
#include "tests/support/scene_files.hpp"

namespace {

using pd_test::cubes;
using pd_test::ExodusMesh;
using pd_test::SceneFiles;
using testing::ElementsAre;
using testing::HasSubstr;

const std::string exodusDeck =
    "Discretization:\n  Type: Exodus\n  Input Mesh File: mesh.g\n"
    "Blocks:\n  Body:\n    Block Names: default\n    Material: None\n    Horizon: 1.5\n";

pd::MeshPoints meshOf(const ExodusMesh& mesh, const std::string& deck = exodusDeck, int format = NC_64BIT_OFFSET) {
  const SceneFiles files("exodus");
  pd_test::writeExodus(files.path("mesh.g"), mesh, format);
  return pd::readMesh(pd::Deck::read(files.write("deck.yaml", deck)), pd::Communicator(MPI_COMM_SELF));
}

pd::Discretization discretize(const std::string& deck, const ExodusMesh& mesh = cubes(1, 1, 1)) {
  const SceneFiles files("exodus");
  pd_test::writeExodus(files.path("mesh.g"), mesh);
  files.write("points.txt", pd_test::latticeMesh(3, 3, 3));
  return pd::readDiscretization(pd::Deck::read(files.write("deck.yaml", deck)), pd::Communicator(MPI_COMM_SELF));
}

std::string complaints(const ExodusMesh& mesh, const std::string& deck = exodusDeck) {
  try {
    discretize(deck, mesh);
  } catch (const pd::DeckError& error) {
    return error.what();
  }
  return "no error";
}

}  // namespace

// ---- elements ----

TEST(Elements, FrustumOfAPyramid) {
  // Squares of side 2 and 1, one above the other: V = (A + a + sqrt(A a)) / 3, its centroid at (A + 2 sqrt(A a) + 3 a)
  // / (4 (A + sqrt(A a) + a)) of the height.
  const double nodes[24] = {-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0, -.5, -.5, 1, .5, -.5, 1, .5, .5, 1, -.5, .5, 1};
  const pd::ElementGeometry element = pd::hexahedron(nodes);
  EXPECT_NEAR(element.volume, 7.0 / 3.0, 1e-14);
  EXPECT_NEAR(element.centroid[2], 11.0 / 28.0, 1e-14);
  EXPECT_NEAR(element.centroid[0], 0.0, 1e-14);
  EXPECT_FALSE(element.isInverted);
}

TEST(Elements, TetrahedronAndItsMirrorImage) {
  const double nodes[12] = {0, 0, 0, 1, 0, 0, 0, 2, 0, 0, 0, 3}, mirrored[12] = {0, 0, 0, 0, 2, 0, 1, 0, 0, 0, 0, 3};
  EXPECT_DOUBLE_EQ(pd::tetrahedron(nodes).volume, 1.0);
  EXPECT_THAT(pd::tetrahedron(nodes).centroid, ElementsAre(0.25, 0.5, 0.75));
  EXPECT_TRUE(pd::tetrahedron(mirrored).isInverted);
}

// ---- Exodus files ----

TEST(Exodus, HexahedraAreCellsInTheirOrder) {
  for (const int format : {NC_64BIT_OFFSET, NC_NETCDF4}) {
    const pd::MeshPoints points = meshOf(cubes(3, 2, 1), exodusDeck, format);
    ASSERT_EQ(points.size(), 6);
    for (int i = 0; i < 6; ++i) {
      EXPECT_NEAR(points.at(i)[0], i % 3 + 0.5, 1e-14);
      EXPECT_NEAR(points.at(i)[1], i / 3 + 0.5, 1e-14);
      EXPECT_NEAR(points.volume[i], 1.0, 1e-14);
      EXPECT_EQ(points.blockId[i], 1);
    }
    // The elements that have a node in the set.
    EXPECT_THAT(points.nodeSets.at("nodelist_7"), ElementsAre(0, 3));
    EXPECT_THAT(points.nodeSets.at("top"), ElementsAre(0, 1, 2, 3, 4, 5));
  }
}

TEST(Exodus, BlocksGoByTheirNames) {
  ExodusMesh mesh = cubes(4, 1, 1);
  const std::vector<int> all = mesh.blocks[0].nodes;
  mesh.blocks[0].nodes.resize(16);
  mesh.blocks.push_back({5, "Steel", "hex", 8, {all.begin() + 16, all.end()}, {}});
  const auto deck = [](const std::string& names) {
    return "Discretization:\n  Type: Exodus\n  Input Mesh File: mesh.g\n"
           "Blocks:\n  Body:\n    Block Names: " +
           names + "\n    Material: None\n    Horizon: 1.5\n";
  };
  const pd::Discretization d = discretize(deck("block_1 Steel"), mesh);
  EXPECT_THAT(d.blockNumbers, ElementsAre(1, 5));
  EXPECT_EQ(d.blockNames.at(5), "Steel");
  EXPECT_THAT(complaints(mesh, deck("block_1 block_5")), HasSubstr("has no block \"block_5\"; it has: block_1, Steel"));
}

TEST(Exodus, TheElementNumberMapNumbersThePoints) {
  ExodusMesh mesh = cubes(3, 1, 1);
  mesh.elementNumbers = {3, 1, 2};
  const pd::MeshPoints points = meshOf(mesh);
  EXPECT_NEAR(points.at(0)[0], 1.5, 1e-14);
  EXPECT_NEAR(points.at(2)[0], 0.5, 1e-14);
  EXPECT_THAT(points.nodeSets.at("nodelist_7"), ElementsAre(2));
  mesh.elementNumbers = {30, 10, 20};  // no numbering from 1 to 3
  EXPECT_NEAR(meshOf(mesh).at(0)[0], 0.5, 1e-14);
}

TEST(Exodus, SpheresAndTetrahedraOfTenNodes) {
  ExodusMesh mesh;
  mesh.nodes = {{1, 2, 3},   {0, 0, 0},  {1, 0, 0},  {0, 1, 0},   {0, 0, 1},  {.5, 0, 0},
                {.5, .5, 0}, {0, .5, 0}, {0, 0, .5}, {.5, 0, .5}, {0, .5, .5}};
  mesh.blocks = {{1, "", "SPHERE", 1, {1}, {0.5, 4.25}}, {2, "", "TETRA10", 10, {2, 3, 4, 5, 6, 7, 8, 9, 10, 11}, {}}};
  const pd::MeshPoints points = meshOf(mesh);
  ASSERT_EQ(points.size(), 2);
  EXPECT_EQ(points.volume[0], 4.25);  // the second attribute
  EXPECT_EQ(points.at(0)[2], 3.0);
  EXPECT_NEAR(points.volume[1], 1.0 / 6.0, 1e-15);
  EXPECT_NEAR(points.at(1)[0], 0.25, 1e-15);
}

TEST(Exodus, OtherElementsNameThePdmeshCommand) {
  ExodusMesh mesh = cubes(1, 1, 1);
  mesh.blocks = {{1, "", "QUAD4", 4, {1, 2, 4, 3}, {}}};
  const std::string text = complaints(mesh);
  EXPECT_THAT(text, HasSubstr("block_1 has elements of 4 nodes of type \"QUAD4\""));
  EXPECT_THAT(text, HasSubstr("meshes/pdmesh convert"));
  EXPECT_THAT(text, HasSubstr("mesh.txt"));
}

TEST(Exodus, InvertedElementsAreNamed) {
  ExodusMesh mesh = cubes(3, 1, 1);
  std::vector<int>& nodes = mesh.blocks[0].nodes;
  std::swap_ranges(nodes.begin() + 8, nodes.begin() + 12, nodes.begin() + 12);  // the second one upside down
  EXPECT_THAT(complaints(mesh), HasSubstr("mesh.g: element 2: the element is inverted"));
}

TEST(Exodus, AFileOfAnotherKindSaysSo) {
  const SceneFiles files("exodus");
  files.write("mesh.g", "0 0 0 1 1.0\n");
  const pd::Deck deck = pd::Deck::read(files.write("deck.yaml", exodusDeck));
  try {
    pd::readDiscretization(deck, pd::Communicator(MPI_COMM_SELF));
    FAIL() << "a text file was read as Exodus";
  } catch (const pd::DeckError& error) {
    EXPECT_THAT(error.what(),
                HasSubstr("deck.yaml:3:20: the mesh \"scene_exodus/mesh.g\": it cannot be read as NetCDF"));
  }
}

TEST(Exodus, PiecesAreNotTheWhole) {
  const auto failureOf = [](const SceneFiles& files, const std::string& name) -> std::string {
    std::string deck = exodusDeck;
    deck.replace(deck.find("mesh.g"), 6, name);
    try {
      pd::readDiscretization(pd::Deck::read(files.write("deck.yaml", deck)), pd::Communicator(MPI_COMM_SELF));
    } catch (const pd::DeckError& error) {
      return error.what();
    }
    return "no error";
  };
  const SceneFiles files("exodus");
  pd_test::writeExodus(files.path("mesh.g.2.0"), cubes(1, 1, 1));
  pd_test::writeExodus(files.path("mesh.g.1.0"), cubes(2, 1, 1));
  EXPECT_THAT(failureOf(files, "mesh.g"), HasSubstr("it is not there, but pieces of it are, as mesh.g."));
  EXPECT_THAT(failureOf(files, "mesh.g.2.0"),
              HasSubstr("it is one of 2 pieces of a mesh; pdrun reads the whole mesh from one file"));
  EXPECT_THAT(failureOf(files, "other.g"), HasSubstr("it cannot be read as NetCDF"));
  EXPECT_EQ(failureOf(files, "mesh.g.1.0"), "no error");
  // Whatever a piece is called, Nemesis' dimensions in it tell.
  for (const char* dimension : {"num_processors", "num_elems_global"}) {
    pd_test::writeExodus(files.path("piece.g"), cubes(2, 1, 1));
    int file = 0, id = 0;
    ASSERT_EQ(nc_open(files.path("piece.g").c_str(), NC_WRITE, &file), NC_NOERR);
    ASSERT_EQ(nc_redef(file), NC_NOERR);
    ASSERT_EQ(nc_def_dim(file, dimension, 4, &id), NC_NOERR);
    ASSERT_EQ(nc_close(file), NC_NOERR);
    EXPECT_THAT(failureOf(files, "piece.g"), HasSubstr("a piece of a mesh that was cut for several processes"));
  }
}

TEST(Exodus, NodeSetsOfTheMeshServeConditions) {
  const std::string conditions = "Boundary Conditions:\n  Hold:\n    Type: Prescribed Displacement\n    Node Set: ";
  const pd::Discretization d = discretize(exodusDeck + conditions + "nodelist_7\n", cubes(3, 2, 1));
  EXPECT_EQ(d.nodeSets.at("nodelist_7").size(), 2u);
  EXPECT_THAT(complaints(cubes(3, 2, 1), exodusDeck + conditions + "nodelist_1\n"),
              HasSubstr("neither Boundary Conditions nor the mesh has a node set \"nodelist_1\" (did you mean "
                        "\"nodelist_7\"?); there are: \"nodelist_7\", \"top\""));
  EXPECT_THAT(complaints(cubes(3, 2, 1), exodusDeck + conditions + "top\n  Top Node Set: 1 2\n"), "no error");
}

TEST(Exodus, NodeSetsThatAreNotSound) {
  ExodusMesh twice = cubes(3, 2, 1);
  twice.nodeSets = {{1, "top", {1}}, {2, "top", {2}}};
  EXPECT_THAT(complaints(twice), HasSubstr("two node sets are called \"top\""));
  ExodusMesh outside = cubes(3, 2, 1);
  outside.nodeSets = {{1, "far", {1, 999}}};
  EXPECT_THAT(complaints(outside), HasSubstr("node set \"far\" has a node that is not there"));
}

// ---- files that are damaged ----

namespace {

const char* const surfaceDeck =
    "Discretization:\n  Type: Text File\n  Input Mesh File: points.txt\n"
    "  Bond Filters:\n    Cut: {Type: Exodus Mesh, File Name: mesh.g}\n"
    "Blocks:\n  Body:\n    Block Names: default\n    Material: None\n    Horizon: 1.5\n";

std::string bytesOf(const ExodusMesh& mesh, int format) {
  const SceneFiles files("exodus_whole");
  const std::string path = files.path("mesh.g");
  pd_test::writeExodus(path, mesh, format);
  std::stringstream content;
  content << std::ifstream(path, std::ios::binary).rdbuf();
  return content.str();
}

void putBigEndian(std::string& bytes, std::size_t at, std::uint32_t value) {
  for (std::size_t k = 0; k < 4; ++k) bytes[at + k] = static_cast<char>(value >> (24 - 8 * k));
}

std::string complaintsOfBytes(const std::string& bytes, const std::string& deck = exodusDeck) {
  const SceneFiles files("exodus_damaged");
  files.write("points.txt", pd_test::latticeMesh(3, 3, 3));
  std::ofstream(files.path("mesh.g"), std::ios::binary) << bytes;
  try {
    pd::readDiscretization(pd::Deck::read(files.write("deck.yaml", deck)), pd::Communicator(MPI_COMM_SELF));
  } catch (const pd::DeckError& error) {
    return error.what();
  }
  return "no error";
}

/// What is said of a file with the length of a dimension changed in its heading alone. In NetCDF's classic format the
/// length, 4 bytes, highest first, follows the name, which is filled up to a multiple of 4 bytes.
std::string complaintsWith(const std::string& dimension, std::uint32_t length, const ExodusMesh& mesh,
                           const std::string& deck) {
  std::string bytes = bytesOf(mesh, NC_64BIT_OFFSET);
  const std::size_t at = bytes.find(dimension);
  EXPECT_NE(at, std::string::npos) << dimension;
  putBigEndian(bytes, at + (dimension.size() + 3) / 4 * 4, length);
  return complaintsOfBytes(bytes, deck);
}
ExodusMesh cubesAndSphere() {
  ExodusMesh mesh = cubes(3, 1, 1);
  mesh.nodes.push_back({0.5, 2.5, 0.5});
  mesh.blocks.push_back({2, "", "SPHERE", 1, {static_cast<int>(mesh.nodes.size())}, {0.5, 1.0}});
  return mesh;
}

ExodusMesh shells() {
  ExodusMesh mesh;
  mesh.nodes = {{0.6, -1, -1}, {0.6, 4, -1}, {0.6, 4, 4}, {0.6, -1, 4}};
  mesh.blocks = {{1, "", "TRI3", 3, {1, 2, 3}, {}}, {2, "", "SHELL4", 4, {1, 2, 3, 4}, {}}};
  return mesh;
}

}  // namespace

TEST(DamagedExodus, SaysWhatDoesNotFit) {
  const auto meshWith = [](const std::string& dimension, std::uint32_t length) {
    return complaintsWith(dimension, length, cubesAndSphere(), exodusDeck);
  };
  EXPECT_THAT(meshWith("num_elem", 2), HasSubstr("its blocks have more elements than its \"num_elem\" says, 2"));
  EXPECT_THAT(meshWith("num_elem", 5), HasSubstr("its blocks do not hold all of its elements"));
  EXPECT_THAT(meshWith("num_elem", 2000000000), HasSubstr("it claims 2000000000 elements, more than a file of"));
  // Refused by NetCDF itself, or by what does not fit.
  EXPECT_THAT(meshWith("num_nodes", 2000000000), HasSubstr("mesh.g\": "));
  EXPECT_THAT(meshWith("num_el_blk", 1000000), HasSubstr("mesh.g\": "));
  EXPECT_THAT(meshWith("num_el_in_blk1", 1000000), HasSubstr("mesh.g\": "));
  EXPECT_THAT(meshWith("num_nod_per_el1", 4096), HasSubstr("mesh.g\": "));
  EXPECT_THAT(meshWith("num_att_in_blk2", 1), HasSubstr("need two attributes"));
  ExodusMesh same = cubesAndSphere();
  same.blocks[1].id = 1;
  EXPECT_THAT(complaints(same), HasSubstr("two of its blocks have the id 1"));
  ExodusMesh outside = cubesAndSphere();
  outside.blocks[0].nodes[3] = 99;
  EXPECT_THAT(complaints(outside), HasSubstr("an element of block_1 has the node 99, which is not there"));
}

/// Whatever a heading claims, the file is read or refused by name.
TEST(DamagedExodus, AnyDimensionMayBeWrong) {
  int nRefused = 0, nRead = 0;
  for (const auto& [mesh, deck] :
       {std::pair(cubesAndSphere(), exodusDeck), std::pair(shells(), std::string(surfaceDeck))})
    for (const char* dimension :
         {"len_name", "num_dim", "num_nodes", "num_elem", "num_el_blk", "num_el_in_blk1", "num_nod_per_el1",
          "num_el_in_blk2", "num_nod_per_el2", "num_att_in_blk2", "num_node_sets", "num_nod_ns1"}) {
      const std::string name = dimension;
      if (mesh.nodeSets.empty() &&
          (name == "num_att_in_blk2" || name.find("ns") != std::string::npos || name == "num_node_sets"))
        continue;
      for (const std::uint32_t length : {1u, 2u, 3u, 5u, 9u, 1000u, 1u << 20, 0x7ffffffeu, 0xfffffff0u}) {
        const std::string said = complaintsWith(name, length, mesh, deck);
        EXPECT_TRUE(said == "no error" || said.find("mesh.g") != std::string::npos)
            << name << " " << length << ": " << said;
        (said == "no error" ? nRead : nRefused) += 1;
      }
    }
  EXPECT_GT(nRefused, 100);
  EXPECT_GT(nRead, 10);  // lengths of names, and those that are right
}

/// By counts of the heading NetCDF takes memory before it looks for what is counted.
TEST(DamagedExodus, CountsOfTheHeadingAreThoseOfTheFile) {
  for (const int format : {0, NC_64BIT_OFFSET}) {
    const std::string whole = bytesOf(cubes(3, 2, 1), format);
    // Lists of dimensions and of variables begin with the tags 10 and 11 (NetCDF User's Guide, classic format); this
    // mesh has ten of each.
    for (const char tag : {'\n', '\v'}) {
      const std::size_t at = whole.find(std::string("\0\0\0", 3) + tag + std::string("\0\0\0\n", 4));
      ASSERT_NE(at, std::string::npos);
      for (const std::uint32_t count : {0x08000000u, 0x7fffffffu, 0xffffffffu}) {
        std::string bytes = whole;
        putBigEndian(bytes, at + 4, count);
        EXPECT_THAT(complaintsOfBytes(bytes),
                    HasSubstr(tag == '\n' ? " dimensions, more than its" : " variables, more than its"));
      }
    }
  }
}

TEST(DamagedExodus, NothingOfAFileMayBeMissing) {
  for (const int format : {0, NC_64BIT_OFFSET, NC_64BIT_DATA, NC_NETCDF4}) {
    const std::string whole = bytesOf(cubes(3, 2, 1), format);
    EXPECT_EQ(complaintsOfBytes(whole), "no error") << format;
    for (std::size_t size = 4; size + 8 < whole.size(); size += whole.size() / 37)
      EXPECT_THAT(complaintsOfBytes(whole.substr(0, size)), HasSubstr("mesh.g\": it")) << format << ", " << size;
  }
}

/// The library dies of some of these, or runs in circles.
TEST(DamagedExodus, AnyByteOfAFileOfHdf5MayBeWrong) {
  const std::string whole = bytesOf(cubes(2, 1, 1), NC_NETCDF4);
  std::mt19937 random(5);
  int nRefused = 0;
  for (int i = 0; i < 60; ++i) {
    std::string bytes = whole;
    for (int k = 0; k < 4; ++k) bytes[random() % bytes.size()] = static_cast<char>(random() % 2 == 0 ? 0xff : 0x80);
    const std::string said = complaintsOfBytes(bytes);
    EXPECT_TRUE(said == "no error" || said.find("mesh.g") != std::string::npos) << said;
    nRefused += said == "no error" ? 0 : 1;
  }
  EXPECT_GT(nRefused, 20);
}

TEST(DamagedExodus, NodesAreSomewhere) {
  for (const double place : {std::nan(""), HUGE_VAL, 1e200}) {
    ExodusMesh mesh = cubes(1, 1, 1), surface = shells();
    mesh.nodes[4][1] = surface.nodes[2][1] = place;
    EXPECT_THAT(complaints(mesh), HasSubstr("mesh.g\": node 5 lies at y = "));
    EXPECT_THAT(complaints(surface, surfaceDeck), HasSubstr("mesh.g\": node 3 lies at y = "));
  }
}

// ---- surfaces that cut bonds ----

namespace {

/// Two columns of four cubes along x, z in [0, 1]; bonds of length 1 alone.
pd::Discretization cutBy(const ExodusMesh& surface) {
  const SceneFiles files("exodus");
  pd_test::writeExodus(files.path("mesh.g"), cubes(4, 2, 1));
  pd_test::writeExodus(files.path("cut.g"), surface);
  const std::string deck =
      "Discretization:\n  Type: Exodus\n  Input Mesh File: mesh.g\n  Thickness: 1.0\n"
      "  Include Partial Neighbors: false\n"
      "  Bond Filters:\n    Crack: {Type: Exodus Mesh, File Name: cut.g, Count In Damage: true}\n"
      "Blocks:\n  Body:\n    Block Names: default\n    Material: None\n    Horizon: 1.1\n";
  return pd::readDiscretization(pd::Deck::read(files.write("deck.yaml", deck)), pd::Communicator(MPI_COMM_SELF));
}

/// Cut pairs of points as (smaller, larger) global ids.
std::set<std::pair<int, int>> cutPairs(const pd::Discretization& d) {
  std::set<std::pair<int, int>> pairs;
  std::size_t bond = 0;
  for (int i = 0; i < d.nOwned; ++i) {
    const int* entry = &d.neighborhoodList[d.neighborhoodStart[i]];
    for (int k = 1; k <= *entry; ++k)
      if (d.bondIsCut[bond++] != 0) pairs.insert(std::minmax(d.globalIds[i], d.globalIds[entry[k]]));
  }
  return pairs;
}

ExodusMesh shell(const std::vector<std::array<double, 3>>& nodes) {
  ExodusMesh mesh;
  mesh.nodes = nodes;
  std::vector<int> numbers(nodes.size());
  std::iota(numbers.begin(), numbers.end(), 1);
  mesh.blocks = {{1, "", nodes.size() == 3 ? "TRI3" : "SHELL4", static_cast<int>(nodes.size()), numbers, {}}};
  return mesh;
}

}  // namespace

TEST(SurfaceFilter, CutsTheBondsThatMeetIt) {
  using Pairs = std::set<std::pair<int, int>>;
  // Points 0 .. 3 at y = 0.5 and 4 .. 7 at y = 1.5, x = 0.5 .. 3.5, z = 0.5.
  EXPECT_EQ(cutPairs(cutBy(shell({{2, 0, 0}, {2, 2, 0}, {2, 2, 1}, {2, 0, 1}}))), (Pairs{{1, 2}, {5, 6}}));
  EXPECT_EQ(cutPairs(cutBy(shell({{2, 1, 0}, {2, 2, 0}, {2, 2, 1}, {2, 1, 1}}))), (Pairs{{5, 6}}));
  // Points on its diagonal, where its two triangles meet.
  EXPECT_EQ(cutPairs(cutBy(shell({{2, 0, 0}, {2, 1, 0}, {2, 1, 1}, {2, 0, 1}}))), (Pairs{{1, 2}}));
  // One triangle across the corner of the body; the bond from 2 to 3 passes beside it.
  EXPECT_EQ(cutPairs(cutBy(shell({{2.2, 2.5, 0.5}, {4, 0.7, -2}, {4, 0.7, 3}}))), (Pairs{{3, 7}, {6, 7}}));
  // A bond that ends on it is cut, one within it is not.
  EXPECT_EQ(cutPairs(cutBy(shell({{0, 1.5, 0}, {2, 1.5, 0}, {2, 1.5, 1}, {0, 1.5, 1}}))), (Pairs{{0, 4}, {1, 5}}));
}

TEST(SurfaceFilter, OtherElementsAreRefused) {
  try {
    cutBy(cubes(1, 1, 1));
    FAIL() << "took a cube for a surface";
  } catch (const pd::DeckError& error) {
    EXPECT_THAT(error.what(), HasSubstr("cut.g\": it has elements of 8 nodes"));
  }
}
