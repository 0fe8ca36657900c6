// Forces and pressures on points of unit volume, scattered over the ranks; the expected values know nothing of ranks.
#include <gtest/gtest.h>
#include <mpi.h>

#include <array>
#include <cmath>

#include "../model_plugins.hpp"
#include "../mpi/lattice.hpp"
#include "driver/boundary/boundary_conditions.hpp"

namespace pd::test {
namespace {

using Vector = std::array<double, 3>;

class LoadsTest : public ::testing::Test {
 protected:
  Communicator comm{MPI_COMM_WORLD};

  /// The points of the lattice where `isInSet` are "Loaded Node Set".
  template <class Place>
  Model modelOf(const Deck& deck, const Lattice& lattice, const Place& isInSet) const {
    Discretization points = lattice.discretization(comm);
    points.nodeSets["Loaded Node Set"];
    for (int i = 0; i < points.nPoints; ++i)
      if (isInSet(points.x.data() + 3 * i)) points.nodeSets["Loaded Node Set"].push_back(i);
    return Model(deck, comm, points, {});
  }
  static Deck deckWith(const std::string& load) {
    return deckOf(plateText() + "Boundary Conditions:\n  Load: {Node Set: Loaded Node Set, " + load + "}\n");
  }
  static std::vector<double> forcesAt(double t, const Deck& deck, Model& model) {
    BoundaryConditions conditions(deck, model);
    EXPECT_TRUE(conditions.hasExternalForce());
    std::vector<double> force(3 * static_cast<std::size_t>(model.nOwned()), 0.0);
    conditions.addExternalForce(t, force.data());
    return force;
  }
  Vector sumOf(const std::vector<double>& force) const {
    Vector own{}, all{};
    for (std::size_t i = 0; i < force.size(); ++i) own[i % 3] += force[i];
    comm.SumAll(own.data(), all.data(), 3);
    return all;
  }
  /// Sum of lengths.
  double sizeOf(const std::vector<double>& force) const {
    double sum = 0.0;
    for (std::size_t i = 0; i < force.size(); i += 3) sum += std::hypot(force[i], force[i + 1], force[i + 2]);
    return comm.sum(sum);
  }
  template <class Place>
  std::string errorOf(const std::string& load, const Lattice& lattice, const Place& isInSet) const {
    const Deck deck = deckWith(load);
    Model model = modelOf(deck, lattice, isInSet);
    try {
      BoundaryConditions conditions(deck, model);
    } catch (const DeckError& error) {
      return error.what();
    }
    return "no error";
  }

