// Bond_Stress: stress of each point, Pa, 9 components row by row.
//
// The force of a single bond is its material's own business, so this is not a sum of bond forces: it is Hooke's law
// with the material's moduli, applied to the strain that the unbroken bonds show.
#include <algorithm>

#include "plugins.hpp"
#include "point_deformation.hpp"

namespace pd {

class BondStress : public TabledCompute {
 public:
  struct Fields : DeformationGradients::Fields {
    FieldHandle stress;
    explicit Fields(const Teuchos::ParameterList& parameters)
        : stress(writes(outputField(parameters, pd::fields::elementTensor, "Pa", "Stress of the point, row by row."))) {
    }
  };
  static void declareParameters(ParameterDeclarations& declarations) {
    declareCommonParameters(declarations, "Bond_Stress");
    declareStrainMeasure(declarations);
    HookesLaw::declareParameters(declarations);
  }
  BondStress(ComputeParameters params, ComputeComm comm, ComputeParameters globalData)
      : TabledCompute(completeParameters<BondStress>(params, "Bond_Stress"), params, comm, globalData),
        isGreenLagrange_(parameters_.get<std::string>("Strain Measure") == "Green-Lagrange"),
        isPlaneStress_(parameters_.get<bool>("Plane Stress")),
        fields_(parameters_) {}

  const Fields& fields() const override { return fields_; }
  int compute(Blocks blocks) const override {
    for (PeridigmNS::Block& block : *blocks) {
      const std::vector<Tensor> gradients = gradients_.of(block);
      const HookesLaw law(*block.getMaterialModel(), isPlaneStress_);
      double* output = view(block, fields_.stress);
      for (std::size_t i = 0; i < gradients.size(); ++i) {
        const Tensor stress = law.stress(strainOf(gradients[i], isGreenLagrange_));
        std::copy(stress.begin(), stress.end(), output + 9 * block.getNeighborhoodData()->OwnedIDs()[i]);
      }
    }
    return 0;
  }

 private:
  DeformationGradients gradients_;
  bool isGreenLagrange_, isPlaneStress_;
  Fields fields_;
};

}  // namespace pd

using pd::BondStress;
PD_REGISTER_COMPUTE(BondStress, "Bond_Stress", "Stress of each point, by Hooke's law from its bond-averaged strain.")
