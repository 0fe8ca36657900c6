#include "dissolve_loose_metal.hpp"

#include <algorithm>

#include "Peridigm_Field.hpp"

namespace pd {

namespace {

const char* const looseField = "Loose";
/// Zero between steps: what the points of other ranks must know goes through it.
const char* const exchangeField = "Dissolution_Demand";

/// Calls visit(j) for solid neighbours of the same block.
template <class Visit>
void forEachPartner(const Discretization& mesh, const double* damage, std::size_t i, Visit visit) {
  const int* entry = mesh.neighborhoodList.data() + mesh.neighborhoodStart[i];
  for (int k = 1; k <= entry[0]; ++k) {
    const auto j = static_cast<std::size_t>(entry[k]);
    if (damage[j] < 1.0 && mesh.blockId[j] == mesh.blockId[i]) visit(j);
  }
}

}  // namespace

void dissolveLooseMetalFirst(Model& model, const std::string& concentrationField, const std::vector<double>& before,
                             double dt) {
  if (!model.hasField(looseField)) return;
  const Discretization& mesh = model.discretization();
  const auto n = static_cast<std::size_t>(model.nOwned()), nPoints = static_cast<std::size_t>(model.nPoints());
  const double *loose = model.field(looseField), *volume = model.field("Volume"), *damage = model.field("Damage");
  const double* saturation = model.field("Saturation_Concentration");
  double *concentration = model.field(concentrationField), *exchange = model.field(exchangeField);
  const auto shared = [&](const std::vector<double>& values) {
    std::copy(values.begin(), values.end(), exchange);
    model.importGhosts(exchangeField);
    return std::vector<double>(exchange, exchange + nPoints);
  };

  // mol that loose points still have to give; those that gave nothing are held or out of reach.
  std::vector<double> own(n, 0.0);
  bool hasAny = false;
  for (std::size_t i = 0; i < n; ++i)
    if (loose[i] > 0.0 && damage[i] < 1.0 && concentration[i] < before[i]) {
      own[i] = volume[i] * std::max(concentration[i] - saturation[i], 0.0);
      hasAny = true;
    }
  if (!model.comm().any(hasAny)) return;
  const std::vector<double> left = shared(own);
  // What the others have given, shared out among the loose points around them, a mol that is left.
  std::vector<double> perLeft(n, 0.0);
  for (std::size_t j = 0; j < n; ++j) {
    if (damage[j] >= 1.0 || left[j] > 0.0) continue;
    double total = 0.0;
    forEachPartner(mesh, damage, j, [&](std::size_t i) { total += left[i]; });
    if (total > 0.0) perLeft[j] = volume[j] * std::max(before[j] - concentration[j], 0.0) / total;
  }
  const std::vector<double> offer = shared(perLeft);
  std::vector<double> ownTaken(n, 0.0);  // share of the offers
  for (std::size_t i = 0; i < n; ++i) {
    if (left[i] == 0.0) continue;
    double offered = 0.0;  // of what is left
    forEachPartner(mesh, damage, i, [&](std::size_t j) { offered += offer[j]; });
    ownTaken[i] = offered > 1.0 ? 1.0 / offered : 1.0;
    concentration[i] = offered >= 1.0 ? saturation[i] : concentration[i] - offered * left[i] / volume[i];
  }
  const std::vector<double> taken = shared(ownTaken);
  for (std::size_t j = 0; j < n; ++j) {
    if (offer[j] == 0.0) continue;
    double returned = 0.0;
    forEachPartner(mesh, damage, j, [&](std::size_t i) { returned += taken[i] * left[i]; });
    concentration[j] = std::min(concentration[j] + offer[j] * returned / volume[j], before[j]);
  }
  std::fill(exchange, exchange + nPoints, 0.0);
  model.importGhosts(concentrationField);
  model.evaluateDamage(dt);
}

}  // namespace pd
