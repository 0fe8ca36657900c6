// The whole of a body of which the mesh is one part, beside planes of symmetry.
#ifndef PD_SYMMETRIC_BODY_HPP
#define PD_SYMMETRIC_BODY_HPP

#include <vector>

#include "../deck/deck.hpp"
#include "../deck/symmetry_planes.hpp"
#include "horizon_shape.hpp"
#include "mesh_points.hpp"
#include "neighbor_search.hpp"
#include "symmetry.hpp"

namespace pd {

/// For the half section of a body of revolution. Points that are not beside the axis, in a plane, and what there is no
/// rule for in rings, are added to `mistakes`. Takes the plane of the axis out of `planes` where no point, with half of
/// the largest `horizon`, reaches as far as there.
void checkHalfSection(const Deck& deck, const MeshPoints& part, int dimension, const std::vector<double>& horizon,
                      std::vector<SymmetryPlane>& planes, Mistakes& mistakes);

/// Makes of volumes of the mesh, as of a plane 1 m thick, those of rings, 2 pi r times area. `x` [3 n], m. Nothing
/// happens to other bodies.
void makeRings(const Deck& deck, const std::vector<double>& x, std::vector<double>& volume);

/// Of the deck's planes. Normals that leave the dimension of the mesh, and bodies of more points than there are numbers
/// for, are added to `mistakes`.
Symmetry symmetryOf(const std::vector<SymmetryPlane>& planes, const MeshPoints& part, int dimension,
                    Mistakes& mistakes);

/// Planes that do not mirror the horizon onto itself, a shape with axes, or a box along x, y, z, are added to
/// `mistakes`.
void checkHorizon(const std::vector<SymmetryPlane>& planes, const kernels::HorizonShape& shape, bool isBox,
                  Mistakes& mistakes);

/// All points of all copies: the image of point i in copy c is point c n + i, n: points of the mesh.
MeshPoints wholeBody(const MeshPoints& part, const Symmetry& symmetry);
/// The same of values by point.
std::vector<double> wholeBody(const std::vector<double>& part, const Symmetry& symmetry);

/// All points of the mesh must lie on one side of each plane, no nearer to it than a quarter of their spacing, since
/// they are centres of cells, and some within its reach: else mistakes of the deck; a gap beside a plane is a warning.
/// `searched`: the whole body, mapped where the horizon is no ball; `spacing` [n] in that space, m.
void checkBesidePlanes(const Deck& deck, const std::vector<SymmetryPlane>& planes, const MeshPoints& part,
                       const MeshPoints& searched, const std::vector<double>& spacing, const NeighborRule& rule);

}  // namespace pd

#endif
