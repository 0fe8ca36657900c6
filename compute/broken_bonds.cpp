// Broken_Bonds: how many bonds of the body are broken, each counted once.
#include <algorithm>

#include "compute_support.hpp"
#include "plugins.hpp"

namespace pd {

class BrokenBonds : public TabledCompute {
 public:
  struct Fields : FieldTable {
    FieldHandle bondDamage = readsIfThere(pd::fields::bondDamage());
    FieldHandle number;
    explicit Fields(const Teuchos::ParameterList& parameters)
        : number(writes(outputField(parameters, pd::fields::globalScalar, "1",
                                    "Broken bonds of the body, each counted once."))) {}
  };
  static void declareParameters(ParameterDeclarations& declarations) {
    declareCommonParameters(declarations, "Broken_Bonds");
  }
  BrokenBonds(ComputeParameters params, ComputeComm comm, ComputeParameters globalData)
      : TabledCompute(completeParameters<BrokenBonds>(params, "Broken_Bonds"), params, comm, globalData),
        fields_(parameters_) {}

  const Fields& fields() const override { return fields_; }
  int compute(Blocks blocks) const override {
    std::ptrdiff_t directedBonds = 0;
    for (PeridigmNS::Block& block : *blocks) {
      const double* bondDamage = fields_.bondDamage.ifIn(*block.getDataManager());
      if (bondDamage == nullptr) continue;
      const auto neighborhood = block.getNeighborhoodData();
      const int nBonds = neighborhood->NeighborhoodListSize() - neighborhood->NumOwnedPoints();
      directedBonds += std::count_if(bondDamage, bondDamage + nBonds, [](double damage) { return damage >= 1.0; });
    }
    setGlobal(blocks, fields_.number, 0.5 * sumOverRanks(*epetraComm, static_cast<double>(directedBonds)));
    return 0;
  }

 private:
  Fields fields_;
};

}  // namespace pd

using pd::BrokenBonds;
PD_REGISTER_COMPUTE(BrokenBonds, "Broken_Bonds", "Number of broken bonds of the whole body.")
