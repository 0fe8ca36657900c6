// Rates, gas, scans, wires and pits of bodies that dissolve by hand; expected numbers worked out from their geometry.
#include <gtest/gtest.h>

#include <cmath>

#include "../support/corroded_body.hpp"
#include "plugins.hpp"

using namespace pdtest;

namespace {

using List = Teuchos::ParameterList;

std::string complaint(const std::function<void()>& work) {
  try {
    work();
  } catch (const std::exception& error) {
    return error.what();
  }
  return "no complaint";
}

bool says(const std::string& text, const std::string& words) { return text.find(words) != std::string::npos; }

double gone(double depth, double y) { return depth - (y - 0.5); }

/// 20 by 8 points of volume 1: two rows of electrolyte, six of metal from y = 0 on.
class Slab : public ::testing::Test {
 protected:
  Slab() : body(stretchedLattice({20, 8, 1}, {1.0, 1.0, 1.0}, {0.0, -1.5, 0.0}), {}, 1) {
    std::vector<int> surface, electrolyte;
    for (int i = 0; i < 20; ++i) {
      surface.push_back(40 + i);
      electrolyte.push_back(20 + i);
      body.field("Interface_Area_Density")[20 + i] = 1.0;
    }
    body.addNodeSet("Surface", surface);
    body.addNodeSet("Electrolyte", electrolyte);
  }
  void sink(double depth) {
    body.dissolve([&](const Point& x) { return gone(depth, x[1]); });
  }
  void at(double time, double depth, PeridigmNS::Compute& compute) {
    if (body.hasField("Time")) body.field("Time")[0] = time;
    sink(depth);
    compute.compute(body.blocks());
  }
  CorrodedBody body;
};

TEST_F(Slab, RateIsThatOfAnImmersionTest) {
  const auto whole = makeCompute(body, "Corrosion_Rate");
  List parameters;
  parameters.set<std::string>("Over", "Last Interval").set<std::string>("Output Label", "Now");
  parameters.set("Surface Area", 10.0);
  const auto interval = makeCompute(body, "Corrosion_Rate", parameters);
  at(5.0, 0.0, *whole);
  interval->compute(body.blocks());
  EXPECT_EQ(body.value("Corrosion_Rate"), 0.0);
  at(15.0, 1.0, *whole);
  interval->compute(body.blocks());
  body.field("Interface_Area_Density")[25] = 7.0;  // later surface does not matter
  const double year = 8760.0 * 3600.0;
  // 20 m3 a metre thick from 20 m2 in 10 s.
  EXPECT_NEAR(body.value("Corrosion_Rate") / (0.1 * 1000.0 * year), 1.0, 1e-14);
  EXPECT_NEAR(body.value("Now") / (0.2 * 1000.0 * year), 1.0, 1e-14);
  at(35.0, 4.0, *whole);
  interval->compute(body.blocks());
  EXPECT_NEAR(body.value("Corrosion_Rate") / (4.0 / 30.0 * 1000.0 * year), 1.0, 1e-14);
  EXPECT_NEAR(body.value("Now") / (2.0 * 3.0 / 20.0 * 1000.0 * year), 1.0, 1e-14);
  interval->compute(body.blocks());
  EXPECT_NEAR(body.value("Now") / (0.3 * 1000.0 * year), 1.0, 1e-14);
}

TEST_F(Slab, HydrogenIsAMoleAMoleOfMagnesium) {
  const auto gas = makeCompute(body, "Hydrogen_Gas");
  at(0.0, 0.0, *gas);
  EXPECT_EQ(body.value("Hydrogen_Gas"), 0.0);
  at(1.0, 2.5, *gas);
  // 250 mol/m2 at 24.465 L/mol (298.15 K, 101325 Pa): 611.6 mL/cm2.
  EXPECT_NEAR(body.value("Hydrogen_Gas"), 250.0 * 24465.4 * 1e-4, 0.01);
  List parameters;
  parameters.set("Temperature", 273.15).set("Pressure", 1.0e5).set("Gas Per Metal", 1.5).set("Surface Area", 40.0);
  // Molar volume of the ideal gas at 273.15 K and 100 kPa, CODATA: 22.710 954 64 L/mol.
  EXPECT_NEAR(body.run("Hydrogen_Gas", parameters), 1.5 * 125.0 * 22710.95464e-4, 1e-5);
}

TEST_F(Slab, WithoutSurfaceOrMetalThereIsNoRate) {
  List ofSet;
  ofSet.set<std::string>("Node Set", "Surface");
  EXPECT_TRUE(says(complaint([&] { body.run("Hydrogen_Gas", ofSet); }), "\"Node Set\" needs \"Surface Area\""));
  ofSet.set<std::string>("Node Set", "Electrolyte");
  for (const char* name : {"Volume_Loss", "Dissolved_Amount", "Relative_Volume_Loss"})
    EXPECT_TRUE(says(complaint([&] { body.run(name, ofSet); }), "node set \"Electrolyte\" had no metal")) << name;
  for (int i = 0; i < body.nPoints(); ++i) body.field("Interface_Area_Density")[i] = 0.0;
  EXPECT_TRUE(says(complaint([&] { body.run("Corrosion_Rate", List()); }), "give Surface Area"));
}

TEST_F(Slab, LossCountsFromTheFirstScan) {
  List parameters;
  parameters.set("First Scan", 15.0);
  const auto since = makeCompute(body, "Relative_Volume_Loss", parameters);
  for (const double time : {0.0, 10.0, 10.0}) {
    at(time, 0.1 * time, *since);
    EXPECT_EQ(body.value("Relative_Volume_Loss"), 0.0);
  }
  // Of 6 rows 4.5 were there at the scan, between two evaluations.
  at(20.0, 2.0, *since);
  EXPECT_NEAR(body.value("Relative_Volume_Loss"), 100.0 * 0.5 / 4.5, 1e-12);
  at(20.0, 2.0, *since);
  at(40.0, 6.0, *since);
  EXPECT_NEAR(body.value("Relative_Volume_Loss"), 100.0, 1e-12);
  EXPECT_NEAR(body.run("Relative_Volume_Loss", List()), 100.0, 1e-12);
  sink(1.5);
  EXPECT_NEAR(body.run("Relative_Volume_Loss", List()), 25.0, 1e-12);
}

TEST_F(Slab, AScanAtAnEvaluationOrAtTheStart) {
  List parameters;
  parameters.set("First Scan", 10.0);
  const auto since = makeCompute(body, "Relative_Volume_Loss", parameters);
  parameters.set("First Scan", 0.0).set<std::string>("Output Label", "Pristine");
  const auto pristine = makeCompute(body, "Relative_Volume_Loss", parameters);
  for (const auto& [time, depth] : {std::pair(0.0, 0.0), std::pair(10.0, 3.0), std::pair(11.0, 4.5)}) {
    at(time, depth, *since);
    pristine->compute(body.blocks());
  }
  EXPECT_NEAR(body.value("Relative_Volume_Loss"), 50.0, 1e-12);
  EXPECT_NEAR(body.value("Pristine"), 75.0, 1e-12);
}

TEST_F(Slab, AScanWithoutMetalIsRefusedOnceItIsOver) {
  List parameters;
  parameters.set("First Scan", 15.0).set<std::string>("Output Label", "Late");
  const auto late = makeCompute(body, "Relative_Volume_Loss", parameters);
  for (const auto& [time, depth] : {std::pair(0.0, 0.0), std::pair(10.0, 6.0), std::pair(15.0, 6.0)}) {
    at(time, depth, *late);
    EXPECT_EQ(body.value("Late"), 0.0);
  }
  EXPECT_TRUE(says(complaint([&] { at(20.0, 6.0, *late); }), "\"Late\": at the First Scan no metal was left"));
}

TEST_F(Slab, AnotherScanMustBeToCome) {
  List parameters;
  const auto with = [&](double scan) {
    parameters.set("First Scan", scan);
    return makeCompute(body, "Relative_Volume_Loss", parameters);
  };
  const auto added = with(5.0);
  EXPECT_TRUE(says(complaint([&] { at(10.0, 1.0, *added); }), "\"Relative_Volume_Loss\": the First Scan lies before"));
  const auto first = with(15.0);
  for (const double time : {10.0, 20.0}) at(time, 0.1 * time, *first);
  for (const double scan : {10.0, 0.0, 16.0}) {
    const auto other = with(scan);
    EXPECT_TRUE(says(complaint([&] { at(30.0, 3.0, *other); }), "lies before the start of this run")) << scan;
  }
  // Of 6 rows 4 were there at the last evaluation, 2.5 between the next two.
  at(30.0, 3.0, *with(20.0));
  EXPECT_NEAR(body.value("Relative_Volume_Loss"), 100.0 * 1.0 / 4.0, 1e-12);
  at(40.0, 4.0, *with(35.0));
  EXPECT_NEAR(body.value("Relative_Volume_Loss"), 100.0 * 0.5 / 2.5, 1e-12);
}

/// Along z four layers, 0.3 apart; a disc of 12 by 12 points each, of which the outer ones go.
class Wire : public ::testing::Test {
 protected:
  Wire() : body(stretchedLattice({12, 12, 4}, {1.0, 1.0, 0.3}, {-5.5, -5.5, 0.1}), {}, 2) {
    parameters.set("First Diameter", 80e-6).set("Along Z", 2.0).set("Slice Width", 0.3);
  }
  CorrodedBody body;
  List parameters;
};

TEST_F(Wire, DiameterIsThatOfTheCircleThatIsLeft) {
  EXPECT_NEAR(body.run("Wire_Diameter", parameters), 80e-6, 1e-18);
  // 3/4, 1/4, 1 and 1 of the layers are left.
  body.dissolve([](const Point& x) { return x[2] < 0.2 ? 0.25 : x[2] < 0.5 ? 0.75 : 0.0; });
  EXPECT_NEAR(body.run("Wire_Diameter", parameters), 20e-6 * (std::sqrt(0.75) + 0.5 + 2.0), 1e-17);
  parameters.set<std::string>("Of", "Smallest");
  EXPECT_NEAR(body.run("Wire_Diameter", parameters), 40e-6, 1e-17);
  parameters.set("Slice Width", 0.6);
  EXPECT_NEAR(body.run("Wire_Diameter", parameters), 80e-6 * std::sqrt(0.5), 1e-17);
  body.dissolve([](const Point& x) { return x[2] < 0.8 ? 0.0 : 1.0; });
  parameters.set("Slice Width", 0.3);
  EXPECT_EQ(body.run("Wire_Diameter", parameters), 0.0);
}

TEST_F(Wire, ASectionNeedsNoSlicesButABodyDoes) {
  parameters.remove("Slice Width");
  EXPECT_TRUE(says(complaint([&] { body.run("Wire_Diameter", parameters); }), "give Slice Width"));
  CorrodedBody section(stretchedLattice({4, 8, 1}, {1.0, 1.0, 1.0}, {0.0, 0.5, 0.0}), {}, 1);
  section.dissolve([](const Point& x) { return x[1] < 6.0 ? 1.0 : 0.0; });
  EXPECT_NEAR(section.run("Wire_Diameter", parameters), 40e-6, 1e-17);
}

TEST_F(Slab, PitsOfARowAreCountedApart) {
  // Depths: 1.2 everywhere, pits of 3 at x = 2, 3 and of 5 at x = 9; a shallow one at the end.
  const auto depth = [](double x) { return x == 2.0 || x == 3.0 ? 3.0 : x == 9.0 ? 5.0 : x > 18.0 ? 2.0 : 1.2; };
  body.dissolve([&](const Point& x) { return gone(depth(x[0]), x[1]); });
  List parameters;
  parameters.set<std::string>("Node Set", "Surface");
  parameters.set("Into Y", 1.0).set("Deeper Than", 1.5);
  EXPECT_EQ(body.run("Pit_Count", parameters), 3.0);
  EXPECT_NEAR(body.run("Pit_Depth", parameters), 10.0 / 3.0, 1e-12);
  parameters.set("Deeper Than", 2.5);
  EXPECT_EQ(body.run("Pit_Count", parameters), 2.0);
  EXPECT_NEAR(body.run("Pit_Depth", parameters), 4.0, 1e-12);
  parameters.set("Deeper Than", 0.5);
  EXPECT_EQ(body.run("Pit_Count", parameters), 1.0);
  parameters.set("Deeper Than", 5.5);
  EXPECT_EQ(body.run("Pit_Count", parameters), 0.0);
  EXPECT_EQ(body.run("Pit_Depth", parameters), 0.0);
  List withoutDirection(parameters);
  withoutDirection.remove("Into Y");  // x is along the surface
  EXPECT_TRUE(says(complaint([&] { body.run("Pit_Count", withoutDirection); }), "runs along x"));
  parameters.set<std::string>("Node Set", "Electrolyte");
  parameters.set("Into Y", -1.0);
  EXPECT_TRUE(says(complaint([&] { body.run("Pit_Count", parameters); }), "no metal lies behind"));
}

/// Columns of a solid, turned about their direction: two pits that touch at a corner are one, a third is apart.
TEST(Pits, OfASolidHangTogetherAtCorners) {
  for (const double angle : {0.0, 0.6}) {
    const double c = std::cos(angle), s = std::sin(angle);
    std::vector<Point> points = stretchedLattice({10, 8, 6}, {2.0, 2.0, 1.0}, {0.0, 0.0, 0.5});
    const auto depthOf = [](std::size_t i) {
      const std::size_t x = i % 10, y = i / 10 % 8;
      if (x == 3 && y == 3) return 4.0;
      if (x == 4 && y == 4) return 3.0;
      return x == 7 && y < 3 ? 2.0 : 0.0;
    };
    for (Point& x : points) x = {c * x[0] - s * x[1], s * x[0] + c * x[1], x[2]};
    CorrodedBody body(points, {0.9, std::vector<double>(points.size(), 4.0)}, 2);
    std::vector<int> top;
    for (int i = 0; i < body.nPoints(); ++i) {
      const double share = std::clamp(gone(depthOf(static_cast<std::size_t>(i)), body.point(i)[2]), 0.0, 1.0);
      body.field("Damage")[i] = share;
      body.field("Concentration")[i] = solidConcentration - share * (solidConcentration - saturation);
      if (i < 80) top.push_back(i);
    }
    body.addNodeSet("Top", top);
    List parameters;
    parameters.set<std::string>("Node Set", "Top");
    parameters.set("Into Z", 1.0).set("Deeper Than", 0.5);
    EXPECT_EQ(body.run("Pit_Count", parameters), 2.0) << angle;
    EXPECT_NEAR(body.run("Pit_Depth", parameters), 3.0, 1e-12) << angle;
  }
}

TEST(Pits, ColumnsThatAreNoSquaresAreRefused) {
  std::vector<Point> points = stretchedLattice({6, 6, 4}, {9.0, 2.0, 1.0}, {0.0, 0.0, 0.5});
  CorrodedBody body(points, {0.9, std::vector<double>(points.size(), 18.0)}, 2);
  body.addNodeSet("Top", {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11});
  List parameters;
  parameters.set<std::string>("Node Set", "Top");
  parameters.set("Into Z", 1.0).set("Deeper Than", 0.5);
  EXPECT_TRUE(says(complaint([&] { body.run("Pit_Count", parameters); }), "give Column Width"));
}

}  // namespace
