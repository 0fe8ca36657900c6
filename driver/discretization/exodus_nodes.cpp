#include "exodus_nodes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <regex>
#include <stdexcept>

namespace pd {

namespace {

constexpr double farthest = 1e75;  // m; products of four lengths, as in squares of areas, are still numbers

const std::regex pieceName(R"(\.(\d+)\.\d+$)");  // mesh.g.4.0: the first of four

std::string remedy(const std::string& piece) {
  return "pdrun reads the whole mesh from one file on any number of ranks: join the pieces by SEACAS' program, `epu "
         "-auto " +
         piece + "`";
}

}  // namespace

void refusePieces(const std::string& fileName) {
  const std::filesystem::path path(fileName);
  const std::string name = path.filename().string();
  std::smatch match;
  if (std::regex_search(name, match, pieceName) && match[1] != "1")
    throw std::runtime_error("it is one of " + match[1].str() + " pieces of a mesh; " + remedy(name));
  std::error_code error;
  if (std::filesystem::exists(path, error)) return;
  for (const auto& entry :
       std::filesystem::directory_iterator(path.has_parent_path() ? path.parent_path() : ".", error)) {
    const std::string other = entry.path().filename().string();
    if (other.compare(0, name.size() + 1, name + ".") == 0 && std::regex_search(other, pieceName))
      throw std::runtime_error("it is not there, but pieces of it are, as " + other + "; " + remedy(other));
  }
}

std::vector<double> exodusNodes(const NetcdfFile& file) {
  // Nemesis' additions to Exodus, which each piece of a mesh has.
  if (file.dimension("num_processors") > 1 || file.dimension("num_elems_global") > file.dimension("num_elem"))
    throw std::runtime_error("it is a piece of a mesh that was cut for several processes; " + remedy("PIECE"));
  const std::size_t nNodes = file.dimension("num_nodes"), nAxes = std::min<std::size_t>(3, file.dimension("num_dim"));
  file.requireRoomFor(nNodes, "nodes");
  std::vector<double> nodes(3 * nNodes, 0.0);
  // Old files keep all coordinates in one variable.
  const std::vector<double> together =
      file.hasVariable("coord") ? file.reals("coord", file.dimension("num_dim") * nNodes) : std::vector<double>();
  for (std::size_t axis = 0; axis < nAxes; ++axis) {
    const std::size_t start = together.empty() ? 0 : axis * nNodes;
    const std::vector<double> values =
        together.empty() ? file.reals(std::string("coord") + "xyz"[axis], nNodes) : together;
    for (std::size_t node = 0; node < nNodes; ++node) {
      if (!(std::abs(values[start + node]) < farthest))
        throw std::runtime_error("node " + std::to_string(node + 1) + " lies at " + "xyz"[axis] + " = " +
                                 fmt::format("{:g}", values[start + node]) + " m, which is no place");
      nodes[3 * node + axis] = values[start + node];
    }
  }
  return nodes;
}

}  // namespace pd
