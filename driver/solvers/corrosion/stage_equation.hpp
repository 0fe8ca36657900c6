// The equation of one implicit stage of dissolution and transport.
#ifndef PD_STAGE_EQUATION_HPP
#define PD_STAGE_EQUATION_HPP

#include <vector>

#include "transport_step.hpp"

namespace pd {

/// C - C_start = h (L C + q + k (C_far - C)), where q, what the surface gives, is s(C) for C < C_sat, some q between
/// `least` and s(C_sat) for C = C_sat, and `least` for C > C_sat. With least = 0, q = (1 - S) s(C): salt covers a share
/// S of the surface. From C_start <= C_sat no C exceeds it then. (Surfaces that pause have S given.) Saturation is thus
/// a complementarity condition. With bonds as symmetric as they are, the equation says where the gradient of a function
/// of C vanishes, which has a kink at C_sat at the surface. Vectors are by point of the step's ids.
class StageEquation {
 public:
  struct Points {
    const std::vector<int>& ids;          ///< owned local ids
    const std::vector<char>& isUnknown;   ///< not prescribed
    const std::vector<double>& exchange;  ///< k, 1/s
    const std::vector<double>& farValue;  ///< C_far
  };
  /// `paused`: S by point, empty where the stage must find it; `nEvaluations` counts evaluations of the flux.
  StageEquation(Model& model, const TransportFields& fields, const Points& points, const std::vector<double>& paused,
                long long& nEvaluations);

  /// For a stage of length h from C_start: first guess from fields alone, so that a restarted run makes the same.
  void begin(const std::vector<double>& start, double h, const std::vector<double>& least);
  /// From now on what a flow carries is limited as at the concentrations of the last evaluation, and linear in C: the
  /// stage has a solution that Newton's method finds at once, in which the same leaves one end of a bond as enters the
  /// other. Until the next stage begins.
  void holdLimits() { limitsAreHeld_ = true; }
  /// Limits are held at the present concentrations, or at zero where they are below it.
  void limitAgain();
  /// What a flow carries is that of its upwind end alone: held limits of a constant.
  void carryUpwind();
  /// Whether any free point is below zero by more than a step may owe. Collective.
  bool isBelowZero() const;
  /// Residual C_start + h rate - C at the concentrations in the fields, of held points with bare surfaces; the largest
  /// of free points, relative to saturation.
  double evaluate();
  /// Held points whose q would be beyond its bounds are free again; whether there are any. From the residual.
  bool release(double tolerance);
  /// Surface points that have passed C_sat are held at it; whether there are any.
  bool hold(double tolerance);
  /// Salt_Coverage of the solution: 1 - q/s(C).
  void setSalt();
  /// Rates from the fields as they are.
  void findRates();
  /// image = (1 - h L - h s' + h k) direction at free points, 0 elsewhere, with s' = slope, on surfaces all under salt:
  /// their electrolyte's flux is linear (what a flow carries: where limits are held). By way of the concentrations in
  /// the fields, which are of no use then. Collective.
  void applyJacobian(const std::vector<double>& slope, const std::vector<double>& direction,
                     std::vector<double>& image);
  double dot(const std::vector<double>& a, const std::vector<double>& b) const;

  Model& model() const { return model_; }
  const TransportFields& fields() const { return fields_; }
  const std::vector<int>& ids() const { return points_.ids; }
  double h() const { return h_; }
  double exchange(std::size_t k) const { return points_.exchange[k]; }
  double inflow(std::size_t k) const;  ///< from beyond the mesh at the present concentration
  const std::vector<double>& start() const { return start_; }
  const std::vector<double>& residual() const { return residual_; }
  const std::vector<char>& isFree() const { return isFree_; }  ///< not: prescribed, or C is C_sat and q the unknown
  bool isHeld(std::size_t k) const { return points_.isUnknown[k] != 0 && isFree_[k] == 0; }
  double slope(std::size_t k) const;  ///< dq/dC, 1/s

 private:
  bool pauses() const { return !paused_.empty(); }

  Model& model_;
  const TransportFields& fields_;
  Points points_;
  const std::vector<double>& paused_;
  long long& nEvaluations_;
  double h_ = 0.0;
  bool limitsAreHeld_ = false;
  std::vector<double> start_, least_, residual_;
  std::vector<char> isFree_, isBeyond_;  ///< beyond: free, with C > C_sat
};

/// A way to solve it.
class StageSolver {
 public:
  virtual ~StageSolver() = default;
  /// From the concentrations in the fields to those of the solution, with the residual there. False where it does not
  /// converge. Collective.
  virtual bool solve(StageEquation& equation) = 0;
  /// What is kept from stage to stage for speed alone.
  virtual void forget() {}
  /// What is kept for longer, since it takes long to make.
  virtual void forgetFactors() {}
  virtual std::string work() const = 0;                    ///< of all stages, in words
  const std::string& trouble() const { return trouble_; }  ///< of the last stage; empty where there is no more to say

 protected:
  std::string trouble_;
};

}  // namespace pd

#endif
