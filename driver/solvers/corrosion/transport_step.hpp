// One implicit step of the ions that dissolve into an electrolyte and diffuse in it, at given phases.
#ifndef PD_TRANSPORT_STEP_HPP
#define PD_TRANSPORT_STEP_HPP

#include <string>
#include <vector>

#include "../../model/simulation.hpp"

namespace pd {

struct TransportSettings {
  int maximumNewtonIterations = 50;
  int maximumLinearIterations = 5000;
  double tolerance = 1e-9;  ///< residual relative to the saturation concentration, at every point
};

/// Backward Euler for the concentration C of liquid points,
///   C - C_old = h (L C + (1 - S) s(C)),    0 <= S, C <= C_sat, S = 0 where C < C_sat,
/// L: diffusion between liquid points, s: what the bare surface gives, S: the share of it that salt covers. Saturation
/// is thus a complementarity condition, solved with the transport by Newton's method on an active set (Hintermueller,
/// Ito & Kunisch, SIAM J. Optim. 13 (2002) 865), each linear system by conjugate gradients without a matrix.
class TransportStep {
 public:
  explicit TransportStep(const TransportSettings& settings) : settings_(settings) {}

  /// Advances field Concentration at liquid and solid points by rates at the end of the step, so that what leaves the
  /// one enters the other: mass is conserved whatever the tolerance. Prescribed points keep their values; Salt_Coverage
  /// is left as the step needs it. Returns false where it does not converge, with the concentrations as they were.
  /// Collective.
  bool solve(Simulation& simulation, double h);

  /// Rate of the last step at owned points, prescribed ones included, mol/(m3 s).
  const std::vector<double>& rate() const { return rate_; }
  /// Concentrations before it, and which owned points were liquid and free.
  const std::vector<double>& before() const { return before_; }
  const std::vector<char>& isUnknown() const { return isUnknown_; }
  const std::string& trouble() const { return trouble_; }

  long long nNewtonIterations = 0, nLinearIterations = 0;  ///< of all steps

 private:
  struct Fields {
    double *concentration, *rate, *salt, *dissolution, *slope, *saturation, *volume, *damage, *area;
    explicit Fields(Model& model);
  };
  void findUnknowns(Simulation& simulation, const Fields& fields);
  double residual(Simulation& simulation, const Fields& fields, double h);
  bool updateSaturated(Simulation& simulation, const Fields& fields);
  bool solveLinear(Simulation& simulation, const Fields& fields, double h, double target);
  void applyMatrix(Simulation& simulation, const Fields& fields, double h, const std::vector<double>& direction,
                   std::vector<double>& image);
  double dot(Simulation& simulation, const Fields& fields, const std::vector<double>& a,
             const std::vector<double>& b) const;

  TransportSettings settings_;
  std::vector<char> isUnknown_, isSaturated_;  ///< [nOwned]; saturated: C is C_sat, S the unknown
  std::vector<double> before_, rate_, residual_, step_, slope_;
  std::string trouble_;
};

}  // namespace pd

#endif
