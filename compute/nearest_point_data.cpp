// Nearest_Point_Data: a field at the point that lies nearest to a given place in the reference configuration.
#include <climits>
#include <iostream>
#include <limits>

#include "field_variable.hpp"
#include "plugins.hpp"

namespace pd {

class NearestPointData : public TabledCompute {
 public:
  struct Fields : FieldTable {
    FieldVariable variable;
    FieldHandle modelCoordinates = reads(pd::fields::modelCoordinates());
    FieldHandle result;
    explicit Fields(const Teuchos::ParameterList& parameters) : variable(FieldVariable::of(parameters)) {
      include(variable.fields());
      result =
          writes(outputField(parameters, variable.width() == 3 ? pd::fields::globalVector : pd::fields::globalScalar,
                             variable.unit(), "The variable at the point."));
    }
  };
  static void declareParameters(ParameterDeclarations& declarations) {
    declarations.text("Compute Class", "Name of the compute.");
    for (const char* axis : {"X", "Y", "Z"})
      declarations.real(axis, "m", "Coordinate of the place in the reference configuration.").required();
    declarations.text("Variable", "Point field, a scalar or a vector.").required();
    declarations.text("Output Label", "Name of the global field that holds the result.").required();
    declarations.flag("Verbose", "Print which point was found.").defaultTo(false);
  }
  NearestPointData(ComputeParameters params, ComputeComm comm, ComputeParameters globalData)
      : TabledCompute(completeParameters<NearestPointData>(params, "Nearest_Point_Data"), params, comm, globalData),
        place_{parameters_.get<double>("X"), parameters_.get<double>("Y"), parameters_.get<double>("Z")},
        isVerbose_(parameters_.get<bool>("Verbose")),
        fields_(parameters_) {}

  const Fields& fields() const override { return fields_; }
  void initialize(Blocks blocks) override;
  int compute(Blocks blocks) const override;

 private:
  Vector3 place_;
  bool isVerbose_;
  Fields fields_;
  int block_ = -1, localId_ = -1;  ///< of the point, on the rank that owns it
};

void NearestPointData::initialize(Blocks blocks) {
  fields_.variable.initialize(blocks);
  // Of several points at the same distance the one with the lowest global id is taken, on any number of ranks.
  double nearest = std::numeric_limits<double>::max();
  int globalId = INT_MAX;
  block_ = localId_ = -1;
  for (std::size_t b = 0; b < blocks->size(); ++b) {
    PeridigmNS::Block& block = (*blocks)[b];
    const auto neighborhood = block.getNeighborhoodData();
    const auto map = block.getOverlapScalarPointMap();
    const double* x = view(block, fields_.modelCoordinates);
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
    const double* x = view((*blocks)[static_cast<std::size_t>(block_)], fields_.modelCoordinates);
    std::cout << "Nearest_Point_Data: point " << globalId + 1 << " at (" << x[3 * localId_] << ", "
              << x[3 * localId_ + 1] << ", " << x[3 * localId_ + 2] << ")" << std::endl;
  }
}

int NearestPointData::compute(Blocks blocks) const {
  std::vector<double> value(static_cast<std::size_t>(fields_.variable.width()), 0.0);
  if (localId_ >= 0) {
    const double* values = fields_.variable.values((*blocks)[static_cast<std::size_t>(block_)]);
    for (std::size_t k = 0; k < value.size(); ++k)
      value[k] = values[value.size() * static_cast<std::size_t>(localId_) + k];
  }
  value = sumOverRanks(*epetraComm, value);
  setGlobal(blocks, fields_.result, value.data(), fields_.variable.width());
  return 0;
}

}  // namespace pd

using pd::NearestPointData;
PD_REGISTER_COMPUTE(NearestPointData, "Nearest_Point_Data", "A field at the point nearest to a given place.")
