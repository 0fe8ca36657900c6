// Backward Euler of dissolution and transport.
#ifndef PD_IMPLICIT_STEP_HPP
#define PD_IMPLICIT_STEP_HPP

#include "transport_step.hpp"
#include "two_level_preconditioner.hpp"

namespace pd {

struct ImplicitSettings {
  int maximumNewtonIterations = 50;
  int maximumLinearIterations = 5000;
  double tolerance = 1e-9;  ///< residual relative to the saturation concentration, at every point
};

/// C - C_old = h (L C + (1 - S) s(C) + k (C_far - C)), and, unless the surface pauses (then S is given),
///   0 <= S, C <= C_sat, S = 0 where C < C_sat.
/// Saturation is thus a complementarity condition, solved with the transport by Newton's method on an active set
/// (Hintermueller, Ito & Kunisch, SIAM J. Optim. 13 (2002) 865), each linear system by conjugate gradients without a
/// matrix, with a preconditioner of two levels where they are stiff.
class ImplicitStep : public TransportStep {
 public:
  ImplicitStep(const ImplicitSettings& settings, Saturation saturation)
      : TransportStep(saturation), settings_(settings) {}

  void forget() override { preconditioner_.discard(); }
  double errorFactor() const override { return 0.5; }
  std::string work() const override;

 protected:
  bool advance(Model& model, const Fields& fields, double h) override;

 private:
  void guessSaturated(const Fields& fields);
  bool iterate(Model& model, const Fields& fields, double h);
  void finish(Model& model, const Fields& fields, double h);
  double dot(Model& model, const Fields& fields, const std::vector<double>& a, const std::vector<double>& b) const;
  double residual(Model& model, const Fields& fields, double h);
  bool updateSaturated(Model& model, const Fields& fields, double tolerance);
  bool solveLinear(Model& model, const Fields& fields, double h, double target);
  void makePreconditioner(Model& model, double h);
  /// Conjugate gradients from step_ on; the iterations taken, negative where it failed.
  int conjugateGradients(Model& model, const Fields& fields, double h, double target, int mostIterations);
  void precondition(Model& model, const std::vector<double>& r, std::vector<double>& z);
  void applyMatrix(Model& model, const Fields& fields, double h, const std::vector<double>& direction,
                   std::vector<double>& image);

  ImplicitSettings settings_;
  std::vector<char> isFree_;  ///< not free: prescribed, or C is C_sat and S the unknown
  std::vector<double> residual_, step_, slope_, paused_;
  TwoLevelPreconditioner preconditioner_;
  double builtFor_ = 0.0;                 ///< step of the preconditioner
  int leastIterations_ = 0, excess_ = 0;  ///< with it: fewest of a solve; all beyond that
  long long nNewtonIterations_ = 0, nLinearIterations_ = 0;
};

}  // namespace pd

#endif
