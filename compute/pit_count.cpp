// Pit_Count: number of pits that a surface has.
#include "pits.hpp"
#include "plugins.hpp"

namespace pd {

class PitCount : public PitCompute {
 public:
  struct Fields : PitCompute::Fields {
    explicit Fields(const Teuchos::ParameterList& parameters)
        : PitCompute::Fields(parameters, "1", "Number of pits.") {}
  };
  static void declareParameters(ParameterDeclarations& declarations) {
    PitCompute::declareParameters(declarations, "Pit_Count");
  }
  PitCount(ComputeParameters params, ComputeComm comm, ComputeParameters globalData)
      : PitCompute(completeParameters<PitCount>(params, "Pit_Count"), params, comm, globalData), fields_(parameters_) {}

  const Fields& fields() const override { return fields_; }
  int compute(Blocks blocks) const override {
    setGlobal(blocks, fields_.result, static_cast<double>(pits(blocks).size()));
    return 0;
  }

 private:
  Fields fields_;
};

}  // namespace pd

using pd::PitCount;
PD_REGISTER_COMPUTE(PitCount, "Pit_Count", "Number of pits of a surface.")
