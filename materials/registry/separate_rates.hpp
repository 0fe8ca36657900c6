// Materials that give several rates, of which a host may want one alone.
#ifndef PD_SEPARATE_RATES_HPP
#define PD_SEPARATE_RATES_HPP

#include "Peridigm_DataManager.hpp"
#include "call.hpp"

namespace pd {

/// What pdrun asks for in place of precompute() and computeFluxDivergence(), which do everything, where it advances one
/// field: other rates cost nothing then, nor does the preparation of forces.
class SeparateRates {
 public:
  virtual ~SeparateRates() = default;
  /// `rateField`: id of a field that the material adds to, other than Force_Density.
  virtual void prepareRate(int rateField, double dt, const Call& call, PeridigmNS::DataManager& data) const = 0;
  virtual void computeRate(int rateField, double dt, const Call& call, PeridigmNS::DataManager& data) const = 0;
};

}  // namespace pd

#endif
