// One step of the ions that dissolve into an electrolyte and diffuse in it, at given phases.
#ifndef PD_TRANSPORT_STEP_HPP
#define PD_TRANSPORT_STEP_HPP

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

/// Of the concentration C of liquid points,
///   dC/dt = L C + (1 - S) s(C) + k (C_far - C),
/// L: diffusion between liquid points, s: what the bare surface gives, S: the share of it that salt covers, k: exchange
/// with an electrolyte beyond the mesh (BoundaryConditions::farField).
class TransportStep {
 public:
  virtual ~TransportStep() = default;

  /// From time t to t + h. Advances field Concentration at liquid and dissolving points by the same rates, so that what
  /// leaves the one enters the other: mass is conserved whatever the tolerance. Prescribed points keep their values;
  /// Salt_Coverage is left as the step needs it. Returns false where it does not converge, with the concentrations as
  /// they were. Collective.
  bool solve(Simulation& simulation, const PhaseLists& lists, double t, double h);
  /// Concentrations as before the last step.
  void takeBack(Model& model) const;
  /// What is kept from step to step for speed alone. Without it, a run goes on exactly as after a restart.
  virtual void forget() = 0;
  /// x of the leading error x h^2 C'' of the last step.
  virtual double errorFactor() const = 0;
  virtual std::string work() const = 0;  ///< of all steps, in words

  // Of the last step.
  const std::vector<int>& points() const { return ids_; }            ///< lists.liquid(); the others in its order
  const std::vector<double>& rate() const { return rate_; }          ///< prescribed points included, mol/(m3 s)
  const std::vector<double>& inflow() const { return inflow_; }      ///< from beyond the mesh, a part of the rate
  const std::vector<char>& isUnknown() const { return isUnknown_; }  ///< not prescribed
  const std::string& trouble() const { return trouble_; }

 protected:
  struct Fields {
    int nOwned, nPoints;
    double *concentration, *rate, *salt, *dissolution, *slope, *saturation, *volume, *area;
    explicit Fields(Model& model);
  };

  explicit TransportStep(Saturation saturation) : saturation_(saturation) {}
  /// From the state before, in the fields, to that after; rate_ and inflow_ of the step.
  virtual bool advance(Model& model, const Fields& fields, double h) = 0;

  bool pauses() const { return saturation_ == Saturation::Pause; }
  /// Salt_Coverage of all points that are liquid here or elsewhere.
  void coverWithSalt(const Fields& fields, double coverage) const;
  /// By point of ids_: 1 where C has reached saturation, else 0.
  void findPaused(const Fields& fields, std::vector<double>& coverage) const;
  /// Salt_Coverage by point of ids_; ghosts too.
  void setSalt(Model& model, const Fields& fields, const std::vector<double>& coverage) const;

  std::vector<int> ids_, solidIds_;  ///< lists.liquid(), lists.dissolving()
  std::vector<char> isUnknown_;
  std::vector<double> before_, saltBefore_, solidBefore_, rate_, inflow_;
  std::vector<double> exchange_, farValue_;  ///< k and C_far
  std::string trouble_;

 private:
  void begin(Simulation& simulation, const Fields& fields, double end);

  Saturation saturation_;
};

}  // namespace pd

#endif
