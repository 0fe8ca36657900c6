// A long strip of lattice with a crack along its middle, between grips that move apart.
#ifndef PD_GROWTH_STRIP_HPP
#define PD_GROWTH_STRIP_HPP

#include <vector>

#include "growth_body.hpp"

namespace pd {

/// It stands in a frame one neighbourhood thick: grips that move by 1 each, and beyond both ends what a strip without
/// end does. The frame is stretched along the crack, too, and contracts across it as a free plate does: that adds a
/// uniform stress along the crack and no K, and is such that the T-stress is 0, which it would else be as
/// 1/sqrt(height) only. The energy release rate is what a column far ahead of the crack holds.
class GrowthStrip : public GrowthBody {
 public:
  /// `height` of the whole between the grips and `growth` that there is room for, in horizons of `horizon` spacings.
  GrowthStrip(const std::vector<LatticeBond>& bonds, double horizon, double height, double growth);
};

}  // namespace pd

#endif
