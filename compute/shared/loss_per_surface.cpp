#include "loss_per_surface.hpp"

#include <stdexcept>

namespace pd {

LossPerSurface::Fields::Fields(const Teuchos::ParameterList& parameters, const std::string& unit,
                               const std::string& meaning)
    : DissolvedMetalSum::Fields(parameters, unit, meaning) {
  if (parameters.isParameter("Surface Area")) return;
  areaDensity = readsIfThere(pd::fields::interfaceAreaDensity());
  surface = writes(kept(pd::fields::globalScalar(parameters.get<std::string>("Output Label") + "_Surface", "m2",
                                                 "Surface of the metal at the first evaluation.")));
}

void LossPerSurface::declareParameters(ParameterDeclarations& declarations, const char* defaultLabel) {
  DissolvedMetalSum::declareParameters(declarations, defaultLabel);
  declarations
      .real("Surface Area", "m2",
            "Of the metal at the start (default: all that dissolves at the first evaluation, as Total_Current has it).")
      .positive();
  // The surface lies in the electrolyte, and belongs to no part of the metal.
  declarations.needs("Block", {"Surface Area"});
  declarations.needs("Node Set", {"Surface Area"});
}

void LossPerSurface::initialize(Blocks blocks) {
  DissolvedMetalSum::initialize(blocks);
  requireDissolvingMetal(blocks, fields());
}

double LossPerSurface::firstSurface(const Blocks& blocks) const {
  if (parameters_.isParameter("Surface Area")) return parameters_.get<double>("Surface Area");
  double* kept = view(blocks->front(), fields().surface);
  if (*kept > 0.0) return *kept;
  double area = 0.0;
  for (PeridigmNS::Block& block : *blocks) {
    const double *density = view(block, fields().areaDensity), *volume = view(block, fields().volume);
    const auto neighborhood = block.getNeighborhoodData();
    for (int i = 0; i < neighborhood->NumOwnedPoints(); ++i) {
      const int id = neighborhood->OwnedIDs()[i];
      area += density[id] * volume[id];
    }
  }
  area = sumOverRanks(*epetraComm, area);
  if (!(area > 0.0))
    throw std::runtime_error(
        "at the first evaluation no metal meets electrolyte, so that it has no surface; give Surface Area");
  return *kept = area;
}

}  // namespace pd
