// The discretization on one rank: neighbourhoods, order, bond filters and node sets of meshes that can be counted.
#include "driver/discretization/discretization.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "driver/discretization/node_sets.hpp"
#include "driver/discretization/ordering.hpp"
#include "tests/support/scene_files.hpp"

namespace {

using pd_test::deckText;
using pd_test::latticeMesh;
using pd_test::SceneFiles;
using testing::HasSubstr;

pd::Discretization discretize(const std::string& mesh, const std::string& deck) {
  const SceneFiles files("discretization");
  files.write("mesh.txt", mesh);
  return pd::readDiscretization(pd::Deck::read(files.write("deck.yaml", deck)), pd::Communicator(MPI_COMM_SELF));
}

std::vector<int> neighborsOf(const pd::Discretization& d, int i) {
  const int* entry = &d.neighborhoodList[d.neighborhoodStart[i]];
  return {entry + 1, entry + 1 + *entry};
}

/// Local id of the point with this number in the file.
int localId(const pd::Discretization& d, int globalId) {
  return static_cast<int>(std::find(d.globalIds.begin(), d.globalIds.end(), globalId) - d.globalIds.begin());
}

std::vector<int> globalNeighbors(const pd::Discretization& d, int globalId) {
  std::vector<int> ids;
  for (const int j : neighborsOf(d, localId(d, globalId))) ids.push_back(d.globalIds[j]);
  std::sort(ids.begin(), ids.end());
  return ids;
}

bool areNeighbors(const pd::Discretization& d, int globalA, int globalB) {
  const std::vector<int> ids = globalNeighbors(d, globalA);
  return std::binary_search(ids.begin(), ids.end(), globalB);
}

double distance(const pd::Discretization& d, int i, int j) {
  return std::hypot(d.x[3 * i] - d.x[3 * j], d.x[3 * i + 1] - d.x[3 * j + 1], d.x[3 * i + 2] - d.x[3 * j + 2]);
}

const std::string noPartial = "  Include Partial Neighbors: false\n";

/// Every list is sorted, free of the point itself and exactly what comparing all pairs gives.
void expectAllPairsWithin(const pd::Discretization& d, double reach) {
  for (int i = 0; i < d.nOwned; ++i) {
    std::vector<int> expected;
    for (int j = 0; j < d.nPoints; ++j)
      if (j != i && distance(d, i, j) < reach) expected.push_back(j);
    ASSERT_EQ(neighborsOf(d, i), expected) << "point " << d.globalIds[i];
  }
}

}  // namespace

// ---- neighbourhoods ----

TEST(Neighborhoods, SquareLatticeHas28NeighborsWithin3015Spacings) {
  const pd::Discretization d = discretize(latticeMesh(11, 9, 1), deckText("3.015", noPartial));
  EXPECT_EQ(d.dimension, 2);
  EXPECT_EQ(d.nOwned, 99);
  EXPECT_EQ(d.nPoints, 99);
  EXPECT_EQ(d.nGlobal, 99);
  EXPECT_EQ(d.shortestBond, 1.0);
  EXPECT_EQ(globalNeighbors(d, 4 * 11 + 5).size(), 28u);  // integer points of the disk of radius 3.015, less one
  expectAllPairsWithin(d, 3.015);
  EXPECT_EQ(d.nBonds() + d.nOwned, d.neighborhoodStart[d.nOwned]);
}

TEST(Neighborhoods, PartialNeighborsReachHalfASpacingFurther) {
  const pd::Discretization d = discretize(latticeMesh(11, 9, 1), deckText("3.015"));
  EXPECT_EQ(globalNeighbors(d, 4 * 11 + 5).size(), 36u);  // i^2 + j^2 < 3.515^2
  expectAllPairsWithin(d, 3.515);
}

TEST(Neighborhoods, CubicLatticeHas122NeighborsWithin3015Spacings) {
  const pd::Discretization d = discretize(latticeMesh(7, 8, 9), deckText("3.015", noPartial));
  EXPECT_EQ(d.dimension, 3);
  EXPECT_EQ(globalNeighbors(d, (4 * 8 + 4) * 7 + 3).size(), 122u);
  expectAllPairsWithin(d, 3.015);
}

