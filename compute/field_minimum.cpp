// Field_Minimum: smallest value of a field over chosen points, 0 where there are none.
#include <algorithm>
#include <limits>

#include "field_reduction.hpp"
#include "plugins.hpp"

namespace pd {

class FieldMinimum : public PeridigmNS::Compute {
 public:
  static void declareParameters(ParameterDeclarations& declarations) {
    FieldReduction::declareParameters(declarations, "Field_Minimum");
  }
  FieldMinimum(ComputeParameters params, ComputeComm comm, ComputeParameters globalData)
      : Compute(params, comm, globalData),
        field_(completeParameters<FieldMinimum>(params, "Field_Minimum"), globalData) {}

  std::vector<int> FieldIds() const override { return field_.fieldIds(); }
  void initialize(Blocks blocks) override { field_.initialize(blocks); }

  int compute(Blocks blocks) const override {
    double smallest = std::numeric_limits<double>::max();
    field_.forEach(blocks, [&](double value, double) { smallest = std::min(smallest, value); });
    smallest = minOverRanks(*epetraComm, smallest);
    field_.store(blocks, smallest == std::numeric_limits<double>::max() ? 0.0 : smallest);
    return 0;
  }

 private:
  FieldReduction field_;
};

}  // namespace pd

using pd::FieldMinimum;
PD_REGISTER_COMPUTE(FieldMinimum, "Field_Minimum", "Smallest value of a field over a block, a node set or the body.")
