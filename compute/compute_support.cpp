#include "compute_support.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "Peridigm_Field.hpp"

namespace pd {

namespace PeridigmField = PeridigmNS::PeridigmField;
using PeridigmNS::FieldManager;

void declareCommonParameters(ParameterDeclarations& declarations, const char* defaultLabel) {
  declarations.text("Compute Class", "Name of the compute.");
  declarations.text("Output Label", "Name of the field that holds the result.").defaultTo(defaultLabel);
}

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

Vector3 directionOf(const Teuchos::ParameterList& parameters, const std::string& prefix) {
  bool isGiven = false;
  for (const char* axis : {" X", " Y", " Z"}) isGiven = isGiven || parameters.isParameter(prefix + axis);
  if (!isGiven) return {1.0, 0.0, 0.0};
  Vector3 result = vectorOf(parameters, prefix);
  const double length = std::sqrt(dot(result, result.data()));
  if (length == 0.0) throw std::invalid_argument("\"" + prefix + " X, Y, Z\" must not all be zero");
  for (double& component : result) component /= length;
  return result;
}

int volumeField() { return elementScalarField("Volume"); }
int modelCoordinatesField() {
  return FieldManager::self().getFieldId(PeridigmField::NODE, PeridigmField::VECTOR, PeridigmField::CONSTANT,
                                         "Model_Coordinates");
}

int pointVectorField(const std::string& label) {
  return FieldManager::self().getFieldId(PeridigmField::NODE, PeridigmField::VECTOR, PeridigmField::TWO_STEP, label);
}

int coordinatesField() { return pointVectorField("Coordinates"); }
int displacementField() { return pointVectorField("Displacement"); }
int velocityField() { return pointVectorField("Velocity"); }
int forceDensityField() { return pointVectorField("Force_Density"); }
int externalForceDensityField() { return pointVectorField("External_Force_Density"); }

int globalField(const std::string& label, PeridigmField::Length length) {
  return FieldManager::self().getFieldId(PeridigmField::GLOBAL, length, PeridigmField::CONSTANT, label);
}

int elementScalarField(const std::string& label) {
  return FieldManager::self().getFieldId(PeridigmField::ELEMENT, PeridigmField::SCALAR, PeridigmField::CONSTANT, label);
}

double* view(PeridigmNS::Block& block, int fieldId, PeridigmField::Step step) {
  double* values = nullptr;
  block.getData(fieldId, step)->ExtractView(&values);
  return values;
}

const double* bondDamageView(PeridigmNS::Block& block) {
  FieldManager& fields = FieldManager::self();
  if (!fields.hasField("Bond_Damage")) return nullptr;
  const int id = fields.getFieldId("Bond_Damage");
  return block.hasData(id, PeridigmField::STEP_NP1) ? view(block, id, PeridigmField::STEP_NP1) : nullptr;
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

void setGlobal(const Blocks& blocks, int fieldId, const double* values, int count) {
  double* result = view(blocks->front(), fieldId, PeridigmField::STEP_NONE);
  for (int k = 0; k < count; ++k) result[k] = values[k];
}

void setGlobal(const Blocks& blocks, int fieldId, double value) { setGlobal(blocks, fieldId, &value, 1); }

}  // namespace pd
