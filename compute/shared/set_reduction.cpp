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

SetReduction::SetReduction(const Teuchos::ParameterList& completed, ComputeParameters params, ComputeComm comm,
                           ComputeParameters globalData)
    : TabledCompute(completed, params, comm, globalData),
      points_(completed, globalData),
      fields_(completed),
      type_(completed.get<std::string>("Calculation Type")) {}

SetReduction::Fields::Fields(const Teuchos::ParameterList& parameters) : variable(FieldVariable::of(parameters)) {
  include(variable.fields());
  result = writes(outputField(parameters, variable.width() == 3 ? pd::fields::globalVector : pd::fields::globalScalar,
                              variable.unit(), "Minimum, maximum or sum of the variable."));
}

void SetReduction::initialize(Blocks blocks) {
  points_.initialize(blocks);
  fields_.variable.initialize(blocks);
}

int SetReduction::compute(Blocks blocks) const {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Vector3 local{}, global{};
  local.fill(type_ == "Minimum" ? infinity : type_ == "Maximum" ? -infinity : 0.0);

  std::vector<const double*> values;
  for (PeridigmNS::Block& block : *blocks) values.push_back(fields_.variable.values(block));
  const std::size_t width = static_cast<std::size_t>(fields_.variable.width());
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
    epetraComm->MinAll(local.data(), global.data(), fields_.variable.width());
  else if (type_ == "Maximum")
    epetraComm->MaxAll(local.data(), global.data(), fields_.variable.width());
  else
    epetraComm->SumAll(local.data(), global.data(), fields_.variable.width());
  setGlobal(blocks, fields_.result, global.data(), fields_.variable.width());
  return 0;
}

}  // namespace pd
