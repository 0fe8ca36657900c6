// An Exodus mesh on several ranks: the root rank reads it, all know it.
#include <gtest/gtest.h>

#include <numeric>

#include "driver/discretization/discretization.hpp"
#include "driver/discretization/mesh_reader.hpp"
#include "tests/support/exodus_file.hpp"
#include "tests/support/scene_files.hpp"

namespace {

using pd_test::ExodusMesh;
using pd_test::SceneFiles;

class ExodusOnRanks : public ::testing::Test {
 protected:
  pd::Communicator comm{MPI_COMM_WORLD};
  SceneFiles files{"exodus_np" + std::to_string(comm.size()), MPI_COMM_WORLD};

  pd::Deck deckOf(const ExodusMesh& mesh) {
    if (comm.isRoot()) pd_test::writeExodus(files.path("mesh.g"), mesh);
    return pd::Deck::read(
        files.write("deck.yaml",
                    "Discretization:\n  Type: Exodus\n  Input Mesh File: mesh.g\n"
                    "Blocks:\n  Body:\n    Block Names: Steel\n    Material: None\n    Horizon: 1.5\n"));
  }
};

TEST_F(ExodusOnRanks, EveryRankHasItsPart) {
  ExodusMesh mesh = pd_test::cubes(6, 5, 4);
  mesh.blocks[0].name = "Steel";
  const pd::Discretization d = pd::readDiscretization(deckOf(mesh), comm);
  EXPECT_EQ(comm.sum(static_cast<long long>(d.nOwned)), 120);
  EXPECT_GT(d.nOwned, 0);
  EXPECT_NEAR(comm.sum(std::accumulate(d.volume.begin(), d.volume.begin() + d.nOwned, 0.0)), 120.0, 1e-10);
  EXPECT_EQ(d.blockNames.at(1), "Steel");
  long long nMembers = 0;
  for (const int point : d.nodeSets.at("top"))
    if (point < d.nOwned) {
      ++nMembers;
      EXPECT_NEAR(d.x[3 * point + 2], 3.5, 1e-14);
    }
  EXPECT_EQ(comm.sum(nMembers), 30);
}

TEST_F(ExodusOnRanks, MistakesAreTheSameOnAllRanks) {
  ExodusMesh mesh = pd_test::cubes(2, 1, 1);
  mesh.blocks[0].type = "WEDGE";
  const pd::Deck deck = deckOf(mesh);
  std::string text;
  try {
    pd::readMesh(deck, comm);
  } catch (const pd::DeckError& error) {
    text = error.what();
  }
  EXPECT_NE(text.find("WEDGE"), std::string::npos);
  std::string repeated;
  for (int rank = 0; rank < comm.size(); ++rank) repeated += text;
  EXPECT_EQ(comm.gather(text), repeated);
}

}  // namespace
