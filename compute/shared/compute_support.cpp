#include "compute_support.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace pd {

void declareCommonParameters(ParameterDeclarations& declarations, const char* defaultLabel) {
  declarations.text("Compute Class", "Name of the compute.");
  declarations.text("Output Label", "Name of the field that holds the result.").defaultTo(defaultLabel);
}

FieldDescription outputField(const Teuchos::ParameterList& parameters,
                             FieldDescription (*make)(const std::string&, const std::string&, const std::string&),
                             const std::string& unit, const std::string& meaning) {
  constexpr const char* key = "Output Label";
  return parameters.isParameter(key) ? make(parameters.get<std::string>(key), unit, meaning)
                                     : fields::namedBy(key, unit, meaning);
}

FieldDescription kept(FieldDescription field) {
  field.temporal = PeridigmNS::PeridigmField::TWO_STEP;
  return field;
}

FieldDescription timeOfRun() { return kept(fields::globalScalar("Time", "s", "Time of the run.")); }

void declareVector(ParameterDeclarations& declarations, const std::string& prefix, const std::string& unit,
                   const std::string& meaning) {
  for (const char* axis : {" X", " Y", " Z"}) declarations.real(prefix + axis, unit, meaning);
}

Vector3 vectorOf(const Teuchos::ParameterList& parameters, const std::string& prefix) {
  Vector3 result{};
  const char* axes[] = {" X", " Y", " Z"};
  for (std::size_t k = 0; k < 3; ++k)
    if (parameters.isParameter(prefix + axes[k])) result[k] = parameters.get<double>(prefix + axes[k]);
  return result;
}

bool isVectorGiven(const Teuchos::ParameterList& parameters, const std::string& prefix) {
  return parameters.isParameter(prefix + " X") || parameters.isParameter(prefix + " Y") ||
         parameters.isParameter(prefix + " Z");
}

Vector3 directionOf(const Teuchos::ParameterList& parameters, const std::string& prefix) {
  if (!isVectorGiven(parameters, prefix)) return {1.0, 0.0, 0.0};
  Vector3 result = vectorOf(parameters, prefix);
  const double length = std::sqrt(dot(result, result.data()));
  if (length == 0.0) throw std::invalid_argument("\"" + prefix + " X, Y, Z\" must not all be zero");
  for (double& component : result) component /= length;
  return result;
}

std::vector<double> sumOverRanks(const Epetra_Comm& comm, std::vector<double> values) {
  std::vector<double> result(values.size());
  comm.SumAll(values.data(), result.data(), static_cast<int>(values.size()));
  return result;
}

double sumOverRanks(const Epetra_Comm& comm, double value) {
  double result = 0.0;
  comm.SumAll(&value, &result, 1);
  return result;
}

double maxOverRanks(const Epetra_Comm& comm, double value) {
  double result = 0.0;
  comm.MaxAll(&value, &result, 1);
  return result;
}

double minOverRanks(const Epetra_Comm& comm, double value) {
  double result = 0.0;
  comm.MinAll(&value, &result, 1);
  return result;
}

std::vector<double> maxOverRanks(const Epetra_Comm& comm, std::vector<double> values) {
  std::vector<double> result(values.size());
  comm.MaxAll(values.data(), result.data(), static_cast<int>(values.size()));
  return result;
}

std::vector<double> minOverRanks(const Epetra_Comm& comm, std::vector<double> values) {
  std::vector<double> result(values.size());
  comm.MinAll(values.data(), result.data(), static_cast<int>(values.size()));
  return result;
}

std::vector<double> gatherFromRanks(const Epetra_Comm& comm, const std::vector<double>& values) {
  std::vector<double> counts(static_cast<std::size_t>(comm.NumProc()), 0.0);
  const auto self = static_cast<std::size_t>(comm.MyPID());
  counts[self] = static_cast<double>(values.size());
  counts = sumOverRanks(comm, counts);
  double before = 0.0, total = 0.0;
  for (std::size_t rank = 0; rank < counts.size(); ++rank) {
    if (rank < self) before += counts[rank];
    total += counts[rank];
  }
  std::vector<double> all(static_cast<std::size_t>(total), 0.0);
  std::copy(values.begin(), values.end(), all.begin() + static_cast<std::ptrdiff_t>(before));
  return sumOverRanks(comm, all);
}

void setGlobal(const Blocks& blocks, const FieldHandle& field, const double* values, int count) {
  std::copy(values, values + count, view(blocks->front(), field));
}

void setGlobal(const Blocks& blocks, const FieldHandle& field, double value) { setGlobal(blocks, field, &value, 1); }

}  // namespace pd
