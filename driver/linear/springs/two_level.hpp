// Two-level preconditioner of a spring network: Chebyshev smoothing and an exact solve among affine displacements.
#ifndef PD_TWO_LEVEL_HPP
#define PD_TWO_LEVEL_HPP

#include <memory>
#include <vector>

#include "coarse_factor.hpp"
#include "coarse_space.hpp"
#include "spring_diagonal.hpp"

namespace pd {

/// z ~ K^-1 r, in single precision: smoothing, correction among the modes of a CoarseSpace, smoothing. Symmetric, and
/// positive definite where K is. With pieces of some sixty points conjugate gradients then need about ten iterations,
/// however large the body is. The coarse level may be older than the damage of the network.
class TwoLevel {
 public:
  /// Refers to both. Collective, as the rest.
  TwoLevel(const Communicator& comm, SpringOperator& stiffness);
  ~TwoLevel();

  /// The smoother, where springs or held degrees of freedom of these owned points, rising, have changed.
  void refreshSmoother(const std::vector<int>& changed);
  /// The coarse level, after the smoother.
  void rebuild();

  void apply(const PointVector<double>& r, PointVector<double>& z);

  int nCoarseUnknowns() const { return space_ ? space_->nUnknowns() : 0; }
  /// D [upper triangles][nOwned]: what couples each point with itself, in units of the network.
  const PointVector<double>& diagonal() const { return diagonal_; }

 private:
  void invertDiagonal(const std::vector<int>& points);
  void estimateLargest();
  void precondition(const PointVector<float>& r, PointVector<float>& z) const;
  /// z += a polynomial of the stiffness times r.
  void smooth(const PointVector<float>& r, PointVector<float>& z);
  void subtract(const PointVector<float>& x, PointVector<float>& from) const;
  void correct(PointVector<float>& r, PointVector<float>& z);

  const Communicator& comm_;
  SpringOperator& stiffness_;
  int nOwned_, dimension_;
  SpringDiagonal springDiagonal_;
  PointVector<double> diagonal_;  ///< [upper triangle][nPoints] with the operator's additions
  PointVector<float> inverse_;    ///< [upper triangle][nOwned]
  float largest_ = 2.0F;          ///< bound of the eigenvalues of D^-1 K
  std::unique_ptr<CoarseSpace> space_;
  std::unique_ptr<CoarseFactor> factor_;
  std::vector<double> right_, solution_;  ///< of this rank's unknowns
  PointVector<float> rest_, sum_, direction_, product_, scaled_, left_;
};

}  // namespace pd

#endif
