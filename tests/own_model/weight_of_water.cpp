// "Weight Of Water": the head of water over submerged points presses them down while it rises; a load of its own.
#include <algorithm>

#include "driver/boundary/load.hpp"

namespace {

/// Pressure (specific weight) x (level - y) on a layer of points, where the level is above them, downwards along y.
class WeightOfWater : public pd::Load {
 public:
  static void declareParameters(pd::ParameterDeclarations& declare) {
    pd::declareNodeSet(declare);
    declare.function("Value", "m", "Level of the water: y of its surface.").required();
    declare.real("Depth", "m", "Thickness of the layer of points that carries the pressure.").positive().required();
    declare.real("Specific Weight", "N/m3", "Of the water.").positive().defaultTo(9810.0);
  }
  explicit WeightOfWater(const pd::ConditionSection& section)
      : Load(section),
        depth_(section.list.get<double>("Depth")),
        specificWeight_(section.list.get<double>("Specific Weight")) {}

  void measure(const pd::Discretization& mesh, const pd::Communicator&) override { requireMotionAlong(1, mesh); }
  /// N/m3 at owned points, added to what other loads give. evaluate() is Value at each of points().
  void addForceDensity(const pd::Discretization& mesh, double t, double* forceDensity) const override {
    const std::vector<double>& level = evaluate(mesh, t);
    for (std::size_t k = 0; k < level.size(); ++k) {
      const auto i = static_cast<std::size_t>(points()[k]);
      if (points()[k] >= mesh.nOwned) continue;
      const double head = std::max(level[k] - mesh.x[3 * i + 1], 0.0);
      forceDensity[3 * i + 1] -= specificWeight_ * head / depth_;
    }
  }

 private:
  double depth_, specificWeight_;
};

PD_REGISTER_CONDITION(WeightOfWater, "Weight Of Water", "Pressure of water that stands over a layer of points")

}  // namespace
