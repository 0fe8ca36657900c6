// Springs of materials against the tangents that the same materials assemble, and solves against direct ones.
#include <gtest/gtest.h>
#include <mpi.h>

#include <cmath>

#include "../model_plugins.hpp"
#include "../mpi/lattice.hpp"
#include "Peridigm_DegreesOfFreedomManager.hpp"
#include "driver/linear/linear_system.hpp"
#include "driver/linear/springs/tip_window.hpp"
#include "driver/model/model.hpp"
#include "driver/solvers/damage_watch.hpp"
#include "driver/solvers/spring_tangent.hpp"

namespace pd::test {
namespace {

const Communicator& world() {
  static const Communicator comm(MPI_COMM_WORLD);
  return comm;
}

/// A number in (-1, 1) that belongs to a pair of global ids and to nothing else.
double rough(long long a, long long b) {
  auto key = static_cast<unsigned long long>(std::min(a, b) * 1000003 + std::max(a, b));
  key = (key ^ (key >> 31)) * 0x9E3779B97F4A7C15ULL;
  key = (key ^ (key >> 27)) * 0xBF58476D1CE4E5B9ULL;
  return static_cast<double>(key >> 12) / std::pow(2.0, 51) - 1.0;
}

struct Body {
  const char* name;
  Lattice lattice;
  double jitter;  ///< of the spacing
  double broken;  ///< share of the bonds
  const char* material;
};

std::ostream& operator<<(std::ostream& out, const Body& body) { return out << body.name; }

std::string deckText(const Body& body) {
  return "Materials: {Solid: " + std::string(body.material) +
         "}\nDamage Models: {Limit: {Damage Model: Critical Stretch, Critical Stretch: 1.0}}\n"
         "Blocks: {All: {Block Names: default, Material: Solid, Damage Model: Limit, Horizon: " +
         std::to_string(body.lattice.horizon) + "}}\n";
}

Discretization pointsOf(const Body& body) {
  Discretization points = body.lattice.discretization(world());
  for (int i = 0; i < points.nPoints; ++i)
    for (int axis = 0; axis < points.dimension; ++axis)
      points.x[static_cast<std::size_t>(3 * i + axis)] +=
          0.5 * body.jitter * rough(points.globalIds[static_cast<std::size_t>(i)], 1000 + axis);
  return points;
}

class Springs : public ::testing::TestWithParam<Body> {
 protected:
  Springs() : deck_(deckOf(deckText(GetParam()))), model_(deck_, world(), pointsOf(GetParam()), {}) {
    model_.initialize();
    model_.updateCoordinates();
    breakBonds();
    const Discretization& points = model_.discretization();
    for (int i = 0; i < points.nPoints; ++i)
      for (int axis = 0; axis < 3; ++axis) {
        const auto id = points.globalIds[static_cast<std::size_t>(i)];
        isHeld_.push_back(axis >= points.dimension || points.x[static_cast<std::size_t>(3 * i)] < 1.5 ||
                          (axis == 1 && id % 17 == 0));
      }
  }

  /// Those whose two global ids and present damage meet `shallBreak`.
  template <class Test>
  void breakBondsWhere(const Test& shallBreak) {
    const Discretization& points = model_.discretization();
    PeridigmNS::Block& block = model_.blocks()->front();
    const int id = PeridigmNS::FieldManager::self().getFieldId("Bond_Damage");
    double* damage = nullptr;
    block.getData(id, PeridigmNS::PeridigmField::STEP_NP1)->ExtractView(&damage);
    const int* list = points.neighborhoodList.data();
    for (int i = 0; i < points.nOwned; ++i)
      for (int count = *list++; count > 0; --count, ++list, ++damage) {
        const auto a = points.globalIds[static_cast<std::size_t>(i)],
                   b = points.globalIds[static_cast<std::size_t>(*list)];
        if (!shallBreak(a, b, *damage)) continue;
        *damage = 1.0;
        model_.field("Damage")[i] += 0.01;
      }
  }

  void breakBonds() {
    breakBondsWhere([&](auto a, auto b, double) { return 0.5 * (1.0 + rough(a, b)) < GetParam().broken; });
  }

