// One mesh, any number of ranks: the same points, bonds and node sets.
#include "driver/discretization/discretization.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "driver/discretization/point_exchange.hpp"
#include "driver/parallel/ghost_exchange.hpp"
#include "tests/support/scene_files.hpp"

namespace {

using pd_test::deckText;
using pd_test::latticeMesh;
using pd_test::SceneFiles;

/// Every directed bond as (global id, global id, is cut), sorted.
using Bonds = std::vector<std::array<int, 3>>;

Bonds bondsOf(const pd::Discretization& d) {
  Bonds bonds;
  for (int i = 0; i < d.nOwned; ++i) {
    const int* entry = &d.neighborhoodList[d.neighborhoodStart[i]];
    for (int k = 1; k <= *entry; ++k)
      bonds.push_back({d.globalIds[i], d.globalIds[entry[k]], d.bondIsCut.empty() ? 0 : d.bondIsCut[bonds.size()]});
  }
  return bonds;
}

/// The bonds of all ranks, sorted, on every rank.
Bonds gather(const Bonds& own, const pd::Communicator& comm) {
  const int count = static_cast<int>(3 * own.size());
  std::vector<int> counts(comm.size()), starts(comm.size());
  MPI_Allgather(&count, 1, MPI_INT, counts.data(), 1, MPI_INT, comm.mpi());
  int total = 0;
  for (int rank = 0; rank < comm.size(); ++rank) {
    starts[rank] = total;
    total += counts[rank];
  }
  Bonds all(total / 3);
  MPI_Allgatherv(own.data(), count, MPI_INT, all.data(), counts.data(), starts.data(), MPI_INT, comm.mpi());
  std::sort(all.begin(), all.end());
  return all;
}

pd::Discretization discretize(const std::string& mesh, const std::string& deck, const pd::Communicator& comm) {
  const SceneFiles files("discretization_mpi_" + std::to_string(comm.size()), comm.mpi());
  files.write("mesh.txt", mesh);
  return pd::readDiscretization(pd::Deck::read(files.write("deck.yaml", deck)), comm);
}

/// The same scene read by this rank alone.
pd::Discretization discretizeAlone(const std::string& mesh, const std::string& deck) {
  int rank = 0, size = 1;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &size);
  const SceneFiles files(fmt::format("discretization_alone_{}_of_{}", rank, size));
  files.write("mesh.txt", mesh);
  return pd::readDiscretization(pd::Deck::read(files.write("deck.yaml", deck)), pd::Communicator(MPI_COMM_SELF));
}

const std::string crack =
    "  Bond Filters:\n    Crack: {Type: Rectangular_Plane, Normal_X: 0.0, Normal_Y: 1.0, Normal_Z: 0.0, "
    "Lower_Left_Corner_X: -2.0, Lower_Left_Corner_Y: 5.2, Lower_Left_Corner_Z: -9.0, Bottom_Unit_Vector_X: 1.0, "
    "Bottom_Unit_Vector_Y: 0.0, Bottom_Unit_Vector_Z: 0.0, Bottom_Length: 12.0, Side_Length: 30.0, Count In Damage: "
    "true}\n";

struct Scene {
  std::string mesh, deck;
};

std::vector<Scene> scenes() {
  return {{latticeMesh(25, 12, 1), deckText("3.015", crack)},
          {latticeMesh(25, 12, 1, 0.45), deckText("3.0", crack)},
          {latticeMesh(11, 10, 9, 0.3), deckText("2.5", crack)},
          {latticeMesh(40, 1, 1, 0.1), deckText("2.5")}};
}

}  // namespace

