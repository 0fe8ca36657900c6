// Model and conditions on several ranks: sums over ghosts, agreement on errors. The points are scattered over the
// ranks, so that most bonds join two ranks; the expected values know nothing of ranks.
#include "driver/model/model.hpp"

#include <gtest/gtest.h>
#include <mpi.h>

#include <cmath>
#include <limits>

#include "../model_plugins.hpp"
#include "driver/boundary/boundary_conditions.hpp"
#include "driver/model/collective.hpp"
#include "driver/model/error_norms.hpp"
#include "lattice.hpp"

namespace pd::test {
namespace {

/// Prepares a field, and from what its neighbours have prepared finds another one; both reach ghosts.
class NonlocalDamage : public DamageModel, public FieldUser {
 public:
  struct Fields : FieldTable {
    FieldHandle own = writes(fields::pointScalar("Test_Own", "1", "A number of the point."), Ghosts::AfterPrecompute);
    FieldHandle sum = writes(fields::pointScalar("Test_Sum", "1", "Of the neighbours'."), Ghosts::AfterPrecompute);
    FieldHandle x = reads(pd::fields::modelCoordinates());
  };
  static void declareParameters(ParameterDeclarations&) {}
  explicit NonlocalDamage(const Teuchos::ParameterList& list) : DamageModel(list) {}
  std::string Name() const override { return "Test Nonlocal"; }
  const Fields& fields() const override { return fields_; }
  std::vector<int> FieldIds() const override { return fields_.ids(); }
  std::vector<int> FieldIdsForSynchronizationAfterPrecompute() const override {
    return fields_.ids(Ghosts::AfterPrecompute);
  }
  void precompute(const double, const int n, const int* owned, const int*, DataManager& data) const override {
    for (int k = 0; k < n; ++k) fields_.own.of(data)[owned[k]] = 1.0 + fields_.x.of(data)[3 * owned[k]];
  }
  void computeDamage(const double, const int n, const int* owned, const int* list, DataManager& data) const override {
    for (int k = 0; k < n; ++k) {
      double& sum = fields_.sum.of(data)[owned[k]] = 0.0;
      for (int nNeighbors = *list++; nNeighbors > 0; --nNeighbors) sum += fields_.own.of(data)[*list++];
    }
  }

 private:
  Fields fields_;
};
PD_REGISTER_DAMAGE_MODEL(NonlocalDamage, "Test Nonlocal", "Looks at what neighbours have prepared.")

class ModelMpiTest : public ::testing::Test {
 protected:
  static constexpr int side = 6;
  Communicator comm{MPI_COMM_WORLD};

  /// side x side points of unit spacing and volume; the right half is block_2 where `nBlocks` is 2.
  Discretization square(int nBlocks) const {
    Discretization points = Lattice{side, side, 1, 1.0}.discretization(comm);
    if (nBlocks == 2) {
      for (int i = 0; i < points.nPoints; ++i) points.blockId[i] = points.x[3 * i] < 0.5 * side ? 1 : 2;
      points.blockNumbers = {1, 2};
    }
    for (int i = 0; i < points.nPoints; ++i)
      if (points.x[3 * i] == side - 1) points.nodeSets["Right Node Set"].push_back(i);
    points.nodeSets["Right Node Set"];
    return points;
  }
  static double stiffnessAt(double x, int nBlocks) { return nBlocks == 2 && x >= 0.5 * side ? 2.0 : 1.0; }

  /// sum_j (k_i + k_j)/2 (v_j - v_i) with v = x^2 + y^2.
  static double expectedSum(const double* x, int nBlocks) {
    double sum = 0.0;
    const double step[4][2] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}};
    for (const auto& s : step) {
      const double other[] = {x[0] + s[0], x[1] + s[1]};
      if (other[0] < 0 || other[1] < 0 || other[0] >= side || other[1] >= side) continue;
      const double difference = other[0] * other[0] + other[1] * other[1] - x[0] * x[0] - x[1] * x[1];
      sum += 0.5 * (stiffnessAt(x[0], nBlocks) + stiffnessAt(other[0], nBlocks)) * difference;
    }
    return sum;
  }
};

