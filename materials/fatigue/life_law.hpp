// Life that a cycle takes of a bond, over the range of its strain in the cycle.
#ifndef PD_LIFE_LAW_HPP
#define PD_LIFE_LAW_HPP

#include <vector>

namespace pd::kernels {

/// d(lost life)/dN, 1 at failure: a power of the strain range that fades out towards a limit (Silling & Askari,
/// SAND2014-18590), or 1/N of a strain-life table, log-log between its rows and beyond them as between the last two.
class LifeLaw {
 public:
  LifeLaw() = default;  ///< no loss
  /// coefficient (strainRange (1 - (limit/strainRange)^sharpness))^exponent; 0 up to the limit. With sharpness 1 that
  /// is coefficient (strainRange - limit)^exponent.
  static LifeLaw power(double coefficient, double exponent, double limit, double sharpness = 1.0);
  /// From lives (cycles, rising) and strain ranges (falling); 0 up to the limit. Throws std::invalid_argument.
  static LifeLaw table(const std::vector<double>& lives, const std::vector<double>& strainRanges, double limit);

  /// Part of a life in a cycle.
  double rate(double strainRange) const;

 private:
  struct Segment {
    double from;               ///< strain range at its lower end
    double logRate, exponent;  ///< rate = exp(logRate) strainRange^exponent
  };
  double coefficient_ = 0.0, exponent_ = 1.0, limit_ = 0.0, sharpness_ = 1.0;
  std::vector<Segment> segments_;  ///< rising; empty: the power law
};

}  // namespace pd::kernels

#endif