  /// Those that cross the middle of the body up to two thirds of its length: of rows of points side by side.
  void breakBondsOfACrack() {
    const Lattice& lattice = GetParam().lattice;
    const int across = lattice.ny > 1 ? 1 : 0;
    const double middle = 0.5 * ((across == 1 ? lattice.ny : lattice.nx) - 1) + 0.25;
    const auto at = [&](auto id, int axis) { return lattice.coordinate(static_cast<int>(id), axis); };
    breakBondsWhere([&](auto a, auto b, double damage) {
      const bool isCut = (at(a, across) < middle) != (at(b, across) < middle);
      return isCut && std::max(at(a, 0), at(b, 0)) < 0.67 * lattice.nx && damage != 1.0;
    });
  }

  /// Two bonds of the point of this number.
  void breakBondsOf(long long centre) {
    breakBondsWhere([&](auto a, auto b, double damage) {
      return std::min(a, b) == centre && std::max(a, b) <= centre + 2 && damage != 1.0;
    });
  }

  void healBonds() {
    PeridigmNS::Block& block = model_.blocks()->front();
    const int id = PeridigmNS::FieldManager::self().getFieldId("Bond_Damage");
    block.getData(id, PeridigmNS::PeridigmField::STEP_NP1)->PutScalar(0.0);
    std::fill_n(model_.field("Damage"), model_.nOwned(), 0.0);
  }

  std::vector<double> someDisplacement(bool isFree) const {
    const Discretization& points = model_.discretization();
    std::vector<double> u(3 * static_cast<std::size_t>(points.nOwned), 0.0);
    for (std::size_t i = 0; i < u.size(); ++i) {
      const auto axis = static_cast<int>(i % 3);
      if (axis < points.dimension && !(isFree && isHeld_[i]))
        u[i] = rough(points.globalIds[i / 3], 5000 + axis) + 0.1 * points.x[3 * (i / 3)] * (1 + axis);
    }
    return u;
  }

  std::unique_ptr<LinearSystem> assembled(const std::vector<char>& isConstrained) {
    PeridigmNS::DegreesOfFreedomManager::self().setUnknowns({{"Displacement", 3}});
    auto system = std::make_unique<LinearSystem>(world(), model_.discretization(), 3, true);
    model_.evaluateForce(1.0);
    model_.assembleJacobian(1.0, *system);
    system->scale(-1.0);
    system->finish(isConstrained);
    return system;
  }
  double norm(const std::vector<double>& v) const {
    double sum = 0.0;
    for (const double value : v) sum += value * value;
    return std::sqrt(world().sum(sum));
  }
  static std::vector<double> difference(std::vector<double> a, const std::vector<double>& b) {
    for (std::size_t i = 0; i < a.size(); ++i) a[i] -= b[i];
    return a;
  }

