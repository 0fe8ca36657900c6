// Reaction_Force: force that holds the points of node sets where they are prescribed, N: minus the sum of their
// internal forces and of the loads on them. Inertia of those points is left out.
#include "plugins.hpp"
#include "point_selection.hpp"

namespace pd {

class ReactionForce : public TabledCompute {
 public:
  struct Fields : FieldTable {
    FieldHandle volume = reads(pd::fields::volume());
    FieldHandle force = reads(pd::fields::forceDensity());
    FieldHandle load = reads(pd::fields::externalForceDensity());
    FieldHandle reaction;
    explicit Fields(const Teuchos::ParameterList& parameters)
        : reaction(writes(outputField(parameters, pd::fields::globalVector, "N", "Force that holds the node set."))) {}
  };
  static void declareParameters(ParameterDeclarations& declarations) {
    declareCommonParameters(declarations, "Reaction_Force");
    declarations.text("Node Set", "Name of the node set that is held.").required();
  }
  ReactionForce(ComputeParameters params, ComputeComm comm, ComputeParameters globalData)
      : TabledCompute(completeParameters<ReactionForce>(params, "Reaction_Force"), params, comm, globalData),
        points_(parameters_, globalData),
        fields_(parameters_) {}

  const Fields& fields() const override { return fields_; }
  void initialize(Blocks blocks) override { points_.initialize(blocks); }

  int compute(Blocks blocks) const override {
    std::vector<const double*> volume, force, load;
    for (PeridigmNS::Block& block : *blocks) {
      volume.push_back(view(block, fields_.volume));
      force.push_back(view(block, fields_.force));
      load.push_back(view(block, fields_.load));
    }
    std::vector<double> reaction(3, 0.0);
    points_.forEach(blocks, [&](std::size_t b, int id) {
      for (int k = 0; k < 3; ++k)
        reaction[static_cast<std::size_t>(k)] -= (force[b][3 * id + k] + load[b][3 * id + k]) * volume[b][id];
    });
    setGlobal(blocks, fields_.reaction, sumOverRanks(*epetraComm, reaction).data(), 3);
    return 0;
  }

 private:
  PointSelection points_;
  Fields fields_;
};

}  // namespace pd

using pd::ReactionForce;
PD_REGISTER_COMPUTE(ReactionForce, "Reaction_Force", "Force that holds the points of a node set.")
