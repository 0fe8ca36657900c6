// The planes of symmetry that a deck names.
#ifndef PD_SYMMETRY_PLANES_HPP
#define PD_SYMMETRY_PLANES_HPP

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "../../materials/kernels/rings.hpp"
#include "deck.hpp"

namespace pd {

struct SymmetryPlane {
  std::array<double, 3> point{}, normal{};  ///< m; of length 1
  std::string place, path;                  ///< in the deck
};

/// The body that Discretization/Axis Of Revolution names; none without the key, and after a mistake in it.
kernels::Rings ringsOf(const Deck& deck);

/// The plane that mirrors the half section of a body of revolution to the whole one; none in other bodies, and after a
/// mistake.
std::optional<SymmetryPlane> axisPlane(const Deck& deck);

/// The entries of Discretization/Symmetry, after the plane of an axis of revolution. Mistakes (lists that are no
/// vectors, normals without length, planes that are not perpendicular to each other) are added to `mistakes`, and the
/// planes that have them left out.
std::vector<SymmetryPlane> readSymmetryPlanes(const Deck& deck, Mistakes& mistakes);

}  // namespace pd

#endif
