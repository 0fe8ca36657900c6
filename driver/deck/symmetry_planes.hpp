// The planes of symmetry that a deck names.
#ifndef PD_SYMMETRY_PLANES_HPP
#define PD_SYMMETRY_PLANES_HPP

#include <array>
#include <string>
#include <vector>

#include "deck.hpp"

namespace pd {

struct SymmetryPlane {
  std::array<double, 3> point{}, normal{};  ///< m; of length 1
  std::string place, path;                  ///< in the deck
};

/// The entries of Discretization/Symmetry. Mistakes (lists that are no vectors, normals without length, planes that are
/// not perpendicular to each other) are added to `mistakes`, and the planes that have them left out.
std::vector<SymmetryPlane> readSymmetryPlanes(const Deck& deck, Mistakes& mistakes);

}  // namespace pd

#endif
