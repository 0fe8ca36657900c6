// What lies along the bonds of a point.
#include "bond_path.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <utility>

namespace {

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

}  // namespace
