// What a bond law makes of a crack on a lattice: growth by a trial, from which the coefficient that gives a wanted law
// of Paris follows in closed form.
//
// A bond near a crack tip whose strain range is e loses A e^M of its life in a cycle. Then, in a body that is linear,
//   da/dN = B A delta (dK / (E' sqrt(delta)))^M
// with a pure number B of M, the lattice, the influence function and the rule by which bonds are near the tip (Silling
// & Askari, SAND2014-18590, find A by a trial of the whole body instead). Here B comes from a long strip between grips,
// in which the energy release rate is the same wherever the tip is.
#ifndef PD_GROWTH_TRIAL_HPP
#define PD_GROWTH_TRIAL_HPP

#include <string>
#include <vector>

namespace pd {

/// A bond of a lattice of unit spacing, seen in the plane across the crack front. Those of one projection and length
/// are one.
struct LatticeBond {
  int x = 0, y = 0;
  double length = 0.0;     ///< in space
  double stiffness = 0.0;  ///< twice its energy at a stretch of 1
  double count = 1.0;      ///< bonds that it stands for
};

struct GrowthTrialCase {
  std::vector<LatticeBond> bonds;  ///< of a point, both directions
  double horizon = 3.0;            ///< in spacings
  double exponent = 3.0;           ///< M
  double growthDamage = 0.35;  ///< a bond wears where an end, or one of its neighbours, has lost this part of its bonds
};

struct GrowthTrialResult {
  double factor = 0.0;  ///< B, for a body large beside the horizon
  int nBroken = 0;      ///< bonds on the way, in the larger strip
};

/// E' (plane stress or strain) of the lattice, of the stiffnesses over the volume of a cell: (C11^2 - C12^2)/C11.
double planeModulus(const std::vector<LatticeBond>& bonds);

/// Runs the trial in two strips, of 8 and 16 horizons, whose factors differ by the share of the horizon in the height,
/// and takes that out. Once in a process for each case. Throws std::runtime_error where no crack grows.
const GrowthTrialResult& growthTrial(const GrowthTrialCase& trial);

}  // namespace pd

#endif
