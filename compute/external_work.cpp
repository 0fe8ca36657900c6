// External_Work: work of the loads since the start, J.
//
// At points whose displacement is prescribed the load is the reaction, minus the internal force density; elsewhere it
// is External_Force_Density, which a host with body forces fills. The work between two evaluations is the mean of the
// loads at both, times the displacement in between (trapezoidal rule), so evaluate it in every increment if the load
// bends sharply. Evaluating it twice in one state adds nothing. The state of the last evaluation is kept in fields, so
// that it survives a restart.
#include "plugins.hpp"
#include "point_selection.hpp"

namespace pd {

namespace PeridigmField = PeridigmNS::PeridigmField;

class ExternalWork : public PeridigmNS::Compute {
 public:
  static void declareParameters(ParameterDeclarations& declarations) {
    declareCommonParameters(declarations, "External_Work");
    declarations.text("Node Set", "Points whose displacement is prescribed.");
    declarations.texts("Node Sets", "Several such node sets.");
    declarations.atMostOneOf({"Node Set", "Node Sets"});
  }
  ExternalWork(ComputeParameters params, ComputeComm comm, ComputeParameters globalData)
      : ExternalWork(completeParameters<ExternalWork>(params, "External_Work"), params, comm, globalData) {}

  std::vector<int> FieldIds() const override {
    return {volumeField_,           displacementField_, forceField_, externalForceField_,
            lastDisplacementField_, lastLoadField_,     outputField_};
  }
  void initialize(Blocks blocks) override { held_.initialize(blocks); }
  int compute(Blocks blocks) const override;

 private:
  ExternalWork(const Teuchos::ParameterList& parameters, ComputeParameters params, ComputeComm comm,
               ComputeParameters globalData)
      : Compute(params, comm, globalData), held_(parameters, globalData) {
    const std::string label = parameters.get<std::string>("Output Label");
    outputField_ = globalField(label, PeridigmField::SCALAR);
    lastDisplacementField_ = memoryField(label + "_Last_Displacement");
    lastLoadField_ = memoryField(label + "_Last_Load");
  }

  static int memoryField(const std::string& label) {
    return PeridigmNS::FieldManager::self().getFieldId(PeridigmField::NODE, PeridigmField::VECTOR,
                                                       PeridigmField::CONSTANT, label);
  }

  PointSelection held_;
  int volumeField_ = pd::volumeField(), displacementField_ = pd::displacementField(), forceField_ = forceDensityField(),
      externalForceField_ = externalForceDensityField();
  int lastDisplacementField_, lastLoadField_, outputField_;
};

int ExternalWork::compute(Blocks blocks) const {
  double work = 0.0;
  for (std::size_t b = 0; b < blocks->size(); ++b) {
    PeridigmNS::Block& block = (*blocks)[b];
    const double* volume = view(block, volumeField_, PeridigmField::STEP_NONE);
    const double* displacement = view(block, displacementField_, PeridigmField::STEP_NP1);
    const double* force = view(block, forceField_, PeridigmField::STEP_NP1);
    const double* external = view(block, externalForceField_, PeridigmField::STEP_NP1);
    double* lastDisplacement = view(block, lastDisplacementField_, PeridigmField::STEP_NONE);
    double* lastLoad = view(block, lastLoadField_, PeridigmField::STEP_NONE);
    const auto neighborhood = block.getNeighborhoodData();
    for (int i = 0; i < neighborhood->NumOwnedPoints(); ++i) {
      const int id = neighborhood->OwnedIDs()[i];
      const bool isHeld = !held_.isAll() && held_.includes(b, i);
      for (int k = 3 * id; k < 3 * id + 3; ++k) {
        const double load = isHeld ? -force[k] : external[k];
        work += 0.5 * (load + lastLoad[k]) * (displacement[k] - lastDisplacement[k]) * volume[id];
        lastDisplacement[k] = displacement[k];
        lastLoad[k] = load;
      }
    }
  }
  const double before = *view(blocks->front(), outputField_, PeridigmField::STEP_NONE);
  setGlobal(blocks, outputField_, before + sumOverRanks(*epetraComm, work));
  return 0;
}

}  // namespace pd

using pd::ExternalWork;
PD_REGISTER_COMPUTE(ExternalWork, "External_Work", "Work of prescribed displacements and body forces since the start.")
