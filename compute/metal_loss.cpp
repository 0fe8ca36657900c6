#include "metal_loss.hpp"

namespace pd {

void MetalLoss::declareParameters(ParameterDeclarations& declarations, const char* defaultLabel) {
  declareCommonParameters(declarations, defaultLabel);
  PointSelection::declareParameters(declarations);
  declarations
      .flag(
          "Count Partly Dissolved",
          "Points that are metal still count by the share (C_solid - C)/(C_solid - C_sat) of it that is gone, so that "
          "the result grows without steps; else only points that have turned liquid count, whole.")
      .defaultTo(true);
}

MetalLoss::MetalLoss(const Teuchos::ParameterList& parameters, const ComputeParameters& globalData)
    : points_(parameters, globalData),
      metal_(parameters.get<bool>("Count Partly Dissolved")),
      outputField_(globalField(parameters.get<std::string>("Output Label"), PeridigmNS::PeridigmField::SCALAR)) {}

std::vector<int> MetalLoss::fieldIds() const {
  std::vector<int> ids = metal_.fieldIds();
  ids.push_back(outputField_);
  return ids;
}

void MetalLoss::initialize(const Blocks& blocks) {
  points_.initialize(blocks);
  metal_.initialize(blocks);
}

}  // namespace pd
