// Deformation_Gradient: of each point from its unbroken bonds, 9 components row by row.
#include <algorithm>

#include "plugins.hpp"
#include "point_deformation.hpp"

namespace pd {

class DeformationGradient : public TabledCompute {
 public:
  struct Fields : DeformationGradients::Fields {
    FieldHandle gradient;
    explicit Fields(const Teuchos::ParameterList& parameters)
        : gradient(writes(outputField(parameters, pd::fields::elementTensor, "1",
                                      "Deformation gradient of the point, row by row."))) {}
  };
  static void declareParameters(ParameterDeclarations& declarations) {
    declareCommonParameters(declarations, "Deformation_Gradient");
  }
  DeformationGradient(ComputeParameters params, ComputeComm comm, ComputeParameters globalData)
      : TabledCompute(completeParameters<DeformationGradient>(params, "Deformation_Gradient"), params, comm,
                      globalData),
        fields_(parameters_) {}

  const Fields& fields() const override { return fields_; }
  int compute(Blocks blocks) const override {
    for (PeridigmNS::Block& block : *blocks) {
      const std::vector<Tensor> gradients = gradients_.of(block);
      double* output = view(block, fields_.gradient);
      for (std::size_t i = 0; i < gradients.size(); ++i)
        std::copy(gradients[i].begin(), gradients[i].end(), output + 9 * block.getNeighborhoodData()->OwnedIDs()[i]);
    }
    return 0;
  }

 private:
  DeformationGradients gradients_;
  Fields fields_;
};

}  // namespace pd

using pd::DeformationGradient;
PD_REGISTER_COMPUTE(DeformationGradient, "Deformation_Gradient",
                    "Deformation gradient of each point, averaged over its unbroken bonds.")
