// Materials whose small displacements are those of a network of springs.
#ifndef PD_LINEAR_BONDS_HPP
#define PD_LINEAR_BONDS_HPP

#include <string>
#include <vector>

#include "Peridigm_DataManager.hpp"
#include "call.hpp"

namespace pd {

/// The second derivative of a strain energy at the reference configuration, bond by bond. With the difference eta of
/// the displacements of both ends of an unbroken bond xi = |xi| n, the energy of point i is
///   W_i = 1/2 sum_j [ along_ij (n.eta)^2 + across_ij (|eta|^2 - (n.eta)^2) ] + C_i(s_i),
/// where the whole family counts by
///   Rotation    s_i = sum_j across_ij xi x eta,  C_i = -1/2 s_i.A_i^-1 s_i,  A_i = sum_j across_ij (|xi|^2 1 - xi xi)
///               (the rotation that makes the energy least takes that much away)
///   Dilatation  s_i = sum_j along_ij xi.eta,     C_i = 1/2 dilatational_i s_i^2.
/// A bond that is damaged by d counts 1 - d. What a bond resists is the sum of what its two ends give.
struct LinearSprings {
  enum class Family { None, Rotation, Dilatation };
  Family family = Family::None;
  std::vector<double> along, across;  ///< [bonds of the call] N/m; across empty: none
  std::vector<double> dilatational;   ///< [owned points of the call] 1/(N m)
};

/// For materials (a mixin, as StepListener is): static solvers then need no tangent of theirs, which they would have to
/// assemble. After initialize().
class LinearBonds {
 public:
  virtual ~LinearBonds() = default;
  /// False where the material has no mechanics, or none of this kind.
  virtual bool hasSprings() const { return true; }
  /// Why it has none, for messages; empty where it has.
  virtual std::string springsObstacle() const { return hasSprings() ? "" : "its material carries no load"; }
  virtual LinearSprings::Family springFamily() const = 0;
  virtual LinearSprings springs(const Call& call, PeridigmNS::DataManager& data) const = 0;
};

}  // namespace pd

#endif
