// Field_Maximum: largest value of a field over chosen points, 0 where there are none.
#include <algorithm>
#include <limits>

#include "field_reduction.hpp"
#include "plugins.hpp"

namespace pd {

class FieldMaximum : public PeridigmNS::Compute {
 public:
  static void declareParameters(ParameterDeclarations& declarations) {
    FieldReduction::declareParameters(declarations, "Field_Maximum");
  }
  FieldMaximum(ComputeParameters params, ComputeComm comm, ComputeParameters globalData)
      : Compute(params, comm, globalData),
        field_(completeParameters<FieldMaximum>(params, "Field_Maximum"), globalData) {}

  std::vector<int> FieldIds() const override { return field_.fieldIds(); }
  void initialize(Blocks blocks) override { field_.initialize(blocks); }

  int compute(Blocks blocks) const override {
    double largest = std::numeric_limits<double>::lowest();
    field_.forEach(blocks, [&](double value, double) { largest = std::max(largest, value); });
    largest = maxOverRanks(*epetraComm, largest);
    field_.store(blocks, largest == std::numeric_limits<double>::lowest() ? 0.0 : largest);
    return 0;
  }

 private:
  FieldReduction field_;
};

}  // namespace pd

using pd::FieldMaximum;
PD_REGISTER_COMPUTE(FieldMaximum, "Field_Maximum", "Largest value of a field over a block, a node set or the body.")
