// Velocities at the ends of the bonds of a fluid point.
#ifndef PD_FLOW_END_VELOCITIES_HPP
#define PD_FLOW_END_VELOCITIES_HPP

#include <array>
#include <vector>

#include "flow_geometry.hpp"
#include "flow_sources.hpp"
#include "flow_weights.hpp"

namespace pd {

/// A velocity as a sum over points, some of which are seen mirrored, and a constant.
struct EndVelocity {
  struct Part {
    int point, copy;
    double weight;
  };
  std::vector<Part> parts;
  std::array<double, 3> constant{};
  SourceWeights<double> sources{};
};

/// In the solver's time t. Throw DeckError where a point has too few neighbours, with its place.
class EndVelocities {
 public:
  using Vector = std::array<double, 3>;
  using End = FlowGeometry::End;

  EndVelocities(const FlowGeometry& geometry, FlowSources& sources, double t)
      : geometry_(geometry), sources_(sources), t_(t) {}

  /// At an end, one of the `ends` of the point: of the point that is there, of the wall, or of a mirrored place.
  EndVelocity at(int point, const std::vector<End>& ends, const End& end);
  /// Of the wall at which a bond ends.
  Vector ofWall(int point, const End& end) const;
  /// What makes it follow the wall from time to time.
  SourceWeights<double> sourceOf(int point, const End& end, double weight);
  /// Bonds up to their ends: at a wall, or whole, as all are where points beyond walls have a value (`areWhole`).
  kernels::BondEnds bondsOf(const std::vector<End>& ends, bool areWhole = false) const;
  [[noreturn]] void tooFewNeighbors(int point) const;

 private:
  EndVelocity mirroredValue(int point, const std::vector<End>& ends, const Vector& seen);
  EndVelocity reflectedValue(int point, const std::vector<End>& ends, const End& end);
  void requireNormal(int point, const End& end) const;
  const double* placeOf(int point) const { return &geometry_.mesh().x[3 * static_cast<std::size_t>(point)]; }

  const FlowGeometry& geometry_;
  FlowSources& sources_;
  const double t_;
};

}  // namespace pd

#endif
