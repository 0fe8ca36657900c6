#include "mesh_reader.hpp"

#include <optional>

#include "../deck/deck_parameters.hpp"
#include "exodus_mesh.hpp"
#include "quick_grid.hpp"
#include "text_file.hpp"
#include "text_mesh.hpp"

namespace pd {

namespace {

void checkName(const DeckNode& value, const NodeSets& nodeSets, Mistakes& mistakes) {
  if (!value || !value.isScalar() || findNodeSet(nodeSets, value.text()) != nullptr) return;
  std::vector<std::string> known;
  for (const auto& entry : nodeSets) known.push_back(entry.first);
  mistakes.add(value.place(), value.path() + ": neither Boundary Conditions nor the mesh has a node set \"" +
                                  value.text() + "\"" + didYouMean(value.text(), known) +
                                  "; there are: " + quotedList(known));
}

void checkNames(const Deck& deck, const NodeSets& nodeSets) {
  for (const char* section : {"Boundary Conditions", "Compute Class Parameters", "Exact Solution"}) {
    for (const auto& item : deck[section].entries()) checkName(item.second["Node Set"], nodeSets, deck.mistakes());
    for (const DeckNode& item : deck[section].items()) checkName(item["Node Set"], nodeSets, deck.mistakes());
  }
  for (const auto& item : deck["Discretization"]["Bond Filters"].entries())
    for (const char* key : {"First Node Set", "Second Node Set"})
      checkName(item.second[key], nodeSets, deck.mistakes());
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
  if (!points.nodeSets.empty()) checkNames(deck, nodeSets);
  return nodeSets;
}

}  // namespace pd
