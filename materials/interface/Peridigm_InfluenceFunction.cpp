#include "Peridigm_InfluenceFunction.hpp"

#include <cmath>
#include <stdexcept>

namespace PeridigmNS {

namespace {

std::function<double(double, double)> userFunction;

double parabolicDecay(double zeta, double horizon) {
  const double ratio = zeta / horizon;
  if (ratio > 1.0) return 0.0;
  return ratio < 0.5 ? 1.0 : 4.0 * ratio * (1.0 - ratio);
}

double gaussian(double zeta, double horizon) {
  const double scaled = zeta / (0.4 * horizon);
  return std::exp(-scaled * scaled);
}

double callUserFunction(double zeta, double horizon) { return userFunction(zeta, horizon); }

}  // namespace

void InfluenceFunction::setInfluenceFunction(const std::string& name) {
  if (name == "One")
    function_ = [](double, double) { return 1.0; };
  else if (name == "Parabolic Decay")
    function_ = parabolicDecay;
  else if (name == "Gaussian")
    function_ = gaussian;
  else
    throw std::invalid_argument("unknown influence function \"" + name + "\" (known: One, Parabolic Decay, Gaussian)");
}

void InfluenceFunction::setInfluenceFunction(std::function<double(double, double)> function) {
  userFunction = std::move(function);
  function_ = callUserFunction;
}

}  // namespace PeridigmNS
