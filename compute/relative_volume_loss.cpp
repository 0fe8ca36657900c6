// Relative_Volume_Loss: volume of the metal that has dissolved, in % of what was there at the start.
#include <stdexcept>

#include "dissolved_metal_sum.hpp"
#include "plugins.hpp"

namespace pd {

class RelativeVolumeLoss : public DissolvedMetalSum {
 public:
  struct Fields : DissolvedMetalSum::Fields {
    explicit Fields(const Teuchos::ParameterList& parameters)
        : DissolvedMetalSum::Fields(parameters, "%", "Volume of metal that has dissolved, of that at the start.") {}
  };
  static void declareParameters(ParameterDeclarations& declarations) {
    DissolvedMetalSum::declareParameters(declarations, "Relative_Volume_Loss");
  }
  RelativeVolumeLoss(ComputeParameters params, ComputeComm comm, ComputeParameters globalData)
      : DissolvedMetalSum(completeParameters<RelativeVolumeLoss>(params, "Relative_Volume_Loss"), params, comm,
                          globalData),
        fields_(parameters_) {}

  const Fields& fields() const override { return fields_; }

  int compute(Blocks blocks) const override {
    const double whole = volumeOfMetal(blocks);
    if (whole == 0.0)
      throw std::invalid_argument(
          "Relative_Volume_Loss: there is no metal that dissolves where it looks; name a \"Block\" or \"Node Set\" "
          "with some, or neither");
    sum(blocks, 100.0 / whole, [](const DissolvedMetal::View&, int) { return 1.0; });
    return 0;
  }

 private:
  Fields fields_;
};

}  // namespace pd

using pd::RelativeVolumeLoss;
PD_REGISTER_COMPUTE(RelativeVolumeLoss, "Relative_Volume_Loss",
                    "Volume of the metal that has dissolved, in % of what was there at the start.")
