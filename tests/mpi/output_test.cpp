// Files of fields and checkpoints: the same from any number of ranks, and readable by any other number.
#include "driver/output/output.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <thread>

#include "../model_plugins.hpp"
#include "../test_folder.hpp"
#include "driver/model/model.hpp"
#include "driver/output/checkpoint.hpp"
#include "driver/output/field_writer.hpp"
#include "driver/output/global_order.hpp"
#include "lattice.hpp"

namespace pd::test {
namespace {

const Lattice lattice{7, 5, 1, 1.5};

/// All ranks, each rank by itself, and where there are four, pairs of them.
class OutputOnRanks : public ::testing::Test {
 protected:
  Communicator world{MPI_COMM_WORLD};
  Communicator alone{MPI_COMM_SELF};
  TestFolder folder{"pd_output_mpi_test_" + std::to_string(world.size()), world.isRoot()};
  // Only names that this rank uses by itself.
  std::string own(const std::string& name) const { return folder / (name + std::to_string(world.rank())); }
  void SetUp() override { world.barrier(); }
  void TearDown() override { world.barrier(); }
};

TEST_F(OutputOnRanks, PointsMoveToRowsAndBack) {
  const Discretization points = lattice.discretization(world);
  const GlobalOrder order(world, points.globalIds, points.nOwned, points.nGlobal);
  EXPECT_EQ(world.sum(order.rows().count), lattice.size());
  std::vector<int> values;
  for (int i = 0; i < points.nOwned; ++i)
    for (int k = 0; k < 2; ++k) values.push_back(10 * points.globalIds[i] + k);
  const std::vector<int> rows = order.toRows(values.data(), 2);
  ASSERT_EQ(static_cast<long long>(rows.size()), 2 * order.rows().count);
  for (std::size_t i = 0; i < rows.size(); ++i)
    EXPECT_EQ(rows[i], 10 * (order.rows().first + static_cast<long long>(i) / 2) + static_cast<long long>(i) % 2);
  std::vector<int> back(values.size());
  order.toPoints(rows, 2, back.data());
  EXPECT_EQ(back, values);
}

TEST_F(OutputOnRanks, ListsOfDifferingLengthMoveToRowsAndBack) {
  const Discretization points = lattice.discretization(world);
  const GlobalOrder order(world, points.globalIds, points.nOwned, points.nGlobal);
  std::vector<int> counts, values;
  for (int i = 0; i < points.nOwned; ++i) {
    const int id = points.globalIds[i];
    counts.push_back(id % 4);
    for (int k = 0; k < id % 4; ++k) values.push_back(100 * id + k);
  }
  const std::vector<int> rowCounts = order.toRows(counts.data(), 1);
  const std::vector<int> rows = order.listsToRows(values, counts, rowCounts);
  std::vector<int> expected;
  for (long long id = order.rows().first; id < order.rows().first + order.rows().count; ++id)
    for (int k = 0; k < id % 4; ++k) expected.push_back(static_cast<int>(100 * id + k));
  EXPECT_EQ(rows, expected);
  EXPECT_EQ(order.listsToPoints(rows, rowCounts, counts), values);
}

TEST_F(OutputOnRanks, RefusesIdsThatAreNotAPermutation) {
  Discretization points = lattice.discretization(world);
  if (world.isRoot()) points.globalIds[0] = points.globalIds[1];
  EXPECT_THROW(GlobalOrder(world, points.globalIds, points.nOwned, points.nGlobal), RunError);
}

/// A file of two steps whose values follow from global ids.
void writeSeries(const Communicator& comm, const std::string& name) {
  const Discretization points = lattice.discretization(comm);
  const GlobalOrder order(comm, points.globalIds, points.nOwned, points.nGlobal);
  FieldWriter writer(name, order, points.x.data(), points.blockId.data(), points.volume.data(), 0);
  std::vector<double> damage, displacement;
  for (int i = 0; i < points.nOwned; ++i) {
    damage.push_back(std::sqrt(points.globalIds[i]));
    for (int k = 0; k < 3; ++k) displacement.push_back(points.globalIds[i] + 0.1 * k);
  }
  for (const int step : {0, 20})
    writer.write(step, 0.5 * step, {{"Damage", 1, damage.data(), "1"}, {"Displacement", 3, displacement.data(), "m"}});
}

TEST_F(OutputOnRanks, FieldFilesAreTheSameToTheByte) {
  writeSeries(world, folder / "all/plate");
  if (world.isRoot()) writeSeries(alone, folder / "one/plate");
  world.barrier();
  for (const char* name :
       {"plate.h5", "plate.xdmf", "plate.steps/mesh.h5", "plate.steps/000000.h5", "plate.steps/000020.h5"}) {
    const std::string content = contentOf(folder / (std::string("all/") + name));
    EXPECT_FALSE(content.empty()) << name;
    EXPECT_EQ(content, contentOf(folder / (std::string("one/") + name))) << name;
  }
}

TEST_F(OutputOnRanks, AllRanksHearOfAFileThatCannotBeMade) {
  if (world.isRoot()) std::ofstream(folder / "file") << "no folder";
  world.barrier();
  try {
    writeSeries(world, folder / "file/plate");
    ADD_FAILURE() << "no error";
  } catch (const RunError& error) {
    EXPECT_NE(std::string(error.what()).find(folder / "file"), std::string::npos) << error.what();
  }
}

// ---- checkpoints ----

const char* const deckText =
    "Materials: {Soft: {Material Model: Test Springs, Stiffness: 1.0}}\n"
    "Damage Models: {Length: {Damage Model: Test Length, Greatest Length: 100.0}}\n"
    "Blocks: {All: {Block Names: default, Material: Soft, Damage Model: Length, Horizon: 1.5}}\n";

double* bondDamage(Model& model) {
  double* values = nullptr;
  model.blocks()->front().getData(FieldManager::self().getFieldId("Bond_Damage"), STEP_NP1)->ExtractView(&values);
  return values;
}

/// Calls visit(place in the bond's field, global id of its point, of the other end).
template <class Visit>
void forEachBond(Model& model, const Visit& visit) {
  const Discretization& points = model.discretization();
  const int* list = points.neighborhoodList.data();
  int bond = 0;
  for (int i = 0; i < points.nOwned; ++i)
    for (int n = *list++; n > 0; --n, ++bond, ++list) visit(bond, points.globalIds[i], points.globalIds[*list]);
}

double displacementOf(int id, int axis) { return std::sin(id + 0.3 * axis); }
double bondDamageOf(int from, int to) { return (from * 31 + to) % 7 == 0 ? 1.0 : 1.0 / (1.0 + from + 100.0 * to); }

struct Body {
  explicit Body(const Communicator& comm, const Lattice& shape = lattice)
      : deck(deckOf(deckText)), model(deck, comm, shape.discretization(comm), {}) {
    model.initialize();
    model.fieldAtN("Displacement");
  }
  void fill() {
    const Discretization& points = model.discretization();
    for (int i = 0; i < points.nPoints; ++i)
      for (int k = 0; k < 3; ++k) model.field("Displacement")[3 * i + k] = displacementOf(points.globalIds[i], k);
    for (int i = 0; i < points.nPoints; ++i) model.field("Concentration")[i] = 1.0 / (1.0 + points.globalIds[i]);
    double* damage = bondDamage(model);
    forEachBond(model, [&](int bond, int from, int to) { damage[bond] = bondDamageOf(from, to); });
  }
  void write(const std::string& fileName, const RestartState& state) {
    const Discretization& points = model.discretization();
    const GlobalOrder order(model.comm(), points.globalIds, points.nOwned, points.nGlobal);
    writeCheckpoint(model, order, fileName, {12, 0.25, "Test", state, "Solver: {}", {}});
  }
  void expectFilled() {
    const Discretization& points = model.discretization();
    for (int i = 0; i < points.nPoints; ++i) {
      for (int k = 0; k < 3; ++k) {
        EXPECT_EQ(model.field("Displacement")[3 * i + k], displacementOf(points.globalIds[i], k));
        EXPECT_EQ(model.fieldAtN("Displacement")[3 * i + k], displacementOf(points.globalIds[i], k));
      }
      EXPECT_EQ(model.field("Concentration")[i], 1.0 / (1.0 + points.globalIds[i]));
    }
    const double* damage = bondDamage(model);
    forEachBond(model, [&](int bond, int from, int to) { EXPECT_EQ(damage[bond], bondDamageOf(from, to)); });
  }
  Deck deck;
  Model model;
};

TEST_F(OutputOnRanks, CheckpointsAreReadOnTheSameRanks) {
  Body written(world);
  written.fill();
  const RestartState state = {{"steps", 3.0}, {"part/largest eigenvalue", 0.125}};
  written.write(folder / "state.checkpoint.h5", state);
  Body read(world);
  const Checkpoint checkpoint = readCheckpoint(read.model, folder / "state.checkpoint.h5");
  EXPECT_EQ(checkpoint.step, 12);
  EXPECT_EQ(checkpoint.time, 0.25);
  EXPECT_EQ(checkpoint.solver, "Test");
  EXPECT_EQ(checkpoint.state.entries(), state.entries());
  EXPECT_EQ(checkpoint.state.part("part").entries(), (RestartState{{"largest eigenvalue", 0.125}}).entries());
  EXPECT_EQ(checkpoint.deck, "Solver: {}");
  EXPECT_TRUE(checkpoint.missingFields.empty());
  read.expectFilled();
}

TEST_F(OutputOnRanks, CheckpointsAreReadOnOtherRanks) {
  const RestartState state = {{"steps", 1.0}, {"critical step", -2.5}};
  {
    Body all(world);
    all.fill();
    all.write(folder / "all.checkpoint.h5", state);
    std::this_thread::sleep_for(std::chrono::seconds(1));  // what time stamps count in
    Body one(alone);
    one.fill();
    one.write(own("one.checkpoint.h5"), state);
  }
  world.barrier();
  EXPECT_EQ(contentOf(folder / "all.checkpoint.h5"), contentOf(own("one.checkpoint.h5")));
  Body one(alone), all(world);
  EXPECT_EQ(readCheckpoint(one.model, folder / "all.checkpoint.h5").state.entries(), state.entries());
  one.expectFilled();
  EXPECT_EQ(readCheckpoint(all.model, folder / "one.checkpoint.h50").state.entries(), state.entries());
  all.expectFilled();
}

TEST_F(OutputOnRanks, AFlippedByteOfACheckpointIsFoundOrDoesNothing) {
  const std::string whole = folder / "whole.checkpoint.h5", flipped = folder / "flipped.checkpoint.h5";
  const RestartState state = {{"steps", 1.0}, {"critical step", -2.5}};
  {
    Body body(world);
    body.fill();
    body.write(whole, state);
  }
  const std::string content = contentOf(whole);
  int nRefused = 0;
  const std::size_t stride = content.size() / 61;
  for (std::size_t at = 0; at < content.size(); at += stride) {
    if (world.isRoot()) {
      std::string other = content;
      other[at] = static_cast<char>(other[at] ^ 0x10);
      std::ofstream(flipped, std::ios::binary) << other;
    }
    world.barrier();
    Body body(world);
    try {
      const Checkpoint checkpoint = readCheckpoint(body.model, flipped);
      // What is not read does no harm.
      EXPECT_EQ(checkpoint.step, 12) << "byte " << at;
      EXPECT_EQ(checkpoint.time, 0.25) << "byte " << at;
      EXPECT_EQ(checkpoint.state.entries(), state.entries()) << "byte " << at;
      EXPECT_EQ(checkpoint.deck, "Solver: {}") << "byte " << at;
      body.expectFilled();
    } catch (const RunError& error) {
      EXPECT_NE(std::string(error.what()).find("flipped.checkpoint.h5"), std::string::npos) << error.what();
      ++nRefused;
    }
    world.barrier();
  }
  EXPECT_GT(nRefused, 10);
}

TEST_F(OutputOnRanks, CheckpointsOfAnotherBodyAreRefused) {
  Body written(world);
  written.write(folder / "other.checkpoint.h5", {});
  const auto errorOf = [&](const Lattice& shape, const std::string& file) -> std::string {
    Body body(world, shape);
    try {
      readCheckpoint(body.model, file);
    } catch (const RunError& error) {
      return error.what();
    }
    return "no error";
  };
  const std::string file = folder / "other.checkpoint.h5";
  EXPECT_NE(errorOf({7, 6, 1, 1.5}, file).find("another mesh"), std::string::npos);
  EXPECT_NE(errorOf({5, 7, 1, 1.5}, file).find("another mesh"), std::string::npos);
  EXPECT_NE(errorOf({7, 5, 1, 2.0}, file).find("other neighbourhoods"), std::string::npos);
  EXPECT_NE(errorOf(lattice, folder / "missing.h5").find("missing.h5"), std::string::npos);
  if (world.isRoot()) std::ofstream(folder / "text.h5") << "This is not an HDF5 file.";
  world.barrier();
  EXPECT_NE(errorOf(lattice, folder / "text.h5").find("text.h5"), std::string::npos);
}

}  // namespace
}  // namespace pd::test
