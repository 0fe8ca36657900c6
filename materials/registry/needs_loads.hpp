// Computes whose result is that of loads.
#ifndef PD_NEEDS_LOADS_HPP
#define PD_NEEDS_LOADS_HPP

#include <string>

namespace pd {

/// A host that knows its loads refuses such a compute where there are none; others need not.
class NeedsLoads {
 public:
  virtual ~NeedsLoads() = default;
  /// What else it could look at, as the end of a sentence; empty where it does.
  virtual std::string inPlaceOfLoads() const = 0;
};

}  // namespace pd

#endif
