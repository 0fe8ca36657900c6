// Corrosion_Depth: how deep the metal has dissolved behind each point of a surface, m; 0 at other points.
#include "plugins.hpp"
#include "surface_compute.hpp"

namespace pd {

class CorrosionDepth : public SurfaceCompute {
 public:
  struct Fields : SurfaceCompute::Fields {
    explicit Fields(const Teuchos::ParameterList& parameters)
        : SurfaceCompute::Fields(parameters, pd::fields::pointScalar, "m",
                                 "Depth dissolved behind the point of the surface.") {}
  };
  static void declareParameters(ParameterDeclarations& declarations) {
    SurfaceCompute::declareParameters(declarations, "Corrosion_Depth");
  }
  CorrosionDepth(ComputeParameters params, ComputeComm comm, ComputeParameters globalData)
      : SurfaceCompute(completeParameters<CorrosionDepth>(params, "Corrosion_Depth"), params, comm, globalData),
        fields_(parameters_) {}

  const Fields& fields() const override { return fields_; }
  int compute(Blocks blocks) const override {
    const SurfaceColumns::Profile columns = profile(blocks);
    std::vector<double*> depths;
    for (PeridigmNS::Block& block : *blocks) depths.push_back(view(block, fields_.result));
    columns_.forEachSurfacePoint(
        [&](std::size_t b, int id, std::size_t column) { depths[b][id] = columns[column].depth; });
    return 0;
  }

 private:
  Fields fields_;
};

}  // namespace pd

using pd::CorrosionDepth;
PD_REGISTER_COMPUTE(CorrosionDepth, "Corrosion_Depth", "Depth dissolved behind each point of a surface, m.")
