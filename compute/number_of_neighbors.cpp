// Number_Of_Neighbors: bonds of each point, broken ones included.
#include "compute_support.hpp"
#include "plugins.hpp"

namespace pd {

class NumberOfNeighbors : public PeridigmNS::Compute {
 public:
  static void declareParameters(ParameterDeclarations& declarations) {
    declareCommonParameters(declarations, "Number_Of_Neighbors");
  }
  NumberOfNeighbors(ComputeParameters params, ComputeComm comm, ComputeParameters globalData)
      : Compute(params, comm, globalData),
        outputField_(elementScalarField(
            completeParameters<NumberOfNeighbors>(params, "Number_Of_Neighbors").get<std::string>("Output Label"))) {}

  std::vector<int> FieldIds() const override { return {outputField_}; }

  // Neighbourhoods do not change during a run, but a restart overwrites fields: so in compute, not in initialize.
  int compute(Blocks blocks) const override {
    for (PeridigmNS::Block& block : *blocks) {
      const auto neighborhood = block.getNeighborhoodData();
      double* number = view(block, outputField_, PeridigmNS::PeridigmField::STEP_NONE);
      const int* list = neighborhood->NeighborhoodList();
      for (int i = 0; i < neighborhood->NumOwnedPoints(); ++i) {
        number[neighborhood->OwnedIDs()[i]] = *list;
        list += 1 + *list;
      }
    }
    return 0;
  }

 private:
  int outputField_;
};

}  // namespace pd

using pd::NumberOfNeighbors;
PD_REGISTER_COMPUTE(NumberOfNeighbors, "Number_Of_Neighbors", "Number of bonds of each point, broken ones included.")
