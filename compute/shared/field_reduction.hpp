// One number of a field over chosen points: what Field_Mean, Field_Integral, Field_Minimum and Field_Maximum have in
// common.
#ifndef PD_FIELD_REDUCTION_HPP
#define PD_FIELD_REDUCTION_HPP

#include "field_variable.hpp"
#include "point_selection.hpp"

namespace pd {

class FieldReduction : public TabledCompute {
 public:
  struct Fields : FieldTable {
    ScalarVariable variable;
    FieldHandle volume = reads(pd::fields::volume());
    FieldHandle result;
    /// `isIntegral`: over volume.
    Fields(const Teuchos::ParameterList& parameters, const std::string& meaning, bool isIntegral = false);
  };
  static void declareParameters(ParameterDeclarations& declarations, const char* defaultLabel);
  const Fields& fields() const override = 0;
  void initialize(Blocks blocks) override;

 protected:
  FieldReduction(const Teuchos::ParameterList& completed, ComputeParameters params, ComputeComm comm,
                 ComputeParameters globalData);

  /// Calls visit(value, volume) for every chosen point of this rank whose value is not ignored.
  template <class Visit>
  void forEach(const Blocks& blocks, Visit&& visit) const {
    std::vector<const double*> values, volumes;
    for (PeridigmNS::Block& block : *blocks) {
      values.push_back(fields().variable.values(block));
      volumes.push_back(view(block, fields().volume));
    }
    points_.forEach(blocks, [&](std::size_t b, int id) {
      const double value = fields().variable.at(values[b], id);
      if (!hasFloor_ || value >= floor_) visit(value, volumes[b][id]);
    });
  }

  void store(const Blocks& blocks, double value) const { setGlobal(blocks, fields().result, value); }

 private:
  PointSelection points_;
  bool hasFloor_;
  double floor_ = 0.0;
};

}  // namespace pd

#endif
