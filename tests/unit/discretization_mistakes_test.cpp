// Mistakes in meshes, node sets and what the deck says of them: each is reported with its place, all at once.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "driver/discretization/discretization.hpp"
#include "tests/support/scene_files.hpp"

namespace {

using pd_test::deckText;
using pd_test::latticeMesh;
using pd_test::SceneFiles;
using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

/// The text of the DeckError that reading throws.
std::string complaints(const std::string& mesh, const std::string& deck, const SceneFiles& files) {
  files.write("mesh.txt", mesh);
  const pd::Deck read = pd::Deck::read(files.write("deck.yaml", deck));
  try {
    pd::readDiscretization(read, pd::Communicator(MPI_COMM_SELF));
  } catch (const pd::DeckError& error) {
    return error.what();
  }
  return "no error";
}

std::string complaints(const std::string& mesh, const std::string& deck) {
  return complaints(mesh, deck, SceneFiles("mistakes"));
}

}  // namespace

TEST(MeshMistakes, AllBadRowsAreReportedWithTheirLines) {
  const std::string text = complaints(
      "# x y z block volume\n"
      "0 0 0 1 1.0\n"
      "1 0 0 1\n"
      "2 0 0 1 1.0 7\n"
      "3 zero 0 1 1.0\n"
      "4 nan 0 1 1.0\n"
      "5 0 inf 1 1.0\n"
      "6 0 0 1 0.0\n"
      "7 0 0 1 -2.0\n"
      "8 0 0 0 1.0\n"
      "9 0 0 1.5 1.0\n"
      "0 0 -0.0 1 1.0\n"
      "10 1e999 0 1 1.0\n"
      "11 1e200 0 1 1.0\n"
      "12 0 0 1 1.0\n",
      deckText("3.0"));
  EXPECT_THAT(text, HasSubstr("mesh.txt:3: a point has 5 numbers (x y z block_id volume), this line has 4"));
  EXPECT_THAT(text, HasSubstr("mesh.txt:4: a point has 5 numbers (x y z block_id volume), this line has 6"));
  EXPECT_THAT(text, HasSubstr("mesh.txt:5: y is \"zero\", not a finite number"));
  EXPECT_THAT(text, HasSubstr("mesh.txt:6: y is \"nan\""));
  EXPECT_THAT(text, HasSubstr("mesh.txt:7: z is \"inf\""));
  EXPECT_THAT(text, HasSubstr("mesh.txt:8: the volume (fifth column) must be greater than 0"));
  EXPECT_THAT(text, HasSubstr("mesh.txt:9: the volume"));
  EXPECT_THAT(text, HasSubstr("mesh.txt:10: the block number (fourth column) must be an integer of 1 or more"));
  EXPECT_THAT(text, HasSubstr("mesh.txt:11: the block number"));
  EXPECT_THAT(text, HasSubstr("mesh.txt:12: this point is at the same place as the one in line 2"));
  EXPECT_THAT(text, HasSubstr("mesh.txt:13: y is \"1e999\""));
  EXPECT_THAT(text, Not(HasSubstr("mesh.txt:2:")));
  EXPECT_THAT(text, HasSubstr("mesh.txt:14: y is \"1e200\", too large to be meant"));
  EXPECT_THAT(text, Not(HasSubstr("mesh.txt:15")));
}

TEST(MeshMistakes, ExchangedColumnsAreOneMistake) {
  const std::string text = complaints("0 0 0 0.5 1\n1 0 0 0.5 1\n2 0 0 0.25 2\n", deckText("3.0"));
  EXPECT_THAT(text, AllOf(HasSubstr("mesh.txt: columns 4 and 5 look exchanged"), Not(HasSubstr("mesh.txt:1:")),
                          Not(HasSubstr("has no block"))));
  // A row that is wrong otherwise: each is reported by itself.
  EXPECT_THAT(complaints("0 0 0 0.5 1\n1 0 0 0.5 0.7\n", deckText("3.0")),
              AllOf(HasSubstr("mesh.txt:1: the block number"), HasSubstr("mesh.txt:2:"), Not(HasSubstr("exchanged"))));
}

