// The influence function of the run; the names of Peridigm's InfluenceFunction.
#ifndef PERIDIGM_INFLUENCEFUNCTION_HPP
#define PERIDIGM_INFLUENCEFUNCTION_HPP

#include <functional>
#include <string>

namespace PeridigmNS {

class InfluenceFunction {
 public:
  using functionPointer = double (*)(double zeta, double horizon);

  static InfluenceFunction& self() {
    static InfluenceFunction influence;
    return influence;
  }

  /// "One", "Parabolic Decay" or "Gaussian". Throws std::invalid_argument for another name.
  void setInfluenceFunction(const std::string& name);
  /// A function given by the user: omega(zeta, horizon).
  void setInfluenceFunction(std::function<double(double, double)> function);
  functionPointer getInfluenceFunction() const { return function_; }

 private:
  InfluenceFunction() = default;
  functionPointer function_ = [](double, double) { return 1.0; };
};

}  // namespace PeridigmNS

#endif
