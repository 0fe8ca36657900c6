#include "set_reduction.hpp"

#include <algorithm>
#include <limits>

namespace pd {

void SetReduction::declareParameters(ParameterDeclarations& declarations) {
  declarations.text("Compute Class", "Name of the compute.");
  declarations.text("Variable", "Point field, a scalar or a vector.").required();
  declarations.text("Calculation Type", "What to take over the points, component by component.")
      .oneOf({"Minimum", "Maximum", "Sum"})
      .required();
  declarations.text("Output Label", "Name of the global field that holds the result.").required();
}

SetReduction::SetReduction(const Teuchos::ParameterList& parameters, const ComputeParameters& globalData)
    : points_(parameters, globalData),
      variable_(parameters.get<std::string>("Variable")),
      type_(parameters.get<std::string>("Calculation Type")),
      outputField_(globalField(parameters.get<std::string>("Output Label"), variable_.length())) {}

std::vector<int> SetReduction::fieldIds() const {
  std::vector<int> ids = variable_.fieldIds();
  ids.push_back(outputField_);
  return ids;
}

void SetReduction::initialize(const Blocks& blocks) {
  points_.initialize(blocks);
  variable_.initialize(blocks);
}

void SetReduction::compute(const Blocks& blocks, const Epetra_Comm& comm) const {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Vector3 local{}, global{};
  local.fill(type_ == "Minimum" ? infinity : type_ == "Maximum" ? -infinity : 0.0);

  std::vector<const double*> values;
  for (PeridigmNS::Block& block : *blocks) values.push_back(variable_.values(block));
  const std::size_t width = static_cast<std::size_t>(variable_.width());
  points_.forEach(blocks, [&](std::size_t b, int id) {
    const double* value = values[b] + width * static_cast<std::size_t>(id);
    for (std::size_t k = 0; k < width; ++k) {
      if (type_ == "Minimum")
        local[k] = std::min(local[k], value[k]);
      else if (type_ == "Maximum")
        local[k] = std::max(local[k], value[k]);
      else
        local[k] += value[k];
    }
  });
  if (type_ == "Minimum")
    comm.MinAll(local.data(), global.data(), variable_.width());
  else if (type_ == "Maximum")
    comm.MaxAll(local.data(), global.data(), variable_.width());
  else
    comm.SumAll(local.data(), global.data(), variable_.width());
  setGlobal(blocks, outputField_, global.data(), variable_.width());
}

}  // namespace pd