TEST(Neighborhoods, PointsOnALineAreOneDimensional) {
  const pd::Discretization d = discretize(latticeMesh(20, 1, 1), deckText("2.2", noPartial));
  EXPECT_EQ(d.dimension, 1);
  EXPECT_THAT(globalNeighbors(d, 10), testing::ElementsAre(8, 9, 11, 12));
}

TEST(Neighborhoods, LatticePointsExactlyAtTheHorizonAreInWhateverTheUnit) {
  // 0.1 * 3 != 0.3 in floating point: rounding must not decide.
  std::string mesh;
  for (int j = 0; j < 9; ++j)
    for (int i = 0; i < 9; ++i) mesh += fmt::format("{} {} 0 1 0.01\n", 0.1 * i, 0.7 + 0.1 * j);
  const pd::Discretization d = discretize(mesh, deckText("0.3", noPartial));
  EXPECT_EQ(globalNeighbors(d, 4 * 9 + 4).size(), 28u);
  EXPECT_EQ(globalNeighbors(d, 3 * 9 + 5).size(), 28u);
}

/// Of a deck of Peridigm, of one block a horizon.
pd::Discretization discretizeAsPeridigm(const std::string& section, const std::vector<std::string>& horizons,
                                        const std::string& mesh = "") {
  std::string deck = "Peridigm:\n  Discretization:\n" + section + "  Blocks:\n";
  for (std::size_t b = 0; b < horizons.size(); ++b)
    deck +=
        fmt::format("    Block {0}: {{Block Names: block_{0}, Material: None, Horizon: {1}}}\n", b + 1, horizons[b]);
  const SceneFiles files("peridigm_discretization");
  files.write("mesh.txt", mesh);
  return pd::readDiscretization(pd::Deck::read(files.write("deck.yaml", deck)), pd::Communicator(MPI_COMM_SELF));
}

const std::string textFile = "    Type: Text File\n    Input Mesh File: mesh.txt\n";

TEST(Neighborhoods, ReachToTheHorizonAndNoFurtherInDecksOfPeridigm) {
  // A cross of points, in which arms of 1 + 2e-12 are beyond a horizon of 1 + 1e-12 and arms of 1 beyond 1 - 1e-12:
  // what Peridigm's own test of several horizons has in it.
  std::string mesh;
  for (const int block : {1, 2, 3})
    for (const char* offset : {"0 0", "1 0", "0 1", "-1.000000000002 0", "0 -1.000000000002"}) {
      double x = 0.0, y = 0.0;
      std::sscanf(offset, "%lf %lf", &x, &y);
      mesh += fmt::format("{:.17g} {:.17g} 0 {} 1.0\n", x, y + 10.0 * (block - 1), block);
    }
  const pd::Discretization d = discretizeAsPeridigm(textFile, {"1.0", "0.999999999999", "1.000000000001"}, mesh);
  EXPECT_THAT(globalNeighbors(d, 0), testing::ElementsAre(1, 2));  // exactly at the horizon: in
  EXPECT_THAT(globalNeighbors(d, 5), testing::IsEmpty());
  EXPECT_THAT(globalNeighbors(d, 10), testing::ElementsAre(11, 12));
}

TEST(Neighborhoods, OnTheHorizonRoundingDecidesInDecksOfPeridigm) {
  std::string mesh;
  std::vector<double> x;
  for (int i = 0; i < 8; ++i) {
    mesh += fmt::format("{:.17g} 0 0 1 0.1\n", 0.1 * i);
    x.push_back(std::stod(mesh.substr(mesh.rfind('\n', mesh.size() - 2) + 1)));  // rounded, as the mesh has it
  }
  const pd::Discretization d = discretizeAsPeridigm(textFile, {"0.3"}, mesh);
  for (int i = 0; i < 8; ++i)
    for (int j = 0; j < 8; ++j) {
      const double dx = x[j] - x[i];
      EXPECT_EQ(i != j && areNeighbors(d, i, j), i != j && dx * dx <= 0.3 * 0.3) << i << " " << j;
    }
  EXPECT_FALSE(areNeighbors(d, 0, 3));  // 0.1 * 3 > 0.3
}

TEST(Neighborhoods, PartialNeighborsThatADeckOfPeridigmAsksForKeepTheTolerance) {
  const pd::Discretization d =
      discretizeAsPeridigm(textFile + "    Include Partial Neighbors: true\n", {"3.0"}, latticeMesh(11, 1, 1));
  EXPECT_EQ(globalNeighbors(d, 5).size(), 6u);  // 3.5 spacings, where the ramp is at 0
}

