// Diffusion between materials: what bonds carry that lead through layers of several diffusivities.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <map>
#include <random>

#include "../support/small_body.hpp"
#include "Peridigm_DegreesOfFreedomManager.hpp"
#include "bond_path.hpp"
#include "field_names.hpp"
#include "fields.hpp"
#include "plugins.hpp"

namespace {

using namespace pdtest;

/// The square lattice around the origin, points with x + y/2 > 1.2 having the value 5, others 1; bonds by their ends.
struct Square {
  pd::kernels::BondPaths paths;
  std::map<std::pair<int, int>, std::size_t> bonds;
  Square() {
    paths.startAt(1.0);
    for (int x = -3; x <= 3; ++x)
      for (int y = -3; y <= 3; ++y)
        if (x != 0 || y != 0) {
          bonds.emplace(std::make_pair(x, y), bonds.size());
          paths.add({1.0 * x, 1.0 * y, 0.0}, x + 0.5 * y > 1.2 ? 5.0 : 1.0);
        }
  }
  double mean(int x, int y) { return paths.mean(bonds.at({x, y})); }
};

TEST(BondPaths, PlacesHaveTheValueOfTheNearestPoint) {
  Square square;
  EXPECT_EQ(square.mean(1, 0), 1.0);
  EXPECT_EQ(square.mean(-3, 2), 1.0);
  EXPECT_DOUBLE_EQ(square.mean(2, 0), 0.75 + 0.25 * 5.0);             // behind the middle between 1 and 2
  EXPECT_DOUBLE_EQ(square.mean(3, 0), 0.5 + 0.5 * 5.0);               //
  EXPECT_DOUBLE_EQ(square.mean(1, 1), 0.5 + 0.5 * 5.0);               // past the corner of four cells
  EXPECT_DOUBLE_EQ(square.mean(2, 1), 0.5 + 0.5 * 5.0);               // by way of (1, 0) and (1, 1)
  EXPECT_DOUBLE_EQ(square.mean(3, -3), 5.0 / 6.0 + 1.0 / 6.0 * 5.0);  // by way of (1, -1) and (2, -2)
}

TEST(BondPaths, ALayerThatNothingPassesIsTight) {
  pd::kernels::BondPaths chain;
  chain.startAt(2.0);
  for (int x = 1; x <= 4; ++x) chain.add({1.0 * x, 0.0, 0.0}, x == 3 ? INFINITY : 2.0);
  EXPECT_EQ(chain.mean(1), 2.0);
  EXPECT_EQ(chain.mean(2), INFINITY);
  EXPECT_EQ(chain.mean(3), INFINITY);
}

struct Diffusive {
  const char* title;
  const char* model;
  bool isPlane, isBalanced;
  const char* label;
  std::function<Teuchos::ParameterList(double diffusivity)> parameters;
};

Teuchos::ParameterList hydrogen(double diffusivity) {
  Teuchos::ParameterList list;
  list.set("Diffusivity", diffusivity);
  list.set("Plane Stress", true);
  list.set("Horizon", 3.015);
  return list;
}

Teuchos::ParameterList temperature(double diffusivity) {
  Teuchos::ParameterList list;
  list.set("Coefficient", diffusivity);
  list.set("Horizon", 3.015);
  return list;
}

Teuchos::ParameterList ions(double diffusivity) {
  Teuchos::ParameterList list;
  list.set("Diffusivity", diffusivity);
  list.set("Plane Strain", true);
  list.set("Horizon", 3.015);
  list.set("Solid Concentration", 2e3);
  list.set("Saturation Concentration", 1e3);
  list.set("Charge Number", 2.0);
  list.set<std::string>("Current Density", "1.0");
  return list;
}

const std::vector<Diffusive> materials{{"Hydrogen", "PDHE", true, true, "Concentration", hydrogen},
                                       {"Temperature", "Diffusion", false, true, "Temperature", temperature},
                                       {"FittedTemperature", "Diffusion", false, false, "Temperature",
                                        [](double diffusivity) {
                                          Teuchos::ParameterList list = temperature(diffusivity);
                                          list.set("Use Improved Quadrature", true);
                                          return list;
                                        }},
                                       {"Ions", "Corrosion Dissolution", true, true, "Concentration", ions}};

class Entries : public PeridigmNS::SerialMatrix {
 public:
  std::map<std::pair<int, int>, double> values;
  void addValue(int row, int column, double value) override { values[{row, column}] += value; }
  void addValues(int, const int*, const double* const*) override {}
  void addBlockDiagonalValues(int, const int*, const double* const*) override {}
  void putScalar(double) override { values.clear(); }
};

/// Three blocks along x, the middle one a single layer: bonds lead from the first to the third through it.
class SeriesDiffusivity : public ::testing::TestWithParam<Diffusive> {
 protected:
  static constexpr int nx = 20, ny = 9;
  static constexpr double diffusivities[3] = {1.0, 1e-3, 20.0};
  static int blockOf(int column) { return column < 9 ? 0 : column < 10 ? 1 : 2; }