TEST(MeshMistakes, VeryManyAreCut) {
  std::string mesh;
  for (int i = 0; i < 1000; ++i) mesh += "oops\n";
  const std::string text = complaints(mesh, deckText("3.0"));
  EXPECT_THAT(text, AllOf(HasSubstr("mesh.txt:20:"), Not(HasSubstr("mesh.txt:21:")), HasSubstr("980 more mistakes")));
}

TEST(MeshMistakes, CommentsBlankLinesAndLineEndsOfOtherSystemsAreFine) {
  EXPECT_EQ(complaints("\xEF\xBB\xBF* a\r\n/ b\r\n  # c\r\n\r\n0 0 0 1 1.0\r\n\t1\t0 0 1 +1.0 # end\r\n2 0 0 1.0 1",
                       deckText("3.0")),
            "no error");
}

TEST(MeshMistakes, EmptyOrMissingFile) {
  EXPECT_THAT(complaints("# nothing\n", deckText("3.0")), HasSubstr("mesh.txt: the mesh has no points"));
  std::string deck = deckText("3.0");
  deck.replace(deck.find("mesh.txt"), 8, "misspelt.txt");
  EXPECT_THAT(complaints("", deck),
              AllOf(HasSubstr("deck.yaml:3:20: file \""), HasSubstr("misspelt.txt\": No such file")));
}

TEST(MeshMistakes, PointsNearlyAtTheSamePlace) {
  // As where two parts of a mesh meet and a generator computed the shared points twice.
  EXPECT_THAT(complaints(latticeMesh(4, 4, 1) + "2.00000000000001 1 0 1 1.0\n", deckText("2.0")),
              HasSubstr("mesh.txt:8: the point of line 18 is only"));
}

TEST(NodeSetMistakes, OneOfAnotherMesh) {
  const auto checked = [](const std::string& nodeSet) {
    const SceneFiles files("node_set_of_another_mesh");
    files.write("top.txt", nodeSet);
    return complaints(latticeMesh(3, 3, 1), deckText("2.0", "", "  Top Node Set: top.txt\n"), files);
  };
  EXPECT_THAT(checked("# top: 2 of the 16 points of other.txt\n1\n2\n"),
              HasSubstr("top.txt: the node set was made for the 16 points of other.txt, and the mesh has 9"));
  EXPECT_EQ(checked("# top: 2 of the 9 points of mesh.txt\n1\n2\n"), "no error");
  EXPECT_EQ(checked("# made by hand of the 16 points\n1\n2\n"), "no error");
  EXPECT_EQ(checked("1.000e+00\n+2.0\n"), "no error");
  EXPECT_THAT(checked("1.5\n"), HasSubstr("top.txt:1: \"1.5\" is not a node number"));
}

TEST(NodeSetMistakes, AllAreReportedTogetherWithThoseOfTheMesh) {
  const SceneFiles files("node_set_mistakes");
  files.write("good.txt", "1\n2\n");
  files.write("bad.txt", "1\n0 2 x3\n# fine\n99\n");
  files.write("empty.txt", "# nothing\n");
  const std::string text = complaints(latticeMesh(3, 3, 1) + "bad row\n",
                                      deckText("2.0", "",
                                               "  A Node Set: bad.txt\n"
                                               "  B Node Set: empty.txt\n"
                                               "  C Node Set: nowhere.txt\n"
                                               "  D Node Set: \"1 2 100\"\n"
                                               "  E Node Set: [1, two]\n"
                                               "  F Node Set: {Sphere: 1}\n"
                                               "  G Node Set: {Box: [[0, 0], [1, 1, 1]]}\n"
                                               "  H Node Set: {Box: [[0, 2, 0], [1, 1, 1]]}\n"
                                               "  J Node Set: {Expression: \"x <\"}\n"
                                               "  a_node_set: good.txt\n"),
                                      files);
  EXPECT_THAT(text, HasSubstr("mesh.txt:11: a point has 5 numbers"));
  EXPECT_THAT(text, HasSubstr("bad.txt:2: node 0 is not in the mesh, whose nodes are 1 to 10"));
  EXPECT_THAT(text, HasSubstr("bad.txt:2: \"x3\" is not a node number"));
  EXPECT_THAT(text, HasSubstr("bad.txt:4: node 99 is not in the mesh"));
  EXPECT_THAT(text, HasSubstr("empty.txt: the node set has no node numbers (named in"));
  EXPECT_THAT(text, AllOf(HasSubstr("deck.yaml:12:15: file"), HasSubstr("nowhere.txt\": No such file")));
  EXPECT_THAT(text, HasSubstr("deck.yaml:13:15: node 100 is not in the mesh"));
  EXPECT_THAT(text, HasSubstr("deck.yaml:14:19: \"two\" is not a node number"));
  EXPECT_THAT(text, HasSubstr("deck.yaml:15:15: node set \"F Node Set\" needs a file name, node numbers, or one of"));
  EXPECT_THAT(text, HasSubstr("deck.yaml:16:22: a corner of a box has three coordinates"));
  EXPECT_THAT(text, HasSubstr("deck.yaml:17:21: the first corner of a box is its lowest; y is 2"));
  EXPECT_THAT(text, HasSubstr("deck.yaml:18:"));
  EXPECT_THAT(text, HasSubstr("deck.yaml:19:3: another node set is called \"a_node_set\""));
}

