// Deepest_Place: where a surface has dissolved deepest, m: the bottom of the deepest column.
#include <algorithm>

#include "plugins.hpp"
#include "surface_compute.hpp"

namespace pd {

namespace {

/// Of columns that differ by rounding, as different numbers of ranks leave it, the first.
const SurfaceColumns::Column& deepestOf(const SurfaceColumns::Profile& profile) {
  const double enough = (1.0 - 1e-6) * maximumDepth(profile);
  return *std::find_if(profile.begin(), profile.end(), [&](const SurfaceColumns::Column& column) {
    return column.isMetal() && column.depth >= enough;
  });
}

}  // namespace

class DeepestPlace : public SurfaceCompute {
 public:
  struct Fields : SurfaceCompute::Fields {
    explicit Fields(const Teuchos::ParameterList& parameters)
        : SurfaceCompute::Fields(parameters, pd::fields::globalVector, "m",
                                 "Where the surface has dissolved deepest.") {}
  };
  static void declareParameters(ParameterDeclarations& declarations) {
    SurfaceCompute::declareParameters(declarations, "Deepest_Place");
  }
  DeepestPlace(ComputeParameters params, ComputeComm comm, ComputeParameters globalData)
      : SurfaceCompute(completeParameters<DeepestPlace>(params, "Deepest_Place"), params, comm, globalData),
        fields_(parameters_) {}

  const Fields& fields() const override { return fields_; }
  int compute(Blocks blocks) const override {
    const SurfaceColumns::Profile columns = profile(blocks);
    setGlobal(blocks, fields_.result, columns_.bottom(deepestOf(columns)).data(), 3);
    return 0;
  }

 private:
  Fields fields_;
};

}  // namespace pd

using pd::DeepestPlace;
PD_REGISTER_COMPUTE(DeepestPlace, "Deepest_Place", "Place to which a surface has dissolved deepest, m.")
