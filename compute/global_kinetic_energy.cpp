// Global_Kinetic_Energy: kinetic energy of the body, or of a block or node set, J.
#include "plugins.hpp"
#include "point_selection.hpp"

namespace pd {

class GlobalKineticEnergy : public TabledCompute {
 public:
  struct Fields : FieldTable {
    FieldHandle volume = reads(pd::fields::volume());
    FieldHandle velocity = reads(pd::fields::velocity());
    FieldHandle energy;
    explicit Fields(const Teuchos::ParameterList& parameters)
        : energy(writes(outputField(parameters, pd::fields::globalScalar, "J", "Kinetic energy."))) {}
  };
  static void declareParameters(ParameterDeclarations& declarations) {
    declareCommonParameters(declarations, "Global_Kinetic_Energy");
    PointSelection::declareParameters(declarations);
  }
  GlobalKineticEnergy(ComputeParameters params, ComputeComm comm, ComputeParameters globalData)
      : TabledCompute(completeParameters<GlobalKineticEnergy>(params, "Global_Kinetic_Energy"), params, comm,
                      globalData),
        points_(parameters_, globalData),
        fields_(parameters_) {}

  const Fields& fields() const override { return fields_; }
  void initialize(Blocks blocks) override { points_.initialize(blocks); }

  int compute(Blocks blocks) const override {
    std::vector<const double*> volume, velocity;
    std::vector<double> density;
    for (PeridigmNS::Block& block : *blocks) {
      volume.push_back(view(block, fields_.volume));
      velocity.push_back(view(block, fields_.velocity));
      density.push_back(block.getMaterialModel()->Density());
    }
    double energy = 0.0;
    points_.forEach(blocks, [&](std::size_t b, int id) {
      const double* v = velocity[b] + 3 * id;
      energy += 0.5 * density[b] * volume[b][id] * (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    });
    setGlobal(blocks, fields_.energy, sumOverRanks(*epetraComm, energy));
    return 0;
  }

 private:
  PointSelection points_;
  Fields fields_;
};

}  // namespace pd

using pd::GlobalKineticEnergy;
PD_REGISTER_COMPUTE(GlobalKineticEnergy, "Global_Kinetic_Energy", "Kinetic energy of the body, a block or a node set.")
