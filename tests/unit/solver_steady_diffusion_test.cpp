// Steady diffusion along a chain of unit springs, whose solutions are straight lines between held values.
#include <gtest/gtest.h>

#include <cmath>

#include "../solver_scene.hpp"

namespace pd::test {
namespace {

constexpr int nPoints = 12, last = nPoints - 1;
/// 2 on the left, and 2 + t on the right.
const char* const heldEnds =
    "  Left: {Type: Prescribed Concentration, Node Set: Left Node Set, Value: 2.0}\n"
    "  Right: {Type: Prescribed Concentration, Node Set: Right Node Set, Value: \"2 + t\"}\n";

class SteadyDiffusion : public ::testing::Test {
 protected:
  Communicator comm{MPI_COMM_WORLD};
  Lattice chain{nPoints, 1, 1, 1.0};
};

TEST_F(SteadyDiffusion, ProfileIsLinearWithEveryLinearSolver) {
  for (const std::string linear :
       {"Linear Solver: CG", "Linear Solver: GMRES", "Linear Solver: Direct", "Belos Linear Solver: BlockCG",
        "Belos Linear Solver: BlockGMRES, Belos Relative Tolerance: 1.0e-12, Preconditioner: ILU",
        "Preconditioner: Jacobi", "Preconditioner: None"}) {
    SolverScene scene(comm, chain, heldEnds);
    const auto solver =
        scene.make("ImplicitDiffusion",
                   "{Field: Concentration, Number of Load Steps: 4, Relative Tolerance: 1.0e-12, " + linear + "}");
    scene.start("Concentration", [](double, double) { return 2.0; });
    EXPECT_EQ(scene.run(*solver, 0.0, 3.0), 4);
    EXPECT_LT(scene.error("Concentration", [](double x) { return 2.0 + 3.0 * x / last; }), 1e-11) << linear;
    // What flows in at the ends is the slope; nothing stays in between.
    const double slope = 3.0 / last;
    EXPECT_LT(scene.error("Concentration_Flux_Divergence",
                          [&](double x) { return x == 0.0    ? slope
                                                 : x == last ? -slope
                                                             : 0.0; }),
              1e-11)
        << linear;
  }
}

TEST_F(SteadyDiffusion, TimeStepsSayWhereLoadStepsEnd) {
  SolverScene scene(comm, chain, heldEnds);
  const auto solver = scene.make("ImplicitDiffusion", "{Field: Concentration, Time Steps: \"0.0 1.0 5.0\"}");
  scene.start("Concentration", [](double, double) { return 2.0; });
  solver->initialize(scene.simulation());
  EXPECT_EQ(solver->numberOfIncrements(scene.simulation(), 0.0, 5.0), 2);
  EXPECT_EQ(solver->incrementEnd(1, 2, 0.0, 5.0), 1.0);
  EXPECT_THROW(solver->numberOfIncrements(scene.simulation(), 0.0, 4.0), RunError);
  solver->advance(scene.simulation(), 0.0, 1.0);
  EXPECT_LT(scene.error("Concentration", [](double x) { return 2.0 + x / last; }), 1e-6);
}

TEST_F(SteadyDiffusion, AFieldWithoutDifferencesConvergesAtRoundOff) {
  SolverScene scene(comm, chain, heldEnds);
  const auto solver = scene.make("ImplicitDiffusion", "{Field: Concentration}");
  scene.start("Concentration", [](double, double) { return 2.0; });
  scene.run(*solver, 0.0, 1e-300);
  EXPECT_LT(scene.error("Concentration", [](double) { return 2.0; }), 1e-14);
}

/// Breaks the bond from 4 to 5.
void breakInTheMiddle(SolverScene& scene) {
  for (PeridigmNS::Block& block : *scene.model().blocks()) {
    double* damage = nullptr;
    const int id = PeridigmNS::FieldManager::self().getFieldId("Bond_Damage");
    block.getData(id, STEP_NP1)->ExtractView(&damage);
    const auto points = block.getNeighborhoodData();
    const int* list = points->NeighborhoodList();
    for (int p = 0; p < points->NumOwnedPoints(); ++p)
      for (int count = *list++; count > 0; --count, ++damage)
        if (scene.x(points->OwnedIDs()[p]) + scene.x(*list++) == 9.0) *damage = 1.0;
  }
}

TEST_F(SteadyDiffusion, PointsBeyondABreakKeepTheOneValueTheyHave) {
  const std::string left = "  Left: {Type: Prescribed Concentration, Node Set: Left Node Set, Value: 7.0}\n",
                    breakable = "{Damage Model: Test Length, Greatest Length: 1000.0}";
  SolverScene scene(comm, chain, left, breakable);
  const auto solver = scene.make("ImplicitDiffusion", "{Field: Concentration}");
  scene.start("Concentration", [](double x, double) { return x < 4.5 ? x : 3.0; });
  breakInTheMiddle(scene);
  scene.run(*solver, 0.0, 1.0);
  EXPECT_LT(scene.error("Concentration", [](double x) { return x < 4.5 ? 7.0 : 3.0; }), 1e-11);

  // Where something would flow there, nothing says to what steady state.
  SolverScene open(comm, chain, left, breakable);
  const auto another = open.make("ImplicitDiffusion", "{Field: Concentration}");
  open.start("Concentration", [](double x, double) { return x; });
  breakInTheMiddle(open);
  try {
    open.run(*another, 0.0, 1.0);
    FAIL() << "solved without a prescribed value beyond the break";
  } catch (const RunError& error) {
    EXPECT_NE(std::string(error.what()).find("leaves their steady state open"), std::string::npos) << error.what();
  }
}

TEST_F(SteadyDiffusion, AnOpenProblemIsRefused) {
  SolverScene scene(comm, chain, "");
  const auto solver = scene.make("ImplicitDiffusion", "{Field: Concentration}");
  scene.start("Concentration", [](double x, double) { return x; });
  solver->initialize(scene.simulation());
  try {
    solver->advance(scene.simulation(), 0.0, 1.0);
    FAIL() << "solved without a prescribed value";
  } catch (const RunError& error) {
    EXPECT_NE(std::string(error.what()).find("no point has a prescribed Concentration"), std::string::npos);
  }
}

TEST_F(SteadyDiffusion, AFieldThatNothingDiffusesIsRefused) {
  SolverScene scene(comm, chain, "");
  const auto solver = scene.make("ImplicitDiffusion", "{}");
  scene.start("Concentration", [](double x, double) { return x; });
  EXPECT_THROW(solver->initialize(scene.simulation()), RunError);  // Temperature, its default
}

}  // namespace
}  // namespace pd::test
