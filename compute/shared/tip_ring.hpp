// The ring around the tip of a crack in a plane body over which J_Integral and Stress_Intensity integrate.
#ifndef PD_TIP_RING_HPP
#define PD_TIP_RING_HPP

#include <string>

#include "plugins.hpp"
#include "point_deformation.hpp"

namespace pd {

/// Of the direction of the crack that a Crack_Tip with this label finds.
inline std::string crackDirectionLabel(const std::string& tipLabel) { return tipLabel + "_Direction"; }

struct TipRingFields : DeformationGradients::Fields {
  FieldHandle tip, direction;  ///< unused where the deck gives a position, or the label of no such field
  explicit TipRingFields(const Teuchos::ParameterList& parameters);
};

class TipRing {
 public:
  static void declareParameters(ParameterDeclarations& declarations, const char* compute);
  /// From a completed list. Throws std::invalid_argument.
  TipRing(const Teuchos::ParameterList& parameters, std::string compute);
  /// Throws std::invalid_argument where the deck's Tip Field is not the result of a Crack_Tip.
  void requireTip(PeridigmNS::Block& block, const FieldHandle& tip) const;
  struct Tip {
    Vector3 place, direction;
  };
  /// Where the crack ends and grows to: of the deck, or of a Crack_Tip.
  Tip tip(PeridigmNS::Block& block, const TipRingFields& fields) const;
  bool holds(double radius) const { return radius > innerRadius_ && radius < outerRadius_; }
  /// Of q, which falls from 1 at the inner to 0 at the outer radius, over the vector from the tip: 1/m2, inside the
  /// ring.
  double slope(double radius) const { return -1.0 / ((outerRadius_ - innerRadius_) * radius); }
  /// Of their neighbours: points that keep less than that hang on the lips of the crack as they happen to, and their
  /// strain is none of the body's. A straight cut leaves 0.5 to 0.6, steps of a path across rows of points 0.44.
  static constexpr double leastIntact = 0.4;
  double thickness() const { return thickness_; }  ///< m
  bool isPlaneStress() const { return isPlaneStress_; }

 private:
  std::string compute_, tipField_;
  Vector3 tip_, direction_;
  double innerRadius_, outerRadius_, thickness_;
  bool isPlaneStress_, isDirectionGiven_ = false;
};

}  // namespace pd

#endif
