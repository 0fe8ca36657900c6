// Gradients of the pressure at the points of a flow, by linear fits.
#ifndef PD_FLOW_PRESSURE_FITS_HPP
#define PD_FLOW_PRESSURE_FITS_HPP

#include <array>
#include <unordered_map>
#include <vector>

#include "flow_geometry.hpp"
#include "flow_sources.hpp"
#include "flow_weights.hpp"

namespace pd {

/// The gradient of the pressure at a point: a sum over points, some of which are images, and a constant, Pa/m.
struct PressureFit {
  struct Term {
    int point, copy;
    std::array<double, 3> weight;
  };
  std::vector<Term> terms;
  std::array<double, 3> constant{};
  SourceWeights<std::array<double, 3>> sources{};
};

/// Made when they are asked for, and kept for the points around.
class PressureFits {
 public:
  /// In the solver's time t.
  PressureFits(const FlowGeometry& geometry, FlowSources& sources, double t)
      : geometry_(geometry), sources_(sources), t_(t), n_(static_cast<std::size_t>(geometry.dimension())) {}

  /// Of any fluid point of this rank: from its own neighbours, or from those of the owned point beside it. Beyond an
  /// outflow the pressure is twice that of the outflow less that of the mirrored place. Holds until forget().
  const PressureFit& at(int point, const std::vector<int>& candidates);
  /// All, where they are many: those of the points around come again, few of them.
  void forget();

 private:
  using Vector = std::array<double, 3>;
  using End = FlowGeometry::End;

  kernels::BondEnds wholeBonds(const std::vector<End>& ends) const;
  void addMirroredPressure(int point, const End& end, const std::vector<End>& fluid, const Vector& weight,
                           PressureFit& fit);
  std::vector<double> sharesAt(int point, const std::vector<End>& ends, const Vector& seen) const;

  const FlowGeometry& geometry_;
  FlowSources& sources_;
  const double t_;
  const std::size_t n_;
  std::unordered_map<int, PressureFit> fits_;  ///< by local point
};

}  // namespace pd

#endif
