// External_Work: work of the loads since the start, J.
//
// At points whose displacement is prescribed the load is the reaction, minus the internal force density; elsewhere it
// is External_Force_Density, which a host with body forces fills. The work between two evaluations is the mean of the
// loads at both, times the displacement in between (trapezoidal rule), so evaluate it in every increment if the load
// bends sharply. Evaluating it twice in one state adds nothing. What is displaced before any force answers, as grips
// are whose displacement does not begin at zero, does its work up to the first force. The state of the last evaluation
// is kept in fields, so that it survives a restart.
#include "needs_loads.hpp"
#include "plugins.hpp"
#include "point_selection.hpp"

namespace pd {

class ExternalWork : public TabledCompute, public NeedsLoads {
 public:
  struct Fields : FieldTable {
    FieldHandle volume = reads(pd::fields::volume());
    FieldHandle displacement = reads(pd::fields::displacement());
    FieldHandle force = reads(pd::fields::forceDensity());
    FieldHandle externalForce = reads(pd::fields::externalForceDensity());
    FieldHandle lastDisplacement, lastLoad, work;
    explicit Fields(const Teuchos::ParameterList& parameters) {
      const auto label = parameters.get<std::string>("Output Label");
      lastDisplacement = writes(
          pd::fields::pointVector(label + "_Last_Displacement", "m", "Displacement at the last evaluation.").state());
      lastLoad = writes(pd::fields::pointVector(label + "_Last_Load", "N/m3", "Load at the last evaluation.").state());
      work = writes(pd::fields::globalScalar(label, "J", "Work of the loads since the start."));
    }
  };
  static void declareParameters(ParameterDeclarations& declarations) {
    declareCommonParameters(declarations, "External_Work");
    declarations.text("Node Set", "Points whose prescribed displacement does work, too; without it only loads do.");
    declarations.texts("Node Sets", "Several such node sets.");
    declarations.atMostOneOf({"Node Set", "Node Sets"});
  }
  ExternalWork(ComputeParameters params, ComputeComm comm, ComputeParameters globalData)
      : TabledCompute(completeParameters<ExternalWork>(params, "External_Work"), params, comm, globalData),
        held_(parameters_, globalData),
        fields_(parameters_) {}

  const Fields& fields() const override { return fields_; }
  std::string inPlaceOfLoads() const override {
    return held_.isAll() ? "name the \"Node Set\" or \"Node Sets\" whose prescribed displacements do work" : "";
  }
  void initialize(Blocks blocks) override { held_.initialize(blocks); }
  int compute(Blocks blocks) const override;

 private:
  PointSelection held_;
  Fields fields_;
};

int ExternalWork::compute(Blocks blocks) const {
  double work = 0.0;
  for (std::size_t b = 0; b < blocks->size(); ++b) {
    PeridigmNS::Block& block = (*blocks)[b];
    const double* volume = view(block, fields_.volume);
    const double* displacement = view(block, fields_.displacement);
    const double* force = view(block, fields_.force);
    const double* external = view(block, fields_.externalForce);
    double* lastDisplacement = view(block, fields_.lastDisplacement);
    double* lastLoad = view(block, fields_.lastLoad);
    const auto neighborhood = block.getNeighborhoodData();
    for (int i = 0; i < neighborhood->NumOwnedPoints(); ++i) {
      const int id = neighborhood->OwnedIDs()[i];
      const bool isHeld = !held_.isAll() && held_.includes(b, i);
      for (int k = 3 * id; k < 3 * id + 3; ++k) {
        const double load = isHeld ? -force[k] : external[k];
        if (isHeld && load == 0.0 && lastLoad[k] == 0.0) continue;
        work += 0.5 * (load + lastLoad[k]) * (displacement[k] - lastDisplacement[k]) * volume[id];
        lastDisplacement[k] = displacement[k];
        lastLoad[k] = load;
      }
    }
  }
  const double before = *view(blocks->front(), fields_.work);
  setGlobal(blocks, fields_.work, before + sumOverRanks(*epetraComm, work));
  return 0;
}

}  // namespace pd

using pd::ExternalWork;
PD_REGISTER_COMPUTE(ExternalWork, "External_Work",
                    "Work of loads, and of prescribed displacements of node sets, since the start.")
