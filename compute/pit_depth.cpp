// Pit_Depth: mean depth of the pits of a surface, each where it is deepest, m; 0 without pits.
#include <numeric>

#include "pits.hpp"
#include "plugins.hpp"

namespace pd {

class PitDepth : public PitCompute {
 public:
  struct Fields : PitCompute::Fields {
    explicit Fields(const Teuchos::ParameterList& parameters)
        : PitCompute::Fields(parameters, "m", "Mean depth of the pits.") {}
  };
  static void declareParameters(ParameterDeclarations& declarations) {
    PitCompute::declareParameters(declarations, "Pit_Depth");
  }
  PitDepth(ComputeParameters params, ComputeComm comm, ComputeParameters globalData)
      : PitCompute(completeParameters<PitDepth>(params, "Pit_Depth"), params, comm, globalData), fields_(parameters_) {}

  const Fields& fields() const override { return fields_; }
  int compute(Blocks blocks) const override {
    const std::vector<double> depths = pits(blocks);
    const double sum = std::accumulate(depths.begin(), depths.end(), 0.0);
    setGlobal(blocks, fields_.result, depths.empty() ? 0.0 : sum / static_cast<double>(depths.size()));
    return 0;
  }

 private:
  Fields fields_;
};

}  // namespace pd

using pd::PitDepth;
PD_REGISTER_COMPUTE(PitDepth, "Pit_Depth", "Mean depth of the pits of a surface, m.")
