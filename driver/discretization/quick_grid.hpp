// Meshes that the deck describes: boxes and hollow cylinders of cells (Peridigm's "PdQuickGrid").
#ifndef PD_QUICK_GRID_HPP
#define PD_QUICK_GRID_HPP

#include <array>
#include <optional>

#include "../deck/deck.hpp"
#include "mesh_points.hpp"

namespace pd {

/// The points of the section Discretization, all of block_1, in Peridigm's order:
///   * TensorProduct3DMeshGenerator: x fastest, z slowest, a point at the centre of every cell;
///   * TensorProductCylinderMeshGenerator: the radius fastest, then the angle, then z. The number of cells around and
///     along the axis is Peridigm's choice: as long as they are thick at the mean radius.
/// Throws DeckError.
MeshPoints makeQuickGrid(const Deck& deck);

/// With NeighborhoodType Box (Peridigm's rule where a deck names none): how far apart neighbours can be along x, y, z,
/// m. That is the horizon in whole cells, a half rounded up. Nothing where neighbourhoods are spheres.
std::optional<std::array<double, 3>> quickGridNeighborBox(const Deck& deck, double horizon);

}  // namespace pd

#endif
