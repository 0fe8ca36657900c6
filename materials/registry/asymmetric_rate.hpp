// Materials whose rate of a scalar is no symmetric function of it.
#ifndef PD_ASYMMETRIC_RATE_HPP
#define PD_ASYMMETRIC_RATE_HPP

#include <string>

namespace pd {

/// A mixin: matrices of implicit solvers are then not symmetric, as diffusion alone makes them. `isAsymmetric()` says
/// whether the rate of the scalar called `label` is such a one.
class AsymmetricRate {
 public:
  virtual ~AsymmetricRate() = default;
  virtual bool isAsymmetric(const std::string& label) const = 0;
};

}  // namespace pd

#endif
