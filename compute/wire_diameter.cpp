// Wire_Diameter: mean or smallest diameter of what is left of a wire, m.
//
// The wire is cut into slices across its axis. That of a slice is the diameter of the circle of the same area: the
// first one times the root of the share of its metal that is left. So sections in a plane, halves beside a plane of
// symmetry and staircases of points all have the first diameter at the start.
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "dissolved_metal_sum.hpp"
#include "plugins.hpp"

namespace pd {

class WireDiameter : public DissolvedMetalSum {
 public:
  struct Fields : DissolvedMetalSum::Fields {
    FieldHandle modelCoordinates = reads(pd::fields::modelCoordinates());
    explicit Fields(const Teuchos::ParameterList& parameters)
        : DissolvedMetalSum::Fields(parameters, "m", "Diameter of what is left of the wire.") {}
  };
  static void declareParameters(ParameterDeclarations& declarations) {
    DissolvedMetalSum::declareParameters(declarations, "Wire_Diameter");
    declarations.real("First Diameter", "m", "Of the wire at the start, even along it.").positive().required();
    declareVector(declarations, "Along", "1", "Direction of the wire (default: x; any length).");
    declarations
        .real(
            "Slice Width", "m",
            "Of the slices along the wire, one to three spacings. A section across the wire, in a plane, is one slice "
            "and needs none.")
        .positive();
    declarations.text("Of", "Mean along the wire, or smallest.").oneOf({"Mean", "Smallest"}).defaultTo("Mean");
  }
  WireDiameter(ComputeParameters params, ComputeComm comm, ComputeParameters globalData)
      : DissolvedMetalSum(completeParameters<WireDiameter>(params, "Wire_Diameter"), params, comm, globalData),
        along_(directionOf(parameters_, "Along")),
        first_(parameters_.get<double>("First Diameter")),
        width_(parameters_.isParameter("Slice Width") ? parameters_.get<double>("Slice Width") : 0.0),
        fields_(parameters_) {}

  const Fields& fields() const override { return fields_; }
  int compute(Blocks blocks) const override;

 private:
  /// Calls visit(coordinate along the wire, metal, local id).
  template <class Visit>
  void forEachPlace(const Blocks& blocks, Visit&& visit) const {
    std::vector<const double*> places;
    for (PeridigmNS::Block& block : *blocks) places.push_back(view(block, fields_.modelCoordinates));
    forEachMetal(blocks, [&](std::size_t b, int id, const DissolvedMetal::View& metal) {
      visit(dot(along_, places[b] + 3 * id), metal, id);
    });
  }
  /// What is left of the metal of each slice, then what there was, m3. Collective.
  std::vector<double> volumesOfSlices(const Blocks& blocks) const;

  Vector3 along_;
  double first_, width_;
  Fields fields_;
};

std::vector<double> WireDiameter::volumesOfSlices(const Blocks& blocks) const {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  double low = infinity, high = -infinity;
  forEachPlace(blocks, [&](double place, const DissolvedMetal::View&, int) {
    low = std::min(low, place);
    high = std::max(high, place);
  });
  low = minOverRanks(*epetraComm, low);
  high = maxOverRanks(*epetraComm, high);
  requireMetal(low <= high);
  constexpr double rounding = 1e-3;  // of a slice: layers of a lattice stand just within theirs
  if (width_ == 0.0 && high - low > rounding * first_)
    throw std::runtime_error(
        "Wire_Diameter: the points differ along the wire; give Slice Width, one to three spacings, or the axis of the "
        "section by Along");
  const auto sliceOf = [&](double place) {
    return width_ > 0.0 ? static_cast<std::size_t>((place - low) / width_ + rounding) : 0;
  };
  const std::size_t n = sliceOf(high) + 1;
  std::vector<double> volumes(2 * n, 0.0);
  forEachPlace(blocks, [&](double place, const DissolvedMetal::View& metal, int id) {
    const std::size_t slice = sliceOf(place);
    volumes[slice] += (1.0 - metal.share(id)) * metal.volume(id);
    volumes[n + slice] += metal.volume(id);
  });
  return sumOverRanks(*epetraComm, volumes);
}

int WireDiameter::compute(Blocks blocks) const {
  const std::vector<double> volumes = volumesOfSlices(blocks);
  const std::size_t n = volumes.size() / 2;
  double smallest = first_, sum = 0.0, whole = 0.0;
  for (std::size_t slice = 0; slice < n; ++slice) {
    if (volumes[n + slice] == 0.0) continue;
    const double diameter = first_ * std::sqrt(volumes[slice] / volumes[n + slice]);
    smallest = std::min(smallest, diameter);
    // By volume at the start: the last slice may be a thin one.
    sum += volumes[n + slice] * diameter;
    whole += volumes[n + slice];
  }
  setGlobal(blocks, fields_.result, parameters_.get<std::string>("Of") == "Mean" ? sum / whole : smallest);
  return 0;
}

}  // namespace pd

using pd::WireDiameter;
PD_REGISTER_COMPUTE(WireDiameter, "Wire_Diameter", "Mean or smallest diameter of a wire that dissolves, m.")
