// The current of a dissolving surface over chosen points: what the computes of current have in common.
#ifndef PD_SURFACE_CURRENT_HPP
#define PD_SURFACE_CURRENT_HPP

#include "dissolved_metal.hpp"
#include "point_selection.hpp"

namespace pd {

/// The surface is spread over the electrolyte next to it: a point has Interface_Area_Density times its volume of it, at
/// the Current_Density of the point.
class SurfaceCurrent : public PeridigmNS::Compute {
 public:
  static void declareParameters(ParameterDeclarations& declarations, const char* defaultLabel);

  std::vector<int> FieldIds() const override;
  /// Throws std::invalid_argument where no material of the run dissolves.
  void initialize(Blocks blocks) override;

 protected:
  /// `parameters`: completed.
  SurfaceCurrent(const Teuchos::ParameterList& parameters, ComputeParameters params, ComputeComm comm,
                 ComputeParameters globalData, PeridigmNS::PeridigmField::Length length);

  /// Calls visit(block number, local id, A/m2, m2) for every chosen point of this rank that has surface.
  template <class Visit>
  void forEach(const Blocks& blocks, Visit&& visit) const {
    std::vector<const double*> currents, areas, volumes;
    for (PeridigmNS::Block& block : *blocks) {
      currents.push_back(view(block, currentField_, PeridigmNS::PeridigmField::STEP_NONE));
      areas.push_back(view(block, areaField_, PeridigmNS::PeridigmField::STEP_NONE));
      volumes.push_back(view(block, volumeField_, PeridigmNS::PeridigmField::STEP_NONE));
    }
    points_.forEach(blocks, [&](std::size_t b, int id) {
      if (areas[b][id] > 0.0) visit(b, id, currents[b][id], areas[b][id] * volumes[b][id]);
    });
  }

  /// Largest current density, A/m2; 0 without surface. Collective.
  double peak(const Blocks& blocks) const;
  /// Current, A, and surface, m2. Collective.
  std::array<double, 2> currentAndArea(const Blocks& blocks) const;

  int outputField_;

 private:
  PointSelection points_;
  int currentField_, areaField_, volumeField_;
};

}  // namespace pd

#endif
