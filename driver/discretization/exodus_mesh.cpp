#include "exodus_mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <limits>
#include <numeric>
#include <sstream>
#include <stdexcept>

#include "../parallel/broadcast.hpp"
#include "element_geometry.hpp"
#include "exodus_nodes.hpp"
#include "netcdf_file.hpp"

namespace pd {

namespace {

constexpr int maximumListedElements = 10;  ///< bad elements

enum class ElementKind { Sphere, Tetrahedron, Hexahedron, Other };

/// Peridigm's names, and what begins like them.
ElementKind kindOf(std::string type) {
  for (char& c : type) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  const auto beginsWith = [&](const std::string& start) { return type.compare(0, start.size(), start) == 0; };
  if (beginsWith("SPHERE")) return ElementKind::Sphere;
  if (beginsWith("TET")) return ElementKind::Tetrahedron;
  return beginsWith("HEX") ? ElementKind::Hexahedron : ElementKind::Other;
}

std::string numbered(const std::string& name, std::size_t number) { return name + std::to_string(number); }

/// Reads on one rank. What is wrong goes to `problems` and `notes`, a line each.
class ExodusReader {
 public:
  explicit ExodusReader(const std::string& fileName) : file_(fileName) { points_.fileName = fileName; }

  MeshPoints read() {
    points_.rowName = "element";
    nNodes_ = file_.dimension("num_nodes");
    nElements_ = file_.dimension("num_elem");
    if (nNodes_ == 0 || nElements_ == 0) throw std::runtime_error("it is no Exodus mesh with nodes and elements");
    if (nElements_ > static_cast<std::size_t>(std::numeric_limits<int>::max()))
      throw std::runtime_error("it has more than 2.1e9 elements");
    file_.requireRoomFor(nElements_, "elements");
    points_.nRows = static_cast<int>(nElements_);
    nodes_ = exodusNodes(file_);
    placeElements();
    readBlocks();
    readNodeSets();
    return std::move(points_);
  }

  std::string problems, notes;

 private:
  /// pointOf_: the place of each element of the file among the points.
  void placeElements() {
    pointOf_.resize(nElements_);
    std::iota(pointOf_.begin(), pointOf_.end(), 0);
    if (file_.hasVariable("elem_num_map")) {
      const std::vector<long long> map = file_.integers("elem_num_map");
      std::vector<char> isTaken(nElements_, 0);
      bool isNumbering = map.size() == nElements_;
      for (std::size_t e = 0; isNumbering && e < nElements_; ++e) {
        isNumbering = map[e] >= 1 && map[e] <= static_cast<long long>(nElements_) &&
                      isTaken[static_cast<std::size_t>(map[e] - 1)] == 0;
        if (isNumbering) isTaken[static_cast<std::size_t>(map[e] - 1)] = 1;
      }
      for (std::size_t e = 0; isNumbering && e < nElements_; ++e) pointOf_[e] = static_cast<int>(map[e] - 1);
    }
    points_.x.resize(3 * nElements_);
    points_.volume.resize(nElements_);
    points_.blockId.resize(nElements_);
    points_.line.resize(nElements_);
    std::iota(points_.line.begin(), points_.line.end(), 1);
  }

  /// Ids of blocks or node sets, and their names where they have one.
  std::vector<int> ids(const std::string& kind, std::size_t count) const {
    std::vector<int> result(count);
    std::iota(result.begin(), result.end(), 1);
    if (!file_.hasVariable(kind + "_prop1")) return result;
    const std::vector<long long> given = file_.integers(kind + "_prop1");
    for (std::size_t i = 0; i < std::min(count, given.size()); ++i) {
      result[i] = static_cast<int>(given[i]);
      if (result[i] != given[i])
        throw std::runtime_error("\"" + kind + "_prop1\" has the id " + std::to_string(given[i]) + ", beyond 2.1e9");
    }
    return result;
  }
  std::vector<std::string> names(const std::string& kind, std::size_t count) const {
    std::vector<std::string> result;
    if (file_.hasVariable(kind + "_names")) result = file_.texts(kind + "_names");
    result.resize(count);
    return result;
  }

