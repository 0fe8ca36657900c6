// The highest frequency of a body, which limits the steps of explicit dynamics.
#ifndef PD_LARGEST_FREQUENCY_HPP
#define PD_LARGEST_FREQUENCY_HPP

#include <vector>

#include "../model/simulation.hpp"
#include "lanczos.hpp"

namespace pd {

/// Bound of the largest omega^2 (1/s2) of M^-1 K, with the tangent K of the force at the present displacement probed
/// by finite differences and the held displacements fixed: the central difference method is stable for
/// dt < 2 / omega. Bonds do not break in the probe. Leaves the displacements as they were and Force_Density undefined.
/// Collective.
LargestEigenvalue largestSquaredFrequency(Simulation& simulation, const std::vector<double>& density,
                                          const std::vector<char>& isHeld, double relativeTolerance,
                                          int maximumIterations);

}  // namespace pd

#endif
