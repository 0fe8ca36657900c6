// Strain_Energy: elastic energy of the body, or of a block or node set, J.
#include "plugins.hpp"
#include "point_selection.hpp"
#include "stored_energy.hpp"

namespace pd {

class StrainEnergy : public TabledCompute {
 public:
  struct Fields : FieldTable {
    FieldHandle density = writes(pd::fields::storedEnergyDensity());  ///< by the materials
    FieldHandle volume = reads(pd::fields::volume());
    FieldHandle energy;
    explicit Fields(const Teuchos::ParameterList& parameters)
        : energy(writes(outputField(parameters, pd::fields::globalScalar, "J", "Elastic energy."))) {}
  };
  static void declareParameters(ParameterDeclarations& declarations) {
    declareCommonParameters(declarations, "Strain_Energy");
    PointSelection::declareParameters(declarations);
  }
  StrainEnergy(ComputeParameters params, ComputeComm comm, ComputeParameters globalData)
      : TabledCompute(completeParameters<StrainEnergy>(params, "Strain_Energy"), params, comm, globalData),
        points_(parameters_, globalData),
        fields_(parameters_) {}

  const Fields& fields() const override { return fields_; }
  void initialize(Blocks blocks) override { points_.initialize(blocks); }

  int compute(Blocks blocks) const override {
    fillStoredEnergyDensity(blocks);
    std::vector<const double*> density, volume;
    for (PeridigmNS::Block& block : *blocks) {
      density.push_back(view(block, fields_.density));
      volume.push_back(view(block, fields_.volume));
    }
    double energy = 0.0;
    points_.forEach(blocks, [&](std::size_t b, int id) { energy += density[b][id] * volume[b][id]; });
    setGlobal(blocks, fields_.energy, sumOverRanks(*epetraComm, energy));
    return 0;
  }

 private:
  PointSelection points_;
  Fields fields_;
};

}  // namespace pd

using pd::StrainEnergy;
PD_REGISTER_COMPUTE(StrainEnergy, "Strain_Energy", "Elastic energy of the body, a block or a node set.")
