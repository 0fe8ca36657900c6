// A compact tension specimen (ASTM E647) of lattice, as tests find Paris' constants with.
#ifndef PD_GROWTH_SPECIMEN_HPP
#define PD_GROWTH_SPECIMEN_HPP

#include <vector>

#include "growth_body.hpp"

namespace pd {

/// Of W in horizons, under a force of 1 on the outer rims of its holes; free elsewhere. Its crack is W/2 long, from the
/// line of load, when it has grown by three quarters of `growth` horizons.
class GrowthSpecimen : public GrowthBody {
 public:
  GrowthSpecimen(const std::vector<LatticeBond>& bonds, double horizon, double width, double growth);
};

}  // namespace pd

#endif
