// The points of a whole mesh, whatever kind of file or section of the deck they come from.
#ifndef PD_MESH_POINTS_HPP
#define PD_MESH_POINTS_HPP

#include <map>
#include <string>
#include <vector>

namespace pd {

/// All points of a mesh, in the order of the file.
struct MeshPoints {
  std::string fileName;
  std::vector<double> x;       ///< [3 n] m
  std::vector<double> volume;  ///< [n] m3
  std::vector<int> blockId;    ///< [n] from 1
  std::vector<int> line;       ///< [n] line of the file, from 1; without lines: number of the row
  int nRows = 0;               ///< rows of the file; more than n where some are bad
  /// What a row is where the file has no lines: "element", "point". Empty: a line.
  std::string rowName;
  /// Names of blocks that have one; the others are block_<number>.
  std::map<int, std::string> blockNames;
  /// 0-based ids of the points of the mesh's own node sets, sorted.
  std::map<std::string, std::vector<int>> nodeSets;

  int size() const { return static_cast<int>(volume.size()); }
  const double* at(int point) const { return &x[3 * static_cast<std::size_t>(point)]; }
  /// "plate.txt:17" or "plate.g: element 17" of a point.
  std::string place(int point) const {
    return fileName + (rowName.empty() ? ":" : ": " + rowName + " ") + std::to_string(line[point]);
  }
  /// "line 17" or "element 17".
  std::string row(int point) const { return (rowName.empty() ? "line " : rowName + " ") + std::to_string(line[point]); }
};

/// The name of a block of a mesh: its own, or block_<number>.
inline std::string nameOfBlock(const std::map<int, std::string>& names, int number) {
  const auto found = names.find(number);
  return found == names.end() ? "block_" + std::to_string(number) : found->second;
}

}  // namespace pd

#endif
