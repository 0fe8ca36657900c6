#include "mesh_reader.hpp"

#include <optional>
#include <set>

#include "../deck/deck_parameters.hpp"
#include "../deck/sections.hpp"
#include "block_horizons.hpp"
#include "exodus_mesh.hpp"
#include "quick_grid.hpp"
#include "text_file.hpp"
#include "text_mesh.hpp"

namespace pd {

namespace {

/// Those of the mesh are known now.
void checkNames(const Deck& deck, const MeshPoints& points, const NodeSets& nodeSets) {
  std::vector<std::string> sets, blocks;
  for (const auto& entry : nodeSets) sets.push_back(entry.first);
  for (const DeckNode& value : namesOf(deck, "Node Set"))
    if (findNodeSet(nodeSets, value.text()) == nullptr)
      deck.mistakes().add(value.place(), value.path() + ": neither Boundary Conditions nor the mesh has a node set \"" +
                                             value.text() + "\"" + didYouMean(value.text(), sets) +
                                             "; there are: " + quotedList(sets));
  std::set<std::string> known;  // by their numbers, too
  for (const int number : blockNumbersOf(points)) {
    blocks.push_back(nameOfBlock(points.blockNames, number));
    known.insert({blocks.back(), nameOfBlock({}, number)});
  }
  for (const DeckNode& value : namesOf(deck, "Block"))
    if (known.count(value.text()) == 0)
      deck.mistakes().add(value.place(), value.path() + ": the mesh " + points.fileName + " has no block \"" +
                                             value.text() + "\"" + didYouMean(value.text(), blocks) +
                                             "; it has: " + quotedList(blocks));
}

}  // namespace

MeshPoints readMesh(const Deck& deck, const Communicator& comm) {
  const DeckNode section = deck["Discretization"];
  if (!section) throw DeckError(deck.fileName() + ": the deck has no section Discretization");
  const std::string type = section.text("Type", "Text File");
  if (type == "PdQuickGrid") return makeQuickGrid(deck);
  if (type != "Text File" && type != "Exodus")
    throw DeckError(section["Type"].place() +
                    ": Discretization/Type must be one of \"Text File\", \"Exodus\", \"PdQuickGrid\"");
  const DeckNode name = section["Input Mesh File"];
  if (!name) throw DeckError(section.place() + ": Discretization needs Input Mesh File");
  const std::string fileName = deck.resolvePath(name.text());
  if (type == "Exodus") {
    MeshPoints points = readExodusMesh(fileName, name.place(), comm, deck.mistakes(), deck.warnings());
    deck.mistakes().report();
    return points;
  }
  const std::optional<std::string> text = readTextFile(fileName, name.place(), comm, deck.mistakes());
  deck.mistakes().report();
  return parseTextMesh(*text, fileName, deck.mistakes());
}

NodeSets allNodeSets(const Deck& deck, const Communicator& comm, const MeshPoints& points) {
  NodeSets nodeSets = readNodeSets(deck, comm, points);
  for (const auto& [name, ids] : points.nodeSets) {
    if (findNodeSet(nodeSets, name) != nullptr)
      deck.mistakes().add(deck["Boundary Conditions"].place(), "both the deck and the mesh " + points.fileName +
                                                                   " have a node set \"" + name +
                                                                   "\"; rename the one of the deck");
    nodeSets.emplace(name, ids);
  }
  checkNames(deck, points, nodeSets);
  return nodeSets;
}

}  // namespace pd
