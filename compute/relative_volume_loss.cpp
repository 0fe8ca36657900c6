// Relative_Volume_Loss: volume of the metal that has dissolved, in % of what was there at the start, or at a first
// scan.
//
// What was there at the scan lies, linear in time, between the evaluations before and after it. They are kept in a
// field, so that it survives a restart.
#include <stdexcept>

#include "dissolved_metal_sum.hpp"
#include "plugins.hpp"

namespace pd {

class RelativeVolumeLoss : public DissolvedMetalSum {
 public:
  struct Fields : DissolvedMetalSum::Fields {
    FieldHandle time, last;
    explicit Fields(const Teuchos::ParameterList& parameters)
        : DissolvedMetalSum::Fields(parameters, "%", "Volume of metal that has dissolved, of that at the start.") {
      if (!parameters.isParameter("First Scan")) return;
      time = reads(timeOfRun());
      last =
          writes(kept(pd::fields::globalVector(parameters.get<std::string>("Output Label") + "_Last", "m3, s, m3",
                                               "Loss and time of the last evaluation, and loss at the first scan.")));
    }
  };
  static void declareParameters(ParameterDeclarations& declarations) {
    DissolvedMetalSum::declareParameters(declarations, "Relative_Volume_Loss");
    declarations
        .real("First Scan", "s",
              "Time of the scan that losses count from: they are in % of the metal that was there then, and 0 before. "
              "Without it they count from the start.")
        .atLeast(0.0);
  }
  RelativeVolumeLoss(ComputeParameters params, ComputeComm comm, ComputeParameters globalData)
      : DissolvedMetalSum(completeParameters<RelativeVolumeLoss>(params, "Relative_Volume_Loss"), params, comm,
                          globalData),
        fields_(parameters_) {}

  const Fields& fields() const override { return fields_; }

  int compute(Blocks blocks) const override {
    const auto [dissolved, whole] = volumes(blocks);
    const double before = fields_.last.isUsed() ? lossBeforeScan(blocks, dissolved) : 0.0;
    if (!(whole > before)) throw std::runtime_error("Relative_Volume_Loss: at the first scan no metal is left");
    setGlobal(blocks, fields_.result, 100.0 * (dissolved - before) / (whole - before));
    return 0;
  }

 private:
  /// m3; all of it so far where the scan is still to come.
  double lossBeforeScan(const Blocks& blocks, double dissolved) const {
    const double scan = parameters_.get<double>("First Scan"), time = *view(blocks->front(), fields_.time);
    double* last = view(blocks->front(), fields_.last);
    if (last[1] < scan || last[1] == 0.0) {
      const bool isPassed = time > scan && time > last[1];
      last[2] = isPassed ? last[0] + (dissolved - last[0]) * (scan - last[1]) / (time - last[1]) : dissolved;
    }
    last[0] = dissolved;
    last[1] = time;
    return last[2];
  }

  Fields fields_;
};

}  // namespace pd

using pd::RelativeVolumeLoss;
PD_REGISTER_COMPUTE(RelativeVolumeLoss, "Relative_Volume_Loss",
                    "Volume of the metal that has dissolved, in % of what was there at the start or at a first scan.")