  SeriesDiffusivity() : body(lattice(nx, ny, GetParam().isPlane ? 1 : 7, 1.0), options()) {
    for (std::size_t b = 0; b < 3; ++b) {
      parts.push_back(pd::MaterialRegistry::self().create(GetParam().model, GetParam().parameters(diffusivities[b])));
      body.block(b).setMaterialModel(parts.back());
    }
    body.allocate(parts[0]->FieldIds());
    for (const int id : pd::fieldsIn(*parts[0]).sums())
      for (PeridigmNS::Block& block : *body.blocks()) block.getDataManager()->allocatePrivateData(id);
    forEachPart([](auto& part, auto... call) { part.initialize(0.1, call...); });
    if (body.hasField("Damage")) std::fill_n(body.field("Damage"), body.nPoints(), 1.0);
    forEachPart([](auto& part, auto... call) { part.precompute(0.1, call...); });
  }
  static BodyOptions options() {
    BodyOptions result;
    result.horizon = 3.515;
    result.blockOf = [](int id) { return 1 + blockOf(id % nx); };
    return result;
  }
  template <class Work>
  void forEachPart(Work work) {
    for (std::size_t b = 0; b < 3; ++b) {
      const auto points = body.block(b).getNeighborhoodData();
      work(*parts[b], points->NumOwnedPoints(), points->OwnedIDs(), points->NeighborhoodList(),
           *body.block(b).getDataManager());
    }
  }
  double* scalar() { return body.field(GetParam().label); }
  std::vector<double> rate() {
    forEachPart([](auto& part, auto... call) { part.computeFluxDivergence(0.1, call...); });
    std::vector<double> sum(static_cast<std::size_t>(body.nPoints()), 0.0);
    const std::string label = pd::fluxDivergenceField(GetParam().label);
    for (std::size_t b = 0; b < 3; ++b)
      for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += body.field(label, b)[i];
    return sum;
  }
  void fillAtRandom() {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> value(0.0, 900.0);
    for (int i = 0; i < body.nPoints(); ++i) scalar()[i] = value(random);
  }

