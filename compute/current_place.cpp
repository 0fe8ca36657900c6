// Current_Place: where a surface dissolves, m: the point of the largest current density, or the centre of the current.
#include <climits>

#include "plugins.hpp"
#include "surface_current.hpp"

namespace pd {

class CurrentPlace : public SurfaceCurrent {
 public:
  struct Fields : SurfaceCurrent::Fields {
    FieldHandle modelCoordinates = reads(pd::fields::modelCoordinates());
    explicit Fields(const Teuchos::ParameterList& parameters)
        : SurfaceCurrent::Fields(parameters, pd::fields::globalVector, "m", "Where the surface dissolves.") {}
  };
  static void declareParameters(ParameterDeclarations& declarations) {
    SurfaceCurrent::declareParameters(declarations, "Current_Place");
    declarations
        .text("Of",
              "Peak: the point of electrolyte with the largest current density. Centre: mean place of the surface, "
              "weighted by its current.")
        .oneOf({"Peak", "Centre"})
        .defaultTo("Peak");
  }
  CurrentPlace(ComputeParameters params, ComputeComm comm, ComputeParameters globalData)
      : SurfaceCurrent(completeParameters<CurrentPlace>(params, "Current_Place"), params, comm, globalData),
        isPeak_(parameters_.get<std::string>("Of") == "Peak"),
        fields_(parameters_) {}

  const Fields& fields() const override { return fields_; }
  int compute(Blocks blocks) const override {
    const Vector3 place = isPeak_ ? placeOfPeak(blocks) : centre(blocks);
    setGlobal(blocks, fields_.result, place.data(), 3);
    return 0;
  }

 private:
  const double* coordinates(const Blocks& blocks, std::size_t block, int id) const {
    return view((*blocks)[block], fields_.modelCoordinates) + 3 * id;
  }
  Vector3 placeOfPeak(const Blocks& blocks) const;
  Vector3 centre(const Blocks& blocks) const;

  bool isPeak_;
  Fields fields_;
};

/// Of points that differ by rounding, as different numbers of ranks leave it, the one with the lowest global id.
Vector3 CurrentPlace::placeOfPeak(const Blocks& blocks) const {
  const double largest = peak(blocks), enough = (1.0 - 1e-6) * largest;
  int lowest = INT_MAX;
  std::vector<double> place(3, 0.0);
  if (largest > 0.0)
    forEach(blocks, [&](std::size_t b, int id, double current, double) {
      const int globalId = (*blocks)[b].getOverlapScalarPointMap()->GID(id);
      if (current < enough || globalId >= lowest) return;
      lowest = globalId;
      const double* x = coordinates(blocks, b, id);
      place.assign(x, x + 3);
    });
  int winner = INT_MAX;
  epetraComm->MinAll(&lowest, &winner, 1);
  if (lowest != winner) place.assign(3, 0.0);
  place = sumOverRanks(*epetraComm, place);
  return {place[0], place[1], place[2]};
}

Vector3 CurrentPlace::centre(const Blocks& blocks) const {
  std::vector<double> sums(4, 0.0);  // moments of the current, the current
  forEach(blocks, [&](std::size_t b, int id, double current, double area) {
    const double* x = coordinates(blocks, b, id);
    for (std::size_t k = 0; k < 3; ++k) sums[k] += current * area * x[k];
    sums[3] += current * area;
  });
  sums = sumOverRanks(*epetraComm, sums);
  if (sums[3] == 0.0) return {};
  return {sums[0] / sums[3], sums[1] / sums[3], sums[2] / sums[3]};
}

}  // namespace pd

using pd::CurrentPlace;
PD_REGISTER_COMPUTE(CurrentPlace, "Current_Place", "Where a dissolving surface has its current, m.")
