// A function of concentration, evaluated often, by many points: sampled once.
#ifndef PD_SAMPLED_FUNCTION_HPP
#define PD_SAMPLED_FUNCTION_HPP

#include <functional>
#include <vector>

namespace pd {

/// f over [0, end] by cubic Hermite interpolation over equal intervals; outside the value at the nearer end.
class SampledFunction {
 public:
  struct Value {
    double value, slope;
  };

  SampledFunction() = default;
  /// `fine`: f at the ends and middles of the intervals, from 0 to `end`.
  SampledFunction(double end, const std::vector<double>& fine);
  /// f at the places that the constructor asks for.
  static std::vector<double> samples(double end, const std::function<double(double)>& f);

  Value at(double place) const;

 private:
  double end_ = 0.0;
  std::vector<double> values_, slopes_;
};

}  // namespace pd

#endif