TEST(Neighborhoods, JitteredMeshMatchesAllPairs) {
  const pd::Discretization plane = discretize(latticeMesh(23, 17, 1, 0.4), deckText("3.1", noPartial));
  expectAllPairsWithin(plane, 3.1);
  const pd::Discretization solid = discretize(latticeMesh(9, 8, 7, 0.4), deckText("2.3", noPartial));
  expectAllPairsWithin(solid, 2.3);
}

TEST(Neighborhoods, FarApartFragmentsAreFound) {
  const pd::Discretization d =
      discretize("0 0 0 1 1\n1 0 0 1 1\n1e6 1e6 1e6 1 1\n1000001 1e6 1e6 1 1\n", deckText("1.5", noPartial));
  EXPECT_THAT(globalNeighbors(d, 0), testing::ElementsAre(1));
  EXPECT_THAT(globalNeighbors(d, 3), testing::ElementsAre(2));
}

TEST(Neighborhoods, ThicknessScalesThePartialNeighborsOfAPlane) {
  std::string mesh;  // 1 mm spacing, 4 mm thick
  for (int j = 0; j < 11; ++j)
    for (int i = 0; i < 11; ++i) mesh += fmt::format("{} {} 0 1 4e-9\n", 1e-3 * i, 1e-3 * j);
  const pd::Discretization d = discretize(mesh, deckText("3.015e-3", "  Thickness: 0.004\n"));
  EXPECT_EQ(globalNeighbors(d, 60).size(), 36u);
}

TEST(Neighborhoods, HorizonMayBeAFunctionOfPlace) {
  const pd::Discretization d = discretize(latticeMesh(20, 1, 1), deckText("\"x < 9.5 ? 1.2 : 2.2\"", noPartial));
  EXPECT_EQ(d.horizon[localId(d, 3)], 1.2);
  EXPECT_EQ(d.horizon[localId(d, 15)], 2.2);
  EXPECT_THAT(globalNeighbors(d, 9), testing::ElementsAre(8, 10));          // its own horizon decides
  EXPECT_THAT(globalNeighbors(d, 10), testing::ElementsAre(8, 9, 11, 12));  // as in Peridigm
}

TEST(Neighborhoods, PeridigmsDecksKeepToTheHorizon) {
  std::string deck = "Peridigm:\n";
  std::string text = deckText("3.015");
  for (std::size_t begin = 0; begin < text.size(); begin = text.find('\n', begin) + 1)
    deck += "  " + text.substr(begin, text.find('\n', begin) + 1 - begin);
  const pd::Discretization d = discretize(latticeMesh(11, 9, 1), deck);
  EXPECT_EQ(globalNeighbors(d, 4 * 11 + 5).size(), 28u);
}

TEST(Neighborhoods, BlocksHaveTheirOwnHorizonAndNumbers) {
  std::string mesh;
  for (int i = 0; i < 10; ++i) mesh += fmt::format("{} 0 0 {} 1\n", i, i < 5 ? 3 : 12);
  const std::string deck =
      "Discretization:\n  Type: Text File\n  Input Mesh File: mesh.txt\n  Include Partial Neighbors: false\n"
      "Blocks:\n  Fine: {Block Names: block_12, Material: A, Horizon: 1.2}\n"
      "  Rest: {Block Names: default, Material: A, Horizon: 2.2}\n";
  const pd::Discretization d = discretize(mesh, deck);
  EXPECT_THAT(d.blockNumbers, testing::ElementsAre(3, 12));
  EXPECT_EQ(d.blockId[localId(d, 4)], 3);
  EXPECT_THAT(globalNeighbors(d, 2), testing::ElementsAre(0, 1, 3, 4));
  EXPECT_THAT(globalNeighbors(d, 7), testing::ElementsAre(6, 8));
}

// ---- order ----

