// Nonlinear conjugate gradients for a stage of dissolution.
#ifndef PD_POLAK_RIBIERE_HPP
#define PD_POLAK_RIBIERE_HPP

#include <string>
#include <vector>

#include "stage_equation.hpp"

namespace pd {

/// By the residual alone, as it is minus the gradient of what a solution minimises: Polak and Ribiere's directions,
/// begun anew where they point back ("modified"), and a search along each by secants (J.R. Shewchuk, An introduction to
/// the conjugate gradient method without the agonizing pain, Carnegie Mellon University, 1994, B5). The bound C_sat by
/// projection: points that pass it are held, and released, where they have to be, as the others come to rest (B.T.
/// Polyak, USSR Comput. Math. Math. Phys. 9 (1969) 94).
class PolakRibiere : public StageSolver {
 public:
  /// `tolerance`: residual relative to the saturation concentration, at every point.
  PolakRibiere(double tolerance, int maximumIterations)
      : tolerance_(tolerance), maximumIterations_(maximumIterations) {}

  bool solve(StageEquation& equation) override;
  std::string work() const override;

 private:
  void findFreeResidual(const StageEquation& equation, std::vector<double>& values) const;
  void turn(const StageEquation& equation, bool isNew);
  /// To where the residual is across the direction; the largest residual there, NaN where there is no such place.
  double search(StageEquation& equation);

  double tolerance_;
  int maximumIterations_;
  std::vector<double> residual_, lastResidual_, direction_;
  double length_ = 0.0;  ///< of the last search, as a factor of the direction; 0: none yet
  long long nIterations_ = 0;
};

}  // namespace pd

#endif
