// One entry of section Boundary Conditions.
#ifndef PD_CONDITION_HPP
#define PD_CONDITION_HPP

#include <string>
#include <vector>

#include "../deck/deck.hpp"
#include "../deck/function.hpp"
#include "../discretization/discretization.hpp"

namespace pd {

enum class ConditionKind {
  InitialDisplacement,
  InitialVelocity,
  InitialValue,
  PrescribedDisplacement,
  PrescribedValue,
  BodyForce,
  Traction,
  NoFailure,
  SaturatedCrackFaces,
  FarField
};

struct Condition {
  std::string name;
  DeckNode node;
  ConditionKind kind = ConditionKind::NoFailure;
  std::string field;        ///< what it sets
  int component = 0;        ///< of a vector field
  std::vector<int> points;  ///< local ids, owned and ghosts
  Function value = Function::constant(0.0);
  double threshold = 0.0;                    ///< of Damage
  double area = 0.0;                         ///< m2, of a traction or a far field
  double scale = 1.0;                        ///< of the value; a traction's Area over the volume of its points
  double diffusivity = 0.0, distance = 0.0;  ///< m2/s and m, of a far field
  double exchangeRate = 0.0;                 ///< 1/s, of a far field

  bool isForce() const { return kind == ConditionKind::BodyForce || kind == ConditionKind::Traction; }
  bool isInitial() const {
    return kind == ConditionKind::InitialDisplacement || kind == ConditionKind::InitialVelocity ||
           kind == ConditionKind::InitialValue;
  }
  /// value(x, t) at each of `points`; kept, and evaluated anew only where t matters.
  const std::vector<double>& evaluate(const std::vector<double>& x, double t) const;

 private:
  mutable std::vector<double> values_;
  mutable double evaluatedAt_ = 0.0;
};

/// The conditions of the deck in its order, with their points. Mistakes go to `mistakes`.
std::vector<Condition> readConditions(const Deck& deck, const Discretization& discretization, Mistakes& mistakes);

/// Whether the two conditions give the same value everywhere: the same text in the deck, or equal constants.
bool haveSameValue(const Condition& a, const Condition& b);

}  // namespace pd

#endif
