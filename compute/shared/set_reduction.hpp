// Minimum, maximum or sum of a field over chosen points, component by component: what Block_Data and Node_Set_Data
// have in common.
#ifndef PD_SET_REDUCTION_HPP
#define PD_SET_REDUCTION_HPP

#include "field_variable.hpp"
#include "point_selection.hpp"

namespace pd {

class SetReduction : public TabledCompute {
 public:
  struct Fields : FieldTable {
    FieldVariable variable;
    FieldHandle result;
    explicit Fields(const Teuchos::ParameterList& parameters);
  };
  /// Declares "Variable", "Calculation Type" and "Output Label" (required, as in Peridigm).
  static void declareParameters(ParameterDeclarations& declarations);

  const Fields& fields() const override { return fields_; }
  void initialize(Blocks blocks) override;
  int compute(Blocks blocks) const override;

 protected:
  SetReduction(const Teuchos::ParameterList& completed, ComputeParameters params, ComputeComm comm,
               ComputeParameters globalData);

 private:
  PointSelection points_;
  Fields fields_;
  std::string type_;
};

}  // namespace pd

#endif