  void readBlocks() {
    const std::size_t count = file_.numberOf("num_el_blk");
    const std::vector<int> numbers = ids("eb", count);
    const std::vector<std::string> blockNames = names("eb", count);
    nodeToPoints_.clear();
    std::size_t first = 0;
    for (std::size_t block = 0; block < count; ++block) {
      if (!blockNames[block].empty()) points_.blockNames[numbers[block]] = blockNames[block];
      const std::size_t size = file_.dimension(numbered("num_el_in_blk", block + 1));
      if (size > nElements_ - first)
        throw std::runtime_error("its blocks have more elements than its \"num_elem\" says, " +
                                 std::to_string(nElements_));
      if (size > 0) readBlock(block + 1, numbers[block], first, size);
      first += size;
    }
    if (first != nElements_) throw std::runtime_error("its blocks do not hold all of its elements");
    refuseSameIds(numbers);
    if (nBad_ > maximumListedElements)
      problems += fmt::format("{}: {} more elements of no volume\n", points_.fileName, nBad_ - maximumListedElements);
  }

  void refuseSameIds(std::vector<int> numbers) {
    std::sort(numbers.begin(), numbers.end());
    const auto twice = std::adjacent_find(numbers.begin(), numbers.end());
    if (twice != numbers.end()) throw std::runtime_error("two of its blocks have the id " + std::to_string(*twice));
  }

  void readBlock(std::size_t block, int number, std::size_t first, std::size_t size) {
    const std::string connect = numbered("connect", block);
    const std::string type = file_.textAttribute(connect, "elem_type");
    const ElementKind kind = kindOf(type);
    const std::size_t corners = kind == ElementKind::Sphere ? 1 : kind == ElementKind::Tetrahedron ? 4 : 8;
    const std::size_t perElement = file_.dimension(numbered("num_nod_per_el", block));
    const std::string name = nameOfBlock(points_.blockNames, number);
    if (kind == ElementKind::Other || perElement < corners) {
      refuse(name, type, perElement);
      return;
    }
    if (perElement > corners)
      notes += fmt::format("{}: {} has elements of {} nodes ({}): all but their {} corners are passed over\n",
                           points_.fileName, name, perElement, type, corners);
    file_.requireRoomFor(perElement, "nodes of an element");
    const std::vector<long long> nodes = file_.integers(connect, size * perElement);
    std::vector<double> attributes;
    const std::size_t perSphere = file_.dimension(numbered("num_att_in_blk", block));
    if (kind == ElementKind::Sphere) {
      if (perSphere < 2) {
        problems += fmt::format("{}: the spheres of {} need two attributes, the radius and the volume (m3)\n",
                                points_.fileName, name);
        return;
      }
      file_.requireRoomFor(perSphere, "attributes of an element");
      attributes = file_.reals(numbered("attrib", block), size * perSphere);
    }
    for (const long long node : nodes)
      if (node < 1 || node > static_cast<long long>(nNodes_))
        throw std::runtime_error("an element of " + name + " has the node " + std::to_string(node) +
                                 ", which is not there");
    for (std::size_t e = 0; e < size; ++e) {
      const long long* own = &nodes[e * perElement];
      const int point = pointOf_[first + e];
      points_.blockId[static_cast<std::size_t>(point)] = number;
      addElement(kind, corners, own, attributes.empty() ? 0.0 : attributes[e * perSphere + 1], point);
      for (std::size_t k = 0; k < perElement; ++k) nodeToPoints_.emplace_back(own[k], point);
    }
  }

  void addElement(ElementKind kind, std::size_t corners, const long long* nodes, double sphereVolume, int point) {
    std::array<double, 24> x{};
    for (std::size_t k = 0; k < corners; ++k)
      for (std::size_t d = 0; d < 3; ++d) x[3 * k + d] = nodes_[3 * static_cast<std::size_t>(nodes[k] - 1) + d];
    ElementGeometry element;
    if (kind == ElementKind::Sphere)
      element = {{x[0], x[1], x[2]}, sphereVolume, false};
    else
      element = kind == ElementKind::Tetrahedron ? tetrahedron(x.data()) : hexahedron(x.data());
    const auto at = static_cast<std::size_t>(point);
    std::copy(element.centroid.begin(), element.centroid.end(), points_.x.begin() + 3 * point);
    points_.volume[at] = element.volume;
    if (element.volume > 0.0 && std::isfinite(element.volume) && !element.isInverted) return;
    if (++nBad_ > maximumListedElements) return;
    const char* const fault = element.isInverted ? "the element is inverted" : "the element has no volume";
    const char* const cause = kind == ElementKind::Sphere
                                  ? "the second attribute of a sphere is its volume"
                                  : "its nodes are in another order than Exodus asks for, or the mesh is folded there";
    problems += fmt::format("{}: {} (volume {:g} m3); {}\n", points_.place(point), fault, element.volume, cause);
  }

