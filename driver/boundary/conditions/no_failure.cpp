// Points whose bonds never break.
#include "../condition.hpp"

namespace pd {

namespace {

class NoFailure : public Condition {
 public:
  static void declareParameters(ParameterDeclarations& declare) {
    declare.text("Node Set", "Points whose bonds never break.").required();
  }
  explicit NoFailure(const ConditionSection& section) : Condition(section, "No_Failure", 1) {}

  std::string obstacle(const RunContents& run) const override {
    return run.hasDamageModel ? "" : "no block has a Damage Model";
  }
  void applyInitial(Model& model, double) override { write(model, std::vector<double>(points().size(), 1.0)); }
};

}  // namespace

PD_REGISTER_CONDITION(NoFailure, "No Failure", "Points whose bonds never break")

}  // namespace pd
