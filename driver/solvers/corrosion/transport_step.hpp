// One step of the ions that dissolve into an electrolyte and diffuse in it, at given phases.
#ifndef PD_TRANSPORT_STEP_HPP
#define PD_TRANSPORT_STEP_HPP

#include <limits>
#include <string>
#include <vector>

#include "../../model/simulation.hpp"
#include "phase_lists.hpp"

namespace pd {

/// What happens where the electrolyte at a surface can hold no more.
enum class Saturation {
  Complementarity,  ///< salt covers the share of the surface that keeps C at C_sat
  Pause             ///< a surface with C >= C_sat at the beginning of a step does not dissolve in it, others freely
};

/// Point fields that steps work on.
struct TransportFields {
  std::string label, rateLabel;  ///< of the concentration and its rate
  int nOwned, nPoints;
  double *concentration, *rate, *salt, *dissolution, *slope, *saturation, *volume, *area, *limitedAt;
  TransportFields(Model& model, const std::string& concentrationField);
  /// Salt_Coverage of the owned points `ids`, and the same of all points of other ranks.
  void coverWithSalt(const std::vector<int>& ids, double coverage) const;
  /// What a flow carries is limited at the present concentrations, ghosts included, until this is called again.
  void limitHere() const;
  /// Salt_Coverage of the owned points `ids`; imports that of others.
  void setSalt(Model& model, const std::vector<int>& ids, const std::vector<double>& coverage) const;
};

/// Of the concentration C of liquid points,
///   dC/dt = L C + (1 - S) s(C) + k (C_far - C),
/// L: diffusion between liquid points, s: what the bare surface gives, S: the share of it that salt covers, k: exchange
/// with an electrolyte beyond the mesh (BoundaryConditions::farField).
class TransportStep {
 public:
  virtual ~TransportStep() = default;

  /// From time t to t + h. Advances the concentration at liquid and dissolving points by the same rates, so that what
  /// leaves the one enters the other: mass is conserved whatever the tolerance. Prescribed points keep their values;
  /// Salt_Coverage is left as the step needs it. Returns false where it does not converge: the caller takes the step
  /// back (Simulation::takeBackStep), which it has begun. Collective.
  bool solve(Simulation& simulation, const PhaseLists& lists, double t, double h);
  /// What is kept from step to step for speed alone. Without it, a run goes on exactly as after a restart.
  virtual void forget() = 0;
  /// The same of what is kept from increment to increment, unless a checkpoint has been written.
  virtual void forgetFactors() {}
  /// Of the last step: order of what `error` estimates is one more.
  virtual int order() const { return 1; }
  /// Estimate of the error of the last step at the k-th point, mol/m3, with the rate at the end of the step before.
  virtual double error(std::size_t k, double lastRate, double h) const = 0;
  /// Rates at the end of the last step, as `error` of the next one asks for.
  virtual const std::vector<double>& endRate() const { return rate_; }
  /// C of electrolyte at most, of saturation.
  virtual double fullest() const { return pauses() ? std::numeric_limits<double>::infinity() : 1.0; }
  virtual std::string work() const = 0;  ///< of all steps, in words

  // Of the last step.
  const std::vector<int>& points() const { return ids_; }            ///< lists.liquid(); the others in its order
  const std::vector<double>& rate() const { return rate_; }          ///< prescribed points included, mol/(m3 s)
  const std::vector<double>& inflow() const { return inflow_; }      ///< from beyond the mesh, a part of the rate
  const std::vector<char>& isUnknown() const { return isUnknown_; }  ///< not prescribed
  const std::string& trouble() const { return trouble_; }

 protected:
  using Fields = TransportFields;

  TransportStep(Saturation saturation, const std::string& concentrationField)
      : saturation_(saturation), label_(concentrationField) {}
  /// From the state before, in the fields, to that after; rate_ and inflow_ of the step. Prescribed concentrations and
  /// far fields are those of t + h.
  virtual bool advance(Simulation& simulation, const Fields& fields, double t, double h) = 0;

  /// Prescribed concentrations and far fields of a time.
  void setBoundary(Simulation& simulation, double time);
  bool pauses() const { return saturation_ == Saturation::Pause; }
  /// By point of ids_: 1 where C has reached saturation, else 0.
  void findPaused(const Fields& fields, std::vector<double>& coverage) const;

  std::vector<int> ids_, solidIds_;  ///< lists.liquid(), lists.dissolving()
  std::vector<char> isUnknown_;
  std::vector<double> before_, solidBefore_, rate_, inflow_;
  std::vector<double> exchange_, farValue_;  ///< k and C_far
  std::string trouble_;

 private:
  void begin(Simulation& simulation, const Fields& fields, double end);

  Saturation saturation_;
  std::string label_;  ///< of the concentration
};

}  // namespace pd

#endif
