#include "block_horizons.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>

#include "../deck/block_plugins.hpp"
#include "../deck/deck_data.hpp"
#include "../deck/function.hpp"
#include "mesh_geometry.hpp"

namespace pd {

namespace {

constexpr double largestHorizon = 1e100;  ///< m; squares of distances stay far from overflow
/// A horizon that is longer than so many bodies is in another unit, or mistyped.
constexpr double mostBodies = 1000.0;

/// The block of `blockNumbers` that has this name; 0 where none has.
int blockNumber(const std::string& name, const std::vector<int>& blockNumbers, const MeshPoints& points) {
  for (const int number : blockNumbers)
    if (nameOfBlock(points.blockNames, number) == name) return number;
  return 0;
}

std::string namesOf(const std::vector<int>& blockNumbers, const MeshPoints& points) {
  constexpr std::size_t maximumListed = 20;
  std::string names;
  for (std::size_t i = 0; i < std::min(blockNumbers.size(), maximumListed); ++i)
    names += (i == 0 ? "" : ", ") + nameOfBlock(points.blockNames, blockNumbers[i]);
  return names + (blockNumbers.size() > maximumListed ? ", ..." : "");
}

std::vector<std::string> wordsOf(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

/// The horizon of an entry as a function of place; NaN where the deck does not give one that can be read.
Function horizonOf(const DeckNode& entry, Mistakes& mistakes) {
  try {
    if (entry["Horizon"]) return Function::fromDeck(entry["Horizon"]);
    mistakes.add(entry.place(), entry.path() + " needs a Horizon, in m");
  } catch (const DeckError& error) {
    mistakes.add("", error.what());
  }
  return Function::constant(std::nan(""));
}

std::vector<double> numbersOf(const DeckNode& list) {
  std::vector<double> numbers;
  if (list)
    for (const DeckNode& item : list.items()) numbers.push_back(item.real());
  return numbers;
}

}  // namespace

std::vector<int> blockNumbersOf(const MeshPoints& points) {
  std::set<int> numbers;
  int last = 0;
  for (const int block : points.blockId) {
    if (block != last) numbers.insert(block);
    last = block;
  }
  return {numbers.begin(), numbers.end()};
}

std::map<int, DeckNode> entriesOfBlocks(const Deck& deck, const std::vector<int>& blockNumbers,
                                        const MeshPoints& points) {
  Mistakes& mistakes = deck.mistakes();
  const std::string& meshFile = points.fileName;
  std::map<int, DeckNode> entries;
  DeckNode entryOfOthers;
  const auto assign = [&](int number, const DeckNode& entry, const DeckNode& names) {
    const auto [it, isNew] = entries.emplace(number, entry);
    if (!isNew)
      mistakes.add(names.place(), nameOfBlock(points.blockNames, number) + " already belongs to " + it->second.path());
  };
  for (const auto& item : deck["Blocks"].entries()) {
    const DeckNode& entry = item.second;
    const DeckNode names = entry["Block Names"];
    if (!names || !names.isScalar()) {
      mistakes.add(entry.place(),
                   entry.path() + " needs Block Names, such as \"" + namesOf(blockNumbers, points) + "\"");
      continue;
    }
    for (const std::string& name : wordsOf(names.text())) {
      const int number = blockNumber(name, blockNumbers, points);
      if (name == "default") {
        if (entryOfOthers) mistakes.add(names.place(), "\"default\" is taken by " + entryOfOthers.path() + " already");
        entryOfOthers = entry;
      } else if (number != 0) {
        assign(number, entry, names);
      } else if (!blockNumbers.empty()) {  // none: no row of the mesh could be read, which is said already
        mistakes.add(names.place(), "the mesh " + meshFile + " has no block \"" + name +
                                        "\"; it has: " + namesOf(blockNumbers, points));
      }
    }
  }
  std::vector<int> withoutEntry;
  for (const int number : blockNumbers)
    if (entries.count(number) == 0) withoutEntry.push_back(number);
  if (entryOfOthers)
    for (const int number : withoutEntry) entries.emplace(number, entryOfOthers);
  else if (!withoutEntry.empty())
    mistakes.add(deck["Blocks"] ? deck["Blocks"].keyPlace() : deck.fileName(),
                 "no entry of Blocks gives a material and a horizon to " + namesOf(withoutEntry, points) +
                     " of the mesh " + meshFile + "; name them in Block Names, or use \"default\"");
  return entries;
}

std::vector<double> pointHorizons(const MeshPoints& points, const std::map<int, DeckNode>& entries,
                                  Mistakes& mistakes) {
  std::vector<double> horizon(points.volume.size());
  std::map<int, Function> functions;
  std::set<int> refused;  // blocks with a mistake already; one a block is enough
  for (const auto& [number, entry] : entries) {
    const std::size_t before = mistakes.lines().size();
    functions.emplace(number, horizonOf(entry, mistakes));
    if (mistakes.lines().size() > before) refused.insert(number);
  }
  const BoundingBox box = boundingBox(points);
  const double longest = box.diagonal() > 0.0 ? mostBodies * box.diagonal() : largestHorizon;
  for (int i = 0; i < points.size(); ++i) {
    const int block = points.blockId[i];
    const auto function = functions.find(block);
    if (function == functions.end()) continue;
    const double* x = points.at(i);
    const double value = function->second(x[0], x[1], x[2], 0.0);
    horizon[i] = value;
    if ((value > 0.0 && value < std::min(longest, largestHorizon)) || !refused.insert(block).second) continue;
    const std::string place = entries.at(block)["Horizon"].place();
    if (value > longest)
      mistakes.add(place,
                   fmt::format("the horizon of {:g} m at the point of {} reaches far beyond the mesh, which spans "
                               "{} m; horizons are usually 3 to 6 spacings of points",
                               value, points.place(i), box.text()));
    else
      mistakes.add(place, fmt::format("the horizon must be greater than 0 and finite; it is {:g} m at the point of {}",
                                      value, points.place(i)));
  }
  return horizon;
}

kernels::HorizonShape horizonShape(const Deck& deck, const std::map<int, DeckNode>& entries) {
  kernels::HorizonShape shape;
  std::string keys;
  bool isFirst = true;
  std::vector<DeckNode> materials;
  for (const auto& item : entries)
    for (const DeckNode& name : item.second["Material"].each())
      for (const DeckNode& part : materialParts(deck["Materials"][name.text()])) materials.push_back(part);
  for (const DeckNode& material : materials) {
    const DeckNode axes = material["Horizon Axes"];
    std::string own;
    for (const char* key : {"Horizon Axes", "Horizon Rotation"})
      for (const double number : numbersOf(material[key])) own += fmt::format("{} {} ", key, number);
    if (axes) own += material.text("Horizon Shape", "Ellipsoid");
    if (!isFirst && own != keys)
      deck.mistakes().add(material.place(), material.path() +
                                                ": all blocks need the same Horizon Axes, Rotation and Shape, since "
                                                "neighbourhoods must be of one kind; give them to every material");
    keys = own;
    isFirst = false;
    try {
      if (axes)
        shape = kernels::HorizonShape(numbersOf(axes), numbersOf(material["Horizon Rotation"]),
                                      material.text("Horizon Shape", "Ellipsoid") == "Box");
    } catch (const std::invalid_argument& error) {
      deck.mistakes().add(axes.place(), axes.path() + ": " + error.what());
    }
  }
  return shape;
}

}  // namespace pd
