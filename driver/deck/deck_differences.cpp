#include "deck_differences.hpp"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <set>

namespace pd {

namespace {

bool isOfModel(const std::string& path) {
  const std::string section = path.substr(0, path.find('/'));
  const auto contains = [&](const char* word) { return section.find(word) != std::string::npos; };
  return !contains("Solver") && !contains("Output") && section != "Compute Class Parameters" &&
         section != "Exact Solution";
}

std::string textOf(const YAML::Node& node) {
  if (!node || node.IsNull()) return "nothing";
  if (node.IsMap()) return "a section";
  if (node.IsScalar()) return node.Scalar();
  return YAML::Dump(node);
}

class Comparison {
 public:
  void compare(const YAML::Node& now, const YAML::Node& before, const std::string& path) {
    if (!now.IsMap() || !before.IsMap()) {
      if (textOf(now) != textOf(before)) add(path, textOf(now), textOf(before));
      return;
    }
    std::set<std::string> seen;
    for (const auto& entry : now) {
      const auto key = entry.first.as<std::string>();
      seen.insert(key);
      if (const YAML::Node other = before[key])
        compare(entry.second, other, joined(path, key));
      else
        add(joined(path, key), textOf(entry.second), "nothing");
    }
    for (const auto& entry : before)
      if (const auto key = entry.first.as<std::string>(); seen.count(key) == 0)
        add(joined(path, key), "nothing", textOf(entry.second));
  }
  std::vector<DeckDifference> take() { return std::move(found_); }

 private:
  static std::string joined(const std::string& path, const std::string& key) {
    return path.empty() ? key : path + "/" + key;
  }
  void add(const std::string& path, const std::string& now, const std::string& before) {
    found_.push_back({path, now, before, isOfModel(path)});
  }
  std::vector<DeckDifference> found_;
};

/// Without the root key of decks of Peridigm.
YAML::Node deckOf(const std::string& text) {
  const YAML::Node root = YAML::Load(text);
  return root.IsMap() && root.size() == 1 && root["Peridigm"] ? root["Peridigm"] : root;
}

}  // namespace

std::vector<DeckDifference> deckDifferences(const std::string& now, const std::string& before) {
  Comparison comparison;
  comparison.compare(deckOf(now), deckOf(before), "");
  return comparison.take();
}

}  // namespace pd
