// Field_Mean: mean of a field over chosen points, by volume or point by point; 0 where there are none.
#include "field_reduction.hpp"
#include "plugins.hpp"

namespace pd {

class FieldMean : public FieldReduction {
 public:
  struct Fields : FieldReduction::Fields {
    explicit Fields(const Teuchos::ParameterList& parameters)
        : FieldReduction::Fields(parameters, "Mean of the variable.") {}
  };
  static void declareParameters(ParameterDeclarations& declarations) {
    FieldReduction::declareParameters(declarations, "Field_Mean");
    declarations.text("Weights", "Whether points count by their volume or all alike.")
        .oneOf({"Volume", "Equal"})
        .defaultTo("Volume");
  }
  FieldMean(ComputeParameters params, ComputeComm comm, ComputeParameters globalData)
      : FieldReduction(completeParameters<FieldMean>(params, "Field_Mean"), params, comm, globalData),
        fields_(parameters_),
        isByVolume_(parameters_.get<std::string>("Weights") == "Volume") {}

  const Fields& fields() const override { return fields_; }

  int compute(Blocks blocks) const override {
    std::vector<double> sums(2, 0.0);  // weighted values, weights
    forEach(blocks, [&](double value, double volume) {
      const double weight = isByVolume_ ? volume : 1.0;
      sums[0] += weight * value;
      sums[1] += weight;
    });
    sums = sumOverRanks(*epetraComm, sums);
    store(blocks, sums[1] > 0.0 ? sums[0] / sums[1] : 0.0);
    return 0;
  }

 private:
  Fields fields_;
  bool isByVolume_;
};

}  // namespace pd

using pd::FieldMean;
PD_REGISTER_COMPUTE(FieldMean, "Field_Mean", "Mean of a field over a block, a node set or the body.")
