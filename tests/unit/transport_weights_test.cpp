// Weights of dissolving bodies: horizons of any shape, and what corrects them at walls and slanting fronts.
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <vector>

#include "../../materials/corrosion/phase_geometry.hpp"
#include "horizon_shape.hpp"

namespace pd {
namespace {

constexpr double diffusivity = 7.2e-10;
const double pi = std::acos(-1.0);

using kernels::HorizonShape;

TEST(HorizonShapeTest, MapsItsSurfaceToABallOrACube) {
  for (const double degrees : {0.0, 30.0, 90.0}) {
    const HorizonShape ellipse({100e-6, 4e-6}, {degrees}, false), box({100e-6, 4e-6}, {degrees}, true);
    const double c = std::cos(degrees * pi / 180.0), s = std::sin(degrees * pi / 180.0);
    for (double angle = 0.0; angle < 6.0; angle += 0.1) {
      const double u = 100e-6 * std::cos(angle), v = 4e-6 * std::sin(angle);
      const double x[3] = {c * u - s * v, s * u + c * v, 0.0};
      EXPECT_NEAR(ellipse.length(ellipse.mapped(ellipse.along(x))), 100e-6, 1e-18);
      const double most = std::max(std::abs(std::cos(angle)), std::abs(std::sin(angle)));
      EXPECT_NEAR(box.length(box.mapped(box.along(x))), most * 100e-6, 1e-18);
    }
    EXPECT_DOUBLE_EQ(ellipse.volumeFactor(), 25.0);
  }
}

TEST(HorizonShapeTest, TurnsAboutThreeAxes) {
  // About x by 90 degrees y becomes z; then about z by 90 degrees x becomes y.
  const HorizonShape shape({3.0, 2.0, 1.0}, {90.0, 0.0, 90.0}, false);
  const double y[3] = {0.0, 1.0, 0.0}, z[3] = {0.0, 0.0, 1.0};
  EXPECT_NEAR(shape.along(y)[0], 1.0, 1e-15);
  EXPECT_NEAR(shape.along(z)[1], 1.0, 1e-15);
  EXPECT_EQ(shape.longestFirst(), (std::array<std::size_t, 3>{0, 1, 2}));
}

TEST(HorizonShapeTest, RefusesWhatIsNoShape) {
  EXPECT_THROW(HorizonShape({}, {}, false), std::invalid_argument);
  EXPECT_THROW(HorizonShape({1.0, 0.0}, {}, false), std::invalid_argument);
  EXPECT_THROW(HorizonShape({1.0, 1.0, 1.0, 1.0}, {}, false), std::invalid_argument);
  EXPECT_THROW(HorizonShape({1.0, 1.0}, {1.0, 2.0}, false), std::invalid_argument);
}

TransportWeights weightsOf(double ratio, bool isBox) {
  ParameterDeclarations declarations;
  TransportWeights::declareParameters(declarations);
  Teuchos::ParameterList list;
  list.set("Diffusivity", diffusivity);
  list.set("Plane Strain", true);
  list.set("Horizon", 4.0 * ratio);
  if (ratio != 1.0 || isBox) list.set("Horizon Axes", Teuchos::Array<double>(Teuchos::tuple(4.0 * ratio, 4.0)));
  if (isBox) list.set("Horizon Shape", std::string("Box"));
  TransportWeights weights(declarations.complete(list, "a test"), "a test");
  weights.fitToGrid(ratio);
  return weights;
}

/// A plane grid of unit spacing along y and `ratio` along x, all neighbours of each point within reach.
struct Grid {
  int n;
  std::vector<double> x, volume, damage;
  std::vector<std::vector<int>> neighbors;

