// Meshes as text: one point a line, `x y z block_id volume` (Peridigm's "Text File").
#ifndef PD_TEXT_MESH_HPP
#define PD_TEXT_MESH_HPP

#include <string>
#include <vector>

#include "../deck/deck.hpp"

namespace pd {

/// All points of a mesh, in the order of the file.
struct MeshPoints {
  std::string fileName;
  std::vector<double> x;       ///< [3 n] m
  std::vector<double> volume;  ///< [n] m3
  std::vector<int> blockId;    ///< [n] from 1
  std::vector<int> line;       ///< [n] line of the file, from 1
  int nRows = 0;               ///< rows of the file; more than n where some are bad

  int size() const { return static_cast<int>(volume.size()); }
  const double* at(int point) const { return &x[3 * static_cast<std::size_t>(point)]; }
  /// "plate.txt:17" of a point.
  std::string place(int point) const { return fileName + ":" + std::to_string(line[point]); }
};

/// Reads the points from the text of a file. Every bad row (not five numbers, a number that is not finite, a block
/// number below 1, a volume that is not positive, a point that is there twice) is added to `mistakes` with file:line.
MeshPoints parseTextMesh(const std::string& text, const std::string& fileName, Mistakes& mistakes);

}  // namespace pd

#endif
