// Newton's method for static equilibrium at constant damage.
#ifndef PD_NEWTON_HPP
#define PD_NEWTON_HPP

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "../linear/linear_system.hpp"
#include "../model/simulation.hpp"
#include "linear_solver_settings.hpp"
#include "mechanics.hpp"
#include "spring_tangent.hpp"

namespace pd {

struct NewtonSettings {
  int maximumIterations = 50;
  double relativeTolerance = 1e-6;  ///< 0: not a criterion
  double absoluteTolerance = 0.0;   ///< N; 0: not a criterion
  std::string linearSolver = "CG";
  std::string preconditioner;    ///< empty: Two Level where it fits, else Multigrid
  bool hasSmallStrain = false;   ///< forces are those of the springs of the reference configuration (LinearBonds)
  double linearTolerance = 0.0;  ///< 0: as tight as the step needs
  int maximumLinearIterations = 2000;
  bool logsLinearSolves = false;
  double diagonalScale = 1.0, diagonalShift = 0.0;  ///< damped Newton: diagonal * scale + largest diagonal * shift

  void take(const LinearSolverSettings& linear);
  static void declareKinematics(ParameterDeclarations& declare);
  /// After take() and the damping. Throws std::invalid_argument where what `solver` is given does not go together.
  void takeKinematics(const Teuchos::ParameterList& parameters, const std::string& solver);
};

/// How one search for equilibrium went.
struct NewtonOutcome {
  bool hasConverged = false;
  std::vector<double> residuals;     ///< |unbalanced force|, N: at the start and after each iteration
  double scale = 0.0;                ///< what the relative tolerance refers to, N
  std::string trouble;               ///< why it stopped where it has not converged
  bool iterationsAreUsedUp = false;  ///< which is that trouble
};

/// Finds the displacements at which internal and external forces balance at all degrees of freedom that are not held.
/// The tangent is kept as long as it makes good progress, over load steps too.
class Newton {
 public:
  explicit Newton(NewtonSettings settings) : settings_(std::move(settings)) {}

  struct Fields : MechanicsFields {
    FieldHandle tangentDisplacement = writes(pd::fields::pointVector(
        "Tangent_Displacement", "m", "Where the tangent was made: from this a restart makes the same one again."));
  };

  /// `isHeld` [3 nOwned]. A tangent of other held degrees of freedom is dropped.
  void hold(const std::vector<char>& isHeld);
  /// For when bonds have broken, or have been put back.
  void dropTangent();
  /// After dropTangent(): whether bonds that have broken are known to have parted nothing. Collective.
  bool keepsTogether() { return springs_ && springs_->keepsTogether(); }
  /// For the start of an increment: tries the cheapest tangent again, whatever the one before took.
  void startIncrement(Model& model);
  /// What follows is to follow from the state of the model alone, as in a run that is taken up from a checkpoint of it:
  /// what springs are kept with is made anew from the bonds that there are.
  void forgetHistory() {
    forceError_ = 0.0;
    if (springs_) springs_->forgetHistory();
  }
  /// Throws RunError where the settings ask for springs, and the materials have none.
  void requireSprings(Model& model) const;
  /// Makes the tangent at the present displacements, if there is none.
  void prepareTangent(Simulation& simulation, double dt);

  /// A first guess for held displacements that have moved from `start` [3 nOwned] to their present values: the free
  /// ones follow as the tangent says. (Newton's method itself would start from a body distorted along its held points.)
  void followHeldPoints(Simulation& simulation, double dt, const std::vector<double>& externalForce);

  /// From the present displacements. `externalForce` [3 nOwned], N/m3. `largestScale`: of all load steps so far, so
  /// that a body that has broken apart and carries nothing can be in equilibrium too.
  NewtonOutcome solve(Simulation& simulation, double dt, const std::vector<double>& externalForce, double largestScale);

  bool hasTangent() const { return hasTangent_; }
  /// Makes the tangent again that a run before a restart had, from the field that remembers where it was made.
  void restoreTangent(Simulation& simulation, double dt);