TEST(Ordering, FollowsTheLinesOfAShuffledLattice) {
  // 12 along y (the longest extent), 5 along x, 3 along z: lines run along y, then step in z, then in x.
  std::vector<double> x;
  for (int n = 0; n < 180; ++n) {
    const int cell = n * 77 % 180;  // 77 and 180 have no common factor: every cell once
    x.insert(x.end(), {0.1 * (cell % 5), 0.1 * (cell / 5 % 12), 0.1 * (cell / 60)});
  }
  const std::vector<int> order = pd::lineOrder(x, 0.1, x);
  for (int n = 0; n < 180; ++n) {
    const double* at = &x[3 * order[n]];
    EXPECT_DOUBLE_EQ(at[1], 0.1 * (n % 12));
    EXPECT_DOUBLE_EQ(at[2], 0.1 * (n / 12 % 3));
    EXPECT_DOUBLE_EQ(at[0], 0.1 * (n / 36));
  }
}

TEST(Ordering, ToleratesASpacingThatIsSomewhatOff) {
  std::vector<double> x;
  for (int n = 0; n < 100; ++n) x.insert(x.end(), {1.0 * (n % 20), 1.0 * (n / 20), 0.0});
  const std::vector<int> exact = pd::lineOrder(x, 1.0, x);
  EXPECT_EQ(pd::lineOrder(x, 0.01, x), exact);
  EXPECT_EQ(pd::lineOrder(x, 1.3, x), exact);
}

TEST(Ordering, FollowsTheLongestSideOfTheBodyWhereAMapStretchesAnother) {
  // 6 along x, spaced by 25, and 10 along y, spaced by 1: under the map that makes cells square, y is the longer side.
  std::vector<double> body, mapped;
  for (int n = 0; n < 60; ++n) {
    body.insert(body.end(), {25.0 * (n % 6), 1.0 * (n / 6), 0.0});
    mapped.insert(mapped.end(), {25.0 * (n % 6), 25.0 * (n / 6), 0.0});
  }
  const std::vector<int> order = pd::lineOrder(mapped, 25.0, body);
  for (int n = 0; n < 60; ++n) EXPECT_EQ(order[n], n);
}

TEST(Ordering, IsAPermutationOfAnyMesh) {
  std::vector<double> x;
  for (int n = 0; n < 500; ++n) x.insert(x.end(), {std::sin(7.0 * n), std::cos(11.0 * n), std::sin(3.0 * n * n)});
  std::vector<int> order = pd::lineOrder(x, 0.1, x);
  std::sort(order.begin(), order.end());
  for (int n = 0; n < 500; ++n) EXPECT_EQ(order[n], n);
}

TEST(Ordering, NumbersPointsOfALineInARow) {
  const pd::Discretization d = discretize(latticeMesh(11, 9, 1), deckText("3.015", noPartial));
  for (int i = 0; i < d.nOwned; ++i) EXPECT_EQ(d.globalIds[i], i);  // the file is in line order along x already
  const pd::Discretization tall = discretize(latticeMesh(3, 9, 1), deckText("3.015", noPartial));
  EXPECT_EQ(tall.globalIds[0], 0);
  EXPECT_EQ(tall.globalIds[1], 3);  // now lines run along y
}

// ---- bond filters ----

namespace {

std::string plane(double cornerX, double cornerY, double bottomLength, const std::string& more = "") {
  return fmt::format(
      "  Include Partial Neighbors: false\n  Bond Filters:\n    Crack:\n      Type: Rectangular_Plane\n"
      "      Normal_X: 0.0\n      Normal_Y: 1.0\n      Normal_Z: 0.0\n"
      "      Lower_Left_Corner_X: {}\n      Lower_Left_Corner_Y: {}\n      Lower_Left_Corner_Z: -1.0\n"
      "      Bottom_Unit_Vector_X: 1.0\n      Bottom_Unit_Vector_Y: 0.0\n      Bottom_Unit_Vector_Z: 0.0\n"
      "      Bottom_Length: {}\n      Side_Length: 2.0\n{}",
      cornerX, cornerY, bottomLength, more);
}

/// Whether the bond meets the segment y = height, from <= x <= to.
bool crosses(const pd::Discretization& d, int i, int j, double height, double from, double to) {
  const double a = d.x[3 * i + 1] - height, b = d.x[3 * j + 1] - height;
  if (a * b > 0.0) return false;
  const double x = d.x[3 * i] + (d.x[3 * j] - d.x[3 * i]) * a / (a - b);
  return x >= from && x <= to;
}

}  // namespace

