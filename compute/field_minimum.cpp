// Field_Minimum: smallest value of a field over chosen points, 0 where there are none.
#include <algorithm>
#include <limits>

#include "field_reduction.hpp"
#include "plugins.hpp"

namespace pd {

class FieldMinimum : public FieldReduction {
 public:
  struct Fields : FieldReduction::Fields {
    explicit Fields(const Teuchos::ParameterList& parameters)
        : FieldReduction::Fields(parameters, "Smallest value of the variable.") {}
  };
  static void declareParameters(ParameterDeclarations& declarations) {
    FieldReduction::declareParameters(declarations, "Field_Minimum");
  }
  FieldMinimum(ComputeParameters params, ComputeComm comm, ComputeParameters globalData)
      : FieldReduction(completeParameters<FieldMinimum>(params, "Field_Minimum"), params, comm, globalData),
        fields_(parameters_) {}

  const Fields& fields() const override { return fields_; }

  int compute(Blocks blocks) const override {
    double smallest = std::numeric_limits<double>::max();
    forEach(blocks, [&](double value, double) { smallest = std::min(smallest, value); });
    smallest = minOverRanks(*epetraComm, smallest);
    store(blocks, smallest == std::numeric_limits<double>::max() ? 0.0 : smallest);
    return 0;
  }

 private:
  Fields fields_;
};

}  // namespace pd

using pd::FieldMinimum;
PD_REGISTER_COMPUTE(FieldMinimum, "Field_Minimum", "Smallest value of a field over a block, a node set or the body.")