TEST_F(ModelMpiTest, DamageModelsPrepareAndWhatTheyDeclareReachesGhosts) {
  const Deck deck = deckOf(
      "Materials: {Springs: {Material Model: Test Springs, Stiffness: 1.0}}\n"
      "Damage Models: {Nonlocal: {Damage Model: Test Nonlocal}}\n"
      "Blocks: {All: {Block Names: default, Material: Springs, Damage Model: Nonlocal, Horizon: 1.0}}\n");
  Model model(deck, comm, square(1), {});
  model.initialize();
  model.evaluateDamage(1.0);
  for (int i = 0; i < model.nPoints(); ++i) {
    const double* x = model.discretization().x.data() + 3 * i;
    double expected = 0.0;  // 1 + x of up to four neighbours
    for (const double step : {-1.0, 1.0}) {
      if (x[0] + step >= 0.0 && x[0] + step < side) expected += 1.0 + x[0] + step;
      if (x[1] + step >= 0.0 && x[1] + step < side) expected += 1.0 + x[0];
    }
    EXPECT_EQ(model.field("Test_Sum")[i], expected) << "point " << i;
  }
}

TEST_F(ModelMpiTest, ForcesAndFluxesSumOverRanksAndBlocks) {
  for (const int nBlocks : {1, 2}) {
    const Deck deck = deckOf(plateText());
    Model model(deck, comm, square(nBlocks), {});
    model.initialize();
    const auto& x = model.discretization().x;
    for (int i = 0; i < model.nOwned(); ++i) {
      const double value = x[3 * i] * x[3 * i] + x[3 * i + 1] * x[3 * i + 1];
      model.field("Displacement")[3 * i] = model.field("Concentration")[i] = value;
    }
    model.updateCoordinates();
    model.importGhosts("Concentration");
    model.evaluateForce(0.0);
    model.evaluateFluxDivergence(0.0, "Concentration_Flux_Divergence");
    for (int i = 0; i < model.nOwned(); ++i) {
      const double expected = expectedSum(x.data() + 3 * i, nBlocks);
      EXPECT_DOUBLE_EQ(model.field("Force_Density")[3 * i], expected) << nBlocks << " blocks, point " << i;
      EXPECT_DOUBLE_EQ(model.field("Concentration_Flux_Divergence")[i], expected) << nBlocks << " blocks, point " << i;
    }
    // precompute() ran once for initialize() and once here; its field is declared for synchronisation.
    for (int i = model.nOwned(); i < model.nPoints(); ++i) EXPECT_EQ(model.field("Prepared")[i], 2.0);
    const double total = model.dot(model.field("Volume"), model.field("Concentration_Flux_Divergence"), 1);
    EXPECT_NEAR(total, 0.0, 1e-11);  // nothing leaves; 36 values of up to 100
  }
}

TEST_F(ModelMpiTest, DamageOfGhostsIsUpToDate) {
  const Deck deck = deckOf(plateText(", Damage Model: Length"));
  Model model(deck, comm, square(2), {});
  model.initialize();
  const auto& x = model.discretization().x;
  for (int i = 0; i < model.nOwned(); ++i)
    if (x[3 * i] >= 3.0) model.field("Displacement")[3 * i] = 0.6;  // opens the bonds between x = 2 and x = 3
  model.updateCoordinates();
  model.evaluateDamage(0.0);
  for (int i = 0; i < model.nPoints(); ++i) {
    const bool isLip = x[3 * i] == 2.0 || x[3 * i] == 3.0;
    const bool isEdge = x[3 * i + 1] == 0.0 || x[3 * i + 1] == side - 1;
    EXPECT_DOUBLE_EQ(model.field("Damage")[i], isLip ? (isEdge ? 1.0 / 3.0 : 0.25) : 0.0);
  }
}

