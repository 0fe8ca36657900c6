// Reaction_Force: force that holds the points of node sets where they are prescribed, N: minus the sum of their
// internal forces. Inertia of those points is left out.
#include "plugins.hpp"
#include "point_selection.hpp"

namespace pd {

class ReactionForce : public PeridigmNS::Compute {
 public:
  static void declareParameters(ParameterDeclarations& declarations) {
    declareCommonParameters(declarations, "Reaction_Force");
    declarations.text("Node Set", "Name of the node set that is held.").required();
  }
  ReactionForce(ComputeParameters params, ComputeComm comm, ComputeParameters globalData)
      : ReactionForce(completeParameters<ReactionForce>(params, "Reaction_Force"), params, comm, globalData) {}

  std::vector<int> FieldIds() const override { return {volumeField_, forceField_, outputField_}; }
  void initialize(Blocks blocks) override { points_.initialize(blocks); }

  int compute(Blocks blocks) const override {
    namespace PeridigmField = PeridigmNS::PeridigmField;
    std::vector<const double*> volume, force;
    for (PeridigmNS::Block& block : *blocks) {
      volume.push_back(view(block, volumeField_, PeridigmField::STEP_NONE));
      force.push_back(view(block, forceField_, PeridigmField::STEP_NP1));
    }
    std::vector<double> reaction(3, 0.0);
    points_.forEach(blocks, [&](std::size_t b, int id) {
      for (int k = 0; k < 3; ++k) reaction[static_cast<std::size_t>(k)] -= force[b][3 * id + k] * volume[b][id];
    });
    setGlobal(blocks, outputField_, sumOverRanks(*epetraComm, reaction).data(), 3);
    return 0;
  }

 private:
  ReactionForce(const Teuchos::ParameterList& parameters, ComputeParameters params, ComputeComm comm,
                ComputeParameters globalData)
      : Compute(params, comm, globalData),
        points_(parameters, globalData),
        volumeField_(volumeField()),
        forceField_(forceDensityField()),
        outputField_(globalField(parameters.get<std::string>("Output Label"), PeridigmNS::PeridigmField::VECTOR)) {}

  PointSelection points_;
  int volumeField_, forceField_, outputField_;
};

}  // namespace pd

using pd::ReactionForce;
PD_REGISTER_COMPUTE(ReactionForce, "Reaction_Force", "Force that holds the points of a node set.")
