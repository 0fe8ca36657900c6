// Histories of bonds under every solver: a step counts once, however often its state was evaluated.
#include <gtest/gtest.h>
#include <mpi.h>

#include "../solver_scene.hpp"
#include "../support/life_damage.hpp"
#include "../test_folder.hpp"
#include "driver/output/checkpoint.hpp"
#include "driver/output/output.hpp"

namespace pd::test {
namespace {

constexpr double stretch = 0.01, lossPerStep = 0.01;  // 50 steps take half of the life
constexpr int nSteps = 50;

/// A row that is stretched evenly and held so.
class Row {
 public:
  explicit Row(const Communicator& comm, const std::string& value = "0.01*x")
      : scene(comm, Lattice{9, 1, 1, 1.0},
              "  Stretched: {Type: Prescribed Displacement, Node Set: All Node Set, Coordinate: x, Value: \"" + value +
                  "\"}\n",
              "{Damage Model: Test Life, Loss: " + std::to_string(lossPerStep / (stretch * stretch)) + "}",
              "{Material Model: Test Springs, Stiffness: 1.0, Breakable: false}") {}
  void start() {
    scene.start("Displacement", [](double x, double) { return stretch * x; });
  }
  /// Lost life of the bonds of this rank.
  std::vector<double> life() {
    std::vector<double> all;
    for (PeridigmNS::Block& block : *scene.model().blocks()) {
      const auto values = block.getData(FieldManager::self().getFieldId("Test_Lost_Life"), STEP_NP1);
      for (int i = 0; i < values->MyLength(); ++i) all.push_back((*values)[i]);
    }
    return all;
  }
  SolverScene scene;
};

class Steps : public ::testing::TestWithParam<std::pair<const char*, const char*>> {
 protected:
  Communicator comm{MPI_COMM_WORLD};
};

TEST_P(Steps, EachTakesItsPartOnce) {
  Row row(comm);
  const auto solver = row.scene.make(GetParam().first, GetParam().second);
  row.start();
  for (const double life : row.life()) EXPECT_EQ(life, 0.0);  // what was evaluated at the start is no step
  EXPECT_EQ(row.scene.run(*solver, 0.0, 1.0), nSteps);
  for (const double life : row.life()) EXPECT_NEAR(life, nSteps * lossPerStep, 1e-11);
  for (const double count : row.scene.values("Test_Accepted_Steps")) EXPECT_EQ(count, nSteps);
}

TEST_P(Steps, ARunGoesOnFromACheckpointToTheLastBit) {
  const TestFolder folder("pd_steps_test_" + std::to_string(comm.size()), comm.isRoot());
  comm.barrier();
  Row whole(comm), first(comm), second(comm);
  const auto& [name, parameters] = GetParam();
  const auto ofWhole = whole.scene.make(name, parameters), ofFirst = first.scene.make(name, parameters),
             ofSecond = second.scene.make(name, parameters);
  whole.start();
  whole.scene.run(*ofWhole, 0.0, 1.0);

  constexpr int nBefore = 20;
  const auto timeOf = [](int k) { return static_cast<double>(k) / nSteps; };
  const auto advance = [&](Row& row, Solver& solver, int from, int to) {
    for (int k = from; k < to; ++k) solver.advance(row.scene.simulation(), timeOf(k), timeOf(k + 1) - timeOf(k));
  };
  first.start();
  ofFirst->initialize(first.scene.simulation());
  advance(first, *ofFirst, 0, nBefore);
  const Discretization& points = first.scene.model().discretization();
  const GlobalOrder order(comm, points.globalIds, points.nOwned, points.nGlobal);
  writeCheckpoint(first.scene.model(), order, folder / "steps.h5",
                  {nBefore, timeOf(nBefore), name, ofFirst->restartState(), "", {}});

  second.start();
  const Checkpoint checkpoint = readCheckpoint(second.scene.model(), folder / "steps.h5");
  second.scene.simulation().conditions.resume(checkpoint.time);
  ofSecond->initialize(second.scene.simulation());
  ofSecond->setRestartState(checkpoint.state);
  advance(second, *ofSecond, nBefore, nSteps);
  EXPECT_EQ(second.life(), whole.life());
  EXPECT_EQ(second.scene.values("Test_Accepted_Steps"), whole.scene.values("Test_Accepted_Steps"));
}

INSTANTIATE_TEST_SUITE_P(
    Solvers, Steps,
    ::testing::Values(std::make_pair("Verlet", "{Fixed dt: 0.02}"), std::make_pair("QuasiStatic", "{Load Steps: 50}"),
                      std::make_pair("Adaptive Dynamic Relaxation", "{Load Steps: 50, Iterations Per Load Step: 3}"),
                      std::make_pair("Adaptive Dynamic Relaxation", "{Load Steps: 50}"),
                      std::make_pair("Staggered",
                                     "{Load Steps: 50, Diffusion: {Method: Euler}, "
                                     "Mechanics: {QuasiStatic: {}}}")));

TEST(TakenBack, AStepLeavesNoTrace) {
  const Communicator comm(MPI_COMM_WORLD);
  Row row(comm);
  row.start();
  Model& model = row.scene.model();
  model.evaluateDamage(1.0);
  model.acceptStep(1.0, 1.0);
  const std::vector<double> life = row.life(), u = row.scene.values("Displacement"),
                            damage = row.scene.values("Damage");
  model.beginStep();
  for (int attempt = 1; attempt <= 2; ++attempt) {
    for (int i = 0; i < model.nOwned(); ++i) model.field("Displacement")[3 * i] *= 30.0 * attempt;
    model.updateCoordinates();
    model.evaluateDamage(1.0);
    ASSERT_NE(row.scene.values("Damage"), damage);  // bonds break
    model.takeBackStep();
    EXPECT_EQ(row.life(), life);
    EXPECT_EQ(row.scene.values("Displacement"), u);
    EXPECT_EQ(row.scene.values("Damage"), damage);
  }
  model.evaluateDamage(1.0);
  for (const double lost : row.life()) EXPECT_NEAR(lost, 2.0 * lossPerStep, 1e-12);
}

}  // namespace
}  // namespace pd::test
