// Scalar fields at the start: Initial Value, and Initial Temperature and Initial Concentration with the field fixed.
#include "../condition.hpp"

namespace pd {

namespace {

class InitialValue : public Condition {
 public:
  static void declareParameters(ParameterDeclarations& declare) {
    declareValue(declare, "unit of the field");
    declareField(declare);
  }
  explicit InitialValue(const ConditionSection& section)
      : InitialValue(section, section.list.get<std::string>("Field")) {}

  std::string claim() const override { return "start from"; }
  bool dependsOnTime() const override { return false; }  // it is evaluated once
  void applyInitial(Model& model, double t) override { write(model, evaluate(model.discretization(), t)); }

 protected:
  InitialValue(const ConditionSection& section, const std::string& field) : Condition(section, field, 1) {}
  static void declareValue(ParameterDeclarations& declare, const std::string& unit) {
    declareNodeSet(declare);
    declare.function("Value", unit, "Value at the start.").required();
  }
};

class InitialTemperature : public InitialValue {
 public:
  static void declareParameters(ParameterDeclarations& declare) { declareValue(declare, "K"); }
  explicit InitialTemperature(const ConditionSection& section) : InitialValue(section, "Temperature") {}
};

class InitialConcentration : public InitialValue {
 public:
  static void declareParameters(ParameterDeclarations& declare) { declareValue(declare, "unit of the field"); }
  explicit InitialConcentration(const ConditionSection& section) : InitialValue(section, "Concentration") {}
};

}  // namespace

PD_REGISTER_CONDITION(InitialValue, "Initial Value", "A scalar field at the start")
PD_REGISTER_CONDITION(InitialTemperature, "Initial Temperature", "Temperature at the start")
PD_REGISTER_CONDITION(InitialConcentration, "Initial Concentration", "Concentration at the start")

}  // namespace pd
