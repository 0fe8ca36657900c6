// Minimum, maximum or sum of a field over chosen points, component by component: what Block_Data and Node_Set_Data
// have in common.
#ifndef PD_SET_REDUCTION_HPP
#define PD_SET_REDUCTION_HPP

#include "field_variable.hpp"
#include "point_selection.hpp"

namespace pd {

class SetReduction {
 public:
  /// Declares "Variable", "Calculation Type" and "Output Label" (required, as in Peridigm).
  static void declareParameters(ParameterDeclarations& declarations);
  SetReduction(const Teuchos::ParameterList& parameters, const ComputeParameters& globalData);

  std::vector<int> fieldIds() const;
  void initialize(const Blocks& blocks);
  void compute(const Blocks& blocks, const Epetra_Comm& comm) const;

 private:
  PointSelection points_;
  FieldVariable variable_;
  std::string type_;
  int outputField_;
};

}  // namespace pd

#endif
