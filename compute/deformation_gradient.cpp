// Deformation_Gradient: of each point from its unbroken bonds, 9 components row by row.
#include <algorithm>

#include "plugins.hpp"
#include "point_deformation.hpp"

namespace pd {

namespace PeridigmField = PeridigmNS::PeridigmField;

class DeformationGradient : public PeridigmNS::Compute {
 public:
  static void declareParameters(ParameterDeclarations& declarations) {
    declareCommonParameters(declarations, "Deformation_Gradient");
  }
  DeformationGradient(ComputeParameters params, ComputeComm comm, ComputeParameters globalData)
      : Compute(params, comm, globalData),
        outputField_(PeridigmNS::FieldManager::self().getFieldId(
            PeridigmField::ELEMENT, PeridigmField::FULL_TENSOR, PeridigmField::CONSTANT,
            completeParameters<DeformationGradient>(params, "Deformation_Gradient").get<std::string>("Output Label"))) {
  }

  std::vector<int> FieldIds() const override {
    std::vector<int> ids = gradients_.fieldIds();
    ids.push_back(outputField_);
    return ids;
  }

  int compute(Blocks blocks) const override {
    for (PeridigmNS::Block& block : *blocks) {
      const std::vector<Tensor> gradients = gradients_.of(block);
      double* output = view(block, outputField_, PeridigmField::STEP_NONE);
      for (std::size_t i = 0; i < gradients.size(); ++i)
        std::copy(gradients[i].begin(), gradients[i].end(), output + 9 * block.getNeighborhoodData()->OwnedIDs()[i]);
    }
    return 0;
  }

 private:
  DeformationGradients gradients_;
  int outputField_;
};

}  // namespace pd

using pd::DeformationGradient;
PD_REGISTER_COMPUTE(DeformationGradient, "Deformation_Gradient",
                    "Deformation gradient of each point, averaged over its unbroken bonds.")
