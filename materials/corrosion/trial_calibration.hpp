// Calibration of the micro-dissolvability k of bonds between solid and electrolyte, over which k/|xi|^2 dissolves, by a
// trial simulation of uniform corrosion (Jafarzadeh, Zhao, Shakouri & Bobaru, Electrochim. Acta 401 (2022) 139512,
// section 2.2.3): the speed of a plane front with a trial k says what k must be, since the one is proportional to the
// other.
#ifndef PD_TRIAL_CALIBRATION_HPP
#define PD_TRIAL_CALIBRATION_HPP

#include <string>

#include "bond_constants.hpp"

namespace pd {

/// What the outcome of a trial depends on. Lengths are in spacings, where the horizon is a ball or a cube.
struct TrialCase {
  int dimension = 3;
  double horizon = 4.0;
  bool isBox = false;
  kernels::VolumeCorrection volumeCorrection = kernels::VolumeCorrection::RampBeyondHorizon;
  bool breaksBondsAtRandom = false;  ///< the rule by which damage follows what has dissolved

  std::string description() const;
};

/// In a lattice of unit spacing whose solid loses sum_liquid k share/|xi|^2 a cell.
struct TrialResult {
  double dissolvability;  ///< k with which the front moves one spacing in unit time
  /// sum share |n|/(2 |xi|^2) over the bonds of a point, n: across the front; 1/k of a front that stays plane.
  double firstMoment;
  double spacings;  ///< that the front has moved while its speed was measured
};

/// Runs the trial, once in a process for each case. Throws std::invalid_argument where there are no bonds across a
/// front, or neighbourhoods have no end (VolumeCorrection::EveryNeighbor).
const TrialResult& trialCalibration(const TrialCase& trial);

}  // namespace pd

#endif