TEST(NodeSetMistakes, GeometryWithoutPoints) {
  EXPECT_THAT(
      complaints(latticeMesh(3, 4, 1), deckText("2.0", "", "  Far Node Set: {Box: [[9, 9, 9], [10, 10, 10]]}\n")),
      HasSubstr("node set \"Far Node Set\" has no points (the mesh spans [0, 2] x [0, 3] x [0, 0] m)"));
}

TEST(BlockMistakes, BlocksAndEntriesMustMatch) {
  const std::string mesh = "0 0 0 1 1\n1 0 0 2 1\n2 0 0 3 1\n";
  const std::string text = complaints(mesh,
                                      "Discretization: {Type: Text File, Input Mesh File: mesh.txt}\n"
                                      "Blocks:\n"
                                      "  A: {Block Names: block_1, Material: M, Horizon: 2.0}\n"
                                      "  B: {Block Names: block_1 block_7 steel, Material: M, Horizon: -1.0}\n"
                                      "  C: {Material: M, Horizon: 2.0}\n");
  EXPECT_THAT(text, HasSubstr("deck.yaml:4:20: block_1 already belongs to Blocks/A"));
  EXPECT_THAT(text, AllOf(HasSubstr("has no block \"block_7\"; it has: block_1, block_2, block_3"),
                          HasSubstr("has no block \"steel\"")));
  EXPECT_THAT(text, HasSubstr("Blocks/C needs Block Names"));
  EXPECT_THAT(text, HasSubstr("deck.yaml:2:1: no entry of Blocks gives a material and a horizon to block_2, block_3"));
}

TEST(BlockMistakes, HorizonMustBePositiveEverywhere) {
  EXPECT_THAT(complaints(latticeMesh(5, 1, 1), deckText("\"2.5 - x\"")),
              HasSubstr("deck.yaml:8:14: the horizon must be greater than 0 and finite; it is -0.5 m at the point of "
                        "scene_mistakes/mesh.txt:5"));
}

TEST(ResolutionMistakes, PointsWithoutNeighborsAreListed) {
  const std::string text = complaints(latticeMesh(4, 1, 1) + "7.5 0 0 1 1.0\n", deckText("1.1"));
  EXPECT_THAT(text, AllOf(HasSubstr("mesh.txt:6: the point (7.5, 0, 0) has no neighbours within its horizon of 1.1 m"),
                          HasSubstr("larger Horizon"), Not(HasSubstr("mesh.txt:5"))));
  EXPECT_THAT(complaints(latticeMesh(30, 1, 1), deckText("0.3", "  Include Partial Neighbors: false\n")),
              HasSubstr("20 more points without neighbours"));
}

TEST(ResolutionMistakes, AFilterThatTakesAllBondsOfAPoint) {
  const std::string filter = "  Include Partial Neighbors: false\n  Omit Bonds Between Blocks: All\n";
  std::string deck = deckText("1.1", filter);
  deck.replace(deck.find("block_1"), 7, "default");
  EXPECT_THAT(complaints("0 0 0 1 1\n1 0 0 1 1\n2 0 0 2 1\n", deck),
              HasSubstr("mesh.txt:3: the point (2, 0, 0) has no"));
}