  static constexpr Lattice square{13, 13, 1, 1.0}, cube{9, 9, 9, 1.0};
  static bool isRight(const double* x) { return x[0] > 10.5; }
  /// Around a place that is none of the lattice's symmetry.
  static double radius(const double* x) { return std::hypot(x[0] - 6.3, x[1] - 5.8); }
  static bool isRing(const double* x) { return radius(x) > 3.0 && radius(x) < 4.5; }
  static bool isQuarter(const double* x) { return isRing(x) && x[0] > 6.3 && x[1] > 5.8; }
};

TEST_F(LoadsTest, AForceIsSharedByVolume) {
  const Deck deck = deckWith("Type: Force, Coordinate: y, Value: \"3*t\"");
  Model model = modelOf(deck, square, isRight);
  for (int i = 0; i < model.nPoints(); ++i)  // a graded mesh
    model.discretization().volume[i] = 1.0 + model.discretization().x[3 * i + 1];
  const std::vector<double> force = forcesAt(2.0, deck, model);
  const double volume = 2.0 * (13.0 + 78.0);  // two columns
  double own = 0.0;
  for (int i = 0; i < model.nOwned(); ++i) {
    const bool isLoaded = isRight(model.discretization().x.data() + 3 * i);
    EXPECT_DOUBLE_EQ(force[3 * i + 1], isLoaded ? 6.0 / volume : 0.0);
    EXPECT_EQ(force[3 * i], 0.0);
    own += force[3 * i + 1] * model.discretization().volume[i];
  }
  EXPECT_NEAR(comm.sum(own), 6.0, 1e-14);
}

TEST_F(LoadsTest, PressureOnAFlatFaceIsItsArea) {
  // The normal may have any length; a layer two deep carries what one of one would.
  const Deck deck = deckWith("Type: Pressure, Normal: [4, 0, 0], Area: 15.0, Value: \"2*t\"");
  Model model = modelOf(deck, square, isRight);
  const std::vector<double> force = forcesAt(3.5, deck, model);
  for (int i = 0; i < model.nOwned(); ++i)
    EXPECT_DOUBLE_EQ(force[3 * i], isRight(model.discretization().x.data() + 3 * i) ? -7.0 * 15.0 / 26.0 : 0.0);
  EXPECT_NEAR(sumOf(force)[0], -105.0, 1e-12);
  EXPECT_EQ(sumOf(force)[1], 0.0);
  const Deck slanted = deckWith("Type: Pressure, Normal: [3, 4, 0], Area: 15.0, Value: 1.0");
  Model other = modelOf(slanted, square, isRight);
  EXPECT_NEAR(sumOf(forcesAt(0.0, slanted, other))[0], -9.0, 1e-13);
  EXPECT_NEAR(sumOf(forcesAt(0.0, slanted, other))[1], -12.0, 1e-13);
}

TEST_F(LoadsTest, PressureInAClosedHoleHasNoResultant) {
  for (const double side : {1.0, -1.0}) {
    const Deck deck = deckWith("Type: Pressure, Center: [6.3, 5.8, 0], Area: 18.0, Value: 2.0, Side: " +
                               std::string(side > 0.0 ? "Inside" : "Outside"));
    Model model = modelOf(deck, square, isRing);
    const std::vector<double> force = forcesAt(0.0, deck, model);
    for (int d = 0; d < 3; ++d) EXPECT_NEAR(sumOf(force)[d], 0.0, 1e-13);
    EXPECT_NEAR(sizeOf(force), 2.0 * 18.0, 1e-12);
    for (int i = 0; i < model.nOwned(); ++i) {
      const double* x = model.discretization().x.data() + 3 * i;
      if (!isRing(x)) continue;
      const double along = side * (force[3 * i] * (x[0] - 6.3) + force[3 * i + 1] * (x[1] - 5.8)) / radius(x);
      EXPECT_NEAR(along, std::hypot(force[3 * i], force[3 * i + 1]), 1e-13);  // straight away from the Center
      EXPECT_GT(along, 0.5);                                                  // 35 points or so share 36 N
    }
  }
}

TEST_F(LoadsTest, PressureInAQuarterOfAHoleIsThatOfItsProjections) {
  // p r t on either symmetry plane, for the area pi/2 r t; the lattice is coarse.
  const Deck deck = deckWith("Type: Pressure, Center: [6.3, 5.8, 0], Area: 4.712389, Value: 1.0, Closed: false");
  Model model = modelOf(deck, square, isQuarter);
  const Vector sum = sumOf(forcesAt(0.0, deck, model));
  EXPECT_NEAR(sum[0], 3.0, 0.3);
  EXPECT_NEAR(sum[1], 3.0, 0.3);
}

TEST_F(LoadsTest, PressureInABoreAndInACavity) {
  const auto isBore = [](const double* x) {
    const double r = std::hypot(x[1] - 4.2, x[2] - 3.9);
    return r > 1.8 && r < 3.2;
  };
  const Deck bore = deckWith("Type: Pressure, Center: [70, 4.2, 3.9], Axis: [-2, 0, 0], Area: 50.0, Value: 1.0");
  Model pierced = modelOf(bore, cube, isBore);
  const std::vector<double> across = forcesAt(0.0, bore, pierced);
  for (int d = 0; d < 3; ++d) EXPECT_NEAR(sumOf(across)[d], 0.0, 1e-13);
  EXPECT_NEAR(sizeOf(across), 50.0, 1e-12);
  for (int i = 0; i < pierced.nOwned(); ++i) EXPECT_EQ(across[3 * i], 0.0);

  const auto isCavity = [](const double* x) {
    const double r = std::hypot(x[0] - 4.1, x[1] - 4.2, x[2] - 3.9);
    return r > 1.8 && r < 3.2;
  };
  const Deck cavity = deckWith("Type: Pressure, Center: [4.1, 4.2, 3.9], Area: 50.0, Value: 1.0");
  Model hollow = modelOf(cavity, cube, isCavity);
  const std::vector<double> away = forcesAt(0.0, cavity, hollow);
  for (int d = 0; d < 3; ++d) EXPECT_NEAR(sumOf(away)[d], 0.0, 1e-13);
  EXPECT_NEAR(sizeOf(away), 50.0, 1e-12);
  for (int i = 0; i < hollow.nOwned(); ++i) {
    const double* x = hollow.discretization().x.data() + 3 * i;
    if (!isCavity(x)) continue;
    EXPECT_GT(away[3 * i] * (x[0] - 4.1) + away[3 * i + 1] * (x[1] - 4.2) + away[3 * i + 2] * (x[2] - 3.9), 0.0);
  }
}

TEST_F(LoadsTest, TheLogSaysWhatALoadSpreadsOver) {
  const Deck deck = deckWith("Type: Pressure, Normal: [1, 0, 0], Area: 13.0, Value: 1.0");
  Model model = modelOf(deck, square, isRight);
  const std::vector<std::string> notes = BoundaryConditions(deck, model).notes();
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_EQ(notes[0], "condition \"Load\": pressure on 13 m2 shared by 26 points of 26 m3 in all, a layer 2 m deep");
}

TEST_F(LoadsTest, WhatDoesNotFitTheMeshIsAMistake) {
  const auto expect = [&](const std::string& error, const std::string& part) {
    EXPECT_NE(error.find(part), std::string::npos) << error;
  };
  expect(errorOf("Type: Force, Coordinate: z, Value: 1.0", square, isRight),
         "test.yaml:10:3: condition \"Load\" acts along z, but the points of this mesh are in one plane");
  expect(errorOf("Type: Pressure, Normal: [1, 0, 1], Area: 1.0, Value: 1.0", square, isRight), "acts along z");
  expect(errorOf("Type: Pressure, Center: [6.3, 5.8, 0], Area: 4.7, Value: 1.0", square, isQuarter),
         "a node set that is a part of a round surface needs \"Closed: false\"");
  expect(errorOf("Type: Pressure, Center: [6, 5, 0], Area: 4.7, Value: 1.0", square,
                 [](const double* x) { return std::hypot(x[0] - 6.0, x[1] - 5.0) < 2.5; }),
         "has a point of its node set at the Center");
  expect(errorOf("Type: Pressure, Center: [6, 5, 0], Axis: [0, 1, 1], Area: 4.7, Value: 1.0", square, isRing),
         "Boundary Conditions/Load/Axis must be along z");
}

}  // namespace
}  // namespace pd::test
