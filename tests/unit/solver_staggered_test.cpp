// Diffusion and mechanics in turn.
#include <gtest/gtest.h>

#include <cmath>

#include "../solver_scene.hpp"

namespace pd::test {
namespace {

constexpr int nPoints = 9;
const char* const conditions =
    "  Left: {Type: Prescribed Displacement, Node Set: Left Node Set, Coordinate: x, Value: 0.0}\n"
    "  Right: {Type: Prescribed Displacement, Node Set: Right Node Set, Coordinate: x, Value: \"0.04*t\"}\n"
    "  Hydrogen: {Type: Prescribed Concentration, Node Set: Left Node Set, Value: 1.0}\n";

class StaggeredTest : public ::testing::Test {
 protected:
  Communicator comm{MPI_COMM_WORLD};
  Lattice chain{nPoints, 1, 1, 1.0};
  static double none(double, double) { return 0.0; }
};

TEST_F(StaggeredTest, IsItsPartsInTurn) {
  SolverScene together(comm, chain, conditions), apart(comm, chain, conditions);
  const auto staggered = together.make("Staggered",
                                       "{Load Steps: 6, Diffusion: {Method: Euler, Sub Steps: 4}, Mechanics: {Adaptive "
                                       "Dynamic Relaxation: {Iterations Per Load Step: 2}}}");
  const auto diffusion = apart.make("Diffusion", "{Method: Euler, Sub Steps: 4}"),
             mechanics = apart.make("Adaptive Dynamic Relaxation", "{Iterations Per Load Step: 2}");
  together.start("Concentration", none);
  apart.start("Concentration", none);
  EXPECT_EQ(together.run(*staggered, 0.0, 6.0), 6);
  diffusion->initialize(apart.simulation());
  mechanics->initialize(apart.simulation());
  for (int k = 0; k < 6; ++k) {
    diffusion->advance(apart.simulation(), k, 1.0);
    mechanics->advance(apart.simulation(), k, 1.0);
  }
  EXPECT_EQ(together.values("Concentration"), apart.values("Concentration"));
  EXPECT_EQ(together.values("Displacement"), apart.values("Displacement"));
  EXPECT_GT(together.error("Concentration", [](double x) { return x == 0.0 ? 1.0 : 0.0; }), 0.1);
}

TEST_F(StaggeredTest, NewCrackFacesBecomeSourcesOfTheNextStep) {
  // All bonds are 1 + 0.04 t / 8 long in equilibrium: they break in the step that ends at t = 5 (1.025 > 1.021).
  const std::string more =
      std::string(conditions) +
      "  Faces: {Type: Saturated Crack Faces, Field: Concentration, Value: 1.0, Threshold: 0.36}\n";
  SolverScene scene(comm, chain, more, "{Damage Model: Test Length, Greatest Length: 1.021}");
  const auto solver = scene.make("Staggered",
                                 "{Load Steps: 6, Diffusion: {Method: RKL}, Mechanics: {Adaptive Dynamic Relaxation: "
                                 "{Relative Tolerance: 1e-9}}}");
  scene.start("Concentration", none);
  solver->initialize(scene.simulation());
  scene.advance(*solver, 0.0, 4.0, 4);
  EXPECT_GT(scene.error("Concentration", [](double) { return 1.0; }), 0.1);
  scene.advance(*solver, 4.0, 5.0, 1);
  EXPECT_EQ(scene.error("Damage", [](double) { return 1.0; }), 0.0);
  scene.advance(*solver, 5.0, 6.0, 1);
  EXPECT_EQ(scene.error("Concentration", [](double) { return 1.0; }), 0.0);
  // The ninth is prescribed already.
  EXPECT_NE(solver->summary().back().find("8 points"), std::string::npos) << solver->summary().back();
}

TEST_F(StaggeredTest, GoesOnBitIdenticallyFromItsRestartState) {
  const std::string parameters =
      "{Load Steps: 8, Diffusion: {Method: RKC, Relative Tolerance: 1e-5}, Mechanics: {Adaptive Dynamic Relaxation: "
      "{Iterations Per Load Step: 3}}}";
  SolverScene whole(comm, chain, conditions), halves(comm, chain, conditions);
  const auto one = whole.make("Staggered", parameters), first = halves.make("Staggered", parameters),
             second = halves.make("Staggered", parameters);
  whole.start("Concentration", none);
  halves.start("Concentration", none);
  whole.run(*one, 0.0, 8.0);
  first->initialize(halves.simulation());
  halves.advance(*first, 0.0, 3.0, 3);
  second->initialize(halves.simulation());
  second->setRestartState(first->restartState());
  halves.advance(*second, 3.0, 8.0, 5);
  EXPECT_EQ(whole.values("Concentration"), halves.values("Concentration"));
  EXPECT_EQ(whole.values("Displacement"), halves.values("Displacement"));
}

TEST_F(StaggeredTest, AsksForBothPartsAndForOneSolverOfMechanics) {
  const ParameterDeclarations declarations = SolverRegistry::self().find("Staggered")->declare();
  const auto messages = [&](const std::string& parameters) {
    try {
      deckOf("List: " + parameters)["List"].parameters(declarations);
    } catch (const DeckError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_NE(messages("{Load Steps: 2, Diffusion: {}}"), "");
  EXPECT_NE(messages("{Load Steps: 2, Diffusion: {}, Mechanics: {}}"), "");
  EXPECT_NE(messages("{Diffusion: {}, Mechanics: {Adaptive Dynamic Relaxation: {}}}"), "");
  EXPECT_NE(messages("{Load Steps: 2, Diffusion: {Load Steps: 2}, Mechanics: {Adaptive Dynamic Relaxation: {}}}"), "")
      << "the parts have no load steps of their own";
  EXPECT_EQ(messages("{Load Steps: 2, Diffusion: {}, Mechanics: {Adaptive Dynamic Relaxation: {}}}"), "");
}

}  // namespace
}  // namespace pd::test
