// What a solver of flows asks a material.
#ifndef PD_FLOW_LAW_HPP
#define PD_FLOW_LAW_HPP

#include "bond_family.hpp"
#include "flow_weights.hpp"

namespace pd {

/// An incompressible Newtonian fluid, and the nonlocal operators that it wants.
struct FlowLaw {
  double density, viscosity;  ///< kg/m3, Pa s
  kernels::ViscousKernel viscousKernel;
  double gradientHorizon;  ///< of gradients, divergence and convection, m; at most half of the horizon
  double fluxHorizon;      ///< of bonds that move volume from point to point (Bond_Flow), m; at most the horizon
  bool reflectsPoints;     ///< at walls, in place of bonds that end there
  BondFamily family;       ///< section, horizon of the viscous operator, share of volumes

  /// Whether gradients count a neighbour at `distance`, which on lattices may be the horizon to rounding.
  bool gradientsReach(double distance) const { return distance <= gradientHorizon * (1.0 + 1e-9); }
  double horizonVolume() const { return kernels::horizonVolume(family.horizon, family.section); }
  /// m3 of a neighbour at `distance` that count.
  double volumeOf(double distance, double volume, double neighborVolume) const {
    return family.share(distance, volume, neighborVolume) * neighborVolume;
  }
};

/// A mixin, for materials.
class FlowMaterial {
 public:
  virtual ~FlowMaterial() = default;
  /// Null where it is no fluid: of a list of materials none may be one.
  virtual const FlowLaw* flowLaw() const = 0;
};

}  // namespace pd

#endif
