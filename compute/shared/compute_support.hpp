// What the computes share: reading parameters, access to fields, results that are one value for the whole body.
#ifndef PD_COMPUTE_SUPPORT_HPP
#define PD_COMPUTE_SUPPORT_HPP

#include <Teuchos_ParameterList.hpp>
#include <Teuchos_RCP.hpp>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "Peridigm_Block.hpp"
#include "Peridigm_Compute.hpp"
#include "fields.hpp"
#include "parameters.hpp"

namespace pd {

using Blocks = Teuchos::RCP<std::vector<PeridigmNS::Block>>;
using ComputeParameters = Teuchos::RCP<const Teuchos::ParameterList>;
using ComputeComm = Teuchos::RCP<const Epetra_Comm>;
using Vector3 = std::array<double, 3>;

/// A compute whose fields stand in a table. That of a derived class, `Fields`, is made from completed parameters, or
/// from the defaults alone where the class is described.
class TabledCompute : public PeridigmNS::Compute, public FieldUser {
 public:
  std::vector<int> FieldIds() const override { return fields().ids(); }

 protected:
  /// `completed`: completeParameters().
  TabledCompute(Teuchos::ParameterList completed, ComputeParameters params, ComputeComm comm,
                ComputeParameters globalData)
      : Compute(params, comm, globalData), parameters_(std::move(completed)) {}

  const Teuchos::ParameterList parameters_;
};

/// "Compute Class", which a host leaves in the list, and "Output Label".
void declareCommonParameters(ParameterDeclarations& declarations, const char* defaultLabel);

/// The parameters of a compute with their defaults. Peridigm passes null for a compute that is only named among the
/// output variables. Throws std::invalid_argument that lists every mistake.
template <class ComputeClass>
Teuchos::ParameterList completeParameters(ComputeParameters params, const std::string& name) {
  return completed<ComputeClass>(params.is_null() ? Teuchos::ParameterList() : *params, name);
}

/// The field that "Output Label" names. `make`: what it is, fields::globalScalar or another.
FieldDescription outputField(const Teuchos::ParameterList& parameters,
                             FieldDescription (*make)(const std::string&, const std::string&, const std::string&),
                             const std::string& unit, const std::string& meaning);

/// With steps: what a compute keeps from one evaluation to the next, restarts included, and no result.
FieldDescription kept(FieldDescription field);
/// The field Time, s, which the host fills.
FieldDescription timeOfRun();

/// Keys "<prefix> X", "<prefix> Y", "<prefix> Z".
void declareVector(ParameterDeclarations& declarations, const std::string& prefix, const std::string& unit,
                   const std::string& meaning);
/// The vector of those keys; what is not given is zero.
Vector3 vectorOf(const Teuchos::ParameterList& parameters, const std::string& prefix);
/// Whether any of them is given.
bool isVectorGiven(const Teuchos::ParameterList& parameters, const std::string& prefix);
/// As vectorOf, scaled to length one; the x axis where no key is given. Throws std::invalid_argument for zero length.
Vector3 directionOf(const Teuchos::ParameterList& parameters, const std::string& prefix);

inline double dot(const Vector3& a, const double* b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Vector3 cross(const Vector3& a, const Vector3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// Values of a field as the block sees it, at the end of the step.
inline double* view(PeridigmNS::Block& block, const FieldHandle& field) { return field.of(*block.getDataManager()); }

/// Sums over all ranks.
std::vector<double> sumOverRanks(const Epetra_Comm& comm, std::vector<double> values);
double sumOverRanks(const Epetra_Comm& comm, double value);
double maxOverRanks(const Epetra_Comm& comm, double value);
double minOverRanks(const Epetra_Comm& comm, double value);
/// Element by element.
std::vector<double> maxOverRanks(const Epetra_Comm& comm, std::vector<double> values);
std::vector<double> minOverRanks(const Epetra_Comm& comm, std::vector<double> values);
/// The values of all ranks, one after the other, on each of them.
std::vector<double> gatherFromRanks(const Epetra_Comm& comm, const std::vector<double>& values);

/// Stores a result for the whole body. Global fields belong to all blocks, so the first one is enough.
void setGlobal(const Blocks& blocks, const FieldHandle& field, const double* values, int count);
void setGlobal(const Blocks& blocks, const FieldHandle& field, double value);

}  // namespace pd

#endif
