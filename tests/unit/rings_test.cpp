// Bonds between the rings of a body of revolution.
#include "rings.hpp"

#include <gtest/gtest.h>

#include <vector>

using pd::kernels::Rings;

namespace {

constexpr double spacing = 0.1;

/// Rings of one lattice line along y, the radius, half a spacing from the axis on, with mirror images below.
struct Line {
  Rings rings{"x"};
  std::vector<double> x;
  int nImages;
  explicit Line(int n, int images) : nImages(images) {
    for (int k = -images; k < n; ++k) x.insert(x.end(), {0.7, spacing * (k + 0.5), 0.0});
  }
  double radius(int k) const { return rings.radius(x.data(), k + nImages); }
  double share(int i, int j) const { return rings.share(x.data(), i + nImages, j + nImages, spacing); }
  /// Of r^2 at ring i, by bonds `length` spacings long alone whose weights in the plane are exact.
  double laplacian(int i, int length) const {
    double sum = 0.0;
    for (const int j : {i - length, i + length}) {
      const double change = radius(j) * radius(j) - radius(i) * radius(i);
      sum += share(i, j) * change / (length * length * spacing * spacing);
    }
    return sum;
  }
};

TEST(Rings, VolumesAreThoseOfPappus) {
  const Rings about_y("y");
  const std::vector<double> x{-0.3, 5.0, 0.0}, volume{2.0 * M_PI * 0.3 * 0.01};
  EXPECT_EQ(about_y.radial(), 0u);
  EXPECT_NEAR(about_y.planeVolume(x.data(), volume.data(), 0), 0.01, 1e-16);
  EXPECT_EQ(Rings().planeVolume(x.data(), volume.data(), 0), volume[0]);
  EXPECT_FALSE(Rings("").areUsed());
}

TEST(Rings, WhatLeavesOneArrivesAtTheOther) {
  const Line line(20, 3);
  for (int i = 0; i < 10; ++i)
    for (int j = 0; j < 20; ++j) {
      EXPECT_NEAR(line.radius(i) * line.share(i, j), line.radius(j) * line.share(j, i), 1e-15);
      EXPECT_GT(line.share(i, j), 0.0);
    }
}

TEST(Rings, NothingPassesThroughTheAxis) {
  const Line line(5, 3);
  for (int i = 0; i < 5; ++i)
    for (int j = -3; j < 0; ++j) EXPECT_EQ(line.share(i, j), 0.0);
}

TEST(Rings, BondsOfOneAndTwoSpacingsAreExactAtEveryRing) {
  const Line line(12, 3);
  for (int i = 0; i < 9; ++i)
    for (const int length : {1, 2}) EXPECT_NEAR(line.laplacian(i, length), 4.0, 1e-11) << i << ", " << length;
}

TEST(Rings, LongerBondsAreExactBeyondTheirLengthAndUpToThereAsAWhole) {
  const Line line(20, 6);
  for (const int length : {3, 5}) {
    double sum = 0.0, whole = 0.0;
    for (int i = 0; i < length; ++i) {
      sum += line.radius(i) * line.laplacian(i, length);
      whole += line.radius(i) * 4.0;
    }
    EXPECT_NEAR(sum, whole, 1e-11 * whole) << length;
    for (int i = length; i < 14; ++i) EXPECT_NEAR(line.laplacian(i, length), 4.0, 1e-11) << i << ", " << length;
  }
}

TEST(Rings, ABondThatEndsAtAWallCountsUpToThere) {
  const Line line(5, 0);
  const double half = line.rings.share(line.x.data(), 2, 3, spacing, 0.5);
  EXPECT_NEAR(half, (0.25 + 0.025) / 0.25, 1e-15);
}

}  // namespace
