// Life that a cycle takes of a bond, over the range of its strain in the cycle.
#ifndef PD_LIFE_LAW_HPP
#define PD_LIFE_LAW_HPP

#include <vector>

namespace pd::kernels {

/// A factor over some argument, of rows by rising arguments: log-log between them, constant beyond them.
struct FactorTable {
  std::vector<double> arguments, factors;
  double at(double argument) const;  ///< 1 where there are no rows
};

/// d(lost life)/dN, 1 at failure: a power of what the strain range exceeds a limit by (Silling & Askari,
/// SAND2014-18590), or 1/N of a strain-life table, log-log between its rows and beyond them as between the last two.
class LifeLaw {
 public:
  LifeLaw() = default;  ///< no loss
  /// coefficient (strainRange - limit)^exponent, times a factor over strainRange/limit; 0 up to the limit.
  static LifeLaw power(double coefficient, double exponent, double limit, FactorTable factors = {});
  /// From lives (cycles, rising) and strain ranges (falling); 0 up to the limit. Throws std::invalid_argument.
  static LifeLaw table(const std::vector<double>& lives, const std::vector<double>& strainRanges, double limit);

  /// Part of a life in a cycle.
  double rate(double strainRange) const;
  double limit() const { return limit_; }

 private:
  struct Segment {
    double from;               ///< strain range at its lower end
    double logRate, exponent;  ///< rate = exp(logRate) strainRange^exponent
  };
  double coefficient_ = 0.0, exponent_ = 1.0, limit_ = 0.0;
  FactorTable factors_;
  std::vector<Segment> segments_;  ///< rising; empty: the power law
};

}  // namespace pd::kernels

#endif
