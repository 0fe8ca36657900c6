// The pits of a surface: what Pit_Count and Pit_Depth have in common.
#ifndef PD_PITS_HPP
#define PD_PITS_HPP

#include <vector>

#include "surface_compute.hpp"

namespace pd {

/// A pit is what hangs together of the columns that are deeper than a level: in a plane body neighbours in the row, in
/// a solid columns that touch, at corners too.
class PitCompute : public SurfaceCompute {
 public:
  struct Fields : SurfaceCompute::Fields {
    Fields(const Teuchos::ParameterList& parameters, const std::string& unit, const std::string& meaning)
        : SurfaceCompute::Fields(parameters, pd::fields::globalScalar, unit, meaning) {}
  };
  static void declareParameters(ParameterDeclarations& declarations, const char* defaultLabel);
  const Fields& fields() const override = 0;

 protected:
  PitCompute(const Teuchos::ParameterList& completed, ComputeParameters params, ComputeComm comm,
             ComputeParameters globalData)
      : SurfaceCompute(completed, params, comm, globalData) {}

  /// Depth of each pit in its deepest column, m. Throws std::runtime_error where columns of a solid are no squares or
  /// stand in no rows. Collective.
  std::vector<double> pits(const Blocks& blocks) const;
};

}  // namespace pd

#endif