TEST(DiscretizationMpi, TheGraphDoesNotDependOnTheNumberOfRanks) {
  const pd::Communicator comm(MPI_COMM_WORLD);
  for (const Scene& scene : scenes()) {
    const pd::Discretization d = discretize(scene.mesh, scene.deck, comm),
                             whole = discretizeAlone(scene.mesh, scene.deck);
    Bonds expected = bondsOf(whole);
    std::sort(expected.begin(), expected.end());
    EXPECT_EQ(gather(bondsOf(d), comm), expected);
    EXPECT_EQ(d.nGlobal, whole.nGlobal);
    EXPECT_EQ(d.dimension, whole.dimension);
    EXPECT_EQ(d.shortestBond, whole.shortestBond);
    EXPECT_EQ(comm.sum(static_cast<long long>(d.nOwned)), whole.nGlobal);
  }
}

TEST(DiscretizationMpi, BondsAreSymmetricAcrossRanks) {
  const pd::Communicator comm(MPI_COMM_WORLD);
  for (const Scene& scene : scenes()) {
    const Bonds bonds = gather(bondsOf(discretize(scene.mesh, scene.deck, comm)), comm);
    for (const auto& [a, b, isCut] : bonds)
      ASSERT_TRUE(std::binary_search(bonds.begin(), bonds.end(), std::array<int, 3>{b, a, isCut})) << a << " " << b;
  }
}

TEST(DiscretizationMpi, OwnershipIsBalancedAndGhostsAreJustTheNeighbors) {
  const pd::Communicator comm(MPI_COMM_WORLD);
  const pd::Discretization d = discretize(latticeMesh(32, 24, 1), deckText("3.015"), comm);
  EXPECT_NEAR(d.nOwned, 32.0 * 24.0 / comm.size(), 24.0);  // a line of the lattice more or less
  const std::set<int> distinct(d.globalIds.begin(), d.globalIds.end());
  EXPECT_EQ(distinct.size(), d.globalIds.size());
  std::vector<char> isUsed(d.nPoints, 0);
  for (int i = 0; i < d.nOwned; ++i) {
    const int* entry = &d.neighborhoodList[d.neighborhoodStart[i]];
    EXPECT_TRUE(std::is_sorted(entry + 1, entry + 1 + *entry));
    for (int k = 1; k <= *entry; ++k) isUsed[entry[k]] = 1;
  }
  for (int i = d.nOwned; i < d.nPoints; ++i) EXPECT_EQ(isUsed[i], 1);
}

TEST(DiscretizationMpi, GhostsHoldTheValuesOfTheirOwners) {
  const pd::Communicator comm(MPI_COMM_WORLD);
  const pd::Discretization d = discretize(latticeMesh(20, 10, 1, 0.3), deckText("3.015"), comm);
  const pd::GhostExchange exchange(comm, d.globalIds, d.nOwned);
  std::vector<double> x(d.x.begin(), d.x.begin() + 3 * d.nOwned);
  x.resize(d.x.size(), -1.0);
  exchange.import(x.data(), 3);
  EXPECT_EQ(x, d.x);
}

namespace {

const std::string corner =
    "  Symmetry:\n    Left: {Point: [-0.5, 0, 0], Normal: [1, 0, 0]}\n"
    "    Low: {Point: [0, -0.5, 0], Normal: [0, 1, 0]}\n";

std::vector<Scene> corners() {
  return {{latticeMesh(12, 25, 1, 0.2), deckText("3.015", corner + crack)},
          {latticeMesh(9, 8, 7, 0.2), deckText("2.5", corner + crack)}};
}

}  // namespace

TEST(DiscretizationMpi, BondsToImagesDoNotDependOnTheNumberOfRanks) {
  const pd::Communicator comm(MPI_COMM_WORLD);
  for (const Scene& scene : corners()) {
    const pd::Discretization d = discretize(scene.mesh, scene.deck, comm);
    const Bonds bonds = gather(bondsOf(d), comm);
    Bonds expected = bondsOf(discretizeAlone(scene.mesh, scene.deck));
    std::sort(expected.begin(), expected.end());
    EXPECT_EQ(bonds, expected);
    // The bond from a to an image of b is the mirror image of that from b to the same image of a.
    const auto n = static_cast<int>(d.nGlobal);
    int nToImages = 0;
    for (const auto& [a, b, isCut] : bonds) {
      ASSERT_TRUE(std::binary_search(bonds.begin(), bonds.end(), std::array<int, 3>{b % n, b / n * n + a, isCut}));
      nToImages += b >= n ? 1 : 0;
    }
    EXPECT_GT(nToImages, 500);
    EXPECT_EQ(std::set<int>(d.globalIds.begin(), d.globalIds.end()).size(), d.globalIds.size());
  }
}

