// Bond_Strain: strain of each point from its unbroken bonds, 9 components row by row.
#include <algorithm>

#include "plugins.hpp"
#include "point_deformation.hpp"

namespace pd {

class BondStrain : public TabledCompute {
 public:
  struct Fields : DeformationGradients::Fields {
    FieldHandle strain;
    explicit Fields(const Teuchos::ParameterList& parameters)
        : strain(writes(outputField(parameters, pd::fields::elementTensor, "1", "Strain of the point, row by row."))) {}
  };
  static void declareParameters(ParameterDeclarations& declarations) {
    declareCommonParameters(declarations, "Bond_Strain");
    declareStrainMeasure(declarations);
  }
  BondStrain(ComputeParameters params, ComputeComm comm, ComputeParameters globalData)
      : TabledCompute(completeParameters<BondStrain>(params, "Bond_Strain"), params, comm, globalData),
        isGreenLagrange_(parameters_.get<std::string>("Strain Measure") == "Green-Lagrange"),
        fields_(parameters_) {}

  const Fields& fields() const override { return fields_; }
  int compute(Blocks blocks) const override {
    for (PeridigmNS::Block& block : *blocks) {
      const std::vector<Tensor> gradients = gradients_.of(block);
      double* output = view(block, fields_.strain);
      for (std::size_t i = 0; i < gradients.size(); ++i) {
        const Tensor strain = strainOf(gradients[i], isGreenLagrange_);
        std::copy(strain.begin(), strain.end(), output + 9 * block.getNeighborhoodData()->OwnedIDs()[i]);
      }
    }
    return 0;
  }

 private:
  DeformationGradients gradients_;
  bool isGreenLagrange_;
  Fields fields_;
};

}  // namespace pd

using pd::BondStrain;
PD_REGISTER_COMPUTE(BondStrain, "Bond_Strain", "Strain of each point, averaged over its unbroken bonds.")
