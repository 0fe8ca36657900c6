// Field_Maximum: largest value of a field over chosen points, 0 where there are none.
#include <algorithm>
#include <limits>

#include "field_reduction.hpp"
#include "plugins.hpp"

namespace pd {

class FieldMaximum : public FieldReduction {
 public:
  struct Fields : FieldReduction::Fields {
    explicit Fields(const Teuchos::ParameterList& parameters)
        : FieldReduction::Fields(parameters, "Largest value of the variable.") {}
  };
  static void declareParameters(ParameterDeclarations& declarations) {
    FieldReduction::declareParameters(declarations, "Field_Maximum");
  }
  FieldMaximum(ComputeParameters params, ComputeComm comm, ComputeParameters globalData)
      : FieldReduction(completeParameters<FieldMaximum>(params, "Field_Maximum"), params, comm, globalData),
        fields_(parameters_) {}

  const Fields& fields() const override { return fields_; }

  int compute(Blocks blocks) const override {
    double largest = std::numeric_limits<double>::lowest();
    forEach(blocks, [&](double value, double) { largest = std::max(largest, value); });
    largest = maxOverRanks(*epetraComm, largest);
    store(blocks, largest == std::numeric_limits<double>::lowest() ? 0.0 : largest);
    return 0;
  }

 private:
  Fields fields_;
};

}  // namespace pd

using pd::FieldMaximum;
PD_REGISTER_COMPUTE(FieldMaximum, "Field_Maximum", "Largest value of a field over a block, a node set or the body.")
