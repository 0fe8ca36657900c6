// The stiffness of a model for small displacements, as springs, and equilibria with it.
#ifndef PD_SPRING_TANGENT_HPP
#define PD_SPRING_TANGENT_HPP

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "../linear/linear_system.hpp"
#include "../linear/springs/conjugate_gradients.hpp"
#include "../linear/springs/two_level.hpp"
#include "../model/model.hpp"

namespace pd {

/// Of a model whose materials have LinearBonds. No matrix: conjugate gradients with a TwoLevel preconditioner.
class SpringTangent {
 public:
  /// Which material with forces has no springs, or of another kind than the rest; empty where it fits the model.
  static std::string obstacle(Model& model);
  /// Refers to the model. After its initialize(). `isBody`: forces are those of the springs, not of the materials; then
  /// a bond that is broken at one of its ends alone is refused (RunError) when it is taken up. Collective.
  SpringTangent(Model& model, bool isBody);

  /// `isHeld` [3 nOwned].
  void hold(const std::vector<char>& isHeld);
  /// Bonds have broken, or have been put back.
  void bondsHaveChanged() { bondsAreKnown_ = false; }
  /// What is kept from now on depends on bonds and held points alone, not on how they came to be so.
  void forgetHistory();
  /// Takes up what has changed. Collective.
  void prepare();
  /// Takes up changed bonds; false where they may have parted the body. Collective.
  bool keepsTogether();
  /// Takes up what has changed but for what conjugate gradients need alone. Collective.
  const SpringOperator& stiffness();
  /// The owned points whose bonds have changed since this was last called, rising.
  std::vector<int> takeChangedPoints();

  /// Writes the force density [3 nPoints] N/m3 that displacements [3 nPoints] cause, complete at owned points. The
  /// norm of the forces may be off by `mostError` N, beyond what double precision leaves of them. Collective.
  void force(const double* displacement, double* forceDensity, double mostError = 0.0);
  /// Where blocks have a Force_Density of their own, the sum for each of them.
  void copyForceToBlocks();
  /// x = K^-1 b over free degrees of freedom [3 nOwned], N, m; zero at held ones. With `product`, of another stiffness
  /// K near this one: [3 nOwned] m to N. Collective.
  using Product = std::function<void(const double*, double*)>;
  LinearSolveReport solve(const double* b, double* x, double tolerance, int maximumIterations,
                          const Product& product = {});

  /// |u_j - u_i|/|xi| of the unbroken bonds of some fifty points, in the mean, for displacements [3 nPoints]: how far
  /// bonds have stretched and turned. Collective.
  double meanBondMotion(const double* displacement) const;
  /// Norm of the diagonal at free degrees of freedom, N/m, when the coarse level was made.
  double normOfDiagonal() const { return normOfDiagonal_; }

  int nCoarseUnknowns() const { return levels_.nCoarseUnknowns(); }
  std::size_t bytes() const { return network_.bytes(); }
  int nStiffenedPoints() const { return static_cast<int>(stiffness_.additions().size()); }

 private:
  static SpringNetwork networkOf(Model& model, bool isBody);
  void takeUpDamage();
  void requireWholeBonds(const std::vector<int>& changed) const;
  /// Throws RunError: point i has broken its bond to j, which has not.
  [[noreturn]] void refuseHalfBond(int i, int j) const;
  void refreshSmoother();
  void rebuildLevels();  ///< the coarse level and its smoother anew, of the bonds as they are. Collective
  void findNormOfDiagonal();
  double normOfRight() const;
  /// knownImage_ = K full_, of which only what has changed is found again.
  void applyToDisplacement(double mostError);
  /// The same where no bond has changed, by what the displacements have changed by, in single precision. False where
  /// that would leave more than `mostError`. Collective.
  bool followDisplacement(double mostError);
  bool hasSprings(int point) const;
  void toSinglePrecision(const PointVector<double>& x, double factor);  ///< single_ = factor x
  void applyInSinglePrecision(const PointVector<double>& x, PointVector<double>& y);
  std::vector<int> allPoints() const;

  Model& model_;
  bool isBody_;
  SpringNetwork network_;
  SpringOperator stiffness_;
  TwoLevel levels_;
  std::vector<char> isHeld_;
  std::vector<double> seenDamage_;      ///< [nOwned] Damage when its bonds were last read; NaN: never
  std::vector<std::size_t> firstBond_;  ///< [nOwned] in the bond fields of the point's block
  std::vector<int> stalePoints_;        ///< whose springs or held degrees of freedom the smoother does not know
  std::vector<int> newlyHeld_;          ///< points held since the coarse level was last looked at
  bool bondsAreKnown_ = false, coarseIsCurrent_ = false, mustRebuild_ = true;
  double normOfDiagonal_ = 0.0;       ///< N/m, of what is free to move
  double normOfWholeDiagonal_ = 0.0;  ///< N/m, with what is held
  int nChanges_ = 0;                  ///< of bonds or held points since the coarse level was made
  /// Norm of the residual that the last solve was to leave; huge: none with these bonds.
  double expectedRest_ = std::numeric_limits<double>::max();
  double freshRate_ = 0.0;  ///< decades of the residual an iteration when it was new
  PointVector<double> right_, solution_, full_, change_;
  PointVector<float> single_, singleImage_;
  /// What force() found last, and the points whose bonds have changed since.
  PointVector<double> knownDisplacement_, knownImage_, knownResponses_;
  double knownError_ = 0.0;  ///< N, bound of what single precision has left of knownImage_
  std::vector<int> changedSince_;
  std::vector<char> isUntaken_;  ///< [nOwned] of takeChangedPoints()
  bool knowsImage_ = false;
};

}  // namespace pd

#endif
