// Corrosion_Depth: how deep the metal has dissolved behind each point of a surface, m; 0 at other points.
#include "plugins.hpp"
#include "surface_compute.hpp"

namespace pd {

namespace PeridigmField = PeridigmNS::PeridigmField;

class CorrosionDepth : public SurfaceCompute {
 public:
  static void declareParameters(ParameterDeclarations& declarations) {
    SurfaceCompute::declareParameters(declarations, "Corrosion_Depth");
  }
  CorrosionDepth(ComputeParameters params, ComputeComm comm, ComputeParameters globalData)
      : SurfaceCompute(completeParameters<CorrosionDepth>(params, "Corrosion_Depth"), params, comm, globalData,
                       pointResult) {}

  int compute(Blocks blocks) const override {
    const SurfaceColumns::Profile columns = profile(blocks);
    std::vector<double*> depths;
    for (PeridigmNS::Block& block : *blocks) depths.push_back(view(block, outputField_, PeridigmField::STEP_NONE));
    columns_.forEachSurfacePoint(
        [&](std::size_t b, int id, std::size_t column) { depths[b][id] = columns[column].depth; });
    return 0;
  }

 private:
  static int pointResult(const std::string& label) {
    return PeridigmNS::FieldManager::self().getFieldId(PeridigmField::NODE, PeridigmField::SCALAR,
                                                       PeridigmField::CONSTANT, label);
  }
};

}  // namespace pd

using pd::CorrosionDepth;
PD_REGISTER_COMPUTE(CorrosionDepth, "Corrosion_Depth", "Depth dissolved behind each point of a surface, m.")
