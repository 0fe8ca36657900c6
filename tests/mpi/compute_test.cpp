// Computes on a body whose points are dealt out to the ranks: the answers are those of one rank.
#include <gtest/gtest.h>
#include <mpi.h>

#include <cmath>

#include "../../driver/parallel/communicator.hpp"
#include "../support/corroded_body.hpp"

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
  Teuchos::ParameterList curved;
  curved.set<std::string>("Path", "Curved");
  for (const char* key : {"Start X", "Start Y"}) curved.set(key, 0.0);
  // The nearest way goes from the start to (1, 0.5), along the row, and on to where damage falls through the threshold.
  EXPECT_NEAR(run("Crack_Length", curved), std::sqrt(1.25) + 1.25, 1e-12);
  EXPECT_NEAR(run("Crack_Tip", curved, 0), 2.25, 1e-12);
}

TEST_F(DistributedComputes, CrackHangsTogetherAcrossRanks) {
  for (int i = 0; i < body.nPoints(); ++i)
    if (body.point(i)[0] == 5.0) body.field("Damage")[i] = 0.46;  // ahead of the crack, not connected
  EXPECT_NEAR(run("Crack_Tip", Teuchos::ParameterList()), 5.0, 1e-12);
  Teuchos::ParameterList parameters;
  parameters.set("Start X", -0.5);
  parameters.set("Start Y", -2.0);  // the line along y from there passes within a bond of the first column alone
  parameters.set("Direction X", 0.0);
  parameters.set("Direction Y", 1.0);
  EXPECT_NEAR(run("Crack_Tip", parameters, 1), 0.5, 1e-12);
  EXPECT_NEAR(run("Crack_Tip", parameters, 0), 1.0, 1e-12);  // the mean of the columns 0, 1 and 2
}

TEST_F(DistributedComputes, BrokenBondsAndReaction) {
  body.breakBonds([](const Point& a, const Point& b) { return a[1] * b[1] < 0.0; });
  EXPECT_EQ(run("Broken_Bonds", Teuchos::ParameterList()), 6.0 + 2.0 * 5.0);
  Teuchos::ParameterList parameters;
  parameters.set<std::string>("Node Set", "Some");
  EXPECT_NEAR(run("Reaction_Force", parameters, 2), -(3.0 * 4.0 + 7.0 * 8.0 + 10.0 * 11.0), 1e-12);
}

/// 4 x 8 points, spacings 25 and 1, every column dealt out over the ranks; two rows of electrolyte, metal below.
class DistributedCorrosion : public ::testing::Test {
 protected:
  DistributedCorrosion()
      : comm(Teuchos::rcp(new pd::Communicator(MPI_COMM_WORLD))),
        body(stretchedLattice({4, 8, 1}, {25.0, 1.0, 1.0}, {0.0, -1.5, 0.0}), options(*comm), 1) {
    body.dissolve([](const Point& x) { return depthAt(x[0]) - (x[1] - 0.5); });
    std::vector<int> surface;
    for (const int id : {8, 9, 10, 11})
      if (options(*comm).isOwned(id)) surface.push_back(id);
    body.addNodeSet("Surface", surface);
    onSurface.set<std::string>("Node Set", "Surface");
    onSurface.set("Into Y", 1.0);
    for (int i = 0; i < body.nOwned(); ++i) {
      const bool isNear = std::abs(body.point(i)[1] + 0.5) < 0.1;
      body.field("Interface_Area_Density")[i] = isNear ? 0.02 : 0.0;
      body.field("Current_Density")[i] = isNear ? 7.0 + 1e-9 * body.globalId(i) : 0.0;
    }
  }
  static double depthAt(double x) {
    const double depths[] = {0.0, 2.5, 3.25, 3.25 * (1.0 + 1e-9)};
    return depths[std::lround(x / 25.0)];
  }
  static BodyOptions options(const pd::Communicator& comm) {
    BodyOptions result;
    result.volumes.assign(32, 50.0);
    result.isOwned = [rank = comm.rank(), size = comm.size()](int id) { return (id + id / 4) % size == rank; };
    return result;
  }
  double run(const std::string& name, const Teuchos::ParameterList& parameters, int component = 0) {
    return body.run(name, parameters, component, comm);
  }

  Teuchos::RCP<pd::Communicator> comm;
  CorrodedBody body;
  Teuchos::ParameterList onSurface;
};

TEST_F(DistributedCorrosion, ColumnsAreCutByThePartition) {
  run("Corrosion_Depth", onSurface);
  for (int i = 0; i < body.nOwned(); ++i) {
    const bool isSurface = body.globalId(i) >= 8 && body.globalId(i) < 12;
    EXPECT_NEAR(body.field("Corrosion_Depth")[i], isSurface ? depthAt(body.point(i)[0]) : 0.0, 1e-12);
  }
  EXPECT_NEAR(run("Mean_Depth", onSurface), 9.0 / 4.0, 1e-8);
  EXPECT_NEAR(run("Maximum_Depth", onSurface), 3.25, 1e-8);
  EXPECT_NEAR(run("Deepest_Place", onSurface), 50.0, 1e-12);
  EXPECT_NEAR(run("Volume_Loss", Teuchos::ParameterList()), 50.0 * 9.0, 1e-6);
  Teuchos::ParameterList deepest = onSurface;
  deepest.set<std::string>("Measure", "Deepest");
  EXPECT_NEAR(run("Maximum_Depth", deepest), 3.25, 1e-8);
  Teuchos::ParameterList binned = onSurface;  // two columns in a bin
  binned.set("Column Width", 50.0);
  EXPECT_NEAR(run("Maximum_Depth", binned), 3.25, 1e-8);
  EXPECT_NEAR(run("Mean_Depth", binned), 9.0 / 4.0, 1e-8);
}

TEST_F(DistributedCorrosion, CurrentAndItsPlace) {
  EXPECT_NEAR(run("Total_Current", Teuchos::ParameterList()), 4.0 * 7.0, 1e-6);
  EXPECT_NEAR(run("Mean_Current_Density", Teuchos::ParameterList()), 7.0, 1e-6);
  // Alike but for rounding: the lowest global id, 4.
  EXPECT_EQ(run("Current_Place", Teuchos::ParameterList(), 0), 0.0);
  EXPECT_EQ(run("Current_Place", Teuchos::ParameterList(), 1), -0.5);
  Teuchos::ParameterList centre;
  centre.set<std::string>("Of", "Centre");
  EXPECT_NEAR(run("Current_Place", centre, 0), 37.5, 1e-6);
}

}  // namespace
