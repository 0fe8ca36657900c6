// Global_Kinetic_Energy: kinetic energy of the body, or of a block or node set, J.
#include "plugins.hpp"
#include "point_selection.hpp"

namespace pd {

class GlobalKineticEnergy : public PeridigmNS::Compute {
 public:
  static void declareParameters(ParameterDeclarations& declarations) {
    declareCommonParameters(declarations, "Global_Kinetic_Energy");
    PointSelection::declareParameters(declarations);
  }
  GlobalKineticEnergy(ComputeParameters params, ComputeComm comm, ComputeParameters globalData)
      : GlobalKineticEnergy(completeParameters<GlobalKineticEnergy>(params, "Global_Kinetic_Energy"), params, comm,
                            globalData) {}

  std::vector<int> FieldIds() const override { return {volumeField_, velocityField_, outputField_}; }
  void initialize(Blocks blocks) override { points_.initialize(blocks); }

  int compute(Blocks blocks) const override {
    namespace PeridigmField = PeridigmNS::PeridigmField;
    std::vector<const double*> volume, velocity;
    std::vector<double> density;
    for (PeridigmNS::Block& block : *blocks) {
      volume.push_back(view(block, volumeField_, PeridigmField::STEP_NONE));
      velocity.push_back(view(block, velocityField_, PeridigmField::STEP_NP1));
      density.push_back(block.getMaterialModel()->Density());
    }
    double energy = 0.0;
    points_.forEach(blocks, [&](std::size_t b, int id) {
      const double* v = velocity[b] + 3 * id;
      energy += 0.5 * density[b] * volume[b][id] * (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    });
    setGlobal(blocks, outputField_, sumOverRanks(*epetraComm, energy));
    return 0;
  }

 private:
  GlobalKineticEnergy(const Teuchos::ParameterList& parameters, ComputeParameters params, ComputeComm comm,
                      ComputeParameters globalData)
      : Compute(params, comm, globalData),
        points_(parameters, globalData),
        volumeField_(volumeField()),
        velocityField_(velocityField()),
        outputField_(globalField(parameters.get<std::string>("Output Label"), PeridigmNS::PeridigmField::SCALAR)) {}

  PointSelection points_;
  int volumeField_, velocityField_, outputField_;
};

}  // namespace pd

using pd::GlobalKineticEnergy;
PD_REGISTER_COMPUTE(GlobalKineticEnergy, "Global_Kinetic_Energy", "Kinetic energy of the body, a block or a node set.")
