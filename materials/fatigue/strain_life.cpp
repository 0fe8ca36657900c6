#include "strain_life.hpp"

#include <algorithm>
#include <cmath>

namespace pd::kernels {

double StrainLife::lossRate(double strainRange) const {
  const bool isOfAmplitudes = measure == StrainMeasure::Amplitude;
  const double strain = isOfAmplitudes ? 0.5 * strainRange : strainRange;
  if (!(strain > limit)) return 0.0;
  return (isOfAmplitudes ? 2.0 : 1.0) * std::pow((strain - limit) / ductility, power());
}

double neuberStrainRange(double elasticRange, double yieldStrain) {
  return elasticRange * std::max(1.0, elasticRange / (2.0 * yieldStrain));
}

}  // namespace pd::kernels
