// The ring around the tip of a crack in a plane body over which J_Integral and Stress_Intensity integrate.
#ifndef PD_TIP_RING_HPP
#define PD_TIP_RING_HPP

#include <optional>
#include <string>

#include "tip_place.hpp"
#include "whole_body.hpp"

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

  /// Looks, for each tip until there is one, for a place where the body does not fill the ring. Collective.
  void watchCover(const Blocks& blocks, const TipFields& fields, const WholeBody& whole, const Tip& tip,
                  const Epetra_Comm& comm) const;
  /// What watchCover() has found, for RunNotes; `label`: of the compute's result.
  std::vector<std::string> notes(const std::string& label) const;

 private:
  double innerRadius_, outerRadius_;
  bool isPlaneStress_;
  mutable std::optional<Vector3> watched_;  ///< the tip for which the cover was looked at last
  mutable std::string gap_;
};

}  // namespace pd

#endif
