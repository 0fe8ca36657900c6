// An order of elimination for the points of a spring network.
#ifndef PD_DISSECTION_HPP
#define PD_DISSECTION_HPP

#include <vector>

#include "spring_network.hpp"

namespace pd {

/// These owned points. Nested dissection (A. George, SIAM J. Numer. Anal. 10 (1973) 345): the points are cut in two
/// across their longer side, and those of one half that have springs to the other come after both halves; so do the
/// halves in turn.
std::vector<int> dissectionOrder(const SpringNetwork& network, std::vector<int> points);

}  // namespace pd

#endif
