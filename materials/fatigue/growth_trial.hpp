// What a bond law makes of a crack on a lattice: growth by a trial, from which the coefficient that gives a wanted law
// of Paris follows in closed form.
//
// A bond near a crack tip whose strain range is e loses A e^M of its life in a cycle. Then, in a body that is linear,
//   da/dN = B A delta (dK / (E' sqrt(delta)))^M
// with a pure number B of M, the lattice, the influence function and the rule by which bonds are near the tip (Silling
// & Askari, SAND2014-18590, find A by a trial of the whole body instead), E' that of G = K^2/E' in the lattice, and K
// the factor of stresses ahead of the tip. Here B comes from a long strip between grips, in which the energy release
// rate is the same wherever the tip is, without T-stress; or from a compact tension specimen, under loads that hold K.
#ifndef PD_GROWTH_TRIAL_HPP
#define PD_GROWTH_TRIAL_HPP

#include <functional>
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
  double specimenWidth = 0.0;  ///< W of a compact tension specimen, in horizons; 0: a body large beside the horizon
};

/// Numbers that tell a case from all others.
std::vector<double> keyOf(const GrowthTrialCase& trial);

struct GrowthTrialResult {
  double factor = 0.0;  ///< B, for a body large beside the horizon, or for the specimen
  int nBroken = 0;      ///< bonds on the way, in the last body
};

/// Of the lattice in the plane, of the stiffnesses of bonds over the volume of a cell. C66 = C12, as of all bonds
/// without k_t.
struct PlaneStiffness {
  double c11 = 0.0, c12 = 0.0;
  double modulus() const { return (c11 * c11 - c12 * c12) / c11; }  ///< along an axis, E in a plane
  /// E' of G = K^2/E' for a crack of mode I along an axis, K the factor of stresses ahead of it (Sih, Paris & Irwin,
  /// Int. J. Fract. Mech. 1 (1965) 189). (C11^2 - C12^2)/C11 where C11 = 3 C12; of squares with three spacings a
  /// horizon 0.976 of that.
  double fractureModulus() const;
};
PlaneStiffness planeStiffness(const std::vector<LatticeBond>& bonds);

/// Runs the trial in two strips, of 12 and 24 horizons, whose factors differ by the share of the horizon in the height,
/// and takes that out: strips of 24 and 48 horizons give the same within 1 %. Or in the specimen, about a = W/2: there
/// bonds see more than K, as in tests that find Paris' constants, and B is smaller. Once in a process for each case.
/// Throws std::runtime_error where no crack grows.
const GrowthTrialResult& growthTrial(const GrowthTrialCase& trial);

/// Part of a life in a cycle, over the strain range in parts of dK / (E' sqrt(delta)).
using LossRate = std::function<double(double)>;
enum class TrialBody {
  Strip,  ///< the smaller one, or the specimen
  Large   ///< what both have in common, or the specimen
};
/// Horizons a cycle where bonds near the tip lose by this law in place of a power; 0 where the crack stands.
double trialGrowth(const GrowthTrialCase& trial, const LossRate& lossRate, TrialBody body);

/// Strain range of the bond that must break next where a crack stands, over dK / (E' sqrt(delta)), to 2e-3 of it: with
/// that limit of strains a crack grows at ranges of K above dK alone. By some ten trials in each strip.
double standingStrain(const GrowthTrialCase& trial, TrialBody body);

}  // namespace pd

#endif
