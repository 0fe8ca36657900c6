// Dissolved metal per area of the first surface: what Corrosion_Rate and Hydrogen_Gas have in common.
#ifndef PD_LOSS_PER_SURFACE_HPP
#define PD_LOSS_PER_SURFACE_HPP

#include "dissolved_metal_sum.hpp"

namespace pd {

/// The surface is that of the chosen points of metal at the first evaluation, kept in a field so that it survives a
/// restart, or what the deck gives.
class LossPerSurface : public DissolvedMetalSum {
 public:
  struct Fields : DissolvedMetalSum::Fields {
    FieldHandle areaDensity, surface;  ///< unused where the deck gives the area
    Fields(const Teuchos::ParameterList& parameters, const std::string& unit, const std::string& meaning);
  };
  static void declareParameters(ParameterDeclarations& declarations, const char* defaultLabel);
  const Fields& fields() const override = 0;
  /// Throws std::invalid_argument where no material of the run dissolves.
  void initialize(Blocks blocks) override;

 protected:
  using DissolvedMetalSum::DissolvedMetalSum;

  /// m2. Throws std::runtime_error where no metal meets electrolyte. Collective.
  double firstSurface(const Blocks& blocks) const;
};

}  // namespace pd

#endif
