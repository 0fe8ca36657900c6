#include "bulk_modulus_step.hpp"

#include <cmath>
#include <limits>

namespace pd {

double bulkModulusCriticalStep(Model& model) {
  const Discretization& points = model.discretization();
  const double pi = std::acos(-1.0);
  double smallest = std::numeric_limits<double>::infinity();
  for (PeridigmNS::Block& block : *model.blocks()) {
    const auto neighborhood = block.getNeighborhoodData();
    const double bulkModulus = block.getMaterialModel()->BulkModulus(), density = block.getMaterialModel()->Density();
    const int* list = neighborhood->NeighborhoodList();
    for (int k = 0; k < neighborhood->NumOwnedPoints(); ++k) {
      const auto i = static_cast<std::size_t>(neighborhood->OwnedIDs()[k]);
      const double micromodulus = 18.0 * bulkModulus / (pi * std::pow(points.horizon[i], 4));
      double stiffness = 0.0;
      for (int n = *list++; n > 0; --n) {
        const auto j = static_cast<std::size_t>(*list++);
        const double* x = points.x.data();
        const double length = std::hypot(x[3 * j] - x[3 * i], x[3 * j + 1] - x[3 * i + 1], x[3 * j + 2] - x[3 * i + 2]);
        stiffness += points.volume[j] * micromodulus / length;
      }
      if (stiffness > 0.0) smallest = std::min(smallest, std::sqrt(2.0 * density / stiffness));
    }
  }
  return model.comm().min(smallest);
}

}  // namespace pd
