// Displacement and velocity at the start, along one axis.
#include "../condition.hpp"
#include "Peridigm_Field.hpp"

namespace pd {

namespace {

class InitialVector : public Condition {
 public:
  std::string claim() const override { return "start from"; }
  bool dependsOnTime() const override { return false; }  // it is evaluated once
  void applyInitial(Model& model, double t) override { write(model, evaluate(model.discretization(), t)); }

 protected:
  InitialVector(const ConditionSection& section, const std::string& field) : Condition(section, field, 3) {}
  static void declareVector(ParameterDeclarations& declare, const std::string& unit, const std::string& meaning) {
    declareNodeSet(declare);
    declare.function("Value", unit, meaning).required();
    declareCoordinate(declare);
  }
};

class InitialDisplacement : public InitialVector {
 public:
  static void declareParameters(ParameterDeclarations& declare) {
    declareVector(declare, "m", "Displacement at the start.");
  }
  explicit InitialDisplacement(const ConditionSection& section) : InitialVector(section, "Displacement") {}
};

class InitialVelocity : public InitialVector {
 public:
  static void declareParameters(ParameterDeclarations& declare) {
    declareVector(declare, "m/s", "Velocity at the start.");
  }
  explicit InitialVelocity(const ConditionSection& section) : InitialVector(section, "Velocity") {}

  std::vector<int> fieldIds() const override {
    using namespace PeridigmNS::PeridigmField;
    return {PeridigmNS::FieldManager::self().getFieldId(NODE, VECTOR, TWO_STEP, field())};
  }
  std::string obstacle(const RunContents& run) const override {
    if (run.solverFields.count(field()) != 0 || node().isPeridigms()) return "";
    return "no solver of this deck moves points by their velocity, as Verlet does";
  }
};

}  // namespace

PD_REGISTER_CONDITION(InitialDisplacement, "Initial Displacement", "Displacement along one axis at the start")
PD_REGISTER_CONDITION(InitialVelocity, "Initial Velocity", "Velocity along one axis at the start")

}  // namespace pd
