#include "flow_time_step.hpp"

#include <algorithm>
#include <cmath>

#include "../lanczos.hpp"
#include "arnoldi.hpp"

namespace pd {

namespace {

constexpr int mostArnoldiSteps = 120;
constexpr double nearEnough = 2e-3;  ///< last change of a limit by ten iterations, of itself

/// Velocities, then pressures over rho c: both are then of one size in a sound wave.
class LinearFlow {
 public:
  LinearFlow(FlowRates& rates, const FlowRates::Parts& parts)
      : rates_(rates),
        parts_(parts),
        impedance_(rates.fluid().density * rates.fluid().soundSpeed),
        state_(rates.makeState()),
        change_(rates.makeState()) {}

  /// Both [owned points (dimension + 1)].
  void apply(const double* x, double* y) {
    const std::vector<int>& fluid = rates_.geometry().fluid();
    const int n = rates_.dimension();
    for (const int point : fluid) {
      for (int a = 0; a < n; ++a) state_.velocity[a][point] = x[(n + 1) * point + a];
      state_.pressure[0][point] = impedance_ * x[(n + 1) * point + n];
    }
    rates_.evaluateLinear(state_, parts_, change_);
    std::fill_n(y, (n + 1) * rates_.nOwned(), 0.0);
    for (const int point : fluid) {
      for (int a = 0; a < n; ++a) y[(n + 1) * point + a] = change_.velocity[a][point];
      y[(n + 1) * point + n] = change_.pressure[0][point] / impedance_;
    }
  }

 private:
  FlowRates& rates_;
  const FlowRates::Parts parts_;
  const double impedance_;
  kernels::FlowState state_, change_;
};

double limitOf(const std::vector<std::complex<double>>& values) {
  double limit = HUGE_VAL;
  for (const std::complex<double>& value : values) limit = std::min(limit, rungeKuttaLimit(value));
  return limit;
}

/// Random numbers at points of the flow, zero elsewhere.
std::vector<double> startVector(const FlowRates& rates) {
  const int width = rates.dimension() + 1;
  const std::vector<double> random = randomPointValues(rates.geometry().mesh().globalIds, rates.nOwned(), width);
  std::vector<double> start(random.size(), 0.0);
  for (const int point : rates.geometry().fluid())
    std::copy_n(random.begin() + width * point, width, start.begin() + width * point);
  return start;
}

double findLimit(FlowRates& rates, const Communicator& comm, const FlowRates::Parts& parts) {
  LinearFlow flow(rates, parts);
  double before = 0.0;
  const auto values = outerEigenvalues(
      comm, [&](const double* x, double* y) { flow.apply(x, y); }, startVector(rates),
      [&](const std::vector<std::complex<double>>& soFar) {
        const double limit = limitOf(soFar);
        const bool isEnough = std::abs(limit - before) <= nearEnough * limit || limit == HUGE_VAL;
        before = limit;
        return isEnough;
      },
      mostArnoldiSteps);
  return limitOf(values);
}

}  // namespace

double rungeKuttaLimit(std::complex<double> lambda) {
  const double size = std::abs(lambda);
  if (size == 0.0) return HUGE_VAL;
  const std::complex<double> direction = lambda.real() > 0.0 ? std::complex<double>(0.0, 1.0) : lambda / size;
  const auto isStable = [&](double radius) {
    const std::complex<double> z = radius * direction;
    constexpr double rounding = 1e-9;  // |R| = 1 - r^6/144 on the imaginary axis
    return std::abs(1.0 + z * (1.0 + z / 2.0 * (1.0 + z / 3.0 * (1.0 + z / 4.0)))) <= 1.0 + rounding;
  };
  constexpr double stride = 0.02, farthest = 4.0;
  double stable = 0.0, unstable = stride;
  while (unstable < farthest && isStable(unstable)) {
    stable = unstable;
    unstable += stride;
  }
  for (int halving = 0; halving < 40; ++halving) {
    const double middle = 0.5 * (stable + unstable);
    (isStable(middle) ? stable : unstable) = middle;
  }
  return stable / size;
}

FlowTimeSteps findFlowTimeSteps(FlowRates& rates, const Communicator& comm) {
  return {findLimit(rates, comm, {1.0, 1.0, 1.0}), findLimit(rates, comm, {1.0, 0.0, 0.0}),
          findLimit(rates, comm, {0.0, 1.0, 0.0}), findLimit(rates, comm, {0.0, 0.0, 1.0})};
}

}  // namespace pd