TEST(ResolutionMistakes, VolumesThatDoNotFitTheSpacing) {
  std::string mesh;  // 4 mm thick, and the deck does not say so
  for (int j = 0; j < 11; ++j)
    for (int i = 0; i < 11; ++i) mesh += fmt::format("{} {} 0 1 4e-9\n", 1e-3 * i, 1e-3 * j);
  EXPECT_THAT(complaints(mesh, deckText("3.015e-3")),
              AllOf(HasSubstr("volumes and coordinates do not fit"), HasSubstr("set Discretization/Thickness (m)")));
}

TEST(ResolutionMistakes, OneVolumeFarTooLarge) {
  EXPECT_THAT(complaints(latticeMesh(9, 9, 9) + "9 0 0 1 1e9\n", deckText("3.015")),
              HasSubstr("the volume 1e+09 m3 of the point scene_mistakes/mesh.txt:731 means a spacing of 1000 m"));
}

TEST(ResolutionMistakes, AHorizonOfFewNeighborsIsWarnedOf) {
  const auto warnings = [](const std::string& mesh, const std::string& horizon) {
    const SceneFiles files("few_neighbors");
    files.write("mesh.txt", mesh);
    const pd::Deck deck = pd::Deck::read(files.write("deck.yaml", deckText(horizon)));
    pd::readDiscretization(deck, pd::Communicator(MPI_COMM_SELF));
    return deck.warnings().lines();
  };
  for (const std::string& mesh : {latticeMesh(9, 9, 1), latticeMesh(6, 6, 6)}) {
    EXPECT_THAT(warnings(mesh, "1.1"), Contains(HasSubstr("the Horizon is 1.1 times the distance of the next point")));
    EXPECT_THAT(warnings(mesh, "1.5"), IsEmpty());
  }
  EXPECT_THAT(warnings(latticeMesh(9, 1, 1), "1.1"), IsEmpty());
}

TEST(ResolutionMistakes, AHorizonFarTooLargeIsSeenBeforeTheSearch) {
  // 200 x 250 points that all see each other: 2.5e9 bonds.
  EXPECT_THAT(
      complaints(latticeMesh(250, 200, 1), deckText("3015.0")),
      AllOf(HasSubstr("the horizon reaches over about 49999 neighbours a point"), HasSubstr("points are 1 m apart")));
}

TEST(FilterMistakes, AllAreReported) {
  const std::string filters =
      "  Omit Bonds Between Blocks: Some\n"
      "  Bond Filters:\n"
      "    A: {Type: Cylinder}\n"
      "    B: {Type: Disk, Center_X: 0.0, Center_Y: 0.0, Center_Z: 0.0, Normal_X: 0.0, Normal_Y: 0.0, Normal_Z: 0.0, "
      "Radius: 1.0}\n"
      "    C: {Type: Disk, Center_X: 0.0, Center_Y: 0.0, Normal_X: 0.0, Normal_Y: 0.0, Normal_Z: 1.0, Radius: 1.0}\n"
      "    D: {Type: Disk, Center_X: 0.0, Center_Y: 0.0, Center_Z: 0.0, Normal_X: 0.0, Normal_Y: 0.0, Normal_Z: 1.0, "
      "Radius: 0.0}\n"
      "    E: {Type: Node Set Pair, First Node Set: Up Node Set, Second Node Set: Down Node Set}\n"
      "    F: {Normal_X: 1.0}\n";
  const std::string text = complaints(latticeMesh(4, 4, 1), deckText("2.0", filters, "  Up Node Set: \"1 2\"\n"));
  EXPECT_THAT(text, HasSubstr("Omit Bonds Between Blocks must be None or All, not \"Some\""));
  EXPECT_THAT(text, HasSubstr("deck.yaml:6:15: unknown bond filter \"Cylinder\"; there are Rectangular_Plane, Disk"));
  EXPECT_THAT(text, HasSubstr("Normal is a zero vector"));
  EXPECT_THAT(text, HasSubstr("Discretization/Bond Filters/C needs Center_Z"));
  EXPECT_THAT(text, HasSubstr("Radius must be greater than 0"));
  EXPECT_THAT(text, HasSubstr("no node set \"Down Node Set\" in Boundary Conditions (there are: Up Node Set)"));
  EXPECT_THAT(text, HasSubstr("Discretization/Bond Filters/F needs Type"));
}
