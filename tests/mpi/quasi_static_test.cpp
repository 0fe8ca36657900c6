// QuasiStatic on 1, 2 and 4 ranks against each rank's own run of the whole body: the same fields and broken bonds.
#include <gtest/gtest.h>

#include "../bar_scene.hpp"

namespace pd::test {
namespace {

struct Case {
  Lattice lattice;
  const char* linearSolver;
  const char* preconditioner;
};

class QuasiStaticOnRanks : public ::testing::TestWithParam<Case> {
 protected:
  pd::Communicator world{MPI_COMM_WORLD};
  pd::Communicator alone{MPI_COMM_SELF};

  /// A body with a notch (of small volumes) that is pulled in x until it tears; its right side is held in x alone.
  static Discretization body(const pd::Communicator& comm, const Lattice& lattice) {
    Discretization points = lattice.discretization(comm);
    addNodeSets(points, {{"Left Node Set", [](const auto& x) { return x[0] < 1.5; }},
                         {"Right Node Set", [&](const auto& x) { return x[0] > lattice.nx - 2.5; }}});
    for (int i = 0; i < points.nPoints; ++i) {
      const double* x = &points.x[static_cast<std::size_t>(3 * i)];
      if (std::abs(x[0] - 0.5 * lattice.nx) < 1.1 && x[1] > lattice.ny - 2.5) points.volume[i] = 0.1;
    }
    return points;
  }
  static std::string deck() {
    std::string text;
    for (const char* axis : {"x", "y", "z"})
      text += std::string("  Hold ") + axis +
              ": {Type: Prescribed Displacement, Node Set: Left Node Set, Coordinate: " + axis + ", Value: 0.0}\n";
    text += "  Pull: {Type: Prescribed Displacement, Node Set: Right Node Set, Coordinate: x, Value: \"t\"}\n";
    return barDeck(1000.0, 0.06, text);
  }
};

TEST_P(QuasiStaticOnRanks, GivesTheSameFieldsAndBrokenBonds) {
  const Case& c = GetParam();
  Teuchos::ParameterList list;
  list.set("Linear Solver", c.linearSolver);
  list.set("Preconditioner", c.preconditioner);
  list.set("Relative Tolerance", 1e-11);
  Scene together(deck(), world, body(world, c.lattice), "QuasiStatic", list);
  Scene whole(deck(), alone, body(alone, c.lattice), "QuasiStatic", list);
  // A crack has grown from the notch; later the body hangs on a few bars, where equilibrium is not unique.
  together.run(5, 0, 2);
  whole.run(5, 0, 2);
  double largest = 0.0;
  const std::vector<int>& ids = together.model.discretization().globalIds;
  for (int i = 0; i < together.model.nOwned(); ++i) {
    const int id = ids[static_cast<std::size_t>(i)];  // on one rank, points are in the order of their ids
    EXPECT_EQ(together.model.field("Damage")[i], whole.model.field("Damage")[id]) << id;
    largest = std::max(largest, whole.model.field("Damage")[id]);
    for (int axis = 0; axis < 3; ++axis)
      EXPECT_NEAR(together.displacement()[3 * i + axis], whole.displacement()[3 * id + axis], 1e-9) << id;
  }
  EXPECT_GT(world.max(largest), 0.2);
}

INSTANTIATE_TEST_SUITE_P(Bodies, QuasiStaticOnRanks,
                         ::testing::Values(Case{{11, 7, 1, 2.3}, "Direct", "None"},
                                           Case{{11, 7, 1, 2.3}, "CG", "Block Jacobi"},
                                           Case{{11, 7, 1, 2.3}, "CG", "Multigrid"},
                                           Case{{7, 4, 3, 1.8}, "CG", "ILU"}));

}  // namespace
}  // namespace pd::test