  SmallBody body;
  std::vector<Teuchos::RCP<PeridigmNS::Material>> parts;
};

TEST_P(SeriesDiffusivity, TheSteadyProfileThroughLayersIsThatOfTheirResistances) {
  // A flux of 0.5 falls by 0.5/D a length; layers meet halfway between columns.
  std::vector<double> profile{900.0};
  for (int column = 1; column < nx; ++column)
    profile.push_back(profile.back() -
                      0.25 * (1.0 / diffusivities[blockOf(column - 1)] + 1.0 / diffusivities[blockOf(column)]));
  for (int i = 0; i < body.nPoints(); ++i) scalar()[i] = profile[static_cast<std::size_t>(body.point(i)[0])];
  const std::vector<double> rates = rate();
  double largest = 0.0, inside = 0.0;
  for (int i = 0; i < body.nPoints(); ++i) {
    const double x = body.point(i)[0], size = std::abs(rates[static_cast<std::size_t>(i)]);
    largest = std::max(largest, size);
    // Ends are open; corrections of ions at walls end a horizon further in.
    if (x > 6.5 && x < nx - 7.5) inside = std::max(inside, size);
  }
  EXPECT_GT(largest, 1e-3);
  EXPECT_LT(inside, 1e-11 * largest);
}

TEST_P(SeriesDiffusivity, WhatLeavesOnePointEntersAnother) {
  if (!GetParam().isBalanced) GTEST_SKIP() << "fitted weights are not balanced";
  fillAtRandom();
  double sum = 0.0, size = 0.0;
  for (const double value : rate()) {
    sum += value;
    size += std::abs(value);
  }
  EXPECT_LT(std::abs(sum), 1e-14 * size);
}

TEST_P(SeriesDiffusivity, TheTangentIsThatOfTheRate) {
  fillAtRandom();
  PeridigmNS::DegreesOfFreedomManager::self().setUnknowns({{GetParam().label, 1}});
  Entries tangent;
  forEachPart([&](auto& part, auto... call) {
    part.computeJacobian(0.1, call..., tangent, PeridigmNS::Material::FULL_MATRIX);
  });
  std::vector<double> products(static_cast<std::size_t>(body.nPoints()), 0.0);
  for (const auto& [place, value] : tangent.values)
    products[static_cast<std::size_t>(place.first)] += value * scalar()[place.second];
  const std::vector<double> rates = rate();
  for (std::size_t i = 0; i < rates.size(); ++i)
    ASSERT_NEAR(products[i], rates[i], 1e-9 * std::abs(rates[i]) + 1e-9) << i;  // volumes are 1
}

INSTANTIATE_TEST_SUITE_P(Materials, SeriesDiffusivity, ::testing::ValuesIn(materials),
                         [](const auto& given) { return std::string(given.param.title); });

TEST(PeridigmsDiffusion, LetsEachEndHaveTheConstantsOfItsBlock) {
  // T = x: the point in front of the interface gains what its own constants say, as if there were none.
  for (const bool isPeridigms : {true, false}) {
    BodyOptions options;
    options.horizon = 1.0;
    options.blockOf = [](int id) { return id < 3 ? 1 : 2; };
    SmallBody body(lattice(6, 1, 1, 1.0), options);
    double rate = 0.0;
    std::vector<Teuchos::RCP<PeridigmNS::Material>> parts;
    for (const double diffusivity : {1.0, 3.0}) {
      Teuchos::ParameterList list = temperature(diffusivity);
      list.set("Horizon", 1.0);
      if (isPeridigms) list.set<std::string>("Flux Between Blocks", "Own Constants");
      parts.push_back(pd::MaterialRegistry::self().create("Diffusion", list));
      body.allocate(parts.back()->FieldIds());
    }
    const int id = PeridigmNS::FieldManager::self().getFieldId("Flux_Divergence");
    for (const bool initializes : {true, false})
      for (std::size_t b = 0; b < 2; ++b) {
        const auto points = body.block(b).getNeighborhoodData();
        auto& data = *body.block(b).getDataManager();
        if (initializes) {
          data.allocatePrivateData(id);
          parts[b]->initialize(0.0, points->NumOwnedPoints(), points->OwnedIDs(), points->NeighborhoodList(), data);
          continue;
        }
        for (int i = 0; i < 6; ++i) body.field("Temperature")[i] = i;
        parts[b]->computeFluxDivergence(0.0, points->NumOwnedPoints(), points->OwnedIDs(), points->NeighborhoodList(),
                                        data);
        rate += body.field("Flux_Divergence", b)[2];
      }
    // Of a bond of length 1: 6/pi D; in series D is 1/(0.5/1 + 0.5/3) = 1.5.
    EXPECT_NEAR(rate, isPeridigms ? 0.0 : 6.0 / std::acos(-1.0) * (1.5 - 1.0), 1e-12);
  }
}

}  // namespace