  Deck deck_;
  Model model_;
  std::vector<char> isHeld_;
};

TEST_P(Springs, ActAsTheAssembledTangent) {
  ASSERT_EQ(SpringTangent::obstacle(model_), "");
  breakBondsOfACrack();
  std::vector<char> nothing(isHeld_.size(), 0);
  for (std::size_t i = 0; i < nothing.size(); ++i)
    nothing[i] = static_cast<int>(i % 3) >= model_.discretization().dimension;
  const auto matrix = assembled(nothing);
  const std::vector<double> u = someDisplacement(false);
  std::vector<double> expected(u.size());
  matrix->apply(u.data(), expected.data());
  // The tangent of Elastic is one of central differences.
  const bool isExact = std::string(GetParam().material).find("Elastic,") == std::string::npos;
  for (const bool isBody : {false, true}) {
    std::vector<double> force(3 * static_cast<std::size_t>(model_.nPoints()));
    SpringTangent(model_, isBody).force(u.data(), force.data());
    force.resize(u.size());
    for (double& value : force) value *= -1.0;  // volumes are 1
    EXPECT_LT(norm(difference(force, expected)), (isExact ? 1e-12 : 1e-6) * norm(force)) << isBody;
  }
}

TEST_P(Springs, SolveAsADirectSolverDoes) {
  const auto matrix = assembled(isHeld_);
  const std::vector<double> exact = someDisplacement(true);
  std::vector<double> right(exact.size()), solution(exact.size(), 0.0);
  matrix->apply(exact.data(), right.data());
  for (const bool isBody : {false, true}) {
    SpringTangent springs(model_, isBody);
    springs.hold({isHeld_.begin(), isHeld_.begin() + 3LL * model_.nOwned()});
    const LinearSolveReport report = springs.solve(right.data(), solution.data(), 1e-7, 60);
    EXPECT_TRUE(report.hasConverged) << report.relativeResidual;
    EXPECT_LE(report.iterations, 30);
    // A residual of 1e-7 is an error of that, times the ratio of the stiffest to the softest displacement, at most.
    EXPECT_LT(norm(difference(solution, exact)), 1e-4 * norm(exact)) << isBody;
  }
}

TEST_P(Springs, ThatFollowBondsAreThoseOfAFreshStartToTheLastBit) {
  const std::vector<char> isHeld(isHeld_.begin(), isHeld_.begin() + 3LL * model_.nOwned());
  const std::vector<double> right = someDisplacement(true);
  std::vector<double> followed(right.size()), fresh(right.size());
  healBonds();
  SpringTangent following(model_, false);
  following.hold(isHeld);
  following.solve(right.data(), followed.data(), 1e-4, 60);
  breakBonds();
  following.bondsHaveChanged();
  following.forgetHistory();
  following.solve(right.data(), followed.data(), 1e-4, 60);
  SpringTangent afresh(model_, false);
  afresh.hold(isHeld);
  afresh.solve(right.data(), fresh.data(), 1e-4, 60);
  EXPECT_EQ(followed, fresh);
}

TEST_P(Springs, FindForcesAgainWhereBondsHaveBroken) {
  const std::vector<double> u = someDisplacement(false);
  std::vector<double> padded(3 * static_cast<std::size_t>(model_.nPoints()));
  std::copy(u.begin(), u.end(), padded.begin());
  for (const bool isBody : {false, true}) {
    std::vector<double> followed(padded.size()), fresh(padded.size());
    SpringTangent following(model_, isBody);
    following.force(padded.data(), followed.data());
    breakBondsOf(model_.discretization().nGlobal / (isBody ? 3 : 2));
    following.bondsHaveChanged();
    following.force(padded.data(), followed.data());
    SpringTangent afresh(model_, isBody);
    afresh.force(padded.data(), fresh.data());
    followed.resize(u.size());
    fresh.resize(u.size());
    EXPECT_LT(norm(difference(followed, fresh)), 1e-14 * norm(fresh)) << isBody;
  }
}

TEST_P(Springs, InAWindowMoveAsInTheWholeBody) {
  const Discretization& points = model_.discretization();
  SpringTangent springs(model_, false);
  std::vector<char> isHeld(isHeld_.begin(), isHeld_.begin() + 3LL * model_.nOwned());
  springs.hold(isHeld);
  const bool isForWindows = points.dimension == 2 && world().size() == 1 && points.symmetry.empty() &&
                            std::string(GetParam().material).find("0.3333") != std::string::npos;
  ASSERT_EQ(TipWindow::obstacle(springs.stiffness()).empty(), isForWindows);
  if (!isForWindows) return;
  const std::vector<double> load = someDisplacement(true);
  std::vector<double> u(load.size()), rest(load.size()), correction(load.size());
  springs.solve(load.data(), u.data(), 1e-13, 400);
  // Of the window some points are only read; bonds break where a point and all of its neighbours are others.
  std::vector<int> read, inside;
  std::vector<char> mayChange(static_cast<std::size_t>(points.nOwned), 0);
  for (int i = 0; i < points.nOwned; ++i) {
    const double x = points.x[3 * static_cast<std::size_t>(i)] / GetParam().lattice.nx;
    mayChange[static_cast<std::size_t>(i)] = x > 0.25 && x < 0.6 ? 1 : 0;
    if (x > 0.25 && x < 0.75) (mayChange[static_cast<std::size_t>(i)] != 0 ? inside : read).push_back(i);
  }
  const auto isFree = [&](int i) {
    const int* list = &points.neighborhoodList[static_cast<std::size_t>(points.neighborhoodStart[i])];
    return std::all_of(list + 1, list + 1 + *list, [&](int j) { return mayChange[static_cast<std::size_t>(j)] != 0; });
  };
  springs.takeChangedPoints();
  // Of a corridor that reaches over a part of the body, and perhaps to its ends.
  std::vector<int> part;
  for (int i = 0; i < points.nOwned; ++i)
    if (const double x = points.x[3 * static_cast<std::size_t>(i)] / GetParam().lattice.nx; x > 0.2 && x < 0.8)
      part.push_back(i);
  Corridor corridor(springs.stiffness(), part);
  ASSERT_EQ(corridor.trouble(), "");
  TipWindow window(springs.stiffness(), corridor, read, inside, u.data());
  ASSERT_EQ(window.trouble(), "");
  // Bonds of one point after another, more than are kept beside the inverse; a point that is held where it is then.
  for (std::size_t k = 0; k < 60; ++k) {
    const int centre = inside[(k * inside.size()) / 60];
    if (!window.isInside(centre) || !isFree(centre)) continue;
    breakBondsOf(points.globalIds[static_cast<std::size_t>(centre)]);
    springs.bondsHaveChanged();
    if (k == 30) isHeld[static_cast<std::size_t>(3 * centre)] = 1;
    springs.hold(isHeld);
    const SpringOperator& stiffness = springs.stiffness();
    ASSERT_EQ(&stiffness, &window.stiffness());
    const std::vector<int> changed = springs.takeChangedPoints();
    EXPECT_TRUE(corridor.fitsAfter(changed));
    ASSERT_TRUE(window.takeUp(changed, u.data()));
    ASSERT_TRUE(window.solve(u.data()));
  }
  // Equilibrium of the whole body: the rest moves, the window does not.
  std::vector<double> padded(3 * static_cast<std::size_t>(model_.nPoints())), force(padded.size());
  std::copy(u.begin(), u.end(), padded.begin());
  springs.force(padded.data(), force.data());
  for (std::size_t d = 0; d < rest.size(); ++d) rest[d] = isHeld[d] ? 0.0 : load[d] + force[d];
  springs.solve(rest.data(), correction.data(), 1e-10, 400);
  double moved = 0.0, outside = 0.0;
  for (std::size_t d = 0; d < correction.size(); ++d) {
    double& most = window.contains(static_cast<int>(d / 3)) ? moved : outside;
    most = std::max(most, std::abs(correction[d]));
  }
  EXPECT_GT(outside, 1e-4 * norm(u) / std::sqrt(static_cast<double>(u.size())));
  EXPECT_LT(moved, 1e-7 * norm(u) / std::sqrt(static_cast<double>(u.size())));
  EXPECT_FALSE(window.takeUp({0}, u.data()));  // its bonds are not in the window
  EXPECT_FALSE(corridor.fitsAfter({0}));
  // Where points are only read nothing may change.
  const auto reader = std::find_if(read.begin(), read.end(), [&](int i) { return window.isInside(i); });
  if (reader == read.end()) return;  // a small body
  breakBondsOf(points.globalIds[static_cast<std::size_t>(*reader)]);
  springs.bondsHaveChanged();
  springs.stiffness();
  EXPECT_FALSE(window.takeUp(springs.takeChangedPoints(), u.data()));
}

/// Of which so many bonds were broken when the coarse level was made that what it takes for soft is not any more.
class HealedSprings : public Springs {};

TEST_P(HealedSprings, AreSolvedWithACoarseLevelOfTheBondsThatThereAre) {
  const std::vector<char> isHeld(isHeld_.begin(), isHeld_.begin() + 3LL * model_.nOwned());
  const std::vector<double> right = someDisplacement(true);
  const auto solve = [&](SpringTangent& springs, int mostIterations, bool givesProduct) {
    std::vector<double> solution(right.size()), places(3 * static_cast<std::size_t>(model_.nPoints())), force(places);
    const SpringTangent::Product product = [&](const double* x, double* y) {
      std::copy_n(x, right.size(), places.begin());
      springs.force(places.data(), force.data());
      for (std::size_t i = 0; i < right.size(); ++i) y[i] = -force[i];  // volumes are 1
    };
    return springs.solve(right.data(), solution.data(), 1e-5, mostIterations,
                         givesProduct ? product : SpringTangent::Product());
  };
  for (const bool givesProduct : {false, true}) {
    SpringTangent patient(model_, false), impatient(model_, false);
    for (SpringTangent* springs : {&patient, &impatient}) {
      springs->hold(isHeld);
      springs->prepare();
    }
    healBonds();
    SpringTangent afresh(model_, false);
    afresh.hold(isHeld);
    const LinearSolveReport fresh = solve(afresh, 1000, givesProduct);
    ASSERT_TRUE(fresh.hasConverged);
    patient.bondsHaveChanged();
    impatient.bondsHaveChanged();
    const int most = fresh.iterations + 2;
    ASSERT_GT(solve(patient, 1000, givesProduct).iterations, most) << "the old level would have done";
    const LinearSolveReport report = solve(impatient, most, givesProduct);
    EXPECT_TRUE(report.hasConverged) << report.relativeResidual;
    EXPECT_EQ(report.iterations, fresh.iterations);
    breakBonds();
  }
}

TEST_P(Springs, SumOfBondDamageIsThatOfAllBondsAfterBreakageAndWhenItIsTakenBack) {
  BondDamageSum sum;
  const auto ofAll = [&] {
    const int id = PeridigmNS::FieldManager::self().getFieldId("Bond_Damage");
    const auto damage = model_.blocks()->front().getData(id, PeridigmNS::PeridigmField::STEP_NP1);
    double all = 0.0;
    for (int bond = 0; bond < damage->MyLength(); ++bond) all += (*damage)[bond];
    return world().sum(all);
  };
  EXPECT_EQ(sum.of(model_), ofAll());
  breakBondsOf(4);
  EXPECT_EQ(sum.of(model_), ofAll());
  breakBondsOfACrack();
  EXPECT_EQ(sum.of(model_), ofAll());
  healBonds();
  EXPECT_EQ(sum.of(model_), 0.0);
}

INSTANTIATE_TEST_SUITE_P(Bodies, HealedSprings,
                         ::testing::Values(Body{
                             "TwoParameters",
                             {40, 30, 1, 3.01},
                             0.0,
                             0.7,
                             "{Material Model: PDHE, Young's Modulus: 1.0, Poisson's Ratio: 0.2, Plane Stress: true, "
                             "Thickness: 1.0, Volume Correction: None}"}),
                         [](const auto& info) { return std::string(info.param.name); });

INSTANTIATE_TEST_SUITE_P(
    Bodies, Springs,
    ::testing::Values(
        Body{"BarOfBondBased",
             {40, 1, 1, 3.01},
             0.0,
             0.0,
             "{Material Model: PDHE, Young's Modulus: 1.0, Poisson's Ratio: 0.25, One Dimensional: true, Volume "
             "Correction: None}"},
        Body{"Lattice",
             {24, 14, 1, 3.01},
             0.0,
             0.0,
             "{Material Model: PDHE, Young's Modulus: 1.0, Poisson's Ratio: 0.3333333333333333, Plane Stress: true, "
             "Thickness: 1.0, Volume Correction: None}"},
        Body{"BrokenLattice",
             {24, 14, 1, 3.01},
             0.0,
             0.3,
             "{Material Model: PDHE, Young's Modulus: 1.0, Poisson's Ratio: 0.3333333333333333, Plane Stress: true, "
             "Thickness: 1.0, Volume Correction: None}"},
        // So large that points in runs are the most, and those beside them form strips.
        Body{"LargeBrokenLattice",
             {40, 30, 1, 3.01},
             0.0,
             0.05,
             "{Material Model: PDHE, Young's Modulus: 1.0, Poisson's Ratio: 0.3333333333333333, Plane Stress: true, "
             "Thickness: 1.0, Volume Correction: None}"},
        Body{"LargeTwoParameters",
             {40, 30, 1, 3.01},
             0.0,
             0.05,
             "{Material Model: PDHE, Young's Modulus: 1.0, Poisson's Ratio: 0.2, Plane Stress: true, Thickness: 1.0, "
             "Surface Correction: Volume Method}"},
        Body{"LargeElastic",
             {40, 30, 1, 3.01},
             0.0,
             0.05,
             "{Material Model: Elastic, Density: 1.0, Young's Modulus: 1.0, Poisson's Ratio: 0.1, Plane Stress: true, "
             "Thickness: 1.0}"},
        Body{"LargeSolidTwoParameters",
             {20, 12, 12, 1.5},
             0.0,
             0.02,
             "{Material Model: PDHE, Young's Modulus: 1.0, Poisson's Ratio: 0.1, Volume Correction: None}"},
        Body{"BrokenJitteredPoints",
             {24, 14, 1, 3.2},
             0.3,
             0.3,
             "{Material Model: PDHE, Young's Modulus: 1.0, Poisson's Ratio: 0.3333333333333333, Plane Stress: true, "
             "Thickness: 1.0, Volume Correction: None}"},
        Body{"TwoParameters",
             {24, 14, 1, 3.01},
             0.0,
             0.1,
             "{Material Model: PDHE, Young's Modulus: 1.0, Poisson's Ratio: 0.2, Plane Stress: true, Thickness: 1.0, "
             "Volume Correction: None}"},
        Body{"TwoParametersJittered",
             {24, 14, 1, 3.2},
             0.3,
             0.1,
             "{Material Model: PDHE, Young's Modulus: 1.0, Poisson's Ratio: 0.2, Plane Strain: true, Thickness: 1.0, "
             "Volume Correction: None}"},
        // k_t = k_n: springs that resist alike along and across, whose constants do not follow from one of them.
        Body{"LargeTwoParametersAlike",
             {40, 30, 1, 3.2},
             0.0,
             0.1,
             "{Material Model: PDHE, Young's Modulus: 1.0, Poisson's Ratio: 0.0, Plane Stress: true, Thickness: 1.0, "
             "Surface Correction: Volume Method}"},
        Body{"LargeTwoParametersJittered",
             {40, 30, 1, 4.01},
             0.4,
             0.05,
             "{Material Model: PDHE, Young's Modulus: 1.0, Poisson's Ratio: 0.29, Plane Stress: true, Thickness: 1.0}"},
        Body{"TwoParametersLinear",
             {24, 14, 1, 3.01},
             0.0,
             0.1,
             "{Material Model: PDHE, Young's Modulus: 1.0, Poisson's Ratio: 0.2, Plane Stress: true, Thickness: 1.0, "
             "Tangential Force: Linear, Volume Correction: None}"},
        Body{"SolidBondBased",
             {20, 6, 5, 2.3},
             0.0,
             0.1,
             "{Material Model: Elastic Bond Based, Density: 1.0, Young's Modulus: 1.0}"},
        Body{"SolidTwoParameters",
             {20, 6, 5, 2.3},
             0.2,
             0.1,
             "{Material Model: PDHE, Young's Modulus: 1.0, Poisson's Ratio: 0.1, Volume Correction: None}"},
        Body{"SolidTwoParametersOfALattice",
             {20, 6, 5, 2.3},
             0.0,
             0.1,
             "{Material Model: PDHE, Young's Modulus: 1.0, Poisson's Ratio: 0.1, Volume Correction: None}"},
        Body{"SolidElastic",
             {20, 5, 5, 2.3},
             0.0,
             0.1,
             "{Material Model: Elastic, Density: 1.0, Young's Modulus: 1.0, Poisson's Ratio: 0.35}"},
        Body{"PlateElasticJittered",
             {20, 8, 1, 3.2},
             0.3,
             0.1,
             "{Material Model: Elastic, Density: 1.0, Young's Modulus: 1.0, Poisson's Ratio: 0.1, Plane Stress: true, "
             "Thickness: 1.0}"}),
    [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace pd::test
