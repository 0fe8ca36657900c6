// The current of a dissolving surface over chosen points: what the computes of current have in common.
#ifndef PD_SURFACE_CURRENT_HPP
#define PD_SURFACE_CURRENT_HPP

#include "dissolved_metal.hpp"
#include "point_selection.hpp"

namespace pd {

/// The surface is spread over the electrolyte next to it: a point has Interface_Area_Density times its volume of it, at
/// the Current_Density of the point.
class SurfaceCurrent : public TabledCompute {
 public:
  struct Fields : FieldTable {
    FieldHandle current = readsIfThere(pd::fields::currentDensity());
    FieldHandle area = readsIfThere(pd::fields::interfaceAreaDensity());
    FieldHandle volume = reads(pd::fields::volume());
    FieldHandle result;
    /// `make`: what the result is, fields::globalScalar or another.
    Fields(const Teuchos::ParameterList& parameters,
           FieldDescription (*make)(const std::string&, const std::string&, const std::string&),
           const std::string& unit, const std::string& meaning)
        : result(writes(outputField(parameters, make, unit, meaning))) {}
  };
  static void declareParameters(ParameterDeclarations& declarations, const char* defaultLabel);

  const Fields& fields() const override = 0;
  /// Throws std::invalid_argument where no material of the run dissolves.
  void initialize(Blocks blocks) override;

 protected:
  SurfaceCurrent(const Teuchos::ParameterList& completed, ComputeParameters params, ComputeComm comm,
                 ComputeParameters globalData)
      : TabledCompute(completed, params, comm, globalData), points_(completed, globalData) {}

  /// Calls visit(block number, local id, A/m2, m2) for every chosen point of this rank that has surface.
  template <class Visit>
  void forEach(const Blocks& blocks, Visit&& visit) const {
    std::vector<const double*> currents, areas, volumes;
    for (PeridigmNS::Block& block : *blocks) {
      currents.push_back(view(block, fields().current));
      areas.push_back(view(block, fields().area));
      volumes.push_back(view(block, fields().volume));
    }
    points_.forEach(blocks, [&](std::size_t b, int id) {
      if (areas[b][id] > 0.0) visit(b, id, currents[b][id], areas[b][id] * volumes[b][id]);
    });
  }

  /// Largest current density, A/m2; 0 without surface. Collective.
  double peak(const Blocks& blocks) const;
  /// Current, A, and surface, m2. Collective.
  std::array<double, 2> currentAndArea(const Blocks& blocks) const;

 private:
  PointSelection points_;
};

}  // namespace pd

#endif
