// Names in a deck that refer to other parts of it, or to files.
#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <sstream>

#include "check_deck.hpp"
#include "deck_data.hpp"
#include "sections.hpp"

namespace pd {

namespace {

using Kind = DeckSection::Kind;

class ReferenceCheck {
 public:
  explicit ReferenceCheck(const DeckUnderCheck& check)
      : check_(check), deck_(check.deck), mistakes_(deck_.mistakes()) {}

  void run() {
    blocks();
    warnOfUnused("Materials", "Material");
    warnOfUnused("Damage Models", "Damage Model");
    nodeSets();
    const DeckNode meshType = deck_["Discretization"]["Type"];
    // The mesh has node sets and names of blocks of its own, which are known once it is read.
    const bool meshHasNames = meshType.isScalar() && meshType.text() == "Exodus";
    if (!meshHasNames) nodeSetNames();
    if (!meshHasNames && owners_.count("default") == 0) blockNames();
    blocksOfMaterials();
    fileExists(deck_["Discretization"]["Input Mesh File"]);
    for (const Kind kind : {Kind::BondFilter, Kind::Void})
      for (const CheckedSection* section : check_.ofKind(kind)) fileExists(section->section.node["File Name"]);
  }

 private:
  void blocks() {
    for (const CheckedSection* block : check_.ofKind(Kind::Block)) {
      const DeckNode& node = block->section.node;
      refersTo(node["Material"], "Materials");
      if (!hasNone(node)) refersTo(node["Damage Model"], "Damage Models");
      if (!node["Block Names"].isScalar()) continue;
      std::istringstream names(node["Block Names"].text());
      for (std::string name; names >> name;) {
        const auto [it, isNew] = owners_.emplace(name, node);
        if (!isNew)
          mistakes_.add(node["Block Names"].place(),
                        name + " is named in " + it->second.path() + " already; a block of the mesh has one entry");
      }
    }
  }

  /// A name or a list of them.
  void refersTo(const DeckNode& names, const std::string& section) {
    std::vector<std::string> known;
    for (const auto& entry : deck_[section].entries()) known.push_back(entry.first);
    if (names.isSequence() && names.items().empty())
      mistakes_.add(names.place(), names.path() + " is empty; name an entry of " + section);
    for (const DeckNode& value : names.each()) {
      if (std::find(known.begin(), known.end(), value.text()) != known.end()) continue;
      mistakes_.add(value.place(), value.path() + ": there is no \"" + value.text() + "\" in " + section +
                                       didYouMean(value.text(), known) +
                                       (known.empty() ? "; it is empty" : "; there are: " + quotedList(known)));
    }
  }

  void warnOfUnused(const std::string& section, const std::string& key) {
    for (const auto& [name, node] : deck_[section].entries()) {
      bool isUsed = false;
      for (const CheckedSection* block : check_.ofKind(Kind::Block)) {
        for (const DeckNode& value : block->section.node[key].each()) isUsed = isUsed || value.text() == name;
      }
      if (!isUsed) deck_.warnings().add(node.keyPlace(), node.path() + " is used by no block");
    }
  }

  void nodeSets() {
    for (const auto& [name, node] : deck_["Boundary Conditions"].entries()) {
      if (!isNodeSetName(name) || node["Type"]) continue;
      const std::string plain = plainName(name);
      if (std::find(plainSetNames_.begin(), plainSetNames_.end(), plain) != plainSetNames_.end())
        mistakes_.add(node.keyPlace(), "another node set is called \"" + name +
                                           "\" too (case, blanks and underscores are not told apart); rename one");
      setNames_.push_back(name);
      plainSetNames_.push_back(plain);
      if (node.isSequence()) nodeNumbers(node);
      if (!node.isScalar()) {
        if (node.isMap() && node.entries().empty())
          mistakes_.add(node.keyPlace(), node.path() + " needs node numbers, a file of them, a Box or an Expression");
        continue;
      }
      std::istringstream words(node.text());
      std::string first;
      words >> first;
      if (first.empty())
        mistakes_.add(node.place(),
                      node.path() + " is empty; give node numbers (from 1), a file, a Box or an Expression");
      else if (!parseInteger(first))
        fileExists(node);
    }
  }

  void nodeNumbers(const DeckNode& node) {
    for (const DeckNode& item : node.items()) {
      const auto number = item.isScalar() ? parseInteger(item.text()) : std::nullopt;
      if (!number || *number < 1) mistakes_.add(item.place(), item.path() + " must be a node number (from 1)");
    }
  }

  void nodeSetNames() {
    for (const DeckNode& value : namesOf(deck_, "Node Set")) {
      if (std::find(plainSetNames_.begin(), plainSetNames_.end(), plainName(value.text())) != plainSetNames_.end())
        continue;
      mistakes_.add(value.place(),
                    value.path() + ": there is no node set \"" + value.text() + "\" in Boundary Conditions" +
                        didYouMean(value.text(), setNames_) +
                        (setNames_.empty() ? "; there are none" : "; there are: " + quotedList(setNames_)));
    }
  }

  void blockNames() {
    std::vector<std::string> known;
    for (const auto& owner : owners_) known.push_back(owner.first);
    for (const DeckNode& value : namesOf(deck_, "Block"))
      if (owners_.count(value.text()) == 0)
        mistakes_.add(value.place(), value.path() + ": there is no block \"" + value.text() + "\"" +
                                         didYouMean(value.text(), known) + "; there are: " + quotedList(known));
  }

  /// A material that names a block has it.
  void blocksOfMaterials() {
    for (const DeckNode& value : namesOf(deck_, "Block")) {
      const auto owner = owners_.find(value.text());
      if (owner == owners_.end() || value.path().rfind("Materials/", 0) != 0) continue;
      const std::vector<DeckNode> materials = owner->second["Material"].each();
      const bool isOwn = std::any_of(materials.begin(), materials.end(), [&](const DeckNode& material) {
        return value.path().rfind("Materials/" + material.text() + "/", 0) == 0;
      });
      if (!isOwn)
        mistakes_.add(value.place(), value.path() + ": \"" + value.text() + "\" is a block of " + owner->second.path() +
                                         ", which has another material");
    }
  }

  void fileExists(const DeckNode& value) {
    if (!value.isScalar()) return;
    const std::string name = deck_.resolvePath(value.text());
    std::error_code error;
    if (std::filesystem::is_regular_file(name, error)) return;
    const bool isFolder = std::filesystem::is_directory(name, error);
    mistakes_.add(value.place(),
                  value.path() + ": " +
                      (isFolder ? "\"" + name + "\" is a folder, not a file" : "there is no file \"" + name + "\"") +
                      " (names start at the folder of the deck)");
  }

  const DeckUnderCheck& check_;
  const Deck& deck_;
  Mistakes& mistakes_;
  std::map<std::string, DeckNode> owners_;  ///< entries of Blocks by names of blocks
  std::vector<std::string> setNames_, plainSetNames_;
};

}  // namespace

void checkReferences(const DeckUnderCheck& check) { ReferenceCheck(check).run(); }

}  // namespace pd
