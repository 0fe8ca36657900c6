// How long a step of the explicit flow may be.
#ifndef PD_FLOW_TIME_STEP_HPP
#define PD_FLOW_TIME_STEP_HPP

#include <complex>

#include "flow_rates.hpp"

namespace pd {

/// The largest step, s, with which the classic Runge-Kutta method of four stages does not amplify y' = lambda y, nor
/// with any shorter one: 2.785/|lambda| on the negative axis, 2.828/|lambda| on the imaginary one. What grows by itself
/// counts as what neither grows nor decays.
double rungeKuttaLimit(std::complex<double> lambda);

/// Critical steps, s, of the rates about rest: of all, and of each part alone (infinite where there is none). From the
/// rims of their spectra, found to some parts in a thousand.
struct FlowTimeSteps {
  double all, acoustics, viscosity, diffusion;
};
FlowTimeSteps findFlowTimeSteps(FlowRates& rates, const Communicator& comm);

}  // namespace pd

#endif
