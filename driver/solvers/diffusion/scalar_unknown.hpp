// What solvers that take a scalar field for the unknown of a linear system share.
#ifndef PD_SCALAR_UNKNOWN_HPP
#define PD_SCALAR_UNKNOWN_HPP

#include <memory>
#include <string>
#include <vector>

#include "../../linear/linear_system.hpp"
#include "../../model/model.hpp"
#include "Peridigm_DegreesOfFreedomManager.hpp"

namespace pd {

/// The scalar field is the unknown as long as this exists; then what was before is again.
class ScalarUnknown {
 public:
  explicit ScalarUnknown(const std::string& field) : before_(Manager::self().unknowns()) {
    Manager::self().setUnknowns({{field, 1}});
  }
  ~ScalarUnknown() { Manager::self().setUnknowns(before_); }
  ScalarUnknown(const ScalarUnknown&) = delete;
  ScalarUnknown& operator=(const ScalarUnknown&) = delete;

 private:
  using Manager = PeridigmNS::DegreesOfFreedomManager;
  std::vector<Manager::Unknown> before_;
};

/// `system` (made where there is none) = factor dF/dc, F the flux divergence of the field c times the volumes, plus the
/// volumes on the diagonal where `addsVolumes`; rows of held points [nOwned] are left out. Returns the norm of the
/// diagonal of the others. Collective.
double assembleFluxMatrix(Model& model, const std::string& field, double dt, double factor, bool addsVolumes,
                          const std::vector<char>& isHeld, std::unique_ptr<LinearSystem>& system);

/// Euclidean norm over all ranks of values of owned points. Collective.
double normOverRanks(const Communicator& comm, const std::vector<double>& values);

/// Throws RunError where no material of the run gives a flux divergence of the field. `solver`: its name.
void requireFluxDivergence(Model& model, const std::string& field, const std::string& solver);

/// Whether some material's rate of the field is no symmetric function of it, as where a flow carries it: CG and
/// explicit methods, whose stability limits are of symmetric rates, do not do.
bool rateIsAsymmetric(Model& model, const std::string& field);

/// Throws RunError where a flow carries the field along and none has been found yet. Collective.
void requireFlow(Model& model, const std::string& field, const std::string& solver);

}  // namespace pd

#endif
