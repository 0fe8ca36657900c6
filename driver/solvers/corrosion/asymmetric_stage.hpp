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
    largestRate_ = 0.0;
    nFailures_ = nUntilTry_ = 0;
  }
  /// Over the volumes, of a stage of length `h`, s, with the rates of the last inverse.
  double largestDiagonal(double h) const { return 1.0 + h * largestRate_; }
  long long nIterations() const { return nIterations_; }
  long long nFactors() const { return nFactors_; }
  const std::string& trouble() const { return trouble_; }

 private:
  bool makeInverse(StageEquation& equation, const std::vector<double>& slope);
  void learnFromKept(bool hasConverged);
  GmresReport iterate(StageEquation& equation, const std::vector<double>& slope, double tolerance, int mostIterations,
                      std::vector<double>& solution);

  std::unique_ptr<RowInverse> inverse_;
  PointUnknowns unknowns_;
  double largestRate_ = 0.0;                   ///< 1/s, of diagonals
  double leastPerDigit_ = 0.0, excess_ = 0.0;  ///< iterations since the inverse was made: for a digit; all beyond that
  int nFailures_ = 0, nUntilTry_ = 0;          ///< of old inverses, one after the other; solves without them
  long long nIterations_ = 0, nFactors_ = 0;
  std::string trouble_;
};

}  // namespace pd

#endif
