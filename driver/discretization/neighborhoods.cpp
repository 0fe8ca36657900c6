#include "neighborhoods.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pd {

namespace {

/// The owned points and those within `reach` of their bounding box, in the order of `order`. Rounding loses none.
std::vector<int> candidatesOf(const MeshPoints& points, const std::vector<int>& order, const std::vector<int>& owner,
                              int rank, double reach) {
  reach *= 1.0 + 1e-9;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  double low[3] = {infinity, infinity, infinity}, high[3] = {-infinity, -infinity, -infinity};
  for (int i = 0; i < static_cast<int>(owner.size()); ++i) {
    if (owner[i] != rank) continue;
    for (int k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], points.at(i)[k] - reach);
      high[k] = std::max(high[k], points.at(i)[k] + reach);
    }
  }
  std::vector<int> candidates;
  for (const int i : order) {
    const double* x = points.at(i);
    if (x[0] >= low[0] && x[0] <= high[0] && x[1] >= low[1] && x[1] <= high[1] && x[2] >= low[2] && x[2] <= high[2])
      candidates.push_back(i);
  }
  return candidates;
}

/// Appends [n, neighbours as positions in candidates] of every owned point. Returns the shortest bond, squared.
double searchAll(const NeighborSearch& search, const std::vector<int>& ownedPositions, Discretization& d) {
  std::vector<int> neighbors;
  const std::size_t nOwned = ownedPositions.size();
  // Memory for the list is taken once, from the mean of a sample: growing it would need twice as much.
  const std::size_t stride = std::max<std::size_t>(1, nOwned / 1000);
  std::size_t sampled = 0, entries = 0;
  for (std::size_t i = 0; i < nOwned; i += stride, ++sampled) {
    search.find(ownedPositions[i], neighbors);
    entries += neighbors.size() + 1;
  }
  if (sampled > 0)
    d.neighborhoodList.reserve(static_cast<std::size_t>(1.05 * static_cast<double>(nOwned) *
                                                        static_cast<double>(entries) / static_cast<double>(sampled)));

  double shortest = std::numeric_limits<double>::infinity();
  for (const int position : ownedPositions) {
    shortest = std::min(shortest, search.find(position, neighbors));
    d.neighborhoodStart.push_back(static_cast<long long>(d.neighborhoodList.size()));
    d.neighborhoodList.push_back(static_cast<int>(neighbors.size()));
    d.neighborhoodList.insert(d.neighborhoodList.end(), neighbors.begin(), neighbors.end());
  }
  d.neighborhoodStart.push_back(static_cast<long long>(d.neighborhoodList.size()));
  return shortest;
}

/// Calls visit(local id, first neighbour, number of neighbours) for every owned point.
template <class Visit>
void forEachNeighborhood(Discretization& d, Visit visit) {
  for (int i = 0; i < d.nOwned; ++i) {
    int* entry = &d.neighborhoodList[d.neighborhoodStart[i]];
    visit(i, entry + 1, *entry);
  }
}

/// Numbers the ghosts behind the owned points, images behind these, and puts local ids, sorted, in place of positions.
/// `nMesh`: points of the mesh; `order`: of those of the whole body.
void numberLocally(const std::vector<int>& candidates, const std::vector<int>& ownedPositions,
                   const std::vector<int>& order, int nMesh, Discretization& d) {
  constexpr int isFarAway = -1, isOther = -2;
  std::vector<char> isNeighbor(candidates.size(), 0);
  forEachNeighborhood(d, [&](int, const int* neighbors, int n) {
    for (int k = 0; k < n; ++k) isNeighbor[neighbors[k]] = 1;
  });
  std::vector<int> localId(order.size(), isFarAway);
  const auto number = [&](int id) {
    localId[id] = static_cast<int>(d.globalIds.size());
    d.globalIds.push_back(id);
  };
  for (const int position : ownedPositions) number(candidates[position]);
  for (std::size_t c = 0; c < candidates.size(); ++c)
    for (const int id : {candidates[c], candidates[c] % nMesh})  // an image needs what it mirrors
      if (isNeighbor[c] != 0 && localId[id] == isFarAway) localId[id] = isOther;
  for (const int id : order)
    if (localId[id] == isOther && id < nMesh) number(id);
  for (const int id : order) {
    if (localId[id] != isOther) continue;
    number(id);
    d.imageSource.push_back(localId[id % nMesh]);
    d.imageCopy.push_back(id / nMesh);
  }
  d.nPoints = static_cast<int>(d.globalIds.size());
  std::vector<int> localIdOf;
  for (const int id : candidates) localIdOf.push_back(localId[id]);
  forEachNeighborhood(d, [&](int, int* neighbors, int n) {
    for (int k = 0; k < n; ++k) neighbors[k] = localIdOf[neighbors[k]];
    std::sort(neighbors, neighbors + n);
  });
}

/// What filters say to a bond, and their images: those cut the bond that they would cut if it were mirrored.
BondFilters::Verdict judge(BondFilters& filters, const Symmetry& symmetry, int nMesh, int a, int b) {
  if (symmetry.empty()) return filters.judge(a, b);
  BondFilters::Verdict worst = BondFilters::Verdict::keep;
  for (int copy = 0; copy < symmetry.nCopies(); ++copy) {
    const auto mirrored = [&](int id) { return (id / nMesh ^ copy) * nMesh + id % nMesh; };
    worst = std::max(worst, filters.judge(mirrored(a), mirrored(b)));
  }
  return worst;
}

/// Takes removed bonds out of the list and marks cut ones.
void applyFilters(BondFilters& filters, int nMesh, Discretization& d) {
  if (filters.empty()) return;
  const bool marks = filters.canMark();
  std::size_t out = 0;
  forEachNeighborhood(d, [&](int i, const int* neighbors, int n) {
    // Entries only ever move towards the front, so that what is still to be read is not written over.
    const std::size_t start = out++;
    for (int k = 0; k < n; ++k) {
      const int j = neighbors[k];
      const BondFilters::Verdict verdict = judge(filters, d.symmetry, nMesh, d.globalIds[i], d.globalIds[j]);
      if (verdict == BondFilters::Verdict::remove) continue;
      d.neighborhoodList[out++] = j;
      if (marks) d.bondIsCut.push_back(verdict == BondFilters::Verdict::mark ? 1 : 0);
    }
    d.neighborhoodList[start] = static_cast<int>(out - start - 1);
    d.neighborhoodStart[i] = static_cast<long long>(start);
  });
  d.neighborhoodList.resize(out);
  d.neighborhoodStart.back() = static_cast<long long>(out);
}

}  // namespace

void buildNeighborhoods(const MeshPoints& points, const NeighborRule& rule, BondFilters& filters,
                        const std::vector<int>& order, const std::vector<int>& owner, int rank, Discretization& d) {
  const int nMesh = static_cast<int>(owner.size());
  const std::vector<int> candidates = candidatesOf(points, order, owner, rank, rule.widest());
  std::vector<int> ownedPositions;
  for (std::size_t c = 0; c < candidates.size(); ++c)
    if (candidates[c] < nMesh && owner[candidates[c]] == rank) ownedPositions.push_back(static_cast<int>(c));
  d.nOwned = static_cast<int>(ownedPositions.size());
  {
    const NeighborSearch search(points.x, rule, candidates);
    d.shortestBond = std::sqrt(searchAll(search, ownedPositions, d));
  }
  numberLocally(candidates, ownedPositions, order, nMesh, d);
  applyFilters(filters, nMesh, d);
}

}  // namespace pd
