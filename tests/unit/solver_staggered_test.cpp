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

  /// A run of `nSteps` steps of 1 s ends with the same bits where another solver goes on after `stop` of them.
  void expectToGoOn(const std::string& parameters, int stop, int nSteps) {
    SolverScene whole(comm, chain, conditions), halves(comm, chain, conditions);
    const auto one = whole.make("Staggered", parameters), first = halves.make("Staggered", parameters),
               second = halves.make("Staggered", parameters);
    whole.start("Concentration", none);
    halves.start("Concentration", none);
    whole.run(*one, 0.0, nSteps);
    first->initialize(halves.simulation());
    halves.advance(*first, 0.0, stop, stop);
    second->initialize(halves.simulation());
    second->setRestartState(first->restartState());
    second->numberOfIncrements(halves.simulation(), 0.0, nSteps);
    halves.advance(*second, stop, nSteps, nSteps - stop);
    EXPECT_EQ(whole.values("Concentration"), halves.values("Concentration"));
    EXPECT_EQ(whole.values("Displacement"), halves.values("Displacement"));
  }
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
  expectToGoOn(parameters, 3, 8);
}

/// The lowest mode between held ends decays by the factor 1 - eigenvalue dt in a step of forward Euler.
const double eigenvalue = 4.0 * std::pow(std::sin(0.5 * M_PI / (nPoints - 1)), 2);
double mode(double x, double) { return std::sin(M_PI * x / (nPoints - 1)); }
const char* const heldEnds = "  Ends: {Type: Prescribed Concentration, Node Set: Ends Node Set, Value: \"0*t\"}\n";

TEST_F(StaggeredTest, AListOfTheTwoIsTheTwo) {
  SolverScene list(comm, chain, conditions), pair(comm, chain, conditions);
  const auto one =
                 list.make("Staggered",
                           "{Load Steps: 5, Solvers: {Hydrogen: {Diffusion: {Method: RKC, Relative Tolerance: 1e-5}}, "
                           "Equilibrium: {Adaptive Dynamic Relaxation: {Iterations Per Load Step: 3}}}}"),
             other =
                 pair.make("Staggered",
                           "{Load Steps: 5, Diffusion: {Method: RKC, Relative Tolerance: 1e-5}, Mechanics: {Adaptive "
                           "Dynamic Relaxation: {Iterations Per Load Step: 3}}}");
  list.start("Concentration", none);
  pair.start("Concentration", none);
  list.run(*one, 0.0, 1.7);
  pair.run(*other, 0.0, 1.7);
  EXPECT_EQ(list.values("Concentration"), pair.values("Concentration"));
  EXPECT_EQ(list.values("Displacement"), pair.values("Displacement"));
}

TEST_F(StaggeredTest, EveryAdvancesOverAllTheTimeSinceTheLastRunAndInTheLastLoadStep) {
  SolverScene scene(comm, chain, heldEnds);
  const auto solver = scene.make(
      "Staggered", "{Load Steps: 7, Solvers: {Hydrogen: {Diffusion: {Method: Euler, Sub Steps: 1}, Every: 3}}}");
  scene.start("Concentration", mode);
  scene.run(*solver, 0.0, 0.7);
  // Load steps 3, 6 and 7.
  const double amplitude = std::pow(1.0 - 0.3 * eigenvalue, 2) * (1.0 - 0.1 * eigenvalue);
  EXPECT_LT(scene.error("Concentration", [&](double x) { return amplitude * mode(x, 0.0); }), 1e-14);
  EXPECT_NE(solver->summary().front().find("Hydrogen: Diffusion ran in 3 of 7 load steps"), std::string::npos);
}

TEST_F(StaggeredTest, EveryAndWhenRunWhereEitherAsksForIt) {
  SolverScene scene(comm, chain, heldEnds);
  const auto solver =
      scene.make("Staggered",
                 "{Load Steps: 7, Solvers: {Hydrogen: {Diffusion: {Method: Euler, Sub Steps: 1}, Every: "
                 "3, When: {Field: Concentration, Has Changed By: 9.0}}}}");
  scene.start("Concentration", mode);
  scene.run(*solver, 0.0, 0.7);
  // Nothing changes by that much: load steps 3, 6 and 7.
  const double amplitude = std::pow(1.0 - 0.3 * eigenvalue, 2) * (1.0 - 0.1 * eigenvalue);
  EXPECT_LT(scene.error("Concentration", [&](double x) { return amplitude * mode(x, 0.0); }), 1e-14);
}

