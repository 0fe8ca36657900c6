// Values of the boundaries of a flow, by which the constants of operators follow them from time to time.
#ifndef PD_FLOW_SOURCES_HPP
#define PD_FLOW_SOURCES_HPP

#include <array>
#include <map>
#include <utility>
#include <vector>

#include "flow_geometry.hpp"

namespace pd {

/// A velocity (or in its first component a pressure) of a boundary that changes with time, at a place on it.
struct FlowSource {
  int boundary;
  bool isPressure;
  std::array<double, 3> place, value;  ///< value: at the time of the rows
};

/// Sources in a constant, by their numbers, each with its weight.
template <class Weight>
using SourceWeights = std::vector<std::pair<std::size_t, Weight>>;

/// Numbers the sources as operators come to ask for them.
class FlowSources {
 public:
  /// In the solver's time t.
  FlowSources(const FlowGeometry& geometry, double t) : geometry_(geometry), t_(t) {}

  /// The source of a boundary's value at the place, with a weight; none where that stays as it is.
  template <class Weight>
  SourceWeights<Weight> at(int boundary, const std::array<double, 3>& place, bool isPressure, const Weight& weight) {
    if (!geometry_.changesWithTime(boundary)) return {};
    return {{numberAt(boundary, place, isPressure), weight}};
  }
  std::vector<FlowSource> take() { return std::move(sources_); }

 private:
  std::size_t numberAt(int boundary, const std::array<double, 3>& place, bool isPressure) {
    const bool isOne = !geometry_.dependsOnPlace(boundary);
    const auto known = sourceOf_.find(boundary);
    if (isOne && known != sourceOf_.end()) return known->second;
    std::array<double, 3> value{};
    if (isPressure)
      value[0] = geometry_.outflowPressure(boundary, place, t_);
    else
      value = geometry_.wallVelocity(boundary, place, t_);
    sources_.push_back({boundary, isPressure, place, value});
    if (isOne) sourceOf_[boundary] = sources_.size() - 1;
    return sources_.size() - 1;
  }

  const FlowGeometry& geometry_;
  const double t_;
  std::vector<FlowSource> sources_;
  std::map<int, std::size_t> sourceOf_;  ///< of boundaries whose value is the same everywhere
};

}  // namespace pd

#endif
