// The ring around the tip of a crack in a plane body over which J_Integral and Stress_Intensity integrate.
#ifndef PD_TIP_RING_HPP
#define PD_TIP_RING_HPP

#include <string>

#include "tip_place.hpp"

namespace pd {

class TipRing : public TipPlace {
 public:
  static void declareParameters(ParameterDeclarations& declarations, const char* compute);
  /// From a completed list. Throws std::invalid_argument.
  TipRing(const Teuchos::ParameterList& parameters, std::string compute);
  bool holds(double radius) const { return radius > innerRadius_ && radius < outerRadius_; }
  /// Of q, which falls from 1 at the inner to 0 at the outer radius, over the vector from the tip: 1/m2, inside the
  /// ring.
  double slope(double radius) const { return -1.0 / ((outerRadius_ - innerRadius_) * radius); }
  bool isPlaneStress() const { return isPlaneStress_; }

 private:
  double innerRadius_, outerRadius_;
  bool isPlaneStress_;
};

}  // namespace pd

#endif
