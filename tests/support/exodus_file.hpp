// Small Exodus meshes, written by NetCDF as the format's manual says (SAND92-2137).
#ifndef PD_TESTS_EXODUS_FILE_HPP
#define PD_TESTS_EXODUS_FILE_HPP

#include <netcdf.h>

#include <array>
#include <stdexcept>
#include <string>
#include <vector>

namespace pd_test {

struct ExodusMesh {
  struct Block {
    int id;
    std::string name, type;
    int perElement;
    std::vector<int> nodes;          ///< from 1
    std::vector<double> attributes;  ///< two an element, or none
  };
  struct NodeSet {
    int id;
    std::string name;
    std::vector<int> nodes;  ///< from 1
  };
  std::vector<std::array<double, 3>> nodes;
  std::vector<Block> blocks;
  std::vector<NodeSet> nodeSets;
  std::vector<int> elementNumbers;  ///< empty: none
};

/// Writes a file as large or small programs do: NetCDF's classic format, or `format` NC_NETCDF4 (HDF5).
class ExodusWriter {
 public:
  ExodusWriter(const std::string& fileName, int format) { require(nc_create(fileName.c_str(), format, &file_)); }
  ~ExodusWriter() { nc_close(file_); }

  void write(const ExodusMesh& mesh) {
    std::size_t nElements = 0;
    for (const auto& block : mesh.blocks) nElements += block.nodes.size() / static_cast<std::size_t>(block.perElement);
    const int length = dimension("len_name", 33);
    dimension("num_dim", 3);
    const int nNodes = dimension("num_nodes", mesh.nodes.size()), nElem = dimension("num_elem", nElements);
    for (const char* axis : {"x", "y", "z"}) {
      std::vector<double> values;
      for (const auto& node : mesh.nodes) values.push_back(node[static_cast<std::size_t>(axis[0] - 'x')]);
      put(std::string("coord") + axis, {nNodes}, values);
    }
    if (!mesh.elementNumbers.empty()) put("elem_num_map", {nElem}, mesh.elementNumbers);
    names("eb", dimension("num_el_blk", mesh.blocks.size()), length, mesh.blocks);
    for (std::size_t b = 0; b < mesh.blocks.size(); ++b) block(std::to_string(b + 1), mesh.blocks[b]);
    if (mesh.nodeSets.empty()) return;
    names("ns", dimension("num_node_sets", mesh.nodeSets.size()), length, mesh.nodeSets);
    for (std::size_t s = 0; s < mesh.nodeSets.size(); ++s) {
      const std::string number = std::to_string(s + 1);
      put("node_ns" + number, {dimension("num_nod_ns" + number, mesh.nodeSets[s].nodes.size())},
          mesh.nodeSets[s].nodes);
    }
  }

 private:
  static void require(int status) {
    if (status != NC_NOERR) throw std::runtime_error(nc_strerror(status));
  }
  int dimension(const std::string& name, std::size_t size) {
    int id = 0;
    require(nc_def_dim(file_, name.c_str(), size, &id));
    return id;
  }
  int define(const std::string& name, nc_type type, const std::vector<int>& dimensions) {
    int id = 0;
    nc_redef(file_);
    require(nc_def_var(file_, name.c_str(), type, static_cast<int>(dimensions.size()), dimensions.data(), &id));
    return id;
  }
  void put(const std::string& name, const std::vector<int>& dimensions, const std::vector<double>& values) {
    const int id = define(name, NC_DOUBLE, dimensions);
    nc_enddef(file_);
    require(nc_put_var_double(file_, id, values.data()));
    nc_redef(file_);
  }
  void put(const std::string& name, const std::vector<int>& dimensions, const std::vector<int>& values) {
    const int id = define(name, NC_INT, dimensions);
    nc_enddef(file_);
    require(nc_put_var_int(file_, id, values.data()));
    nc_redef(file_);
  }
  /// Ids and names of blocks or node sets.
  template <class Items>
  void names(const std::string& kind, int count, int length, const Items& items) {
    std::vector<int> ids;
    std::string characters;
    for (const auto& item : items) {
      ids.push_back(item.id);
      characters += item.name + std::string(33 - item.name.size(), '\0');
    }
    put(kind + "_prop1", {count}, ids);
    const int id = define(kind + "_names", NC_CHAR, {count, length});
    nc_enddef(file_);
    require(nc_put_var_text(file_, id, characters.data()));
    nc_redef(file_);
  }
  void block(const std::string& number, const ExodusMesh::Block& block) {
    const int nElements =
        dimension("num_el_in_blk" + number, block.nodes.size() / static_cast<std::size_t>(block.perElement));
    const int perElement = dimension("num_nod_per_el" + number, static_cast<std::size_t>(block.perElement));
    put("connect" + number, {nElements, perElement}, block.nodes);
    int id = 0;
    require(nc_inq_varid(file_, ("connect" + number).c_str(), &id));
    require(nc_put_att_text(file_, id, "elem_type", block.type.size(), block.type.data()));
    if (!block.attributes.empty())
      put("attrib" + number, {nElements, dimension("num_att_in_blk" + number, 2)}, block.attributes);
  }

  int file_ = -1;
};

inline void writeExodus(const std::string& fileName, const ExodusMesh& mesh, int format = NC_64BIT_OFFSET) {
  ExodusWriter(fileName, format).write(mesh);
}

/// Unit cubes, x fastest, in one block without a name. Node set 7, without a name: the nodes of the plane x = 0;
/// node set 8, "top": those of the highest plane.
inline ExodusMesh cubes(int nx, int ny, int nz) {
  ExodusMesh mesh;
  mesh.nodeSets = {{7, "", {}}, {8, "top", {}}};
  const auto node = [&](int i, int j, int k) { return 1 + i + (nx + 1) * (j + (ny + 1) * k); };
  for (int k = 0; k <= nz; ++k)
    for (int j = 0; j <= ny; ++j)
      for (int i = 0; i <= nx; ++i) {
        mesh.nodes.push_back({1.0 * i, 1.0 * j, 1.0 * k});
        if (i == 0) mesh.nodeSets[0].nodes.push_back(node(i, j, k));
        if (k == nz) mesh.nodeSets[1].nodes.push_back(node(i, j, k));
      }
  mesh.blocks.push_back({1, "", "HEX8", 8, {}, {}});
  for (int k = 0; k < nz; ++k)
    for (int j = 0; j < ny; ++j)
      for (int i = 0; i < nx; ++i)
        for (const int l : {0, 1})
          for (const auto& [di, dj] : {std::pair{0, 0}, std::pair{1, 0}, std::pair{1, 1}, std::pair{0, 1}})
            mesh.blocks[0].nodes.push_back(node(i + di, j + dj, k + l));
  return mesh;
}

}  // namespace pd_test

#endif
