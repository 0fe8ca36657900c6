// The condition of materials/YOUR_OWN_MODEL.md: water that rises over a row of points.
#include <gtest/gtest.h>
#include <mpi.h>

#include "driver/boundary/boundary_conditions.hpp"
#include "tests/model_plugins.hpp"
#include "tests/mpi/lattice.hpp"

namespace pd::test {
namespace {

TEST(WeightOfWater, PressesWhatLiesBelowItsLevel) {
  const Communicator comm(MPI_COMM_WORLD);
  Discretization points = Lattice{3, 3, 1, 1.0}.discretization(comm);
  points.nodeSets["All Node Set"];
  for (int i = 0; i < points.nPoints; ++i) points.nodeSets["All Node Set"].push_back(i);
  const Deck deck = deckOf(plateText() +
                           "Boundary Conditions:\n"
                           "  Flood: {Type: Weight Of Water, Node Set: All Node Set, Value: \"0.5*t\", Depth: 0.1,"
                           " Specific Weight: 10.0}\n");
  Model model(deck, comm, points, {});
  BoundaryConditions conditions(deck, model);
  for (const double t : {0.0, 3.0}) {
    std::vector<double> force(3 * static_cast<std::size_t>(model.nOwned()), 0.0);
    conditions.addExternalForce(t, force.data());
    for (int i = 0; i < model.nOwned(); ++i) {
      const double head = std::max(0.0, 0.5 * t - model.discretization().x[3 * i + 1]);  // 1.5 m, 0.5 m, none
      EXPECT_DOUBLE_EQ(force[3 * i + 1], -10.0 * head / 0.1);
      EXPECT_EQ(force[3 * i], 0.0);
    }
  }
}

}  // namespace
}  // namespace pd::test
