// Explicit steps of dissolution and transport: Euler's, and Runge-Kutta-Legendre's of second order.
#ifndef PD_EXPLICIT_STEP_HPP
#define PD_EXPLICIT_STEP_HPP

#include "../diffusion/stabilized_scheme.hpp"
#include "transport_step.hpp"

namespace pd {

enum class ExplicitMethod {
  Euler,    ///< in as many equal sub-steps as stability asks for
  Legendre  ///< one step of as many stages as stability asks for
};

/// Every stage advances liquid and solid points by the same combination of rates, so that mass is conserved. Where
/// salt keeps C at C_sat, S is what keeps the stage's result there, clamped to [0, 1].
class ExplicitStep : public TransportStep {
 public:
  ExplicitStep(ExplicitMethod method, Saturation saturation, const std::string& concentrationField)
      : TransportStep(saturation, concentrationField), method_(method) {}

  void forget() override { nOfBound_ = 0; }
  /// x h^2 C'', from the change of the rate since the last step.
  double error(std::size_t k, double lastRate, double h) const override {
    return errorFactor_ * h * (rate_[k] - lastRate);
  }
  std::string work() const override;

 protected:
  bool advance(Simulation& simulation, const Fields& fields, double t, double h) override;

 private:
  /// By point: of liquid points, prescribed ones included; of dissolving ones; and what comes from beyond the mesh.
  struct Change {
    std::vector<double> liquid, solid, inflow;
    void resize(std::size_t nLiquid, std::size_t nSolid);
    /// this = mu this + nu older + now rate + first firstRate; older = what this was.
    void advance(const StabilizedStage& stage, double h, const Change& rate, const Change& firstRate, Change& older);
    void add(const Change& other);
  };

  /// Largest sum of the weights of a point's bonds with liquid, and exchange beyond the mesh, 1/s.
  void findBound(Model& model, const Fields& fields, double h);
  void takeSubStep(Model& model, const Fields& fields, double h);
  /// Rates of the stage from the values in the fields, into now_.
  void evaluate(Model& model, const Fields& fields, double h, const StabilizedStage& stage);
  /// S by what the stage would come to with bare surfaces; whether there is any.
  bool findSalt(const Fields& fields, double h, const StabilizedStage& stage);
  void useScheme(int nStages);

  ExplicitMethod method_;
  StabilizedScheme scheme_;
  Change total_, change_, older_, now_, first_;
  std::vector<double> start_, coverage_;  ///< of the points ids_: C when the sub-step begins; S of the stage
  std::size_t nOfBound_ = 0;              ///< points that the bound is of
  double bound_ = 0.0, errorFactor_ = 0.5;
  int mostStages_ = 0;
  long long nSubSteps_ = 0, nEvaluations_ = 0;
};

}  // namespace pd

#endif