TEST_F(StaggeredTest, SubStepsAndTimeScaleAreThoseOfTheSolver) {
  SolverScene scene(comm, chain, heldEnds);
  const auto solver = scene.make("Staggered",
                                 "{Load Steps: 2, Solvers: {Hydrogen: {Diffusion: {Method: Euler, Sub Steps: 1}, Sub "
                                 "Steps: 4, Time Scale: 10.0}}}");
  scene.start("Concentration", mode);
  scene.run(*solver, 0.0, 0.2);
  const double amplitude = std::pow(1.0 - 0.25 * eigenvalue, 8);
  EXPECT_LT(scene.error("Concentration", [&](double x) { return amplitude * mode(x, 0.0); }), 1e-14);
}

TEST_F(StaggeredTest, ConditionsKeepTheTimeOfTheRun) {
  SolverScene scene(comm, chain,
                    "  All: {Type: Prescribed Concentration, Node Set: All Node Set, Value: \"3*t\"}\n"
                    "  Move: {Type: Prescribed Displacement, Node Set: All Node Set, Coordinate: x, Value: \"t*t\"}\n");
  const auto solver =
      scene.make("Staggered",
                 "{Load Steps: 4, Solvers: {Waves: {Verlet: {Fixed dt: 1.0}, Time Scale: 4.0}, Hydrogen: "
                 "{Diffusion: {Method: Euler, Sub Steps: 3}, Time Scale: 0.01}}}");
  scene.start("Concentration", none);
  scene.run(*solver, 0.0, 2.0);
  EXPECT_LT(scene.error("Concentration", [](double) { return 6.0; }), 1e-13);
  EXPECT_LT(scene.error("Displacement", [](double) { return 4.0; }), 1e-13);
  // Two steps of Verlet in a load step of half a second: the last one is from t = 1.75 to 2 s and takes 1 s of its own.
  EXPECT_LT(scene.error("Velocity", [](double) { return 4.0 - 1.75 * 1.75; }), 1e-12);
}

TEST_F(StaggeredTest, WhenCountsFromTheLastRun) {
  // The right end moves by 0.04 in a load step: by 0.12 in three.
  const std::string more = std::string(heldEnds) + conditions;
  const std::string moving = more.substr(0, more.find("  Hydrogen:"));
  SolverScene scene(comm, chain, moving);
  const auto solver =
      scene.make("Staggered",
                 "{Load Steps: 100, Solvers: {Equilibrium: {Adaptive Dynamic Relaxation: {}}, Hydrogen: "
                 "{Diffusion: {Method: Euler, Sub Steps: 1}, Time Scale: 0.1, When: {Field: Displacement, "
                 "Has Changed By: 0.1}}}}");
  scene.start("Concentration", mode);
  solver->initialize(scene.simulation());
  scene.advance(*solver, 0.0, 8.0, 8);
  const double amplitude = std::pow(1.0 - 0.3 * eigenvalue, 2);
  EXPECT_LT(scene.error("Concentration", [&](double x) { return amplitude * mode(x, 0.0); }), 1e-14);
}

TEST_F(StaggeredTest, ThreeSolversAreThoseThreeByHand) {
  const std::string damage = "{Damage Model: Test Length, Greatest Length: 1.021}";
  SolverScene together(comm, chain, conditions, damage), apart(comm, chain, conditions, damage);
  const std::string euler = "{Method: Euler, Sub Steps: 2}", relaxation = "{Relative Tolerance: 1e-9}";
  const auto solver = together.make(
      "Staggered", "{Load Steps: 8, Solvers: {Hydrogen: {Diffusion: " + euler +
                       ", Every: 2, Sub Steps: 3}, Equilibrium: {Adaptive Dynamic Relaxation: " + relaxation +
                       "}, Steady: {ImplicitDiffusion: {Field: Concentration}, When: {Field: Damage, Has "
                       "Changed By: 0.5}}}}");
  const auto diffusion = apart.make("Diffusion", euler),
             mechanics = apart.make("Adaptive Dynamic Relaxation", relaxation),
             steady = apart.make("ImplicitDiffusion", "{Field: Concentration}");
  together.start("Concentration", none);
  apart.start("Concentration", none);
  together.run(*solver, 0.0, 8.0);
  Simulation& simulation = apart.simulation();
  for (const auto& part : {diffusion, mechanics, steady}) part->initialize(simulation);
  for (int k = 0; k < 8; ++k) {
    if (k % 2 == 1)
      for (int part = 0; part < 3; ++part) {
        const double start = k - 1 + 2.0 * part / 3;
        diffusion->advance(simulation, start, k - 1 + 2.0 * (part + 1) / 3 - start);
      }
    mechanics->advance(simulation, k, 1.0);
    // The bonds break in the fifth load step, as above; the last one runs all.
    if (k == 4) steady->advance(simulation, 0.0, 5.0);
    if (k == 7) steady->advance(simulation, 5.0, 3.0);
  }
  EXPECT_EQ(together.error("Damage", [](double) { return 1.0; }), 0.0);
  EXPECT_EQ(together.values("Concentration"), apart.values("Concentration"));
  EXPECT_EQ(together.values("Displacement"), apart.values("Displacement"));
}

