// Strain_Energy: elastic energy of the body, or of a block or node set, J.
#include "plugins.hpp"
#include "point_selection.hpp"
#include "stored_energy.hpp"

namespace pd {

class StrainEnergy : public PeridigmNS::Compute {
 public:
  static void declareParameters(ParameterDeclarations& declarations) {
    declareCommonParameters(declarations, "Strain_Energy");
    PointSelection::declareParameters(declarations);
  }
  StrainEnergy(ComputeParameters params, ComputeComm comm, ComputeParameters globalData)
      : StrainEnergy(completeParameters<StrainEnergy>(params, "Strain_Energy"), params, comm, globalData) {}

  std::vector<int> FieldIds() const override { return {densityField_, volumeField_, outputField_}; }
  void initialize(Blocks blocks) override { points_.initialize(blocks); }

  int compute(Blocks blocks) const override {
    constexpr auto none = PeridigmNS::PeridigmField::STEP_NONE;
    fillStoredEnergyDensity(blocks);
    std::vector<const double*> density, volume;
    for (PeridigmNS::Block& block : *blocks) {
      density.push_back(view(block, densityField_, none));
      volume.push_back(view(block, volumeField_, none));
    }
    double energy = 0.0;
    points_.forEach(blocks, [&](std::size_t b, int id) { energy += density[b][id] * volume[b][id]; });
    setGlobal(blocks, outputField_, sumOverRanks(*epetraComm, energy));
    return 0;
  }

 private:
  StrainEnergy(const Teuchos::ParameterList& parameters, ComputeParameters params, ComputeComm comm,
               ComputeParameters globalData)
      : Compute(params, comm, globalData),
        points_(parameters, globalData),
        densityField_(storedEnergyDensityField()),
        volumeField_(volumeField()),
        outputField_(globalField(parameters.get<std::string>("Output Label"), PeridigmNS::PeridigmField::SCALAR)) {}

  PointSelection points_;
  int densityField_, volumeField_, outputField_;
};

}  // namespace pd

using pd::StrainEnergy;
PD_REGISTER_COMPUTE(StrainEnergy, "Strain_Energy", "Elastic energy of the body, a block or a node set.")
