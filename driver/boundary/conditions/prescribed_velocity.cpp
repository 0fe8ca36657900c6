// What acts on a flow: velocities of walls and inlets, pressures of outflows, forces.
#include <algorithm>

#include "../condition.hpp"
#include "../flow_boundary.hpp"

namespace pd {

namespace {

Parameter& declareSurface(ParameterDeclarations& declare, const std::string& more) {
  return declare.function("Surface", "1",
                          "Where the boundary is: a function that is zero there, positive in the fluid and negative "
                          "at the points of the node set, such as \"min(y, 1-y)\" or \"sqrt(x^2+y^2)-0.05\". " +
                              more);
}

/// Empty where there is one.
std::string missingFlowSolver(const RunContents& run) {
  return run.solverFields.count("Pressure") != 0 ? "" : "no solver of this deck is one of flow, as Steady Flow is";
}

/// Points beyond a wall or an inlet. Bonds of the fluid to them end at the boundary, with its velocity there.
class PrescribedVelocity : public Condition, public FlowBoundary {
 public:
  static void declareParameters(ParameterDeclarations& declare) {
    declareNodeSet(declare);
    declare.functions("Velocity", "m/s",
                      "Components of the velocity of the boundary, functions of place and time; at rest if not given.");
    declareSurface(declare, "Without it bonds end half way to the first point of the wall.");
  }
  explicit PrescribedVelocity(const ConditionSection& section)
      : Condition(section, "Velocity", 3), FlowBoundary(section.node) {
    const DeckNode given = section.node["Velocity"];
    if (!given) return;
    for (const DeckNode& component : given.each()) velocity_.push_back(Function::fromDeck(component));
    if (velocity_.size() > 3 || velocity_.empty())
      throw DeckError(given.place() + ": " + given.path() + " must have the components x, y and z, or x and y");
  }

  std::string obstacle(const RunContents& run) const override { return missingFlowSolver(run); }
  bool dependsOnTime() const override {
    return std::any_of(velocity_.begin(), velocity_.end(), [](const Function& f) { return f.dependsOnTime(); });
  }
  bool dependsOnPlace() const override {
    return std::any_of(velocity_.begin(), velocity_.end(), [](const Function& f) { return f.dependsOnPlace(); });
  }
  bool isPrescription() const override { return true; }
  void markPrescribed(std::vector<char>& isPrescribed) const override {
    for (const int point : points())
      for (std::size_t a = 0; a < 3; ++a) isPrescribed[3 * static_cast<std::size_t>(point) + a] = 1;
  }
  void applyPrescribed(Model& model, double t) override {
    double* velocity = model.field(field());
    for (const int point : points()) {
      const std::array<double, 3> value =
          velocityAt(model.discretization().x.data() + 3 * static_cast<std::size_t>(point), t);
      std::copy(value.begin(), value.end(), velocity + 3 * static_cast<std::size_t>(point));
    }
    model.fillImages(field());
  }

  bool isOutflow() const override { return false; }
  std::array<double, 3> velocityAt(const double* x, double t) const override {
    std::array<double, 3> value{};
    for (std::size_t a = 0; a < velocity_.size(); ++a) value[a] = finiteValue(velocity_[a], node()["Velocity"], x, t);
    return value;
  }
  double pressureAt(const double*, double) const override { return 0.0; }

 private:
  std::vector<Function> velocity_;  ///< of the first components
};

/// Points beyond an outflow. The velocity does not change across it, the pressure is given at it.
class Outflow : public Condition, public FlowBoundary {
 public:
  static void declareParameters(ParameterDeclarations& declare) {
    declareNodeSet(declare);
    declare.function("Pressure", "Pa", "Pressure at the outflow.").defaultTo(0.0);
    declareSurface(declare, "The velocity beyond it is that of the mirrored place before it.").required();
  }
  explicit Outflow(const ConditionSection& section)
      : Condition(section, "Pressure", 1), FlowBoundary(section.node), pressure_(Function::constant(0.0)) {
    if (const DeckNode given = section.node["Pressure"]) pressure_ = Function::fromDeck(given);
  }

  std::string obstacle(const RunContents& run) const override { return missingFlowSolver(run); }
  bool dependsOnTime() const override { return pressure_.dependsOnTime(); }
  bool dependsOnPlace() const override { return pressure_.dependsOnPlace(); }
  bool isPrescription() const override { return true; }
  void markPrescribed(std::vector<char>& isPrescribed) const override {
    for (const int point : points()) isPrescribed[static_cast<std::size_t>(point)] = 1;
  }
  void applyPrescribed(Model& model, double t) override {
    double* pressure = model.field(field());
    for (const int point : points())
      pressure[point] = pressureAt(model.discretization().x.data() + 3 * static_cast<std::size_t>(point), t);
    model.fillImages(field());
  }

  bool isOutflow() const override { return true; }
  std::array<double, 3> velocityAt(const double*, double) const override { return {}; }
  double pressureAt(const double* x, double t) const override {
    return finiteValue(pressure_, node()["Pressure"], x, t);
  }

 private:
  Function pressure_;
};

class FlowBodyForce : public Condition, public FlowForce {
 public:
  static void declareParameters(ParameterDeclarations& declare) {
    declareNodeSet(declare);
    declare.function("Value", "N/m3", "Force per volume; a mean gradient of the pressure with the sign changed.")
        .required();
    declareCoordinate(declare);
  }
  explicit FlowBodyForce(const ConditionSection& section) : Condition(section, "Velocity", 3) {}

  std::string obstacle(const RunContents& run) const override { return missingFlowSolver(run); }
  void measure(const Discretization& mesh, const Communicator&) override { requireMotionAlong(component(), mesh); }
  bool dependsOnTime() const override { return Condition::dependsOnTime(); }
  void addTo(const Discretization& mesh, double t, double* force) const override {
    const std::vector<double>& given = evaluate(mesh, t);
    for (std::size_t k = 0; k < given.size(); ++k)
      if (points()[k] < mesh.nOwned) force[3 * points()[k] + component()] += given[k];
  }
};

}  // namespace

PD_REGISTER_CONDITION(PrescribedVelocity, "Prescribed Velocity", "Velocity of a wall or an inlet of a flow")
PD_REGISTER_CONDITION(Outflow, "Outflow", "Pressure where a flow leaves")
PD_REGISTER_CONDITION(FlowBodyForce, "Flow Body Force", "Force per volume on a flow along one axis, such as weight")

}  // namespace pd