TEST(BondFilters, RectangleRemovesTheBondsThatMeetIt) {
  const pd::Discretization d = discretize(latticeMesh(15, 10, 1), deckText("3.015", plane(-0.5, 4.45, 7.3)));
  int nCut = 0;
  for (int i = 0; i < d.nOwned; ++i)
    for (int j = 0; j < d.nOwned; ++j) {
      if (i == j || distance(d, i, j) > 3.015) continue;
      const bool isCut = crosses(d, i, j, 4.45, -0.5, 6.8);
      nCut += isCut ? 1 : 0;
      EXPECT_EQ(areNeighbors(d, d.globalIds[i], d.globalIds[j]), !isCut) << d.globalIds[i] << " " << d.globalIds[j];
    }
  EXPECT_GT(nCut, 100);
  EXPECT_TRUE(d.bondIsCut.empty());
}

TEST(BondFilters, CountInDamageKeepsCutBondsAndMarksThem) {
  const pd::Discretization d =
      discretize(latticeMesh(15, 10, 1), deckText("3.015", plane(-0.5, 4.45, 7.3, "      Count In Damage: true\n")));
  expectAllPairsWithin(d, 3.015);
  ASSERT_EQ(static_cast<long long>(d.bondIsCut.size()), d.nBonds());
  std::size_t bond = 0;
  for (int i = 0; i < d.nOwned; ++i)
    for (const int j : neighborsOf(d, i)) EXPECT_EQ(d.bondIsCut[bond++] != 0, crosses(d, i, j, 4.45, -0.5, 6.8));
}

TEST(BondFilters, APointOnThePlaneLosesBothSidesButNotItsLine) {
  const pd::Discretization d = discretize(latticeMesh(9, 9, 1), deckText("1.2", plane(-1.0, 4.0, 20.0)));
  EXPECT_THAT(globalNeighbors(d, 4 * 9 + 4), testing::ElementsAre(4 * 9 + 3, 4 * 9 + 5));
  EXPECT_THAT(globalNeighbors(d, 5 * 9 + 4), testing::ElementsAre(5 * 9 + 3, 5 * 9 + 5, 6 * 9 + 4));
}

TEST(BondFilters, RectangleBetweenLatticeLinesEndsInXWhereItShould) {
  const pd::Discretization d = discretize(latticeMesh(9, 9, 1), deckText("1.2", plane(0.0, 3.5, 4.0)));
  for (int i = 0; i < 9; ++i) EXPECT_EQ(areNeighbors(d, 3 * 9 + i, 4 * 9 + i), i > 4);  // border included
}

TEST(BondFilters, DiskCutsWithinItsRadius) {
  const std::string disk =
      "  Include Partial Neighbors: false\n  Bond Filters:\n    Penny: {Type: Disk, Center_X: 3.0, Center_Y: 3.0, "
      "Center_Z: 2.5, Normal_X: 0.0, Normal_Y: 0.0, Normal_Z: 2.0, Radius: 2.0}\n";
  const pd::Discretization d = discretize(latticeMesh(7, 7, 6), deckText("1.2", disk));
  for (int j = 0; j < 7; ++j)
    for (int i = 0; i < 7; ++i) {
      const bool isCut = (i - 3) * (i - 3) + (j - 3) * (j - 3) <= 4;
      EXPECT_EQ(areNeighbors(d, (2 * 7 + j) * 7 + i, (3 * 7 + j) * 7 + i), !isCut) << i << " " << j;
      EXPECT_TRUE(areNeighbors(d, (1 * 7 + j) * 7 + i, (2 * 7 + j) * 7 + i));
    }
}

TEST(BondFilters, NodeSetPairCutsBetweenTheTwoSetsOnly) {
  const std::string pair =
      "  Include Partial Neighbors: false\n  Bond Filters:\n    Lips: {Type: Node Set Pair, First Node Set: upper node "
      "set, Second Node Set: Lower Node Set}\n";
  const std::string sets = "  Upper Node Set: \"7 8\"\n  Lower Node Set: [2, 3]\n";
  const pd::Discretization d = discretize(latticeMesh(5, 3, 1), deckText("1.5", pair, sets));
  EXPECT_THAT(globalNeighbors(d, 6), testing::ElementsAre(0, 5, 7, 10, 11, 12));  // not 1 and 2
  EXPECT_THAT(globalNeighbors(d, 1), testing::ElementsAre(0, 2, 5));              // not 6 and 7
}

