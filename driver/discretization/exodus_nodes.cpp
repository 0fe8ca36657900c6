#include "exodus_nodes.hpp"

#include <algorithm>
#include <stdexcept>

namespace pd {

std::vector<double> exodusNodes(const NetcdfFile& file) {
  const std::size_t nNodes = file.dimension("num_nodes"), nAxes = std::min<std::size_t>(3, file.dimension("num_dim"));
  std::vector<double> nodes(3 * nNodes, 0.0);
  // Old files keep all coordinates in one variable.
  const std::vector<double> together = file.hasVariable("coord") ? file.reals("coord") : std::vector<double>();
  for (std::size_t axis = 0; axis < nAxes; ++axis) {
    const std::size_t start = together.empty() ? 0 : axis * nNodes;
    const std::vector<double> values = together.empty() ? file.reals(std::string("coord") + "xyz"[axis]) : together;
    if (values.size() < start + nNodes) throw std::runtime_error("it has coordinates of some nodes alone");
    for (std::size_t node = 0; node < nNodes; ++node) nodes[3 * node + axis] = values[start + node];
  }
  return nodes;
}

}  // namespace pd