TEST_F(ModelMpiTest, SourcesAndTractionsCountEveryPointOnce) {
  const Deck deck = deckOf(plateText(", Damage Model: Length") +
                           "Boundary Conditions:\n"
                           "  Load: {Type: Traction, Node Set: Right Node Set, Coordinate: y, Value: 5.0, Area: 3.0}\n"
                           "  Faces: {Type: Saturated Crack Faces, Field: Concentration, Value: 7.0, "
                           "Threshold: 0.3}\n");
  Model model(deck, comm, square(1), {});
  BoundaryConditions conditions(deck, model);
  conditions.applyInitial();
  model.initialize();
  std::vector<double> force(3 * static_cast<std::size_t>(model.nOwned()), 0.0);
  conditions.addExternalForce(0.0, force.data());
  double total = 0.0;
  for (int i = 0; i < model.nOwned(); ++i) total += force[3 * i + 1];
  EXPECT_NEAR(comm.sum(total), 15.0, 1e-13);
  for (int i = 0; i < model.nPoints(); ++i)
    model.field("Damage")[i] = model.discretization().x[3 * i] == 2.0 ? 0.5 : 0.0;
  EXPECT_EQ(conditions.updateDamageSources(), side);
  for (int i = 0; i < model.nPoints(); ++i)
    EXPECT_EQ(model.field("Concentration")[i], model.discretization().x[3 * i] == 2.0 ? 7.0 : 0.0);
}

TEST_F(ModelMpiTest, ErrorNormsAreThoseOfAllPoints) {
  const Deck deck = deckOf(plateText() +
                           "Exact Solution:\n"
                           "  - {Field: Concentration, Value: \"2*t\"}\n"
                           "  - {Field: Displacement, Coordinate: y, Value: 0.0, Node Set: Right Node Set}\n");
  Model model(deck, comm, square(1), {});
  for (int i = 0; i < model.nOwned(); ++i) {
    const double* x = model.discretization().x.data() + 3 * i;
    model.field("Concentration")[i] = 6.0 + (x[0] == 0.0 && x[1] == 0.0 ? 3.0 : 0.0);
    model.field("Displacement")[3 * i + 1] = x[0] == side - 1 ? 2.0 : 100.0;
  }
  const auto norms = ErrorNorms(deck, model).evaluate(3.0);
  ASSERT_EQ(norms.size(), 4u);
  EXPECT_EQ(norms[0].first, "Concentration relative L2 error");
  EXPECT_NEAR(norms[0].second, 0.5 / side, 1e-15);  // one point of side^2 is off by half of the exact value
  EXPECT_EQ(norms[1].first, "Concentration relative maximum error");
  EXPECT_DOUBLE_EQ(norms[1].second, 0.5);
  EXPECT_EQ(norms[2].first, "Displacement y absolute L2 error");
  EXPECT_NEAR(norms[2].second, 2.0 * std::sqrt(side), 1e-14);
  EXPECT_DOUBLE_EQ(norms[3].second, 2.0);
}

TEST_F(ModelMpiTest, AnErrorOfOneRankIsThrownOnAll) {
  const int last = comm.size() - 1;
  const auto failOnLast = [&] {
    if (comm.rank() == last) throw std::invalid_argument("rank " + std::to_string(comm.rank()) + " refuses");
  };
  try {
    collectively(comm, failOnLast);
    ADD_FAILURE();
  } catch (const DeckError& error) {
    EXPECT_EQ(std::string(error.what()), "rank " + std::to_string(last) + " refuses");
  }
  // The same message of several ranks is shown once.
  try {
    collectively(comm, [] { throw std::runtime_error("disk full"); });
    ADD_FAILURE();
  } catch (const RunError& error) {
    EXPECT_EQ(std::string(error.what()), "disk full");
  }
}

TEST_F(ModelMpiTest, ANanOfOneRankStopsAll) {
  const Deck deck = deckOf(plateText());
  Model model(deck, comm, square(1), {});
  for (int i = 0; i < model.nOwned(); ++i)
    if (model.discretization().globalIds[i] == 8)
      model.field("Concentration")[i] = std::numeric_limits<double>::infinity();
  try {
    model.requireFinite("Concentration", 3);
    ADD_FAILURE();
  } catch (const RunError& error) {
    EXPECT_NE(std::string(error.what()).find("at point 9 (x = 2, y = 1,"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace pd::test
