// Materials that bring the shares that cracks and voids leave of bonds.
#ifndef PD_SHARE_BRINGER_HPP
#define PD_SHARE_BRINGER_HPP

#include <string>

namespace pd {

/// A mixin: a bond between two blocks has one share, found from either end, where `sourceOfShares()` of both blocks is
/// the same text; empty where a material brings none after all.
class ShareBringer {
 public:
  virtual ~ShareBringer() = default;
  virtual std::string sourceOfShares() const = 0;
};

}  // namespace pd

#endif
