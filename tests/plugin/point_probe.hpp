// The neighbourhood of one point in a data manager of its own, as Peridigm's finite-difference tangent makes it.
#ifndef PD_TESTS_POINT_PROBE_HPP
#define PD_TESTS_POINT_PROBE_HPP

#include "material_run.hpp"

namespace pdtest {

/// Local ids of a point's neighbours (body of one block).
std::vector<int> neighborsOf(SmallBody& body, int localId);

/// Point 0 is the one that is probed, 1 ... n its neighbours. The memory stays the same from load to load.
class PointProbe {
 public:
  PointProbe(const MaterialRun& run, int nNeighbors);
  /// Copies the fields of a point of the run's body and of its neighbours.
  void load(MaterialRun& run, int localId);
  /// Results at the probed point and its neighbours.
  Results evaluate(const PeridigmNS::Material& material);

 private:
  PeridigmNS::DataManager data_;
  std::vector<int> fieldIds_;
  std::vector<int> ownedIds_, list_;
};

}  // namespace pdtest

#endif
