// Bond_Strain: strain of each point from its unbroken bonds, 9 components row by row.
#include <algorithm>

#include "plugins.hpp"
#include "point_deformation.hpp"

namespace pd {

namespace PeridigmField = PeridigmNS::PeridigmField;

class BondStrain : public PeridigmNS::Compute {
 public:
  static void declareParameters(ParameterDeclarations& declarations) {
    declareCommonParameters(declarations, "Bond_Strain");
    declareStrainMeasure(declarations);
  }
  BondStrain(ComputeParameters params, ComputeComm comm, ComputeParameters globalData)
      : BondStrain(completeParameters<BondStrain>(params, "Bond_Strain"), params, comm, globalData) {}

  std::vector<int> FieldIds() const override {
    std::vector<int> ids = gradients_.fieldIds();
    ids.push_back(outputField_);
    return ids;
  }

  int compute(Blocks blocks) const override {
    for (PeridigmNS::Block& block : *blocks) {
      const std::vector<Tensor> gradients = gradients_.of(block);
      double* output = view(block, outputField_, PeridigmField::STEP_NONE);
      for (std::size_t i = 0; i < gradients.size(); ++i) {
        const Tensor strain = strainOf(gradients[i], isGreenLagrange_);
        std::copy(strain.begin(), strain.end(), output + 9 * block.getNeighborhoodData()->OwnedIDs()[i]);
      }
    }
    return 0;
  }

 private:
  BondStrain(const Teuchos::ParameterList& parameters, ComputeParameters params, ComputeComm comm,
             ComputeParameters globalData)
      : Compute(params, comm, globalData),
        isGreenLagrange_(parameters.get<std::string>("Strain Measure") == "Green-Lagrange"),
        outputField_(PeridigmNS::FieldManager::self().getFieldId(PeridigmField::ELEMENT, PeridigmField::FULL_TENSOR,
                                                                 PeridigmField::CONSTANT,
                                                                 parameters.get<std::string>("Output Label"))) {}

  DeformationGradients gradients_;
  bool isGreenLagrange_;
  int outputField_;
};

}  // namespace pd

using pd::BondStrain;
PD_REGISTER_COMPUTE(BondStrain, "Bond_Strain", "Strain of each point, averaged over its unbroken bonds.")
