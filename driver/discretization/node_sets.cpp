#include "node_sets.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <limits>
#include <regex>

#include "../deck/deck_data.hpp"
#include "../deck/function.hpp"
#include "mesh_geometry.hpp"
#include "text_file.hpp"

namespace pd {

namespace {

class NodeSetReader {
 public:
  NodeSetReader(const Deck& deck, const Communicator& comm, const MeshPoints& points)
      : deck_(deck), comm_(comm), points_(points), box_(boundingBox(points)) {}

  std::vector<int> read(const std::string& name, const DeckNode& node) {
    std::vector<int> ids;
    const std::size_t mistakesBefore = mistakes().lines().size();
    if (node.isScalar())
      readText(node, ids);
    else if (node.isSequence())
      readList(node, ids);
    else if (node["Box"])
      readBox(node["Box"], ids);
    else if (node["Expression"])
      readExpression(node["Expression"], ids);
    else
      mistakes().add(node.place(),
                     "node set \"" + name + "\" needs a file name, node numbers, or one of Box, Expression");
    std::sort(ids.begin(), ids.end());
    ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
    if (ids.empty() && meshIsSound() && mistakes().lines().size() == mistakesBefore)
      mistakes().add(node.place(), "node set \"" + name + "\" has no points (the mesh spans " + box_.text() + " m)");
    return ids;
  }

 private:
  Mistakes& mistakes() const { return deck_.mistakes(); }
  /// Rows that could not be read would be missing from a geometric set.
  bool meshIsSound() const { return points_.size() == points_.nRows; }

  /// Programs write whole numbers as 1.000e+00, too.
  static std::optional<int> nodeNumber(std::string_view word) {
    const std::string text(word);
    if (const std::optional<int> number = parseInteger(text)) return number;
    const std::optional<double> real = parseReal(text);
    if (!real || *real != std::floor(*real) || std::abs(*real) > std::numeric_limits<int>::max()) return std::nullopt;
    return static_cast<int>(*real);
  }

  /// What is wrong with a node number; empty where it is one of the mesh's.
  std::string complaint(std::string_view word) const {
    const std::optional<int> number = nodeNumber(word);
    if (!number) return quoted(word) + " is not a node number";
    if (*number >= 1 && *number <= points_.nRows) return "";
    return "node " + std::to_string(*number) + " is not in the mesh, whose nodes are 1 to " +
           std::to_string(points_.nRows);
  }

  void readText(const DeckNode& node, std::vector<int>& ids) {
    const std::string text = node.text();
    DataLines words(text);
    std::string_view word = words.next() ? words.word() : std::string_view();
    if (parseInteger(std::string(word))) {
      for (; !word.empty(); word = words.word()) addNumber(node.place(), word, ids);
    } else {
      readFile(deck_.resolvePath(text), node.place(), ids);
    }
  }

  void readList(const DeckNode& node, std::vector<int>& ids) {
    for (const DeckNode& item : node.items()) addNumber(item.place(), item.text(), ids);
  }

  void addNumber(const std::string& place, std::string_view word, std::vector<int>& ids) {
    const std::string problem = complaint(word);
    if (problem.empty())
      ids.push_back(*nodeNumber(word) - 1);
    else
      mistakes().add(place, problem);
  }

  void readFile(const std::string& fileName, const std::string& place, std::vector<int>& ids) {
    const std::optional<std::string> text = readTextFile(fileName, place, comm_, mistakes());
    if (!text) return;
    if (const std::string problem = ofAnotherMesh(*text); !problem.empty()) {
      mistakes().add(fileName, problem);
      return;
    }
    FileMistakes fileMistakes(fileName, mistakes());
    DataLines lines(*text);
    int nWords = 0;
    while (lines.next())
      for (std::string_view word = lines.word(); !word.empty(); word = lines.word(), ++nWords) {
        const std::string problem = complaint(word);
        if (problem.empty())
          ids.push_back(*nodeNumber(word) - 1);
        else
          fileMistakes.add(lines.number(), problem);
      }
    if (nWords == 0) mistakes().add(fileName, "the node set has no node numbers (named in " + place + ")");
  }

