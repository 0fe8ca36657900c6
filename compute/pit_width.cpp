// Pit_Width: width of what has dissolved at a depth, seen along the direction into the metal, m.
//
// In a plane body the length of the surface whose depth exceeds the level, depths taken as linear from column to
// column; in a solid the diameter of the circle of the same area, in whole columns. Several pits add up.
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "plugins.hpp"
#include "surface_compute.hpp"

namespace pd {

namespace {

/// A column's place along the axis across which columns stand, and how much deeper it is than the level.
struct Excess {
  double place, value;
};

/// Length over which the excess is positive; beyond the ends it stays what it is for half a distance between columns.
double lengthAbove(std::vector<Excess> line) {
  std::sort(line.begin(), line.end(), [](const Excess& a, const Excess& b) { return a.place < b.place; });
  double length = 0.0;
  for (std::size_t k = 1; k < line.size(); ++k) {
    const double a = line[k - 1].value, b = line[k].value, distance = line[k].place - line[k - 1].place;
    const double above = std::max(a, 0.0) + std::max(b, 0.0);
    if (above > 0.0) length += distance * above / (std::abs(a) + std::abs(b));
    if (k == 1 && a > 0.0) length += 0.5 * distance;
    if (k + 1 == line.size() && b > 0.0) length += 0.5 * distance;
  }
  return length;
}

}  // namespace

class PitWidth : public SurfaceCompute {
 public:
  struct Fields : SurfaceCompute::Fields {
    explicit Fields(const Teuchos::ParameterList& parameters)
        : SurfaceCompute::Fields(parameters, pd::fields::globalScalar, "m", "Width of the pit.") {}
  };
  static void declareParameters(ParameterDeclarations& declarations) {
    SurfaceCompute::declareParameters(declarations, "Pit_Width");
    declarations
        .real("At Depth", "1",
              "Share of the largest depth at which the width is taken; 0: at the original surface, where half of the "
              "first layer of points is gone.")
        .between(0.0, 1.0)
        .defaultTo(0.5);
  }
  PitWidth(ComputeParameters params, ComputeComm comm, ComputeParameters globalData)
      : SurfaceCompute(completeParameters<PitWidth>(params, "Pit_Width"), params, comm, globalData),
        share_(parameters_.get<double>("At Depth")),
        fields_(parameters_) {}

  const Fields& fields() const override { return fields_; }
  int compute(Blocks blocks) const override;

 private:
  double excess(const SurfaceColumns::Column& column, double largest) const {
    return column.depth - (share_ > 0.0 ? share_ * largest : 0.5 * column.firstLength);
  }

  double share_;
  Fields fields_;
};

int PitWidth::compute(Blocks blocks) const {
  const SurfaceColumns::Profile columns = profile(blocks);
  const double largest = maximumDepth(columns);
  const SurfaceColumns::Extent extent = columns_.extent();
  if (extent.isPoint) throw std::runtime_error("Pit_Width: the node set is one column, which has no width");
  std::vector<Excess> line;
  double area = 0.0;
  for (const SurfaceColumns::Column& column : columns) {
    if (!column.isMetal()) continue;
    line.push_back({column.across[extent.longer], excess(column, largest)});
    if (line.back().value > 0.0) area += column.area;
  }
  constexpr double pi = 3.14159265358979323846;
  setGlobal(blocks, fields_.result, extent.isLine ? lengthAbove(line) : std::sqrt(4.0 * area / pi));
  return 0;
}

}  // namespace pd

using pd::PitWidth;
PD_REGISTER_COMPUTE(PitWidth, "Pit_Width", "Width of a pit at a share of its depth, m.")
