// Nearest_Point_Data: a field at the point that lies nearest to a given place in the reference configuration.
#include <climits>
#include <iostream>
#include <limits>

#include "field_variable.hpp"
#include "plugins.hpp"

namespace pd {

namespace PeridigmField = PeridigmNS::PeridigmField;

class NearestPointData : public PeridigmNS::Compute {
 public:
  static void declareParameters(ParameterDeclarations& declarations) {
    declarations.text("Compute Class", "Name of the compute.");
    for (const char* axis : {"X", "Y", "Z"})
      declarations.real(axis, "m", "Coordinate of the place in the reference configuration.").required();
    declarations.text("Variable", "Point field, a scalar or a vector.").required();
    declarations.text("Output Label", "Name of the global field that holds the result.").required();
    declarations.flag("Verbose", "Print which point was found.").defaultTo(false);
  }
  NearestPointData(ComputeParameters params, ComputeComm comm, ComputeParameters globalData)
      : NearestPointData(completeParameters<NearestPointData>(params, "Nearest_Point_Data"), params, comm, globalData) {
  }

  std::vector<int> FieldIds() const override {
    std::vector<int> ids = variable_.fieldIds();
    ids.insert(ids.end(), {coordinatesField_, outputField_});
    return ids;
  }
  void initialize(Blocks blocks) override;
  int compute(Blocks blocks) const override;

 private:
  NearestPointData(const Teuchos::ParameterList& parameters, ComputeParameters params, ComputeComm comm,
                   ComputeParameters globalData)
      : Compute(params, comm, globalData),
        place_{parameters.get<double>("X"), parameters.get<double>("Y"), parameters.get<double>("Z")},
        variable_(parameters.get<std::string>("Variable")),
        isVerbose_(parameters.get<bool>("Verbose")),
        coordinatesField_(modelCoordinatesField()),
        outputField_(globalField(parameters.get<std::string>("Output Label"), variable_.length())) {}

  Vector3 place_;
  FieldVariable variable_;
  bool isVerbose_;
  int coordinatesField_, outputField_;
  int block_ = -1, localId_ = -1;  ///< of the point, on the rank that owns it
};

void NearestPointData::initialize(Blocks blocks) {
  variable_.initialize(blocks);
  // Of several points at the same distance the one with the lowest global id is taken, on any number of ranks.
  double nearest = std::numeric_limits<double>::max();
  int globalId = INT_MAX;
  block_ = localId_ = -1;
  for (std::size_t b = 0; b < blocks->size(); ++b) {
    PeridigmNS::Block& block = (*blocks)[b];
    const auto neighborhood = block.getNeighborhoodData();
    const auto map = block.getOverlapScalarPointMap();
    const double* x = view(block, coordinatesField_, PeridigmField::STEP_NONE);
    for (int i = 0; i < neighborhood->NumOwnedPoints(); ++i) {
      const int id = neighborhood->OwnedIDs()[i];
      double distance = 0.0;  // squared
      for (int k = 0; k < 3; ++k) {
        const double d = x[3 * id + k] - place_[static_cast<std::size_t>(k)];
        distance += d * d;
      }
      if (distance < nearest || (distance == nearest && map->GID(id) < globalId)) {
        nearest = distance;
        globalId = map->GID(id);
        block_ = static_cast<int>(b);
        localId_ = id;
      }
    }
  }
  if (minOverRanks(*epetraComm, nearest) < nearest) globalId = INT_MAX;
  int winner = INT_MAX;
  epetraComm->MinAll(&globalId, &winner, 1);
  if (globalId != winner) block_ = localId_ = -1;
  if (isVerbose_ && localId_ >= 0) {
    const double* x = view((*blocks)[static_cast<std::size_t>(block_)], coordinatesField_, PeridigmField::STEP_NONE);
    std::cout << "Nearest_Point_Data: point " << globalId + 1 << " at (" << x[3 * localId_] << ", "
              << x[3 * localId_ + 1] << ", " << x[3 * localId_ + 2] << ")" << std::endl;
  }
}

int NearestPointData::compute(Blocks blocks) const {
  std::vector<double> value(static_cast<std::size_t>(variable_.width()), 0.0);
  if (localId_ >= 0) {
    const double* values = variable_.values((*blocks)[static_cast<std::size_t>(block_)]);
    for (std::size_t k = 0; k < value.size(); ++k)
      value[k] = values[value.size() * static_cast<std::size_t>(localId_) + k];
  }
  value = sumOverRanks(*epetraComm, value);
  setGlobal(blocks, outputField_, value.data(), variable_.width());
  return 0;
}

}  // namespace pd

using pd::NearestPointData;
PD_REGISTER_COMPUTE(NearestPointData, "Nearest_Point_Data", "A field at the point nearest to a given place.")
