// Nodes of an Exodus file.
#ifndef PD_EXODUS_NODES_HPP
#define PD_EXODUS_NODES_HPP

#include <vector>

#include "netcdf_file.hpp"

namespace pd {

/// [3 nodes] Coordinates of all nodes, m; 0 along axes that the file has not. Throws std::runtime_error.
std::vector<double> exodusNodes(const NetcdfFile& file);

}  // namespace pd

#endif
