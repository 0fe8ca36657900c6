// The linear system of a stage of dissolution whose matrix is not symmetric.
#ifndef PD_ASSEMBLED_STAGE_HPP
#define PD_ASSEMBLED_STAGE_HPP

#include <memory>
#include <vector>

#include "../../linear/linear_system.hpp"
#include "stage_equation.hpp"

namespace pd {

/// Where a flow carries ions: V (1 - h L - h s' + h k) assembled from the materials' Jacobians, L diffusion and
/// advection, by GMRES with an incomplete factor of each rank's rows.
class AssembledStage {
 public:
  /// step = matrix^-1 residual at free points, 0 at others, to a relative residual of `tolerance`. `slope`: s' by point
  /// of the equation. Returns the iterations taken, negative where it failed. Collective.
  int solve(StageEquation& equation, const std::vector<double>& slope, double tolerance, int mostIterations,
            std::vector<double>& step);
  double largestDiagonal() const { return largestDiagonal_; }  ///< over the volumes

 private:
  void assemble(StageEquation& equation, const std::vector<double>& slope);

  std::unique_ptr<LinearSystem> system_;
  double largestDiagonal_ = 1.0;
};

}  // namespace pd

#endif