TEST_F(StaggeredTest, FewerSubStepsThanASolverNeedsAreRefused) {
  SolverScene scene(comm, chain, heldEnds);
  const auto solver =
      scene.make("Staggered", "{Load Steps: 1, Solvers: {Waves: {Verlet: {Fixed dt: 0.1}, Sub Steps: 9}}}");
  scene.start("Concentration", none);
  solver->initialize(scene.simulation());
  try {
    scene.advance(*solver, 0.0, 1.0, 1);
    ADD_FAILURE() << "nothing was refused";
  } catch (const RunError& error) {
    EXPECT_NE(std::string(error.what()).find("Waves: Verlet needs 10 increments"), std::string::npos) << error.what();
  }
}

TEST_F(StaggeredTest, AListGoesOnBitIdenticallyInTheMiddleOfEverything) {
  const std::string parameters =
      "{Load Steps: 9, Solvers: {Hydrogen: {Diffusion: {Method: RKC, Relative Tolerance: 1e-5}, Every: 4}, Waves: "
      "{Verlet: {Fixed dt: 0.3}, Sub Steps: 5}, Equilibrium: {QuasiStatic: {}, When: {Field: Concentration, Has "
      "Changed "
      "By: 0.3}}}}";
  expectToGoOn(parameters, 6, 9);
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
  EXPECT_EQ(messages("{Load Steps: 2, Solvers: {A: {Diffusion: {}}, B: {QuasiStatic: {}, Every: 2}}}"), "");
  const auto expectIn = [&](const std::string& parameters, const std::string& words) {
    EXPECT_NE(messages(parameters).find(words), std::string::npos) << messages(parameters);
  };
  expectIn("{Load Steps: 2, Solvers: {A: {Diffusion: {}}}, Diffusion: {}, Mechanics: {QuasiStatic: {}}}",
           "give only one of \"Solvers\", \"Diffusion\"");
  expectIn("{Load Steps: 2, Solvers: {A: 3}}", "List/Solvers/A must be a section");
  expectIn("{Load Steps: 2, Solvers: {A: {Every: 2}}}", "List/Solvers/A: give one of");
  expectIn("{Load Steps: 2, Solvers: {A: {Diffusion: {}, QuasiStatic: {}}}}", "give only one of");
  expectIn("{Load Steps: 2, Solvers: {A: {Diffusion: {}, Evry: 2}}}", "did you mean \"Every\"");
  expectIn("{Load Steps: 2, Solvers: {A: {Diffusion: {Load Steps: 2}}}}", "unknown key \"Load Steps\"");
  expectIn("{Load Steps: 2, Solvers: {A: {Diffusion: {}, When: {Field: C, Has Changed By: 0.0}}}}", "must be > 0");
  expectIn("{Load Steps: 2, Solvers: {A: {Diffusion: {}, Time Scale: -1.0}}}", "must be > 0");
}

TEST_F(StaggeredTest, TheSameSolverOfTheSameFieldsTwiceIsRefused) {
  SolverScene scene(comm, chain, conditions);
  EXPECT_THROW(scene.make("Staggered", "{Load Steps: 2, Solvers: {A: {Diffusion: {}}, B: {Diffusion: {}}}}"),
               std::invalid_argument);
  scene.make("Staggered", "{Load Steps: 2, Solvers: {A: {Diffusion: {}}, B: {Diffusion: {Field: Temperature}}}}");
}

}  // namespace
}  // namespace pd::test