  void refuse(const std::string& name, const std::string& type, std::size_t perElement) {
    const std::filesystem::path path(points_.fileName);
    const std::string text = path.stem().string() + ".txt";
    problems += fmt::format(
        "{}: {} has elements of {} nodes of type \"{}\"; read are tetrahedra, hexahedra and spheres. Convert the mesh "
        "by `meshes/pdmesh convert {} {}`, and set `Type: Text File` and `Input Mesh File: {}`\n",
        points_.fileName, name, perElement, type, points_.fileName, text, text);
  }

  void readNodeSets() {
    const std::size_t count = file_.numberOf("num_node_sets");
    const std::vector<int> numbers = ids("ns", count);
    const std::vector<std::string> setNames = names("ns", count);
    std::sort(nodeToPoints_.begin(), nodeToPoints_.end());
    for (std::size_t set = 0; set < count; ++set) {
      const std::string name = setNames[set].empty() ? "nodelist_" + std::to_string(numbers[set]) : setNames[set];
      if (points_.nodeSets.count(name) != 0)
        problems += fmt::format("{}: two node sets are called \"{}\"; rename one of them\n", points_.fileName, name);
      std::vector<int>& members = points_.nodeSets[name];
      const std::string variable = numbered("node_ns", set + 1);
      if (!file_.hasVariable(variable)) continue;  // a set without nodes
      for (const long long node : file_.integers(variable)) {
        if (node < 1 || node > static_cast<long long>(nNodes_))
          throw std::runtime_error("node set \"" + name + "\" has a node that is not there");
        auto it = std::lower_bound(nodeToPoints_.begin(), nodeToPoints_.end(), std::make_pair(node, 0));
        for (; it != nodeToPoints_.end() && it->first == node; ++it) members.push_back(it->second);
      }
      std::sort(members.begin(), members.end());
      members.erase(std::unique(members.begin(), members.end()), members.end());
    }
  }

  NetcdfFile file_;
  MeshPoints points_;
  std::size_t nNodes_ = 0, nElements_ = 0;
  std::vector<double> nodes_;                            ///< [3 nodes] m
  std::vector<int> pointOf_;                             ///< [elements]
  std::vector<std::pair<long long, int>> nodeToPoints_;  ///< (node from 1, point) of all elements
  int nBad_ = 0;
};

void broadcast(MeshPoints& points, const Communicator& comm) {
  broadcast(points.x, comm);
  broadcast(points.volume, comm);
  broadcast(points.blockId, comm);
  broadcast(points.line, comm);
  std::vector<int> numbers;
  std::string names, setNames;
  for (const auto& [number, name] : points.blockNames) {
    numbers.push_back(number);
    names += name + '\n';
  }
  for (const auto& entry : points.nodeSets) setNames += entry.first + '\n';
  broadcast(numbers, comm);
  broadcast(names, comm);
  broadcast(setNames, comm);
  std::istringstream nameLines(names), setLines(setNames);
  for (const int number : numbers) std::getline(nameLines, points.blockNames[number]);
  for (std::string name; std::getline(setLines, name);) broadcast(points.nodeSets[name], comm);
}

void addLines(const std::string& place, const std::string& lines, Mistakes& to) {
  std::istringstream stream(lines);
  for (std::string line; std::getline(stream, line);) to.add(place, line);
}

}  // namespace

MeshPoints readExodusMesh(const std::string& fileName, const std::string& place, const Communicator& comm,
                          Mistakes& mistakes, Mistakes& warnings) {
  MeshPoints points;
  std::string failure, problems, notes;
  if (comm.isRoot()) {
    try {
      refusePieces(fileName);
      ExodusReader reader(fileName);
      points = reader.read();
      problems = reader.problems;
      notes = reader.notes;
    } catch (const std::exception& error) {
      failure = "the mesh \"" + fileName + "\": " + error.what();
    }
  }
  broadcast(failure, comm);
  broadcast(problems, comm);
  broadcast(notes, comm);
  addLines(place, failure, mistakes);
  addLines("", problems, mistakes);
  addLines("", notes, warnings);
  if (!failure.empty()) return points;
  points.fileName = fileName;
  points.rowName = "element";
  broadcast(points, comm);
  points.nRows = points.size();
  return points;
}

}  // namespace pd
