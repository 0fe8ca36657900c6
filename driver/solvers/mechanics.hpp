// What the solvers of mechanics share: held degrees of freedom, masses, total force densities, the highest frequency.
#ifndef PD_SOLVER_MECHANICS_HPP
#define PD_SOLVER_MECHANICS_HPP

#include <vector>

#include "../model/simulation.hpp"
#include "lanczos.hpp"

namespace pd {

/// [3 nOwned] 1 where a displacement component is prescribed, or does not exist in the dimension of the mesh.
std::vector<char> heldDisplacements(const Simulation& simulation);

/// [nOwned] mass density, kg/m3. Throws RunError where it is not positive.
std::vector<double> pointDensity(Model& model);

/// Registers the fields that every solver of mechanics needs, and returns their ids: Displacement, Coordinates,
/// Velocity (where `withVelocity`), Force_Density.
std::vector<int> mechanicsFieldIds(bool withVelocity);

/// Throws RunError where no material of the run computes forces. `solver`: its name, for the message.
void requireMechanics(const Model& model, const char* solver);

/// Body forces and tractions at time t [3 nOwned], N/m3; zeros where there are none.
void externalForce(const Simulation& simulation, double t, std::vector<double>& force);

/// Points whose Damage changes from one look to the next.
class DamageMonitor {
 public:
  /// Remembers the present damage.
  void remember(Model& model);
  /// How many points (all ranks) differ from what was remembered; remembers the new state. Collective.
  long long countChanged(Model& model);

 private:
  std::vector<double> damage_;
};

/// Bound of the largest omega^2 (1/s2) of M^-1 K, with the tangent K of the force at the present displacement probed
/// by finite differences and the held displacements fixed: the central difference method is stable for
/// dt < 2 / omega. Bonds do not break in the probe. Leaves the displacements as they were and Force_Density undefined.
/// Collective.
LargestEigenvalue largestSquaredFrequency(Simulation& simulation, const std::vector<double>& density,
                                          const std::vector<char>& isHeld, double relativeTolerance,
                                          int maximumIterations);

}  // namespace pd

#endif
