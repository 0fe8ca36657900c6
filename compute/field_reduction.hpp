// One number of a field over chosen points: what Field_Mean, Field_Integral, Field_Minimum and Field_Maximum have in
// common.
#ifndef PD_FIELD_REDUCTION_HPP
#define PD_FIELD_REDUCTION_HPP

#include "field_variable.hpp"
#include "point_selection.hpp"

namespace pd {

class FieldReduction {
 public:
  static void declareParameters(ParameterDeclarations& declarations, const char* defaultLabel);
  FieldReduction(const Teuchos::ParameterList& parameters, const ComputeParameters& globalData);

  std::vector<int> fieldIds() const;
  void initialize(const Blocks& blocks);

  /// Calls visit(value, volume) for every chosen point of this rank whose value is not ignored.
  template <class Visit>
  void forEach(const Blocks& blocks, Visit&& visit) const {
    std::vector<const double*> values, volumes;
    for (PeridigmNS::Block& block : *blocks) {
      values.push_back(variable_.values(block));
      volumes.push_back(view(block, volumeField_, PeridigmNS::PeridigmField::STEP_NONE));
    }
    points_.forEach(blocks, [&](std::size_t b, int id) {
      const double value = variable_.at(values[b], id);
      if (!hasFloor_ || value >= floor_) visit(value, volumes[b][id]);
    });
  }

  void store(const Blocks& blocks, double value) const { setGlobal(blocks, outputField_, value); }

 private:
  PointSelection points_;
  ScalarVariable variable_;
  bool hasFloor_;
  double floor_ = 0.0;
  int volumeField_, outputField_;
};

}  // namespace pd

#endif
