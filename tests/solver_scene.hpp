// A lattice of springs with its conditions and one solver, run without any file but its deck.
#ifndef PD_TEST_SOLVER_SCENE_HPP
#define PD_TEST_SOLVER_SCENE_HPP

#include <functional>
#include <string>

#include "driver/model/simulation.hpp"
#include "driver/solvers/solver.hpp"
#include "model_plugins.hpp"
#include "mpi/lattice.hpp"

namespace pd::test {

/// Unit springs between points of unit spacing, volume and density. In one dimension (points 0 .. n-1 along x, ends
/// held) the modes are sin(k pi i / (n - 1)) with eigenvalues 4 sin^2(k pi / (2 (n - 1))).
class SolverScene {
 public:
  using Place = std::function<bool(double x, double y)>;

  /// `conditions`: entries of Boundary Conditions, two spaces deep, which may use the node sets "Left Node Set" and
  /// "Right Node Set" (smallest and largest x), "Ends Node Set" (both) and "All Node Set".
  SolverScene(const Communicator& comm, const Lattice& lattice, const std::string& conditions,
              const std::string& damageModel = "",
              const std::string& material = "{Material Model: Test Springs, Stiffness: 1.0}")
      : deck_(deckOf(text(lattice, conditions, damageModel, material))),
        model_(deck_, comm, points(lattice, comm), {}) {
    using namespace PeridigmNS::PeridigmField;
    auto& fields = PeridigmNS::FieldManager::self();
    model_.allocateFields({fields.getFieldId(NODE, VECTOR, TWO_STEP, "Velocity")});
    output_ = std::make_unique<Output>(deck_, comm, true);
  }

  /// Makes the solver of this name with parameters as in a deck: "{Load Steps: 3, Method: Euler}".
  Teuchos::RCP<Solver> make(const std::string& name, const std::string& parameters) {
    const auto* plugin = SolverRegistry::self().find(name);
    const auto given = deckOf("List: " + parameters)["List"].parameters(plugin->declare());
    const auto solver = plugin->create(given);
    model_.allocateFields(solver->fields().ids());
    return solver;
  }

  /// After the solvers are made: sets `field` (component x of vectors) from the reference place and starts the model.
  void start(const std::string& field, const std::function<double(double x, double y)>& initialValue) {
    if (conditions_) throw std::logic_error("the scene has started");
    conditions_ = std::make_unique<BoundaryConditions>(deck_, model_);
    simulation_ = std::make_unique<Simulation>(Simulation{model_, *conditions_, *output_});
    conditions_->applyInitial();
    const int width = model_.fieldWidth(field);
    for (int i = 0; i < model_.nPoints(); ++i)
      model_.field(field)[width * i] = initialValue(x(i), model_.discretization().x[3 * i + 1]);
    model_.initialize();
    conditions_->applyPrescribed(0.0);
    if (model_.hasMechanics()) model_.updateCoordinates();
    model_.adoptState();
  }

  /// Runs `solver` over [t0, t1] in its own increments; returns their number.
  int run(Solver& solver, double t0, double t1) {
    solver.initialize(simulation());
    const int n = solver.numberOfIncrements(simulation(), t0, t1);
    advance(solver, t0, t1, n);
    return n;
  }
  void advance(Solver& solver, double t0, double t1, int n) {
    for (int k = 0; k < n; ++k) {
      const double start = t0 + (t1 - t0) * k / n, end = t0 + (t1 - t0) * (k + 1) / n;
      solver.advance(simulation(), start, end - start);
    }
  }

  Model& model() { return model_; }
  Simulation& simulation() { return *simulation_; }
  double x(int point) const { return model_.discretization().x[3 * point]; }

  /// Largest |field - expected(x)| (component x of vectors) over all owned points of all ranks.
  double error(const std::string& field, const std::function<double(double x)>& expected) {
    const int width = model_.fieldWidth(field);
    double largest = 0.0;
    for (int i = 0; i < model_.nOwned(); ++i) {
      const double difference = std::abs(model_.field(field)[width * i] - expected(x(i)));
      largest = std::isfinite(difference) ? std::max(largest, difference) : HUGE_VAL;
    }
    return model_.comm().max(largest);
  }
  /// Owned values.
  std::vector<double> values(const std::string& field) {
    const double* first = model_.field(field);
    return {first, first + static_cast<long long>(model_.fieldWidth(field)) * model_.nOwned()};
  }

 private:
  static std::string text(const Lattice& lattice, const std::string& conditions, const std::string& damageModel,
                          const std::string& material) {
    std::string result = "Materials: {Solid: " + material + "}\n";
    if (!damageModel.empty()) result += "Damage Models: {Limit: " + damageModel + "}\n";
    result += "Blocks: {All: {Block Names: default, Material: Solid, Horizon: " + std::to_string(lattice.horizon) +
              (damageModel.empty() ? "" : ", Damage Model: Limit") + "}}\n";
    if (!conditions.empty()) result += "Boundary Conditions:\n" + conditions;
    return result;
  }
  static Discretization points(const Lattice& lattice, const Communicator& comm) {
    Discretization result = lattice.discretization(comm);
    for (int i = 0; i < result.nPoints; ++i) {
      const bool isLeft = result.x[3 * i] == 0.0, isRight = result.x[3 * i] == lattice.nx - 1;
      if (isLeft) result.nodeSets["Left Node Set"].push_back(i);
      if (isRight) result.nodeSets["Right Node Set"].push_back(i);
      if (isLeft || isRight) result.nodeSets["Ends Node Set"].push_back(i);
      result.nodeSets["All Node Set"].push_back(i);
    }
    // Sets exist on all ranks, empty where the rank has none of their points.
    for (const char* name : {"Left Node Set", "Right Node Set", "Ends Node Set"}) result.nodeSets[name];
    return result;
  }

  Deck deck_;
  Model model_;
  std::unique_ptr<Output> output_;
  std::unique_ptr<BoundaryConditions> conditions_;
  std::unique_ptr<Simulation> simulation_;
};

}  // namespace pd::test

#endif