  Grid(int count, double ratio) : n(count) {
    for (int b = 0; b < n; ++b)
      for (int a = 0; a < n; ++a) {
        x.insert(x.end(), {ratio * (a - 0.5 * n), b - 0.5 * n, 0.0});
        volume.push_back(ratio);
        damage.push_back(0.0);
        neighbors.emplace_back();
        for (int d = -5; d <= 5; ++d)
          for (int e = -5; e <= 5; ++e)
            if ((d != 0 || e != 0) && a + d >= 0 && a + d < n && b + e >= 0 && b + e < n)
              neighbors.back().push_back((b + e) * n + a + d);
      }
  }
  int size() const { return n * n; }
};

TEST(TransportWeightsTest, DiffusionIsExactAlongBothAxes) {
  for (const double ratio : {1.0, 5.0, 25.0, 100.0})
    for (const bool isBox : {false, true}) {
      if (ratio == 1.0 && !isBox) continue;  // a ball has the constants of the continuum
      const TransportWeights weights = weightsOf(ratio, isBox);
      const Grid grid(11, ratio);
      const int middle = grid.size() / 2;
      double moment[3] = {}, front[2] = {};
      for (const int j : grid.neighbors[static_cast<std::size_t>(middle)]) {
        const auto bond = weights.bond(grid.x.data(), middle, j);
        const double w = weights.diffusion(bond, ratio, ratio) * ratio,
                     q = weights.dissolution(bond, ratio, ratio) * ratio;
        ASSERT_GE(w, 0.0);
        moment[0] += 0.5 * w * bond.along[0] * bond.along[0];
        moment[1] += 0.5 * w * bond.along[1] * bond.along[1];
        moment[2] += 0.5 * w * bond.along[0] * bond.along[1];
        for (int d = 0; d < 2; ++d) front[d] += 0.5 * q * std::abs(bond.along[static_cast<std::size_t>(d)]);
      }
      EXPECT_NEAR(moment[0] / diffusivity, 1.0, 1e-12) << ratio;
      EXPECT_NEAR(moment[1] / diffusivity, 1.0, 1e-12) << ratio;
      EXPECT_NEAR(moment[2] / diffusivity, 0.0, 1e-12) << ratio;
      for (const double passed : front) EXPECT_NEAR(passed, 1.0, 1e-12) << ratio;
    }
}

TEST(TransportWeightsTest, RefusesMeshesThatAreNoGridAlongTheAxes) {
  const TransportWeights weights = weightsOf(25.0, false);
  Grid grid(11, 25.0);
  const int middle = grid.size() / 2;
  const auto& neighbors = grid.neighbors[static_cast<std::size_t>(middle)];
  const auto check = [&] {
    weights.checkGrid(grid.x.data(), grid.volume.data(), middle, neighbors.data(), static_cast<int>(neighbors.size()));
  };
  EXPECT_NO_THROW(check());
  for (std::size_t i = 0; i < grid.volume.size(); ++i) grid.x[3 * i] += 0.3 * 25.0 * std::sin(7.0 * double(i));
  EXPECT_THROW(check(), std::invalid_argument);
}

TEST(PhaseGeometryTest, AGapDiffusesWithTheFullDiffusivity) {
  // Mean over a straight gap of what its bonds diffuse along it, between bonds' ends.
  for (const double ratio : {1.0, 25.0}) {
    const TransportWeights weights = weightsOf(ratio, false);
    for (const int height : {1, 2, 4, 8}) {
      Grid grid(21, ratio);
      const int first = 10 - height / 2;
      std::vector<int> column;
      for (int i = 0; i < grid.size(); ++i) {
        const int row = i / grid.n;
        if (row < first || row >= first + height) continue;
        grid.damage[static_cast<std::size_t>(i)] = 1.0;
        if (i % grid.n == 10) column.push_back(i);
      }
      const PhaseGeometry geometry(weights, grid.x.data(), grid.volume.data(), grid.damage.data());
      const auto correction = [&](int i) {
        const auto& list = grid.neighbors[static_cast<std::size_t>(i)];
        return geometry.diffusionCorrection(i, list.data(), static_cast<int>(list.size()));
      };
      double total = 0.0;
      for (const int i : column)
        for (const int j : grid.neighbors[static_cast<std::size_t>(i)]) {
          if (grid.damage[static_cast<std::size_t>(j)] < 1.0) continue;
          const double across = grid.x[3 * static_cast<std::size_t>(j)] - grid.x[3 * static_cast<std::size_t>(i)];
          // Points of a row are alike.
          const int same = j / grid.n * grid.n + 10;
          total += 0.25 * (correction(i) + correction(same)) * geometry.diffusionWeight(i, j) * ratio * across * across;
        }
      EXPECT_NEAR(total / (diffusivity * height), 1.0, 1e-12) << ratio << ", " << height;
    }
  }
}

TEST(PhaseGeometryTest, SlantingFrontsPassTheirFlux) {
  const TransportWeights weights = weightsOf(1.0, false);
  for (const double degrees : {0.0, 10.0, 20.0, 30.0, 45.0}) {
    Grid grid(61, 1.0);
    const double c = std::cos(degrees * pi / 180.0), s = std::sin(degrees * pi / 180.0);
    for (int i = 0; i < grid.size(); ++i) {
      const auto at = static_cast<std::size_t>(i);
      grid.damage[at] = c * grid.x[3 * at + 1] - s * grid.x[3 * at] > 0.26 ? 0.0 : 1.0;
    }
    const PhaseGeometry geometry(weights, grid.x.data(), grid.volume.data(), grid.damage.data());
    // Of the front's middle, 30 columns wide.
    double flux = 0.0, uncorrected = 0.0;
    for (int i = 0; i < grid.size(); ++i) {
      if (grid.damage[static_cast<std::size_t>(i)] >= 1.0 || std::abs(i % grid.n - 30) > 15) continue;
      const auto& list = grid.neighbors[static_cast<std::size_t>(i)];
      double sum = 0.0;
      for (const int j : list)
        if (grid.damage[static_cast<std::size_t>(j)] >= 1.0) sum += geometry.dissolutionWeight(i, j);
      if (sum == 0.0) continue;
      uncorrected += sum;
      flux += sum * geometry.surface(i, list.data(), static_cast<int>(list.size())).plane;
    }
    const double width = 31.0 / c;
    EXPECT_NEAR(flux / width, 1.0, degrees == 0.0 ? 1e-12 : 0.04) << degrees << " without: " << uncorrected / width;
  }
}

}  // namespace
}  // namespace pd
