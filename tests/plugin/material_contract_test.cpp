// What every material must keep so that any host (this driver, Peridigm) may call it. Each registered material is run
// with the parameter sets of samples.cpp, on fields that hold nothing but what it declares.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "material_run.hpp"
#include "plugins.hpp"
#include "point_probe.hpp"

using namespace pdtest;

namespace {

/// Sums in another order differ by round-off alone.
constexpr double roundOff = 1e-12;

class MaterialContract : public ::testing::TestWithParam<Sample> {
 protected:
  static double valueAt(const Results& results, const std::string& label, std::size_t i) {
    const auto it = results.find(label);
    return it == results.end() ? 0.0 : it->second[i];
  }
};

TEST(MaterialContract, EveryRegisteredMaterialHasSamples) {
  std::set<std::string> sampled;
  for (const Sample& sample : materialSamples()) {
    sampled.insert(sample.plugin);
    for (auto it = sample.parameters.begin(); it != sample.parameters.end(); ++it)
      if (it->second.isList()) sampled.insert(sample.parameters.sublist(it->first).get<std::string>("Material Model"));
  }
  for (const std::string& name : pd::MaterialRegistry::self().names())
    EXPECT_TRUE(sampled.count(name) == 1 || name.find("Test ") == 0)
        << "add parameter sets of \"" << name << "\" to tests/plugin/samples.cpp";
}

TEST_P(MaterialContract, RunsOnTheFieldsThatItDeclares) {
  for (const bool isDamaged : {false, true}) {
    Layout layout;
    layout.isDamaged = isDamaged;
    Results results;
    ASSERT_NO_THROW(results = MaterialRun(GetParam(), layout).evaluate());
    double largest = 0.0;
    for (const auto& [label, values] : results)
      for (const double value : values) {
        ASSERT_TRUE(std::isfinite(value)) << label;
        largest = std::max(largest, std::abs(value));
      }
    EXPECT_GT(largest, 0.0);
  }
}

TEST_P(MaterialContract, ZeroesItsResultsBeforeItAddsToThem) {
  MaterialRun run(GetParam(), {});
  const Results first = run.evaluate();
  for (const std::string& label : run.summedFields())
    for (int i = 0; i < run.body().nPoints(); ++i) run.body().field(label)[i] += 17.0;
  EXPECT_EQ(relativeDifference(first, run.evaluate()), 0.0);
}

TEST_P(MaterialContract, InitializeIsIdempotent) {
  MaterialRun run(GetParam(), {});
  const Results once = run.evaluate();
  run.initialize();
  run.initialize();
  EXPECT_EQ(relativeDifference(once, run.evaluate()), 0.0);
}

TEST_P(MaterialContract, BlocksAndRanksMakeNoDifference) {
  for (const bool isDamaged : {false, true}) {
    Layout layout;
    layout.isDamaged = isDamaged;
    const Results whole = MaterialRun(GetParam(), layout).evaluate();
    layout.nBlocks = 2;
    EXPECT_LT(relativeDifference(whole, MaterialRun(GetParam(), layout).evaluate()), roundOff);
    layout.nRanks = 3;
    EXPECT_LT(relativeDifference(whole, MaterialRun(GetParam(), layout).evaluate()), roundOff);
    layout.nBlocks = 1;
    EXPECT_LT(relativeDifference(whole, MaterialRun(GetParam(), layout).evaluate()), roundOff);
  }
}

TEST_P(MaterialContract, BondStorageMakesNoDifference) {
  Layout layout;
  layout.isDamaged = true;
  const Results aliased = MaterialRun(GetParam(), layout).evaluate();
  for (const BondSteps steps : {BondSteps::Copied, BondSteps::Swapped}) {
    layout.bondSteps = steps;
    EXPECT_EQ(relativeDifference(aliased, MaterialRun(GetParam(), layout).evaluate()), 0.0);
  }
}

// Peridigm's finite-difference tangent calls a material with the neighbourhood of one point after the other, in a
// small data manager that may lie where the last one lay.
TEST_P(MaterialContract, NoticesThatItIsCalledForOtherPoints) {
  MaterialRun used(GetParam(), {});
  const Results before = used.evaluate();
  std::map<int, std::unique_ptr<PointProbe>> probes;  // by number of neighbours
  // Along z first: points that differ in one coordinate alone follow each other.
  std::vector<int> order(static_cast<std::size_t>(used.body().nOwned()));
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](int a, int b) { return used.body().point(a) < used.body().point(b); });
  for (const int i : order) {
    const int n = static_cast<int>(neighborsOf(used.body(), i).size());
    std::unique_ptr<PointProbe>& probe = probes[n];
    if (!probe) probe = std::make_unique<PointProbe>(used, n);
    probe->load(used, i);
    const Results reused = probe->evaluate(used.material());

    MaterialRun unused(GetParam(), {});
    unused.evaluate();  // as a host does before it probes: precompute() may prepare fields
    PointProbe own(unused, n);
    own.load(unused, i);
    ASSERT_LT(relativeDifference(own.evaluate(unused.material()), reused), roundOff) << "point " << i;
  }
  EXPECT_EQ(relativeDifference(before, used.evaluate()), 0.0);
}

