// Points of a flow whose surroundings are equal, as those of most points of a lattice are.
#ifndef PD_FLOW_SURROUNDINGS_HPP
#define PD_FLOW_SURROUNDINGS_HPP

#include <unordered_map>
#include <vector>

#include "flow_geometry.hpp"

namespace pd {

/// Finds, for a fluid point that no boundary is near, an earlier one with the same neighbours: at the same offsets of
/// local ids and in the same places, of the same volumes, to rounding, which have the same neighbours, too (a filter
/// may have cut bonds of theirs). Their rows are equal. Not in bodies of revolution, where the radius matters.
class FlowSurroundings {
 public:
  explicit FlowSurroundings(const FlowGeometry& geometry) : geometry_(geometry) {}

  /// The row of the earlier point; -1: there is none, and this one is now known as an earlier point if it may be one.
  /// `row`: that of the point, whose neighbourhood may hold neither boundaries nor images.
  long long like(int point, std::size_t row);

 private:
  bool isInside(int point) const;
  bool areEqual(int point, int other) const;
  std::vector<int> compactOffsets(int point) const;

  const FlowGeometry& geometry_;
  std::unordered_map<std::size_t, std::size_t> rowByKey_;
};

}  // namespace pd

#endif
