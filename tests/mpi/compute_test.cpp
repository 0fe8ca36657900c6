// Computes on a body whose points are dealt out to the ranks: the answers are those of one rank.
#include <gtest/gtest.h>
#include <mpi.h>

#include "../../driver/parallel/communicator.hpp"
#include "../support/small_body.hpp"

using namespace pdtest;
using PeridigmNS::FieldManager;
namespace PeridigmField = PeridigmNS::PeridigmField;

namespace {

/// 6 x 2 points of volume 1 + id, dealt out one by one; Damage 1 in the first three columns, 0.06 beyond.
class DistributedComputes : public ::testing::Test {
 protected:
  DistributedComputes() : comm(Teuchos::rcp(new pd::Communicator(MPI_COMM_WORLD))), body(points(), options(*comm)) {
    using namespace PeridigmField;
    body.allocate({FieldManager::self().getFieldId(ELEMENT, SCALAR, TWO_STEP, "Damage"),
                   FieldManager::self().getFieldId(NODE, VECTOR, TWO_STEP, "Force_Density")});
    for (int i = 0; i < body.nPoints(); ++i) {
      body.field("Damage")[i] = body.point(i)[0] < 2.5 ? 0.46 : 0.06;
      body.field("Force_Density")[3 * i + 2] = body.globalId(i);
    }
    body.addNodeSet("Some", {0, 3, 7, 10});
  }
  static std::vector<Point> points() { return lattice(6, 2, 1, 1.0, {0.0, -0.5, 0.0}); }
  static BodyOptions options(const pd::Communicator& comm) {
    BodyOptions result;
    result.horizon = 1.5;
    for (int g = 0; g < 12; ++g) result.volumes.push_back(1.0 + g);
    result.blockOf = [](int id) { return id < 6 ? 1 : 2; };
    result.isOwned = [rank = comm.rank(), size = comm.size()](int id) { return id % size == rank; };
    return result;
  }
  double run(const std::string& name, const Teuchos::ParameterList& parameters, int component = 0) {
    makeCompute(body, name, parameters, comm)->compute(body.blocks());
    return body.value(parameters.isParameter("Output Label") ? parameters.get<std::string>("Output Label") : name,
                      component);
  }

  Teuchos::RCP<pd::Communicator> comm;
  SmallBody body;
};

TEST_F(DistributedComputes, MeanAndExtremes) {
  Teuchos::ParameterList parameters;
  parameters.set<std::string>("Variable", "Damage");
  // Volumes of the damaged points: 1 2 3 7 8 9 of 78 in all.
  EXPECT_NEAR(run("Field_Mean", parameters), (0.46 * 30.0 + 0.06 * 48.0) / 78.0, 1e-15);
  EXPECT_EQ(run("Field_Maximum", parameters), 0.46);
  EXPECT_EQ(run("Field_Minimum", parameters), 0.06);
}

TEST_F(DistributedComputes, NodeSetData) {
  Teuchos::ParameterList parameters;
  parameters.set<std::string>("Variable", "Volume");
  parameters.set<std::string>("Node Set", "Some");
  parameters.set<std::string>("Output Label", "Volume_Of_Some");
  parameters.set<std::string>("Calculation Type", "Sum");
  EXPECT_EQ(run("Node_Set_Data", parameters), 1.0 + 4.0 + 8.0 + 11.0);
  parameters.set<std::string>("Calculation Type", "Maximum");
  EXPECT_EQ(run("Node_Set_Data", parameters), 11.0);
}

TEST_F(DistributedComputes, NearestPointBreaksTiesByGlobalIdAcrossRanks) {
  Teuchos::ParameterList parameters;
  parameters.set<std::string>("Variable", "Volume");
  parameters.set<std::string>("Output Label", "Nearest_Volume");
  parameters.set("X", 3.5);
  parameters.set("Y", 0.0);
  parameters.set("Z", 0.0);
  EXPECT_EQ(run("Nearest_Point_Data", parameters), 4.0);
}

TEST_F(DistributedComputes, CrackTipAveragesLipsOfDifferentRanks) {
  EXPECT_NEAR(run("Crack_Tip", Teuchos::ParameterList(), 0), 2.25, 1e-12);
  EXPECT_NEAR(run("Crack_Tip", Teuchos::ParameterList(), 1), 0.0, 1e-12);
  EXPECT_NEAR(run("Crack_Length", Teuchos::ParameterList()), 2.25, 1e-12);
}

TEST_F(DistributedComputes, BrokenBondsAndReaction) {
  body.breakBonds([](const Point& a, const Point& b) { return a[1] * b[1] < 0.0; });
  EXPECT_EQ(run("Broken_Bonds", Teuchos::ParameterList()), 6.0 + 2.0 * 5.0);
  Teuchos::ParameterList parameters;
  parameters.set<std::string>("Node Set", "Some");
  EXPECT_NEAR(run("Reaction_Force", parameters, 2), -(3.0 * 4.0 + 7.0 * 8.0 + 10.0 * 11.0), 1e-12);
}

}  // namespace