TEST(BondFilters, BondsBetweenBlocksCanBeOmitted) {
  std::string mesh;
  for (int i = 0; i < 10; ++i) mesh += fmt::format("{} 0 0 {} 1\n", i, i < 5 ? 1 : 2);
  std::string deck = deckText("2.2", noPartial + "  Omit Bonds Between Blocks: All\n");
  deck.replace(deck.find("block_1"), 7, "block_1 block_2");
  const pd::Discretization d = discretize(mesh, deck);
  EXPECT_THAT(globalNeighbors(d, 4), testing::ElementsAre(2, 3));
  EXPECT_THAT(globalNeighbors(d, 5), testing::ElementsAre(6, 7));
}

TEST(BondFilters, OneThatCutsNothingIsWarnedOf) {
  const SceneFiles files("idle_filter");
  files.write("mesh.txt", latticeMesh(9, 9, 1));
  // Above the body; and one whose bonds another one has removed already, which is not idle.
  const std::string disk =
      "    Again: {Type: Disk, Center_X: 1.0, Center_Y: 3.5, Center_Z: 0.0, Normal_X: 0.0, Normal_Y: 1.0, Normal_Z: "
      "0.0, "
      "Radius: 0.6}\n    Beside: {Type: Disk, Center_X: 1.0, Center_Y: 9.5, Center_Z: 0.0, Normal_X: 0.0, "
      "Normal_Y: 1.0, Normal_Z: 0.0, Radius: 3.0}\n";
  const pd::Deck deck = pd::Deck::read(files.write("deck.yaml", deckText("1.5", plane(0.0, 3.5, 4.0) + disk)));
  pd::readDiscretization(deck, pd::Communicator(MPI_COMM_SELF));
  ASSERT_EQ(deck.warnings().lines().size(), 1u);
  EXPECT_THAT(deck.warnings().lines()[0],
              testing::MatchesRegex(".*deck.yaml:[0-9]+:5: Discretization/Bond Filters/Beside cuts no bond.*"));
}

// ---- node sets ----

TEST(NodeSets, OfEveryForm) {
  const SceneFiles files("node_sets");
  files.write("mesh.txt", latticeMesh(5, 4, 1));
  files.write("left.txt", "# left edge\n1 6\n\n* and\n11\n16 # last\n");
  files.write("deck.yaml", deckText("1.5", "",
                                    "  Left Node Set: left.txt\n"
                                    "  Few Node Set: \"3 1 3\"\n"
                                    "  one_node_set: 20\n"
                                    "  List Node Set: [2, 4]\n"
                                    "  Box Node Set: {Box: [[1, 1, -1], [2.0, 2.0, 1]]}\n"
                                    "  Top Node Set: {Expression: \"y > 2.5 && x < 1.5\"}\n"
                                    "  Pull Node Set Left: {Type: Body Force, Node Set: Left Node Set, Value: 1}\n"));
  const pd::Deck deck = pd::Deck::read(files.path("deck.yaml"));
  const pd::Discretization d = pd::readDiscretization(deck, pd::Communicator(MPI_COMM_SELF));
  const auto global = [&](const std::string& name) {
    const std::vector<int>* local = pd::findNodeSet(d.nodeSets, name);
    std::vector<int> ids;
    if (local != nullptr)
      for (const int i : *local) ids.push_back(d.globalIds[i]);
    std::sort(ids.begin(), ids.end());
    return ids;
  };
  EXPECT_THAT(global("Left Node Set"), testing::ElementsAre(0, 5, 10, 15));
  EXPECT_THAT(global("FEW_node set"), testing::ElementsAre(0, 2));  // Peridigm's comparison of names
  EXPECT_THAT(global("One Node Set"), testing::ElementsAre(19));
  EXPECT_THAT(global("List Node Set"), testing::ElementsAre(1, 3));
  EXPECT_THAT(global("Box Node Set"), testing::ElementsAre(6, 7, 11, 12));
  EXPECT_THAT(global("Top Node Set"), testing::ElementsAre(15, 16));
  EXPECT_EQ(d.nodeSets.count("one_node_set"), 1u);  // under the name in the deck
  EXPECT_EQ(d.nodeSets.size(), 6u);                 // the boundary condition is none
}
