// Names in a deck that refer to other parts of it, or to files.
#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <sstream>

#include "check_deck.hpp"
#include "deck_data.hpp"

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
    for (const CheckedSection& checked : check_.sections) namesOfSets(checked);
    fileExists(deck_["Discretization"]["Input Mesh File"]);
    for (const CheckedSection* filter : check_.ofKind(Kind::BondFilter)) fileExists(filter->section.node["File Name"]);
  }

 private:
  void blocks() {
    std::map<std::string, std::string> owners;
    for (const CheckedSection* block : check_.ofKind(Kind::Block)) {
      const DeckNode& node = block->section.node;
      refersTo(node["Material"], "Materials");
      if (!hasNone(node)) refersTo(node["Damage Model"], "Damage Models");
      if (!node["Block Names"].isScalar()) continue;
      std::istringstream names(node["Block Names"].text());
      for (std::string name; names >> name;) {
        const auto [it, isNew] = owners.emplace(name, node.path());
        if (!isNew)
          mistakes_.add(node["Block Names"].place(),
                        name + " is named in " + it->second + " already; a block of the mesh has one entry");
        blockNames_.push_back(name);
      }
    }
  }

  /// A name or a list of them.
  void refersTo(const DeckNode& names, const std::string& section) {
    std::vector<std::string> known, seen;
    for (const auto& entry : deck_[section].entries()) known.push_back(entry.first);
    if (names.isSequence() && names.items().empty())
      mistakes_.add(names.place(), names.path() + " is empty; name an entry of " + section);
    for (const DeckNode& value : names.each()) {
      if (std::find(seen.begin(), seen.end(), value.text()) != seen.end())
        mistakes_.add(value.place(), value.path() + ": \"" + value.text() + "\" is in the list already");
      seen.push_back(value.text());
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

  void namesOfSets(const CheckedSection& checked) {
    const DeckNode& node = checked.section.node;
    const DeckNode meshType = deck_["Discretization"]["Type"];
    // The mesh has node sets of its own, which are known once it is read.
    const bool meshHasSets = meshType.isScalar() && meshType.text() == "Exodus";
    for (const char* key : {"Node Set", "First Node Set", "Second Node Set"}) {
      const DeckNode value = node[key];
      if (meshHasSets || checked.section.declarations.find(key) == nullptr || !value.isScalar()) continue;
      const std::string plain = plainName(value.text());
      if (std::find(plainSetNames_.begin(), plainSetNames_.end(), plain) != plainSetNames_.end()) continue;
      mistakes_.add(value.place(),
                    value.path() + ": there is no node set \"" + value.text() + "\" in Boundary Conditions" +
                        didYouMean(value.text(), setNames_) +
                        (setNames_.empty() ? "; there are none" : "; there are: " + quotedList(setNames_)));
    }
    const DeckNode block = node["Block"];
    const bool hasDefault = std::find(blockNames_.begin(), blockNames_.end(), "default") != blockNames_.end();
    if (checked.section.declarations.find("Block") == nullptr || !block.isScalar() || hasDefault) return;
    if (std::find(blockNames_.begin(), blockNames_.end(), block.text()) == blockNames_.end())
      mistakes_.add(block.place(), block.path() + ": there is no block \"" + block.text() + "\"" +
                                       didYouMean(block.text(), blockNames_) +
                                       "; there are: " + quotedList(blockNames_));
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
  std::vector<std::string> blockNames_, setNames_, plainSetNames_;
};

}  // namespace

void checkReferences(const DeckUnderCheck& check) { ReferenceCheck(check).run(); }

}  // namespace pd
