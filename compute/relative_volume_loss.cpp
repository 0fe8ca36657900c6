// Relative_Volume_Loss: volume of the metal that has dissolved, in % of what was there at the start, or at a first
// scan.
//
// What was there at the scan lies, linear in time, between the evaluations before and after it. They are kept in
// fields, so that it survives a restart, with the time of the scan that they are kept for: another one may lie before
// them.
#include <stdexcept>
#include <string>

#include "dissolved_metal_sum.hpp"
#include "plugins.hpp"

namespace pd {

class RelativeVolumeLoss : public DissolvedMetalSum {
 public:
  struct Fields : DissolvedMetalSum::Fields {
    FieldHandle time, last, scan;
    explicit Fields(const Teuchos::ParameterList& parameters)
        : DissolvedMetalSum::Fields(parameters, "%", "Volume of metal that has dissolved, of that at the start.") {
      if (!parameters.isParameter("First Scan")) return;
      time = reads(timeOfRun());
      const auto label = parameters.get<std::string>("Output Label");
      last = writes(kept(pd::fields::globalVector(
          label + "_Last", "m3, s, m3", "Loss and time of the last evaluation, and loss at the first scan.")));
      scan = writes(kept(pd::fields::globalVector(label + "_Scan", "s, 1",
                                                  "Time of the first scan, and 1 where there was an evaluation.")));
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
    const bool hasScan = fields_.last.isUsed();
    const double before = hasScan ? lossBeforeScan(blocks, dissolved) : 0.0;
    const bool isOver = !hasScan || *view(blocks->front(), fields_.time) > firstScan();
    if (isOver && !(whole > before)) refuse("at the First Scan no metal was left; set an earlier one");
    setGlobal(blocks, fields_.result, isOver ? 100.0 * (dissolved - before) / (whole - before) : 0.0);
    return 0;
  }

 private:
  double firstScan() const { return parameters_.get<double>("First Scan"); }

  [[noreturn]] void refuse(const std::string& why) const {
    throw std::runtime_error("Relative_Volume_Loss, Output Label \"" + parameters_.get<std::string>("Output Label") +
                             "\": " + why);
  }

  /// m3; all of it so far where the scan is still to come.
  double lossBeforeScan(const Blocks& blocks, double dissolved) const {
    const double scan = firstScan(), time = *view(blocks->front(), fields_.time);
    double *last = view(blocks->front(), fields_.last), *keptScan = view(blocks->front(), fields_.scan);
    const bool isFirst = keptScan[1] == 0.0, isOther = isFirst || keptScan[0] != scan;
    if (isOther && (isFirst ? time > scan && dissolved > 0.0 : last[1] > scan))
      refuse(
          "the First Scan lies before the start of this run, and what had dissolved by then was not kept; set that of "
          "the run that wrote the checkpoint or a time to come, or start afresh");
    if (isOther || last[1] < scan) {
      const bool isPassed = time > scan && time > last[1];
      last[2] = isPassed ? last[0] + (dissolved - last[0]) * (scan - last[1]) / (time - last[1]) : dissolved;
    }
    last[0] = dissolved;
    last[1] = time;
    keptScan[0] = scan;
    keptScan[1] = 1.0;
    return last[2];
  }

  Fields fields_;
};

}  // namespace pd

using pd::RelativeVolumeLoss;
PD_REGISTER_COMPUTE(RelativeVolumeLoss, "Relative_Volume_Loss",
                    "Volume of the metal that has dissolved, in % of what was there at the start or at a first scan.")
