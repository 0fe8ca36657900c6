// How often each solver calls a plug-in in a step: the table of materials/YOUR_OWN_MODEL.md, counted.
#include <gtest/gtest.h>
#include <mpi.h>

#include <fstream>
#include <map>
#include <sstream>

#include "../solver_scene.hpp"
#include "step_listener.hpp"

namespace pd::test {
namespace {

std::map<std::string, int> calls;  ///< so far, by kind of plug-in and call

constexpr char springs[] = "Test Springs", length[] = "Test Length", metal[] = "Corrosion Dissolution",
               phases[] = "Dissolution";

/// Counts the calls of another plug-in. What that calls itself (the forces of a probed tangent) does not count.
template <class Base>
class Counted : public Base, public FieldUser, public StepListener {
 public:
  using Call = pd::Call;
  Counted(const Teuchos::ParameterList& list, Teuchos::RCP<Base> inner, const char* kind)
      : Base(list), inner_(inner), kind_(kind) {}
  std::string Name() const override { return inner_->Name(); }
  std::vector<int> FieldIds() const override { return inner_->FieldIds(); }
  std::vector<int> FieldIdsForSynchronizationAfterInitialize() const override {
    return inner_->FieldIdsForSynchronizationAfterInitialize();
  }
  std::vector<int> FieldIdsForSynchronizationAfterPrecompute() const override {
    return inner_->FieldIdsForSynchronizationAfterPrecompute();
  }
  const FieldTable& fields() const override {
    static const FieldTable none;
    const FieldTable* table = fieldTableOf(*inner_);
    return table == nullptr ? none : *table;
  }
  void precompute(const double dt, const int n, const int* owned, const int* list, DataManager& data) const override {
    count("precompute");
    inner_->precompute(dt, n, owned, list, data);
  }
  void stepAccepted(const Call& call, DataManager& data, double time, double dt) const override {
    count("stepAccepted");
    if (const auto* listener = dynamic_cast<const StepListener*>(inner_.get()))
      listener->stepAccepted(call, data, time, dt);
  }
  void stepTakenBack() const override {
    count("stepTakenBack");
    if (const auto* listener = dynamic_cast<const StepListener*>(inner_.get())) listener->stepTakenBack();
  }

 protected:
  void count(const std::string& call) const { ++calls[kind_ + " " + call]; }
  Teuchos::RCP<Base> inner_;

