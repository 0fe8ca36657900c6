// Bond_Stress: stress of each point, Pa, 9 components row by row.
//
// The force of a single bond is its material's own business, so this is not a sum of bond forces: it is Hooke's law
// with the material's moduli, applied to the strain that the unbroken bonds show.
#include <algorithm>

#include "plugins.hpp"
#include "point_deformation.hpp"

namespace pd {

namespace PeridigmField = PeridigmNS::PeridigmField;

class BondStress : public PeridigmNS::Compute {
 public:
  static void declareParameters(ParameterDeclarations& declarations) {
    declareCommonParameters(declarations, "Bond_Stress");
    declareStrainMeasure(declarations);
    HookesLaw::declareParameters(declarations);
  }
  BondStress(ComputeParameters params, ComputeComm comm, ComputeParameters globalData)
      : BondStress(completeParameters<BondStress>(params, "Bond_Stress"), params, comm, globalData) {}

  std::vector<int> FieldIds() const override {
    std::vector<int> ids = gradients_.fieldIds();
    ids.push_back(outputField_);
    return ids;
  }

  int compute(Blocks blocks) const override {
    for (PeridigmNS::Block& block : *blocks) {
      const std::vector<Tensor> gradients = gradients_.of(block);
      const HookesLaw law(*block.getMaterialModel(), isPlaneStress_);
      double* output = view(block, outputField_, PeridigmField::STEP_NONE);
      for (std::size_t i = 0; i < gradients.size(); ++i) {
        const Tensor stress = law.stress(strainOf(gradients[i], isGreenLagrange_));
        std::copy(stress.begin(), stress.end(), output + 9 * block.getNeighborhoodData()->OwnedIDs()[i]);
      }
    }
    return 0;
  }

 private:
  BondStress(const Teuchos::ParameterList& parameters, ComputeParameters params, ComputeComm comm,
             ComputeParameters globalData)
      : Compute(params, comm, globalData),
        isGreenLagrange_(parameters.get<std::string>("Strain Measure") == "Green-Lagrange"),
        isPlaneStress_(parameters.get<bool>("Plane Stress")),
        outputField_(PeridigmNS::FieldManager::self().getFieldId(PeridigmField::ELEMENT, PeridigmField::FULL_TENSOR,
                                                                 PeridigmField::CONSTANT,
                                                                 parameters.get<std::string>("Output Label"))) {}

  DeformationGradients gradients_;
  bool isGreenLagrange_, isPlaneStress_;
  int outputField_;
};

}  // namespace pd

using pd::BondStress;
PD_REGISTER_COMPUTE(BondStress, "Bond_Stress", "Stress of each point, by Hooke's law from its bond-averaged strain.")
