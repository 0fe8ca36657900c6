// The linear system of a stage of dissolution whose matrix is not symmetric.
#ifndef PD_ASYMMETRIC_STAGE_HPP
#define PD_ASYMMETRIC_STAGE_HPP

#include <memory>
#include <string>
#include <vector>

#include "../../linear/operator_system.hpp"
#include "../../linear/row_inverse.hpp"
#include "compact_jacobian.hpp"
#include "stage_equation.hpp"

namespace pd {

/// Where a flow carries ions: 1 - h L - h s' + h k at free points, L diffusion and advection; by GMRES without the
/// matrix (StageEquation::applyJacobian), preconditioned by a factor of that of an earlier stage, or in
/// space, where factors grow fast, an incomplete one over near points (compact_jacobian.hpp). Other points are
/// unknowns, too, which are zero: so a factor fits when metal has dissolved.
class AsymmetricStage {
 public:
  /// step = matrix^-1 residual at free points, 0 at others, to a relative residual of `tolerance`. `slope`: s' by point
  /// of the equation. False where it failed. Concentrations in the fields are of no use then. Collective.
  bool solve(StageEquation& equation, const std::vector<double>& slope, double tolerance, std::vector<double>& step);
  void forget() {
    inverse_.reset();
    largestDiagonal_ = 1.0;
  }
  double largestDiagonal() const { return largestDiagonal_; }  ///< over the volumes
  long long nIterations() const { return nIterations_; }
  long long nFactors() const { return nFactors_; }
  const std::string& trouble() const { return trouble_; }

 private:
  bool makeInverse(StageEquation& equation, const std::vector<double>& slope);
  GmresReport iterate(StageEquation& equation, const std::vector<double>& slope, double tolerance, int mostIterations,
                      std::vector<double>& solution);

  std::unique_ptr<RowInverse> inverse_;
  PointUnknowns unknowns_;
  double largestDiagonal_ = 1.0;
  double leastPerDigit_ = 0.0, excess_ = 0.0;  ///< iterations since the inverse was made: for a digit; all beyond that
  long long nIterations_ = 0, nFactors_ = 0;
  std::string trouble_;
};

}  // namespace pd

#endif
