#include "surface_current.hpp"

namespace pd {

void SurfaceCurrent::declareParameters(ParameterDeclarations& declarations, const char* defaultLabel) {
  declareCommonParameters(declarations, defaultLabel);
  PointSelection::declareParameters(declarations);
}

void SurfaceCurrent::initialize(Blocks blocks) {
  requireDissolvingMetal(blocks, fields());
  points_.initialize(blocks);
}

double SurfaceCurrent::peak(const Blocks& blocks) const {
  double largest = 0.0;
  forEach(blocks, [&](std::size_t, int, double current, double) { largest = std::max(largest, current); });
  return maxOverRanks(*epetraComm, largest);
}

std::array<double, 2> SurfaceCurrent::currentAndArea(const Blocks& blocks) const {
  std::vector<double> sums(2, 0.0);
  forEach(blocks, [&](std::size_t, int, double current, double area) {
    sums[0] += current * area;
    sums[1] += area;
  });
  sums = sumOverRanks(*epetraComm, sums);
  return {sums[0], sums[1]};
}

}  // namespace pd