  // Counted over the run.
  long long nIterations = 0, nTangents = 0, nLinearIterations = 0, nGmresFallbacks = 0;
  double largestLinearResidual = 0.0;
  int nStiffenedPoints = 0;  ///< of the last tangent, on this rank: points free to move along some direction
  bool stoppedAtRoundOff = false;
  long long nSpringSolves = 0, nDifferenceSolves = 0;  ///< linear solves without a matrix: by springs, by differences
  const SpringTangent* springs() const { return springs_.get(); }
  SpringTangent* springs() { return springs_.get(); }
  bool couplesFamilies() const { return couplesFamilies_; }
  /// For an equilibrium: in small strain, keeps how far bonds have stretched and turned. Collective.
  void watchBondMotion(Model& model);
  /// For the end of a run: of what makes the results of such equilibria doubtful.
  std::vector<std::string> warnings() const;

 private:
  struct Balance {
    double free = 0.0, scale = 0.0;  ///< N
  };
  /// What the linear solves are made with: springs of the reference configuration; difference quotients of the forces
  /// about the present displacements, for which the former are the preconditioner; or the matrix of the tangent.
  enum class Tangent { Springs, Differences, Assembled };

  /// In which no bond resists a point: it hangs on bonds in a line, as a loose end or a fibre on the lips of a crack.
  struct SlackDirection {
    std::size_t point;
    std::array<double, 3> axis;
  };

  Balance evaluate(Simulation& simulation, double dt, const std::vector<double>& externalForce);
  /// Where bonds are springs, and all held displacements have grown from the start of the step by one factor, so do the
  /// others. False where it is not so. Collective.
  bool growWithLoads(Simulation& simulation);
  void forgetTangent();
  void leaveOutSlack(const std::vector<double>& externalForce);
  void chooseTangent(Model& model);
  void makeTangent(Simulation& simulation, double dt);
  /// Goes over to a better kind. False where there is none.
  bool improveTangent(Tangent better);
  void learn(double reduction, double linearResidual);
  /// For the start of an equilibrium.
  void findFarthest(Model& model);
  /// N: what rounding of places alone makes of the residual.
  double roundOff() const;
  void springForce(Model& model);
  void completeSmallStrain(Model& model, double dt);
  std::string preconditionerName() const;
  LinearSolveReport solveByDifferences(Simulation& simulation, double dt, const std::vector<double>& externalForce,
                                       double tolerance);
  void assemble(Simulation& simulation, double dt);
  void assembleOnce(Simulation& simulation, double dt);
  bool someFamilyIsCoupled(Model& model, double dt) const;
  void stiffenLoosePoints(Model& model);
  void damp(Model& model);
  LinearSolveReport solveLinear(Simulation& simulation, double dt, const std::vector<double>& externalForce,
                                double tolerance);
  double search(Simulation& simulation, double dt, const std::vector<double>& externalForce, Balance& balance);

  Fields fields_;
  NewtonSettings settings_;
  std::unique_ptr<LinearSystem> system_;
  std::unique_ptr<SpringTangent> springs_;
  Tangent tangent_ = Tangent::Springs;
  bool hasChosen_ = false, usesSprings_ = false, derivesFields_ = false;
  double largestBondMotion_ = 0.0;       ///< SpringTangent::meanBondMotion()
  double nonlinearity_ = 1e-3;           ///< what a step leaves of the residual that solves the linear problem exactly
  std::vector<char> isHeld_;             ///< [3 nOwned]
  std::vector<double> residual_, step_;  ///< [3 nOwned] N, m
  std::vector<SlackDirection> slack_;    ///< of the last matrix
  bool hasTangent_ = false, couplesFamilies_ = false, hasProbed_ = false;
  double normOfDiagonal_ = 0.0;  ///< N/m: of the last tangent
  double forceError_ = 0.0;      ///< N: that the forces of springs may have
  double farthest_ = 0.0;        ///< m: of any coordinate, in the reference configuration and displacement together
};

}  // namespace pd

#endif
