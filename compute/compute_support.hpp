// What the computes share: reading parameters, access to fields, results that are one value for the whole body.
#ifndef PD_COMPUTE_SUPPORT_HPP
#define PD_COMPUTE_SUPPORT_HPP

#include <Teuchos_ParameterList.hpp>
#include <Teuchos_RCP.hpp>
#include <array>
#include <string>
#include <vector>

#include "Peridigm_Block.hpp"
#include "Peridigm_Compute.hpp"
#include "parameters.hpp"

namespace pd {

using Blocks = Teuchos::RCP<std::vector<PeridigmNS::Block>>;
using ComputeParameters = Teuchos::RCP<const Teuchos::ParameterList>;
using ComputeComm = Teuchos::RCP<const Epetra_Comm>;
using Vector3 = std::array<double, 3>;

/// "Compute Class", which a host leaves in the list, and "Output Label".
void declareCommonParameters(ParameterDeclarations& declarations, const char* defaultLabel);

/// The parameters of a compute with their defaults. Peridigm passes null for a compute that is only named among the
/// output variables. Throws std::invalid_argument that lists every mistake.
template <class ComputeClass>
Teuchos::ParameterList completeParameters(ComputeParameters params, const std::string& name) {
  ParameterDeclarations declarations;
  ComputeClass::declareParameters(declarations);
  return declarations.complete(params.is_null() ? Teuchos::ParameterList() : *params, name);
}

/// Keys "<prefix> X", "<prefix> Y", "<prefix> Z".
void declareVector(ParameterDeclarations& declarations, const std::string& prefix, const std::string& unit,
                   const std::string& meaning);
/// The vector of those keys; what is not given is zero.
Vector3 vectorOf(const Teuchos::ParameterList& parameters, const std::string& prefix);
/// As vectorOf, scaled to length one; the x axis where no key is given. Throws std::invalid_argument for zero length.
Vector3 directionOf(const Teuchos::ParameterList& parameters, const std::string& prefix);

inline double dot(const Vector3& a, const double* b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

// Ids of fields that several computes use.
int volumeField();
int modelCoordinatesField();
int coordinatesField();
int displacementField();
int velocityField();
int forceDensityField();
int externalForceDensityField();
int globalField(const std::string& label, PeridigmNS::PeridigmField::Length length);
int elementScalarField(const std::string& label);  ///< not stepped
int pointVectorField(const std::string& label);    ///< of two steps, as Peridigm has those of its computes

double* view(PeridigmNS::Block& block, int fieldId, PeridigmNS::PeridigmField::Step step);

/// The block's Bond_Damage, or null in a run without it. Not declared by computes, since a run that breaks no bonds
/// need not pay for it.
const double* bondDamageView(PeridigmNS::Block& block);

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
void setGlobal(const Blocks& blocks, int fieldId, const double* values, int count);
void setGlobal(const Blocks& blocks, int fieldId, double value);

}  // namespace pd

#endif