TEST(DiscretizationMpi, ImagesHoldTheMirroredValuesOfOwners) {
  const pd::Communicator comm(MPI_COMM_WORLD);
  for (const Scene& scene : corners()) {
    const pd::Discretization d = discretize(scene.mesh, scene.deck, comm);
    const pd::PointExchange exchange(comm, d);
    std::vector<double> x(d.x.begin(), d.x.begin() + 3 * d.nOwned);
    x.resize(d.x.size(), -1.0);
    exchange.import(x.data(), 3, pd::Reflection::Position);
    EXPECT_EQ(x, d.x);
    // What is added back is the transpose of what is handed out: v . (P u) = (P^T v) . u over all ranks.
    for (const auto rule : {pd::Reflection::Even, pd::Reflection::Vector, pd::Reflection::AxialVector}) {
      std::vector<double> u(d.x.size()), v(d.x.size());
      for (std::size_t i = 0; i < u.size(); ++i) {
        u[i] = std::sin(1.0 + 7.0 * d.globalIds[i / 3] + 3.0 * static_cast<double>(i % 3));
        v[i] = std::cos(2.0 + 5.0 * d.globalIds[i / 3] - static_cast<double>(i % 3) + comm.rank());
      }
      const std::vector<double> owned = u;
      exchange.import(u.data(), 3, rule);
      double handedOut = 0.0, addedBack = 0.0;
      for (std::size_t i = 0; i < u.size(); ++i) handedOut += u[i] * v[i];
      exchange.exportAdd(v.data(), 3, rule);
      for (std::size_t i = 0; i < 3 * static_cast<std::size_t>(d.nOwned); ++i) addedBack += owned[i] * v[i];
      EXPECT_NEAR(comm.sum(handedOut), comm.sum(addedBack), 1e-10);
    }
  }
}

TEST(DiscretizationMpi, NodeSetsHoldOwnedAndGhostPoints) {
  const pd::Communicator comm(MPI_COMM_WORLD);
  const pd::Discretization d =
      discretize(latticeMesh(20, 10, 1), deckText("3.015", "", "  Low Node Set: {Expression: \"y < 2.5\"}\n"), comm);
  const std::vector<int>& set = d.nodeSets.at("Low Node Set");
  EXPECT_TRUE(std::is_sorted(set.begin(), set.end()));
  for (int i = 0; i < d.nPoints; ++i)
    EXPECT_EQ(std::binary_search(set.begin(), set.end(), i), d.globalIds[i] < 60) << d.globalIds[i];
}

TEST(DiscretizationMpi, MoreRanksThanPointsIsNoProblem) {
  const pd::Communicator comm(MPI_COMM_WORLD);
  const pd::Discretization d = discretize(latticeMesh(3, 1, 1), deckText("1.5"), comm);
  EXPECT_EQ(comm.sum(static_cast<long long>(d.nOwned)), 3);
  EXPECT_EQ(gather(bondsOf(d), comm).size(), 4u);
}

TEST(DiscretizationMpi, EveryRankThrowsTheSameMistakes) {
  const pd::Communicator comm(MPI_COMM_WORLD);
  std::string message;
  try {
    discretize(latticeMesh(30, 1, 1) + "500 0 0 1 1\n", deckText("1.1"), comm);
  } catch (const pd::DeckError& error) {
    message = error.what();
  }
  EXPECT_THAT(message, testing::HasSubstr("mesh.txt:32: the point (500, 0, 0) has no neighbours"));
  const std::string all = comm.gather(message);
  for (int rank = 0; rank < comm.size(); ++rank) EXPECT_EQ(all.substr(rank * message.size(), message.size()), message);
}
