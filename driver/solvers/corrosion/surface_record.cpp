#include "surface_record.hpp"

#include <algorithm>

namespace pd {

namespace {

constexpr const char* labels[] = {"Current_Density", "Interface_Area_Density"};

}  // namespace

void SurfaceRecord::take(Model& model, const std::vector<int>& liquid) {
  const double *current = model.field(labels[0]), *area = model.field(labels[1]);
  rows_.clear();
  for (const int i : liquid)
    if (area[i] > 0.0) rows_.push_back({i, {current[i], area[i]}});
}

void SurfaceRecord::show(Model& model) {
  for (std::size_t k = 0; k < hidden_.size(); ++k) {
    double* values = model.field(labels[k]);
    hidden_[k].assign(values, values + model.nOwned());
    std::fill(values, values + model.nOwned(), 0.0);
    for (const Row& row : rows_) values[row.point] = row.values[k];
  }
}

void SurfaceRecord::hide(Model& model) {
  for (std::size_t k = 0; k < hidden_.size(); ++k) {
    std::copy(hidden_[k].begin(), hidden_[k].end(), model.field(labels[k]));
    hidden_[k].clear();
  }
}

}  // namespace pd