 private:
  std::string kind_;
};

template <const char* name>
class CountedMaterial : public Counted<Material> {
 public:
  static void declareParameters(ParameterDeclarations& declare) {
    declare = MaterialRegistry::self().find(name)->declare();
  }
  explicit CountedMaterial(const Teuchos::ParameterList& list)
      : Counted(list, MaterialRegistry::self().create(name, list), "material") {}
  double Density() const override { return inner_->Density(); }
  double BulkModulus() const override { return inner_->BulkModulus(); }
  double ShearModulus() const override { return inner_->ShearModulus(); }
  double lookupMaterialProperty(const std::string key) const override { return inner_->lookupMaterialProperty(key); }
  void initialize(const double dt, const int n, const int* owned, const int* list, DataManager& data) override {
    count("initialize");
    inner_->initialize(dt, n, owned, list, data);
  }
  void computeForce(const double dt, const int n, const int* owned, const int* list, DataManager& data) const override {
    count("computeForce");
    inner_->computeForce(dt, n, owned, list, data);
  }
  void computeFluxDivergence(const double dt, const int n, const int* owned, const int* list,
                             DataManager& data) const override {
    count("computeFluxDivergence");
    inner_->computeFluxDivergence(dt, n, owned, list, data);
  }
  void computeJacobian(const double dt, const int n, const int* owned, const int* list, DataManager& data,
                       SerialMatrix& matrix, JacobianType type) const override {
    count("computeJacobian");
    inner_->computeJacobian(dt, n, owned, list, data, matrix, type);
  }
};

template <const char* name>
class CountedDamage : public Counted<DamageModel> {
 public:
  static void declareParameters(ParameterDeclarations& declare) {
    declare = DamageModelRegistry::self().find(name)->declare();
  }
  explicit CountedDamage(const Teuchos::ParameterList& list)
      : Counted(list, DamageModelRegistry::self().create(name, list), "damage") {}
  void initialize(const double dt, const int n, const int* owned, const int* list, DataManager& data) const override {
    count("initialize");
    inner_->initialize(dt, n, owned, list, data);
  }
  void computeDamage(const double dt, const int n, const int* owned, const int* list,
                     DataManager& data) const override {
    count("computeDamage");
    inner_->computeDamage(dt, n, owned, list, data);
  }
};

using CountedSprings = CountedMaterial<springs>;
using CountedMetal = CountedMaterial<metal>;
using CountedLength = CountedDamage<length>;
using CountedPhases = CountedDamage<phases>;
PD_REGISTER_MATERIAL(CountedSprings, "Test Counted Springs", "Test Springs, counted.")
PD_REGISTER_MATERIAL(CountedMetal, "Test Counted Metal", "Corrosion Dissolution, counted.")
PD_REGISTER_DAMAGE_MODEL(CountedLength, "Test Counted Length", "Test Length, counted.")
PD_REGISTER_DAMAGE_MODEL(CountedPhases, "Test Counted Phases", "Dissolution, counted.")

/// The columns of the table, in its order.
const std::vector<std::string> columns = {
    "damage precompute",     "damage computeDamage",           "damage stepAccepted",      "material precompute",
    "material computeForce", "material computeFluxDivergence", "material computeJacobian", "material stepAccepted"};

struct Row {
  const char* solver;
  const char* parameters;  ///< as the table has them
};

void PrintTo(const Row& row, std::ostream* out) { *out << row.solver << " " << row.parameters; }

/// Cells of the row of materials/YOUR_OWN_MODEL.md that begins with such a solver and parameters.
std::vector<std::string> cellsOf(const Row& row) {
  std::ifstream page(std::string(PD_SOURCE_DIR) + "/materials/YOUR_OWN_MODEL.md");
  const std::string start = std::string("| `") + row.solver + ": " + row.parameters + "` |";
  for (std::string line; std::getline(page, line);) {
    if (line.compare(0, start.size(), start) != 0) continue;
    std::vector<std::string> cells;
    std::istringstream rest(line.substr(start.size()));
    for (std::string cell; std::getline(rest, cell, '|');) {
      cell.erase(0, cell.find_first_not_of(' '));
      cells.push_back(cell.substr(0, cell.find_last_not_of(' ') + 1));
    }
    return cells;
  }
  return {};
}

/// "3, then 1", "2", or nothing where there are no calls.
std::string cell(int first, int later) {
  if (first == 0 && later == 0) return "";
  return first == later ? std::to_string(later) : std::to_string(first) + ", then " + std::to_string(later);
}

class Calls : public ::testing::TestWithParam<Row> {
 protected:
  /// Springs along a row whose ends are pulled apart, and through which a scalar diffuses; or dissolving metal.
  static std::unique_ptr<SolverScene> sceneOf(const std::string& solver, const Communicator& comm) {
    if (solver == "Corrosion")
      return std::make_unique<SolverScene>(
          comm, Lattice{12, 1, 1, 3.0}, "", "{Damage Model: Test Counted Phases}",
          "{Material Model: Test Counted Metal, Diffusivity: 1.0, Solid Concentration: 100.0, Saturation "
          "Concentration: 10.0, Charge Number: 2.0, Current Density: \"1.0\", One Dimensional: true, Cross Section "
          "Area: 1.0}");
    return std::make_unique<SolverScene>(
        comm, Lattice{9, 1, 1, 1.0},
        "  Pull: {Type: Prescribed Displacement, Node Set: Ends Node Set, Coordinate: x, Value: \"0.01*x*t^2\"}\n"
        "  Charge: {Type: Prescribed Concentration, Node Set: Left Node Set, Value: 1.0}\n",
        "{Damage Model: Test Counted Length, Greatest Length: 2.0}",
        "{Material Model: Test Counted Springs, Stiffness: 1.0, Finite Difference Probe Length: 1.0e-4}");
  }
};

TEST_P(Calls, AreThoseOfThePage) {
  const Communicator comm(MPI_COMM_WORLD);
  const std::string name = GetParam().solver;
  const auto scene = sceneOf(name, comm);
  const auto solver = scene->make(name, "{" + std::string(GetParam().parameters) + "}");
  calls.clear();
  const double solid = name == "Corrosion" ? 100.0 : 0.0;
  scene->start("Concentration", [solid](double x, double) { return x < 2.5 ? 0.0 : solid; });
  EXPECT_EQ(calls["material initialize"], 1);
  EXPECT_EQ(calls["damage initialize"], 1);
  solver->initialize(scene->simulation());
  std::vector<std::map<std::string, int>> steps;
  constexpr double dt = 0.1;
  for (int k = 0; k < 4; ++k) {
    calls.clear();
    solver->advance(scene->simulation(), k * dt, dt);
    steps.push_back(calls);
  }
  // The first step has estimates of limits and matrices, the second may still begin a history of steps.
  EXPECT_EQ(steps[2], steps[3]);
  std::string expected, counted;
  for (const std::string& cell : cellsOf(GetParam())) expected += cell + " | ";
  for (const std::string& column : columns) counted += cell(steps[0][column], steps[3][column]) + " | ";
  EXPECT_EQ(expected, counted) << "row of materials/YOUR_OWN_MODEL.md";
  EXPECT_EQ(steps[3]["damage stepTakenBack"] + steps[3]["material stepTakenBack"], 0);
}

INSTANTIATE_TEST_SUITE_P(
    Solvers, Calls,
    ::testing::Values(Row{"Verlet", "Fixed dt: 0.1"}, Row{"QuasiStatic", "Load Steps: 10"},
                      Row{"Adaptive Dynamic Relaxation", "Iterations Per Load Step: 3"},
                      Row{"Diffusion", "Method: Euler, Sub Steps: 3"}, Row{"Diffusion", "Method: Implicit Euler"},
                      Row{"Staggered",
                          "Load Steps: 10, Diffusion: {Method: Euler, Sub Steps: 3}, Mechanics: {QuasiStatic: {}}"},
                      Row{"Corrosion", "Fixed dt: 0.1"}));

// A step that fails is taken back, and everybody is told: the history of the next attempt starts from the same N.
TEST(Calls, AStepIsTakenBackWithANote) {
  const Communicator comm(MPI_COMM_WORLD);
  SolverScene scene(comm, Lattice{9, 1, 1, 1.0}, "", "{Damage Model: Test Counted Length, Greatest Length: 2.0}",
                    "{Material Model: Test Counted Springs, Stiffness: 1.0}");
  scene.start("Displacement", [](double, double) { return 0.0; });
  scene.model().beginStep();
  scene.model().evaluateDamage(1.0);
  calls.clear();
  scene.model().takeBackStep();
  EXPECT_EQ(calls["damage stepTakenBack"], 1);
  EXPECT_EQ(calls["material stepTakenBack"], 1);
}

}  // namespace
}  // namespace pd::test
