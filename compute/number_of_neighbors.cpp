// Number_Of_Neighbors: bonds of each point, broken ones included.
#include "compute_support.hpp"
#include "plugins.hpp"

namespace pd {

class NumberOfNeighbors : public TabledCompute {
 public:
  struct Fields : FieldTable {
    FieldHandle number;
    explicit Fields(const Teuchos::ParameterList& parameters)
        : number(writes(
              outputField(parameters, pd::fields::elementScalar, "1", "Bonds of the point, broken ones included."))) {}
  };
  static void declareParameters(ParameterDeclarations& declarations) {
    declareCommonParameters(declarations, "Number_Of_Neighbors");
  }
  NumberOfNeighbors(ComputeParameters params, ComputeComm comm, ComputeParameters globalData)
      : TabledCompute(completeParameters<NumberOfNeighbors>(params, "Number_Of_Neighbors"), params, comm, globalData),
        fields_(parameters_) {}

  const Fields& fields() const override { return fields_; }
  // Neighbourhoods do not change during a run, but a restart overwrites fields: so in compute, not in initialize.
  int compute(Blocks blocks) const override {
    for (PeridigmNS::Block& block : *blocks) {
      const auto neighborhood = block.getNeighborhoodData();
      double* number = view(block, fields_.number);
      const int* list = neighborhood->NeighborhoodList();
      for (int i = 0; i < neighborhood->NumOwnedPoints(); ++i) {
        number[neighborhood->OwnedIDs()[i]] = *list;
        list += 1 + *list;
      }
    }
    return 0;
  }

 private:
  Fields fields_;
};

}  // namespace pd

using pd::NumberOfNeighbors;
PD_REGISTER_COMPUTE(NumberOfNeighbors, "Number_Of_Neighbors", "Number of bonds of each point, broken ones included.")
