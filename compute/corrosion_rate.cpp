// Corrosion_Rate: thickness of metal that a year would take, mm/year: volume lost per first surface and time.
//
// Over the whole run it is the rate of an immersion test (ASTM G1, whose years have 8760 h). What an evaluation is
// compared with is kept in a field, so that it survives a restart.
#include "kept_rate.hpp"
#include "loss_per_surface.hpp"
#include "plugins.hpp"

namespace pd {

class CorrosionRate : public LossPerSurface {
 public:
  struct Fields : LossPerSurface::Fields {
    FieldHandle time = reads(timeOfRun());
    FieldHandle last;
    explicit Fields(const Teuchos::ParameterList& parameters)
        : LossPerSurface::Fields(parameters, "mm/year", "Loss of thickness of the first surface.") {
      last = writes(kept(
          pd::fields::globalVector(parameters.get<std::string>("Output Label") + "_Last", "m3, s, 1",
                                   "Loss and time that the rate counts from, and 1 where there was an evaluation.")));
    }
  };
  static void declareParameters(ParameterDeclarations& declarations) {
    LossPerSurface::declareParameters(declarations, "Corrosion_Rate");
    declarations
        .text("Over", "The time that the loss is taken over: since the first evaluation, or since the last one.")
        .oneOf({"Whole Run", "Last Interval"})
        .defaultTo("Whole Run");
  }
  CorrosionRate(ComputeParameters params, ComputeComm comm, ComputeParameters globalData)
      : LossPerSurface(completeParameters<CorrosionRate>(params, "Corrosion_Rate"), params, comm, globalData),
        isOfInterval_(parameters_.get<std::string>("Over") == "Last Interval"),
        fields_(parameters_) {}

  const Fields& fields() const override { return fields_; }
  int compute(Blocks blocks) const override;

 private:
  bool isOfInterval_;
  Fields fields_;
};

int CorrosionRate::compute(Blocks blocks) const {
  constexpr double year = 8760.0 * 3600.0, millimetres = 1000.0;
  const double loss = volumes(blocks).dissolved, area = firstSurface(blocks);
  const auto rate = keptRate(
      view(blocks->front(), fields_.last), loss, *view(blocks->front(), fields_.time), !isOfInterval_,
      "Corrosion_Rate: metal has dissolved, but the field Time, which this host does not keep, has not changed");
  if (rate) setGlobal(blocks, fields_.result, *rate / area * year * millimetres);
  return 0;
}

}  // namespace pd

using pd::CorrosionRate;
PD_REGISTER_COMPUTE(CorrosionRate, "Corrosion_Rate", "Loss of thickness of the first surface, mm/year.")
