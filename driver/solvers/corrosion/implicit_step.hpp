// Implicit steps of dissolution and transport: backward Euler's, and one of second order.
#ifndef PD_IMPLICIT_STEP_HPP
#define PD_IMPLICIT_STEP_HPP

#include <memory>

#include "stage_equation.hpp"
#include "transport_step.hpp"

namespace pd {

enum class ImplicitMethod {
  BackwardEuler,
  Sdirk2  ///< R. Alexander, SIAM J. Numer. Anal. 14 (1977) 1006: L-stable, the last stage is the result
};

/// Of SDIRK2, with g = 1 - 1/sqrt(2),
///   C_1 = C_0 + g h f(C_1)   and   C_2 = C_0 + h ((1 - g) f(C_1) + g f(C_2)).
/// No method of its order keeps C between 0 and C_sat in steps of any length (C. Bolley & M. Crouzeix, RAIRO Anal.
/// Numer. 12 (1978) 237). The second stage starts beyond C_sat where the first has reached it: there it may take metal
/// back, no more than the first has given. A step that leaves C below 0, or above C_sat by more than
/// `largestOvershoot`, is replaced by one of backward Euler.
class ImplicitStep : public TransportStep {
 public:
  ImplicitStep(ImplicitMethod method, std::unique_ptr<StageSolver> solver, Saturation saturation,
               const std::string& concentrationField)
      : TransportStep(saturation, concentrationField), method_(method), solver_(std::move(solver)) {}

  void forget() override { solver_->forget(); }
  void forgetFactors() override { solver_->forgetFactors(); }
  int order() const override { return order_; }
  double error(std::size_t k, double lastRate, double h) const override;
  const std::vector<double>& endRate() const override { return order_ == 2 ? second_.liquid : rate_; }
  double fullest() const override;
  std::string work() const override;

 protected:
  bool advance(Simulation& simulation, const Fields& fields, double t, double h) override;

 private:
  /// Rates of a stage, by point of ids_ and solidIds_.
  struct Rates {
    std::vector<double> liquid, inflow, solid;
    std::vector<double> dissolution;  ///< what the surface gives
  };

  bool takeEulerStep(Model& model, const Fields& fields, double h);
  bool takeTwoStages(Simulation& simulation, const Fields& fields, double t, double h);
  void finishStage(StageEquation& equation, Rates& rates) const;
  bool isWithinBounds(Model& model, const Fields& fields) const;
  StageEquation equation(Model& model, const Fields& fields);

  ImplicitMethod method_;
  std::unique_ptr<StageSolver> solver_;
  std::vector<double> paused_;
  Rates first_, second_;
  int order_ = 1;
  long long nEvaluations_ = 0, nReplaced_ = 0;
};

}  // namespace pd

#endif
