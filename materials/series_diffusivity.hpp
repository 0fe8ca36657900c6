// Diffusion between materials: a bond carries what the resistances along it, in series, let through.
#ifndef PD_SERIES_DIFFUSIVITY_HPP
#define PD_SERIES_DIFFUSIVITY_HPP

#include <algorithm>
#include <vector>

#include "bond_family.hpp"
#include "bond_path.hpp"
#include "diffusivity_field.hpp"

namespace pd {

/// [bonds] Diffusivity of each bond in parts of that of its point: 1/D of a bond is the mean of 1/D over its length,
/// where each place counts as the point nearest to it. Then bonds carry the same flux per length through any layers
/// across which the steady flux goes, and that flux is exact. `diffusivity`: by local id; 0 of what lets nothing
/// through. `vectorOf(i, j)`: the bond, m, in the space where spacings are alike. Empty where no point sees another
/// diffusivity than its own: nothing has to be multiplied.
template <class VectorOf>
std::vector<double> seriesDiffusivities(const Call& call, const double* diffusivity, VectorOf vectorOf) {
  std::vector<double> relative;
  kernels::BondPaths paths;
  const int* list = call.neighborhoodList;
  std::size_t bond = 0;
  for (int p = 0; p < call.nOwned; ++p) {
    const int i = call.ownedIds[p], *neighbors = list + 1, *end = neighbors + *list;
    const std::size_t first = bond;
    bond += static_cast<std::size_t>(*list);
    list = end;
    if (std::all_of(neighbors, end, [&](int j) { return diffusivity[j] == diffusivity[i]; })) continue;
    const double resistance = 1.0 / diffusivity[i];
    paths.startAt(resistance);
    std::for_each(neighbors, end, [&](int j) { paths.add(vectorOf(i, j), 1.0 / diffusivity[j]); });
    relative.resize(bond, 1.0);
    for (std::size_t k = first; k < bond; ++k) relative[k] = resistance / paths.mean(k - first);
  }
  if (!relative.empty()) relative.resize(bond, 1.0);
  return relative;
}

}  // namespace pd

#endif
