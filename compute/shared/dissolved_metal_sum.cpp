#include "dissolved_metal_sum.hpp"

#include <stdexcept>

namespace pd {

void DissolvedMetalSum::declareParameters(ParameterDeclarations& declarations, const char* defaultLabel) {
  declareCommonParameters(declarations, defaultLabel);
  PointSelection::declareParameters(declarations);
  DissolvedMetal::declareParameters(declarations);
  declarations
      .flag(
          "Count Partly Dissolved",
          "Points that are metal still count by the share (C_solid - C)/(C_solid - C_sat) of it that is gone, so that "
          "the result grows without steps; else only points that have turned liquid count, whole.")
      .defaultTo(true);
}

DissolvedMetalSum::DissolvedMetalSum(const Teuchos::ParameterList& completed, ComputeParameters params,
                                     ComputeComm comm, ComputeParameters globalData)
    : TabledCompute(completed, params, comm, globalData),
      points_(completed, globalData),
      metal_(completed, completed.get<bool>("Count Partly Dissolved")) {}

void DissolvedMetalSum::initialize(Blocks blocks) {
  points_.initialize(blocks);
  metal_.initialize(blocks);
}

void DissolvedMetalSum::requireMetal(bool isThere) const {
  if (!isThere)
    throw std::runtime_error(points_.name() +
                             " had no metal at the start, of which something could dissolve: check the initial "
                             "concentration, which is that of the solid in metal, and the block or node set");
}

}  // namespace pd
