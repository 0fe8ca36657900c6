// Scalar fields at all times: Prescribed Value, and Prescribed Temperature and Prescribed Concentration with the field
// fixed.
#include "../condition.hpp"

namespace pd {

namespace {

class PrescribedValue : public Condition {
 public:
  static void declareParameters(ParameterDeclarations& declare) {
    declareValue(declare, "unit of the field");
    declareField(declare);
  }
  explicit PrescribedValue(const ConditionSection& section)
      : PrescribedValue(section, section.list.get<std::string>("Field")) {}

  std::string claim() const override { return "prescribe"; }
  bool isPrescription() const override { return true; }
  void markPrescribed(std::vector<char>& isPrescribed) const override {
    for (const int point : points()) isPrescribed[static_cast<std::size_t>(point)] = 1;
  }
  void applyPrescribed(Model& model, double t) override { write(model, evaluate(model.discretization(), t)); }

 protected:
  PrescribedValue(const ConditionSection& section, const std::string& field) : Condition(section, field, 1) {}
  static void declareValue(ParameterDeclarations& declare, const std::string& unit) {
    declareNodeSet(declare);
    declare.function("Value", unit, "Value at all times.").required();
  }
};

class PrescribedTemperature : public PrescribedValue {
 public:
  static void declareParameters(ParameterDeclarations& declare) { declareValue(declare, "K"); }
  explicit PrescribedTemperature(const ConditionSection& section) : PrescribedValue(section, "Temperature") {}
};

class PrescribedConcentration : public PrescribedValue {
 public:
  static void declareParameters(ParameterDeclarations& declare) { declareValue(declare, "unit of the field"); }
  explicit PrescribedConcentration(const ConditionSection& section) : PrescribedValue(section, "Concentration") {}
};

}  // namespace

PD_REGISTER_CONDITION(PrescribedValue, "Prescribed Value", "A scalar field at all times")
PD_REGISTER_CONDITION(PrescribedTemperature, "Prescribed Temperature", "Temperature at all times")
PD_REGISTER_CONDITION(PrescribedConcentration, "Prescribed Concentration", "Concentration at all times")

}  // namespace pd
