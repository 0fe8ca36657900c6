// A lattice of points whose distribution over ranks, ghosts and neighbourhoods are made without any file.
#ifndef PD_TEST_LATTICE_HPP
#define PD_TEST_LATTICE_HPP

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "driver/discretization/discretization.hpp"

namespace pd::test {

/// Unit spacing, nx * ny * nz points, x fastest. All ranks can ask for any point.
struct Lattice {
  int nx, ny, nz;
  double horizon;

  int size() const { return nx * ny * nz; }
  double coordinate(int id, int axis) const {
    return axis == 0 ? id % nx : (axis == 1 ? id / nx % ny : id / (nx * ny));
  }
  int dimension() const { return nz > 1 ? 3 : (ny > 1 ? 2 : 1); }
  double distance(int a, int b) const {
    double sum = 0.0;
    for (int axis = 0; axis < 3; ++axis) sum += std::pow(coordinate(a, axis) - coordinate(b, axis), 2);
    return std::sqrt(sum);
  }
  std::vector<int> neighbours(int id) const {
    std::vector<int> result;
    const int reach = static_cast<int>(horizon), x = id % nx, y = id / nx % ny, z = id / (nx * ny);
    for (int k = std::max(z - reach, 0); k <= std::min(z + reach, nz - 1); ++k)
      for (int j = std::max(y - reach, 0); j <= std::min(y + reach, ny - 1); ++j)
        for (int i = std::max(x - reach, 0); i <= std::min(x + reach, nx - 1); ++i) {
          const int other = (k * ny + j) * nx + i;
          if (other != id && distance(id, other) <= horizon) result.push_back(other);
        }
    return result;
  }
  /// Scattered on purpose: every rank borders on every other one.
  static int owner(int id, int ranks) { return (id / 3 + id % 5) % ranks; }

  Discretization discretization(const Communicator& comm) const {
    Discretization result;
    result.dimension = dimension();
    result.nGlobal = size();
    std::set<int> ghosts;
    std::vector<int> local(static_cast<std::size_t>(size()), -1);
    for (int id = 0; id < size(); ++id)
      if (owner(id, comm.size()) == comm.rank()) result.globalIds.push_back(id);
    result.nOwned = static_cast<int>(result.globalIds.size());
    for (int i = 0; i < result.nOwned; ++i)
      for (const int other : neighbours(result.globalIds[static_cast<std::size_t>(i)]))
        if (owner(other, comm.size()) != comm.rank()) ghosts.insert(other);
    // Descending, so that nothing relies on ghosts being sorted.
    result.globalIds.insert(result.globalIds.end(), ghosts.rbegin(), ghosts.rend());
    result.nPoints = static_cast<int>(result.globalIds.size());
    for (int i = 0; i < result.nPoints; ++i)
      local[static_cast<std::size_t>(result.globalIds[static_cast<std::size_t>(i)])] = i;
    result.neighborhoodStart.push_back(0);
    for (int i = 0; i < result.nOwned; ++i) {
      std::set<int> family;
      for (const int other : neighbours(result.globalIds[static_cast<std::size_t>(i)]))
        family.insert(local[static_cast<std::size_t>(other)]);
      result.neighborhoodList.push_back(static_cast<int>(family.size()));
      result.neighborhoodList.insert(result.neighborhoodList.end(), family.begin(), family.end());
      result.neighborhoodStart.push_back(static_cast<long long>(result.neighborhoodList.size()));
    }
    for (const int id : result.globalIds)
      for (int axis = 0; axis < 3; ++axis) result.x.push_back(coordinate(id, axis));
    result.volume.assign(result.globalIds.size(), 1.0);
    result.horizon.assign(result.globalIds.size(), horizon);
    result.blockId.assign(result.globalIds.size(), 1);
    result.blockNumbers = {1};
    result.shortestBond = 1.0;
    return result;
  }
};

}  // namespace pd::test

#endif