  /// What is wrong where the file says ("# top: 9 of the 400 points of plate.txt", as pdmesh writes it) that its mesh
  /// has another number of points; empty where it does not.
  std::string ofAnotherMesh(const std::string& text) const {
    static const std::regex heading(R"(# .*: \d+ of the (\d+) points of (\S+))");
    const std::string line = text.substr(0, std::min<std::size_t>(text.find('\n'), 500));
    std::smatch match;
    if (!std::regex_search(line, match, heading, std::regex_constants::match_continuous)) return "";
    if (parseInteger(match[1].str()) == points_.nRows) return "";
    return "the node set was made for the " + match[1].str() + " points of " + match[2].str() + ", and the mesh has " +
           std::to_string(points_.nRows) + "; make it again with its mesh, in a folder of their own";
  }

  static std::array<double, 3> corner(const DeckNode& node) {
    const std::vector<DeckNode> values = node.items();
    if (values.size() != 3)
      throw DeckError(node.place() + ": a corner of a box has three coordinates: {Box: [[x, y, z], [x, y, z]]}");
    return {values[0].real(), values[1].real(), values[2].real()};
  }

  void readBox(const DeckNode& node, std::vector<int>& ids) {
    const std::vector<DeckNode> corners = node.items();
    if (corners.size() != 2)
      throw DeckError(node.place() + ": a box has two corners: {Box: [[x, y, z], [x, y, z]]}, lowest first");
    const std::array<double, 3> low = corner(corners[0]), high = corner(corners[1]);
    for (std::size_t k = 0; k < 3; ++k)
      if (low[k] > high[k])
        throw DeckError(node.place() + ": the first corner of a box is its lowest; " + "xyz"[k] + " is " +
                        std::to_string(low[k]) + " there and " + std::to_string(high[k]) + " in the second");
    const double tolerance = geometricTolerance(box_);
    for (int i = 0; meshIsSound() && i < points_.size(); ++i) {
      const double* x = points_.at(i);
      bool isInside = true;
      for (std::size_t k = 0; k < 3; ++k)
        isInside = isInside && x[k] >= low[k] - tolerance && x[k] <= high[k] + tolerance;
      if (isInside) ids.push_back(i);
    }
  }

  void readExpression(const DeckNode& node, std::vector<int>& ids) {
    const Function expression(node.text(), node.place());
    for (int i = 0; meshIsSound() && i < points_.size(); ++i) {
      if (expression.at(points_.at(i), 0.0, i) != 0.0) ids.push_back(i);
    }
  }

  const Deck& deck_;
  const Communicator& comm_;
  const MeshPoints& points_;
  const BoundingBox box_;
};

bool isNodeSet(const std::string& name, const DeckNode& node) {
  return nodeSetKey(name).find("NODE_SET") != std::string::npos && !node["Type"];
}

}  // namespace

std::string nodeSetKey(const std::string& name) {
  std::string key = name;
  for (char& c : key) c = c == ' ' ? '_' : static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return key;
}

const std::vector<int>* findNodeSet(const NodeSets& nodeSets, const std::string& name) {
  const std::string key = nodeSetKey(name);
  for (const auto& entry : nodeSets)
    if (nodeSetKey(entry.first) == key) return &entry.second;
  return nullptr;
}

NodeSets readNodeSets(const Deck& deck, const Communicator& comm, const MeshPoints& points) {
  NodeSets nodeSets;
  NodeSetReader reader(deck, comm, points);
  for (const auto& [name, node] : deck["Boundary Conditions"].entries()) {
    if (!isNodeSet(name, node)) continue;
    if (findNodeSet(nodeSets, name) != nullptr)
      deck.mistakes().add(node.keyPlace(), "another node set is called \"" + name + "\" too (upper and lower case, " +
                                               "blank and '_' are not told apart); rename one of them");
    std::vector<int>& ids = nodeSets[name];  // there for those that name it, read or not
    try {
      ids = reader.read(name, node);
    } catch (const DeckError& error) {
      deck.mistakes().add("", error.what());
    }
  }
  return nodeSets;
}

}  // namespace pd