TEST_P(MaterialContract, ConservesMomentumAndMass) {
  if (!GetParam().conserves) GTEST_SKIP() << "not claimed";
  for (const bool isDamaged : {false, true}) {
    Layout layout;
    layout.isDamaged = isDamaged;
    MaterialRun run(GetParam(), layout);
    const Results results = run.evaluate();
    const Scene& scene = run.scene();
    for (const std::string& label : run.summedFields()) {
      const std::size_t width = results.at(label).size() / scene.points.size();
      for (std::size_t k = 0; k < width; ++k) {
        double sum = 0.0, size = 0.0;
        for (std::size_t i = 0; i < scene.points.size(); ++i) {
          const double value = results.at(label)[width * i + k] * scene.volumes[i];
          sum += value;
          size += std::abs(value);
        }
        EXPECT_LE(std::abs(sum), roundOff * size) << label << " component " << k;
      }
    }
  }
}

TEST_P(MaterialContract, ConservesAngularMomentumWhereItSaysSo) {
  if (!GetParam().conservesAngularMomentum) GTEST_SKIP() << "not claimed";
  MaterialRun run(GetParam(), {});
  const Results results = run.evaluate();
  if (results.count("Force_Density") == 0) return;
  const Motion motion = someMotion(GetParam().dimension);
  double torque[3] = {0.0, 0.0, 0.0}, size = 0.0;
  for (std::size_t i = 0; i < run.scene().points.size(); ++i) {
    const Point y = motion(static_cast<int>(i), run.scene().points[i]);
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t a = (k + 1) % 3, b = (k + 2) % 3;
      const double* force = &results.at("Force_Density")[3 * i];
      torque[k] += run.scene().volumes[i] * (y[a] * force[b] - y[b] * force[a]);
      size += run.scene().volumes[i] * std::abs(y[a] * force[b]);
    }
  }
  for (const double component : torque) EXPECT_LE(std::abs(component), roundOff * size);
}

TEST_P(MaterialContract, TranslationMakesNoDifference) {
  MaterialRun run(GetParam(), {});
  const Results before = run.evaluate();
  const Motion motion = someMotion(GetParam().dimension);
  run.move([&](int id, const Point& x) {
    Point y = motion(id, x);
    for (int k = 0; k < GetParam().dimension; ++k) y[static_cast<std::size_t>(k)] += 3.0;
    return y;
  });
  // Strains of a per cent of bonds of 0.5, seen at coordinates around 3.
  EXPECT_LT(relativeDifference(before, run.evaluate()), 1e-11);
}

TEST_P(MaterialContract, ForcesTurnWithTheBodyWhereItSaysSo) {
  const Sample& sample = GetParam();
  if (!sample.isObjective || sample.dimension == 1) GTEST_SKIP() << "not claimed";
  MaterialRun run(sample, {});
  Results expected = run.evaluate();
  const double c = std::cos(0.8), s = std::sin(0.8);
  // About z in the plane; about a skew axis in space: z, then x.
  const auto rotate = [&](const double* v) {
    const Point inPlane{c * v[0] - s * v[1], s * v[0] + c * v[1], v[2]};
    if (sample.dimension == 2) return inPlane;
    return Point{inPlane[0], c * inPlane[1] - s * inPlane[2], s * inPlane[1] + c * inPlane[2]};
  };
  const Motion motion = someMotion(sample.dimension);
  run.move([&](int id, const Point& x) { return rotate(motion(id, x).data()); });
  for (std::size_t i = 0; i < expected["Force_Density"].size() / 3; ++i) {
    const Point turned = rotate(&expected["Force_Density"][3 * i]);
    std::copy(turned.begin(), turned.end(), &expected["Force_Density"][3 * i]);
  }
  if (expected["Force_Density"].empty()) expected.erase("Force_Density");
  EXPECT_LT(relativeDifference(expected, run.evaluate()), 1e-11);
}

std::string titleOf(const ::testing::TestParamInfo<Sample>& info) { return info.param.title; }
INSTANTIATE_TEST_SUITE_P(Materials, MaterialContract, ::testing::ValuesIn(materialSamples()), titleOf);

}  // namespace
