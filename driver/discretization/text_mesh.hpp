// Meshes as text: one point a line, `x y z block_id volume` (Peridigm's "Text File").
#ifndef PD_TEXT_MESH_HPP
#define PD_TEXT_MESH_HPP

#include <string>

#include "../deck/deck.hpp"
#include "mesh_points.hpp"

namespace pd {

/// Reads the points from the text of a file. Every bad row (not five numbers, a number that is not finite, a block
/// number below 1, a volume that is not positive, a point that is there twice) is added to `mistakes` with file:line.
MeshPoints parseTextMesh(const std::string& text, const std::string& fileName, Mistakes& mistakes);

}  // namespace pd

#endif
