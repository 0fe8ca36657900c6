// Grids that the deck describes: points, volumes, neighbourhoods.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <sstream>

#include "driver/discretization/discretization.hpp"
#include "tests/support/scene_files.hpp"

namespace {

using testing::HasSubstr;

pd::Discretization discretize(const std::string& deck) {
  const pd_test::SceneFiles files("quick_grid");
  return pd::readDiscretization(pd::Deck::read(files.write("deck.yaml", deck)), pd::Communicator(MPI_COMM_SELF));
}

std::string complaints(const std::string& deck) {
  try {
    discretize(deck);
  } catch (const pd::DeckError& error) {
    return error.what();
  }
  return "no error";
}

std::string gridDeck(const std::string& generator, double horizon, const std::string& root = "") {
  const std::string pad = root.empty() ? "" : "  ";
  std::string deck =
      "Discretization:\n  Type: PdQuickGrid\n" + generator +
      "Blocks:\n  Body:\n    Block Names: block_1\n    Material: None\n    Horizon: " + std::to_string(horizon) + "\n";
  if (root.empty()) return deck;
  for (std::size_t at = 0; (at = deck.find('\n', at)) + 1 < deck.size(); at += 3) deck.replace(at, 1, "\n  ");
  return root + ":\n  " + deck;
}

std::string boxOf(int nx, int ny, int nz, const std::string& lengths = "3.0 2.0 4.0") {
  std::istringstream stream(lengths);
  std::string x, y, z;
  stream >> x >> y >> z;
  return "  TensorProduct3DMeshGenerator:\n    X Origin: 1.0\n    Y Origin: -1.0\n    Z Origin: 0.0\n    X Length: " +
         x + "\n    Y Length: " + y + "\n    Z Length: " + z + "\n    Number Points X: " + std::to_string(nx) +
         "\n    Number Points Y: " + std::to_string(ny) + "\n    Number Points Z: " + std::to_string(nz) + "\n";
}

int nNeighbors(const pd::Discretization& d, int globalId) {
  const auto local = std::find(d.globalIds.begin(), d.globalIds.end(), globalId) - d.globalIds.begin();
  return d.neighborhoodList[d.neighborhoodStart[static_cast<std::size_t>(local)]];
}

}  // namespace

TEST(QuickGrid, PointsAreCellCentresXFastest) {
  const pd::Discretization d = discretize(gridDeck(boxOf(3, 2, 4), 1.1));
  ASSERT_EQ(d.nOwned, 24);
  for (int i = 0; i < d.nOwned; ++i) {
    const int id = d.globalIds[i];
    EXPECT_NEAR(d.x[3 * i], 1.5 + id % 3, 1e-14);
    EXPECT_NEAR(d.x[3 * i + 1], -0.5 + id / 3 % 2, 1e-14);
    EXPECT_NEAR(d.x[3 * i + 2], 0.5 + id / 6, 1e-14);
    EXPECT_NEAR(d.volume[i], 1.0, 1e-14);
  }
}

TEST(QuickGrid, PeridigmsNeighborhoodsAreBoxesOfCells) {
  // Its rule without a NeighborhoodType: round(1.6) = 2 cells along each axis.
  const auto cells = [](double horizon, const std::string& type, const std::string& root) {
    return nNeighbors(discretize(gridDeck(type + boxOf(5, 5, 5, "5.0 5.0 5.0"), horizon, root)), 62);
  };
  EXPECT_EQ(cells(1.6, "", "Peridigm"), 124);  // 5^3 - 1
  EXPECT_EQ(cells(1.4, "", "Peridigm"), 26);   // 3^3 - 1
  EXPECT_EQ(cells(1.6, "  NeighborhoodType: Spherical\n", "Peridigm"), 18);
  EXPECT_EQ(cells(1.6, "  NeighborhoodType: Box\n", ""), 124);
  EXPECT_EQ(cells(1.6, "  Include Partial Neighbors: false\n", ""), 18);
  // At the horizon to the last bit: out in its grids, in here.
  EXPECT_EQ(cells(2.0, "  NeighborhoodType: Spherical\n", "Peridigm"), 26);
  EXPECT_EQ(cells(2.0, "  Include Partial Neighbors: false\n", ""), 32);
}

TEST(QuickGrid, ABondCanBeLongerThanTheHorizon) {
  // As in Peridigm's test BondBreakingInitialVelocity: 0.51 is half a cell along y, and less along x.
  const pd::Discretization d = discretize(gridDeck(boxOf(2, 2, 1, "2.1 2.0 1.0"), 0.51, "Peridigm"));
  for (int id = 0; id < 4; ++id) EXPECT_EQ(nNeighbors(d, id), 1);
  EXPECT_DOUBLE_EQ(d.shortestBond, 1.0);
}

TEST(QuickGrid, CylinderHasItsVolume) {
  const std::string generator =
      "  NeighborhoodType: Spherical\n  TensorProductCylinderMeshGenerator:\n    Inner Radius: 1.0\n    Outer Radius: "
      "2.0\n"
      "    Cylinder Length: 3.0\n    Number Points Radius: 4\n    Ring Center x: 5.0\n    Ring Center y: 0.0\n"
      "    Z Origin: -1.0\n";
  const pd::Discretization d = discretize(gridDeck(generator, 0.6));
  // 2 pi / (0.25 / 1.5) = 37.7: 38 cells around; 3 / 0.25 + 1 = 13 along.
  EXPECT_EQ(d.nOwned, 4 * 38 * 13);
  const double volume = std::accumulate(d.volume.begin(), d.volume.begin() + d.nOwned, 0.0);
  EXPECT_NEAR(volume, 3.14159265358979 * 3.0 * 3.0, 1e-10);
  double sumOfX = 0.0;
  for (int i = 0; i < d.nOwned; ++i) sumOfX += d.x[3 * i];
  EXPECT_NEAR(sumOfX / d.nOwned, 5.0, 1e-10);
}

TEST(QuickGrid, GeneratorIsNeeded) {
  EXPECT_THAT(complaints(gridDeck("", 1.0)), HasSubstr("Discretization needs one of TensorProduct3DMeshGenerator"));
}
