// One implicit step of the ions that dissolve into an electrolyte and diffuse in it, at given phases.
#ifndef PD_TRANSPORT_STEP_HPP
#define PD_TRANSPORT_STEP_HPP

#include <string>
#include <vector>

#include "../../model/simulation.hpp"
#include "phase_lists.hpp"
#include "two_level_preconditioner.hpp"

namespace pd {

struct TransportSettings {
  int maximumNewtonIterations = 50;
  int maximumLinearIterations = 5000;
  double tolerance = 1e-9;  ///< residual relative to the saturation concentration, at every point
};

/// Backward Euler for the concentration C of liquid points,
///   C - C_old = h (L C + (1 - S) s(C) + k (C_far - C)),    0 <= S, C <= C_sat, S = 0 where C < C_sat,
/// L: diffusion between liquid points, s: what the bare surface gives, S: the share of it that salt covers, k: exchange
/// with an electrolyte beyond the mesh (BoundaryConditions::farField). Saturation is thus a complementarity condition,
/// solved with the transport by Newton's method on an active set (Hintermueller, Ito & Kunisch, SIAM J. Optim. 13
/// (2002) 865), each linear system by conjugate gradients without a matrix, with a preconditioner of two levels where
/// they are stiff.
class TransportStep {
 public:
  explicit TransportStep(const TransportSettings& settings) : settings_(settings) {}

  /// From time t to t + h. Advances field Concentration at liquid and dissolving points by rates at the end of the
  /// step, so that what leaves the one enters the other: mass is conserved whatever the tolerance. Prescribed points
  /// keep their values; Salt_Coverage is left as the step needs it. Returns false where it does not converge, with the
  /// concentrations as they were. Collective.
  bool solve(Simulation& simulation, const PhaseLists& lists, double t, double h);
  /// Concentrations as before the last step.
  void takeBack(Model& model) const;
  /// What is kept from step to step for speed alone. Without it, a run goes on exactly as after a restart.
  void forget() { preconditioner_.discard(); }

  // Of the last step.
  const std::vector<int>& points() const { return ids_; }            ///< lists.liquid(); the others in its order
  const std::vector<double>& rate() const { return rate_; }          ///< prescribed points included, mol/(m3 s)
  const std::vector<double>& inflow() const { return inflow_; }      ///< from beyond the mesh, a part of the rate
  const std::vector<char>& isUnknown() const { return isUnknown_; }  ///< not prescribed
  const std::string& trouble() const { return trouble_; }

  long long nNewtonIterations = 0, nLinearIterations = 0, nPreconditioners = 0;  ///< of all steps

 private:
  struct Fields {
    int nOwned, nPoints;
    double *concentration, *rate, *salt, *dissolution, *slope, *saturation, *volume, *area;
    explicit Fields(Model& model);
  };
  void begin(Simulation& simulation, const Fields& fields, double end);
  bool iterate(Model& model, const Fields& fields, double h);
  void finish(Model& model, const Fields& fields, double h);
  void coverWithSalt(const Fields& fields, double coverage) const;
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

  TransportSettings settings_;
  std::vector<int> ids_, solidIds_;       ///< lists.liquid(), lists.dissolving()
  std::vector<char> isUnknown_, isFree_;  ///< not free: prescribed, or C is C_sat and S the unknown
  std::vector<double> before_, saltBefore_, solidBefore_, rate_, residual_, step_, slope_;
  std::vector<double> exchange_, farValue_, inflow_;
  TwoLevelPreconditioner preconditioner_;
  double builtFor_ = 0.0;                 ///< step of the preconditioner
  int leastIterations_ = 0, excess_ = 0;  ///< with it: fewest of a solve; all beyond that
  std::string trouble_;
};

}  // namespace pd

#endif
