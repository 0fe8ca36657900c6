#include "field_reduction.hpp"

namespace pd {

void FieldReduction::declareParameters(ParameterDeclarations& declarations, const char* defaultLabel) {
  declareCommonParameters(declarations, defaultLabel);
  ScalarVariable::declareParameters(declarations);
  PointSelection::declareParameters(declarations);
  declarations.real("Ignore Below", "that of the variable",
                    "Leave out points whose value is below this (default: all points count).");
}

namespace {

/// "J/m3" over volume is "J".
std::string timesVolume(const std::string& unit) {
  const std::string perVolume = "/m3";
  if (unit == "1") return "m3";
  if (unit.size() > perVolume.size() && unit.compare(unit.size() - perVolume.size(), perVolume.size(), perVolume) == 0)
    return unit.substr(0, unit.size() - perVolume.size());
  return unit + " m3";
}

}  // namespace

FieldReduction::Fields::Fields(const Teuchos::ParameterList& parameters, const std::string& meaning, bool isIntegral)
    : variable(parameters) {
  include(variable.fields());
  result = writes(outputField(parameters, pd::fields::globalScalar,
                              isIntegral ? timesVolume(variable.unit()) : variable.unit(), meaning));
}

FieldReduction::FieldReduction(const Teuchos::ParameterList& completed, ComputeParameters params, ComputeComm comm,
                               ComputeParameters globalData)
    : TabledCompute(completed, params, comm, globalData),
      points_(completed, globalData),
      hasFloor_(completed.isParameter("Ignore Below")),
      floor_(hasFloor_ ? completed.get<double>("Ignore Below") : 0.0) {}

void FieldReduction::initialize(Blocks blocks) {
  points_.initialize(blocks);
  fields().variable.initialize(blocks);
}

}  // namespace pd
