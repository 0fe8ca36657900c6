// Exodus files: their nodes, and pieces that are not the whole.
#ifndef PD_EXODUS_NODES_HPP
#define PD_EXODUS_NODES_HPP

#include <string>
#include <vector>

#include "netcdf_file.hpp"

namespace pd {

/// Throws std::runtime_error where a name is that of a piece of a mesh that was cut for several processes, or of a mesh
/// that is there in pieces alone.
void refusePieces(const std::string& fileName);

/// [3 nodes] Coordinates of all nodes, m; 0 along axes that the file has not. Throws std::runtime_error, also where the
/// file says that it holds a piece of a mesh.
std::vector<double> exodusNodes(const NetcdfFile& file);

}  // namespace pd

#endif
