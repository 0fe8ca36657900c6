// Broken_Bonds: how many bonds of the body are broken, each counted once.
#include "compute_support.hpp"
#include "plugins.hpp"

namespace pd {

class BrokenBonds : public PeridigmNS::Compute {
 public:
  static void declareParameters(ParameterDeclarations& declarations) {
    declareCommonParameters(declarations, "Broken_Bonds");
  }
  BrokenBonds(ComputeParameters params, ComputeComm comm, ComputeParameters globalData)
      : Compute(params, comm, globalData),
        outputField_(
            globalField(completeParameters<BrokenBonds>(params, "Broken_Bonds").get<std::string>("Output Label"),
                        PeridigmNS::PeridigmField::SCALAR)) {}

  std::vector<int> FieldIds() const override { return {outputField_}; }

  int compute(Blocks blocks) const override {
    double directedBonds = 0.0;
    for (PeridigmNS::Block& block : *blocks) {
      const double* bondDamage = bondDamageView(block);
      if (bondDamage == nullptr) continue;
      const auto neighborhood = block.getNeighborhoodData();
      const int nBonds = neighborhood->NeighborhoodListSize() - neighborhood->NumOwnedPoints();
      for (int k = 0; k < nBonds; ++k) directedBonds += bondDamage[k] >= 1.0 ? 1.0 : 0.0;
    }
    setGlobal(blocks, outputField_, 0.5 * sumOverRanks(*epetraComm, directedBonds));
    return 0;
  }

 private:
  int outputField_;
};

}  // namespace pd

using pd::BrokenBonds;
PD_REGISTER_COMPUTE(BrokenBonds, "Broken_Bonds", "Number of broken bonds of the whole body.")
