#include "surface_current.hpp"

namespace pd {

void SurfaceCurrent::declareParameters(ParameterDeclarations& declarations, const char* defaultLabel) {
  declareCommonParameters(declarations, defaultLabel);
  PointSelection::declareParameters(declarations);
}

SurfaceCurrent::SurfaceCurrent(const Teuchos::ParameterList& parameters, ComputeParameters params, ComputeComm comm,
                               ComputeParameters globalData, PeridigmNS::PeridigmField::Length length)
    : Compute(params, comm, globalData),
      outputField_(globalField(parameters.get<std::string>("Output Label"), length)),
      points_(parameters, globalData),
      currentField_(corrosionField("Current_Density")),
      areaField_(corrosionField("Interface_Area_Density")),
      volumeField_(volumeField()) {}

std::vector<int> SurfaceCurrent::FieldIds() const {
  std::vector<int> ids = {volumeField_, outputField_};
  for (const int id : {currentField_, areaField_})
    if (id >= 0) ids.push_back(id);
  return ids;
}

void SurfaceCurrent::initialize(Blocks blocks) {
  requireCorrosionFields(blocks, {"Current_Density", "Interface_Area_Density"});
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
