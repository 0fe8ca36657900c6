// What the solvers of mechanics share: held degrees of freedom, masses, fields, external forces.
#ifndef PD_SOLVER_MECHANICS_HPP
#define PD_SOLVER_MECHANICS_HPP

#include <vector>

#include "../model/simulation.hpp"

namespace pd {

/// [3 nOwned] 1 where a displacement component is prescribed, or does not exist in the dimension of the mesh.
std::vector<char> heldDisplacements(const Simulation& simulation);

/// [nOwned] mass density, kg/m3. Throws RunError where it is not positive.
std::vector<double> pointDensity(Model& model);

/// For the tables of solvers of mechanics.
struct MechanicsFields : FieldTable {
  FieldHandle displacement = writes(fields::displacement());
  FieldHandle coordinates = writes(fields::coordinates());
  FieldHandle force = reads(fields::forceDensity());
};

/// Throws RunError where no material of the run computes forces. `solver`: its name, for the message.
void requireMechanics(const Model& model, const char* solver);

/// Body forces and tractions at time t [3 nOwned], N/m3; zeros where there are none.
void externalForce(const Simulation& simulation, double t, std::vector<double>& force);

}  // namespace pd

#endif
