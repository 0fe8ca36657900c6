// Broken_Bonds: how many bonds of the body are broken, each counted once.
#include <algorithm>

#include "compute_support.hpp"
#include "families.hpp"
#include "plugins.hpp"

namespace pd {

class BrokenBonds : public TabledCompute {
 public:
  struct Fields : FieldTable {
    FieldHandle bondDamage = readsIfThere(pd::fields::bondDamage());
    FieldHandle damage = readsIfThere(pd::fields::damage());
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
  void initialize(Blocks blocks) override { families_ = Families::of(*blocks); }
  int compute(Blocks blocks) const override {
    std::ptrdiff_t directedBonds = 0;
    for (std::size_t b = 0; b < families_.size(); ++b) {
      PeridigmNS::Block& block = (*blocks)[b];
      const double* bondDamage = fields_.bondDamage.ifIn(*block.getDataManager());
      if (bondDamage == nullptr) continue;
      // Most points have lost nothing: their bonds need not be read.
      const double* damage = fields_.damage.ifIn(*block.getDataManager());
      const Families& families = families_[b];
      for (std::size_t p = 0; p < families.size(); ++p) {
        if (damage != nullptr && damage[families.id(p)] == 0.0) continue;
        const Family family = families[p];
        const double* own = bondDamage + family.firstBond;
        directedBonds += std::count_if(own, own + family.n, [](double lost) { return lost >= 1.0; });
      }
    }
    setGlobal(blocks, fields_.number, 0.5 * sumOverRanks(*epetraComm, static_cast<double>(directedBonds)));
    return 0;
  }

 private:
  Fields fields_;
  std::vector<Families> families_;  ///< [blocks]
};

}  // namespace pd

using pd::BrokenBonds;
PD_REGISTER_COMPUTE(BrokenBonds, "Broken_Bonds", "Number of broken bonds of the whole body.")
