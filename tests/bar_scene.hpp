// Bodies of elastic bars, small enough to be solved by hand, with everything that a solver of mechanics needs.
#ifndef PD_TEST_BAR_SCENE_HPP
#define PD_TEST_BAR_SCENE_HPP

#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "Peridigm_DegreesOfFreedomManager.hpp"
#include "driver/model/simulation.hpp"
#include "driver/solvers/solver.hpp"
#include "model_plugins.hpp"
#include "mpi/lattice.hpp"

namespace pd::test {

/// A bond is a bar of force c s along its present direction, s = (|y| - |xi|) / |xi|, on volumes of one: force density
/// of i = sum_j c s V_j e. Half comes from either end. Bond_Damage of 1 means no force.
class BarMaterial : public Material {
 public:
  static void declareParameters(ParameterDeclarations& declare) {
    declare.real("Stiffness", "N/m6", "c.").positive().required();
    declare.real("Finite Difference Probe Length", "m", "The tangent is probed with it where it is given.").positive();
  }
  explicit BarMaterial(const Teuchos::ParameterList& list)
      : Material(list),
        stiffness_(list.get<double>("Stiffness")),
        isProbed_(list.isParameter("Finite Difference Probe Length")) {
    auto& fields = FieldManager::self();
    coordinates_ = fields.getFieldId(NODE, VECTOR, TWO_STEP, "Coordinates");
    reference_ = fields.getFieldId(NODE, VECTOR, CONSTANT, "Model_Coordinates");
    force_ = fields.getFieldId(NODE, VECTOR, TWO_STEP, "Force_Density");
    volume_ = fields.getFieldId(ELEMENT, SCALAR, CONSTANT, "Volume");
    bondDamage_ = fields.getFieldId(BOND, SCALAR, TWO_STEP, "Bond_Damage");
  }
  std::string Name() const override { return "Test Bars"; }
  double Density() const override { return 1.0; }
  double BulkModulus() const override { return 1.0; }
  double ShearModulus() const override { return 1.0; }
  std::vector<int> FieldIds() const override { return {coordinates_, reference_, force_, volume_, bondDamage_}; }

  void computeForce(const double, const int n, const int* owned, const int* list, DataManager& data) const override {
    const auto force = data.getData(force_, STEP_NP1);
    const auto volume = data.getData(volume_, STEP_NONE);
    force->PutScalar(0.0);
    forEachBar(n, owned, list, data, [&](int i, int j, const Bar& bar) {
      for (int c = 0; c < 3; ++c) {
        const double half = 0.5 * stiffness_ * bar.stretch * bar.direction[static_cast<std::size_t>(c)];
        (*force)[3 * i + c] += half * (*volume)[j];
        (*force)[3 * j + c] -= half * (*volume)[i];
      }
    });
  }

  void computeJacobian(const double dt, const int n, const int* owned, const int* list, DataManager& data,
                       SerialMatrix& jacobian, JacobianType type) const override {
    if (isProbed_) return Material::computeJacobian(dt, n, owned, list, data, jacobian, type);
    const auto volume = data.getData(volume_, STEP_NONE);
    forEachBar(n, owned, list, data, [&](int i, int j, const Bar& bar) {
      std::array<int, 6> indices{};
      std::array<std::array<double, 6>, 6> block{};
      std::array<const double*, 6> rows{};
      for (std::size_t a = 0; a < 6; ++a) {
        indices[a] = 3 * data.getOverlapScalarPointMap()->GID(a < 3 ? i : j) + static_cast<int>(a % 3);
        rows[a] = block[a].data();
        for (std::size_t b = 0; b < 6; ++b) {
          const double along = bar.direction[a % 3] * bar.direction[b % 3], identity = a % 3 == b % 3 ? 1.0 : 0.0;
          const double k = 0.5 * stiffness_ * (*volume)[i] * (*volume)[j] *
                           (along / bar.length + bar.stretch * (identity - along) / bar.presentLength);
          block[a][b] = (a < 3) == (b < 3) ? -k : k;
        }
      }
      jacobian.addValues(6, indices.data(), rows.data());
    });
  }

 private:
  struct Bar {
    double length, presentLength, stretch;
    std::array<double, 3> direction;
  };
  template <class Visit>
  void forEachBar(int n, const int* owned, const int* list, DataManager& data, const Visit& visit) const {
    const auto y = data.getData(coordinates_, STEP_NP1), x = data.getData(reference_, STEP_NONE);
    const auto isBroken = data.getData(bondDamage_, STEP_NP1);
    int bond = 0;
    for (int k = 0; k < n; ++k)
      for (int count = *list++; count > 0; --count, ++bond) {
        const int i = owned[k], j = *list++;
        if ((*isBroken)[bond] >= 1.0) continue;
        Bar bar{0.0, 0.0, 0.0, {}};
        for (int c = 0; c < 3; ++c) {
          bar.direction[static_cast<std::size_t>(c)] = (*y)[3 * j + c] - (*y)[3 * i + c];
          bar.length += std::pow((*x)[3 * j + c] - (*x)[3 * i + c], 2);
          bar.presentLength += std::pow((*y)[3 * j + c] - (*y)[3 * i + c], 2);
        }
        bar.length = std::sqrt(bar.length);
        bar.presentLength = std::sqrt(bar.presentLength);
        bar.stretch = (bar.presentLength - bar.length) / bar.length;
        for (double& component : bar.direction) component /= bar.presentLength;
        visit(i, j, bar);
      }
  }

