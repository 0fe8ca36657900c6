// The linear system of a stage of dissolution whose matrix is not symmetric.
#ifndef PD_ASSEMBLED_STAGE_HPP
#define PD_ASSEMBLED_STAGE_HPP

#include <memory>
#include <string>
#include <vector>

#include "../../linear/row_system.hpp"
#include "stage_equation.hpp"

namespace pd {

/// Where a flow carries ions: 1 - h L - h s' + h k at free points, from the materials' Jacobians, L diffusion and
/// advection; by GMRES with an LU factor of an earlier stage's matrix, as long as that takes few iterations, or in
/// space, where factors grow fast, an incomplete one. Other points are unknowns, too, which are zero: so a factor fits
/// when metal has dissolved.
class AssembledStage {
 public:
  /// step = matrix^-1 residual at free points, 0 at others, to a relative residual of `tolerance`. `slope`: s' by point
  /// of the equation. False where it failed. Collective.
  bool solve(StageEquation& equation, const std::vector<double>& slope, double tolerance, std::vector<double>& step);
  void forget() {
    system_.reset();
    largestDiagonal_ = 1.0;
  }
  double largestDiagonal() const { return largestDiagonal_; }  ///< over the volumes
  long long nIterations() const { return nIterations_; }
  long long nFactors() const { return nFactors_; }
  const std::string& trouble() const { return trouble_; }

 private:
  class Collector;
  void number(StageEquation& equation);
  SparseRows assemble(StageEquation& equation, const std::vector<double>& slope);
  bool factor(const Discretization& mesh);

  std::unique_ptr<RowSystem> system_;
  std::vector<int> localId_;             ///< by global id, of owned points and ghosts
  std::vector<double> column_, isFree_;  ///< [points] of the unknown; 1 at free points
  long long first_ = 0;                  ///< unknown of this rank
  double largestDiagonal_ = 1.0;
  long long nIterations_ = 0, nFactors_ = 0;
  std::string trouble_;
};

}  // namespace pd

#endif