  double stiffness_;
  bool isProbed_;
  int coordinates_ = -1, reference_ = -1, force_ = -1, volume_ = -1, bondDamage_ = -1;
};
inline const bool hasBarMaterial = registerPlugin<MaterialRegistry, BarMaterial>("Test Bars", "Elastic bars.");

/// A bar breaks where its stretch exceeds a limit.
class StretchDamage : public DamageModel {
 public:
  static void declareParameters(ParameterDeclarations& declare) {
    declare.real("Greatest Stretch", "1", "Of a bond.").positive().required();
  }
  explicit StretchDamage(const Teuchos::ParameterList& list)
      : DamageModel(list), greatest_(list.get<double>("Greatest Stretch")) {
    auto& fields = FieldManager::self();
    coordinates_ = fields.getFieldId(NODE, VECTOR, TWO_STEP, "Coordinates");
    reference_ = fields.getFieldId(NODE, VECTOR, CONSTANT, "Model_Coordinates");
    bondDamage_ = fields.getFieldId(BOND, SCALAR, TWO_STEP, "Bond_Damage");
    damage_ = fields.getFieldId(ELEMENT, SCALAR, TWO_STEP, "Damage");
  }
  std::string Name() const override { return "Test Stretch"; }
  std::vector<int> FieldIds() const override { return {coordinates_, reference_, bondDamage_, damage_}; }
  void computeDamage(const double, const int n, const int* owned, const int* list, DataManager& data) const override {
    const auto y = data.getData(coordinates_, STEP_NP1), x = data.getData(reference_, STEP_NONE);
    const auto isBroken = data.getData(bondDamage_, STEP_NP1);
    const auto damage = data.getData(damage_, STEP_NP1);
    int bond = 0;
    for (int k = 0; k < n; ++k) {
      const int i = owned[k], count = *list++;
      double nBroken = 0.0;
      for (int m = 0; m < count; ++m, ++bond) {
        const int j = *list++;
        double now = 0.0, then = 0.0;
        for (int c = 0; c < 3; ++c) {
          now += std::pow((*y)[3 * j + c] - (*y)[3 * i + c], 2);
          then += std::pow((*x)[3 * j + c] - (*x)[3 * i + c], 2);
        }
        if (now > std::pow(1.0 + greatest_, 2) * then) (*isBroken)[bond] = 1.0;
        nBroken += (*isBroken)[bond];
      }
      (*damage)[i] = count > 0 ? nBroken / count : 0.0;
    }
  }

 private:
  double greatest_;
  int coordinates_ = -1, reference_ = -1, bondDamage_ = -1, damage_ = -1;
};
inline const bool hasStretchDamage =
    registerPlugin<DamageModelRegistry, StretchDamage>("Test Stretch", "Bars of limited stretch.");

/// Points that a node set holds, by their reference place.
using NodeSets = std::map<std::string, std::function<bool(const std::array<double, 3>&)>>;

inline void addNodeSets(Discretization& points, const NodeSets& sets) {
  for (const auto& [name, contains] : sets)
    for (int i = 0; i < points.nPoints; ++i)
      if (contains({points.x[static_cast<std::size_t>(3 * i)], points.x[static_cast<std::size_t>(3 * i + 1)],
                    points.x[static_cast<std::size_t>(3 * i + 2)]}))
        points.nodeSets[name].push_back(i);
}

/// A solver at work on a deck and a lattice.
struct Scene {
  Scene(const std::string& deckText, const Communicator& comm, const Discretization& points,
        const std::string& solverName, const Teuchos::ParameterList& solverParameters)
      : deck(deckOf(deckText)),
        model(deck, comm, points, {}),
        solver(SolverRegistry::self().create(solverName, solverParameters)) {
    model.allocateFields(solver->fields().ids());
    conditions = std::make_unique<BoundaryConditions>(deck, model);
    output = std::make_unique<Output>(deck, comm, true);
    conditions->applyInitial();
    model.initialize();
    conditions->applyPrescribed(0.0);
    if (model.hasMechanics()) model.updateCoordinates();
    model.adoptState();
    solver->initialize(simulation());
  }

  Simulation& simulation() {
    if (!simulation_) simulation_ = std::make_unique<Simulation>(Simulation{model, *conditions, *output});
    return *simulation_;
  }
  /// Increments `first` + 1 ... `last` of `count` from 0 to 1 s.
  void run(int count, int first, int last) {
    for (int k = first; k < last; ++k) {
      const double start = solver->incrementEnd(k, count, 0.0, 1.0), end = solver->incrementEnd(k + 1, count, 0.0, 1.0);
      solver->advance(simulation(), start, end - start);
    }
  }
  void run(int count) { run(count, 0, count); }
  double* displacement() { return model.field("Displacement"); }

  Deck deck;
  Model model;
  Teuchos::RCP<Solver> solver;
  std::unique_ptr<BoundaryConditions> conditions;
  std::unique_ptr<Output> output;

 private:
  std::unique_ptr<Simulation> simulation_;
};

/// Materials, damage model (where `greatestStretch` > 0) and blocks; `conditions` are the lines of that section.
inline std::string barDeck(double stiffness, double greatestStretch, const std::string& conditions,
                           bool probesTangent = false) {
  std::string text = "Materials:\n  Bars: {Material Model: Test Bars, Stiffness: " + std::to_string(stiffness) +
                     (probesTangent ? ", Finite Difference Probe Length: 1.0e-6" : "") + "}\n";
  if (greatestStretch > 0.0)
    text +=
        "Damage Models:\n  Limit: {Damage Model: Test Stretch, Greatest Stretch: " + std::to_string(greatestStretch) +
        "}\n";
  text += "Blocks:\n  All: {Block Names: default, Material: Bars, Horizon: 1.0" +
          std::string(greatestStretch > 0.0 ? ", Damage Model: Limit" : "") + "}\n";
  text += "Boundary Conditions:\n" + conditions;
  return text;
}

}  // namespace pd::test

#endif
