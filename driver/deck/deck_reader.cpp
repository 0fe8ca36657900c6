// YAML text to the tree of a deck, by the events of yaml-cpp: they know the place of every key and value, and leave
// aliases to us, so that a deck can neither refer to itself nor blow up.
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/parser.h>

#include <map>
#include <sstream>

#include "deck_data.hpp"

namespace pd {

namespace {

using Data = DeckNode::Data;

constexpr int maximumValues = 200000;  // a deck is written by hand; more than this comes from aliases of aliases

int countValues(const Data& node) {
  int count = 1;
  for (const auto& entry : node.entries) count += countValues(*entry.second);
  for (const auto& item : node.items) count += countValues(*item);
  return count;
}

class TreeBuilder : public YAML::EventHandler {
 public:
  TreeBuilder(std::string source, bool hasLines)
      : source_(std::make_shared<const std::string>(std::move(source))), hasLines_(hasLines) {}

  std::shared_ptr<Data> root() const { return root_; }
  Mistakes& mistakes() { return mistakes_; }

  void OnDocumentStart(const YAML::Mark&) override {}
  void OnDocumentEnd() override {}

  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override { finish(make(mark, Data::Kind::Null), anchor); }

  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                const std::string& value) override {
    auto node = make(mark, Data::Kind::Scalar);
    node->scalar = value;
    node->isQuoted = tag == "!";
    finish(node, anchor);
  }

  void OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    const auto it = anchors_.find(anchor);
    if (it == anchors_.end()) {
      mistakes_.add(place(mark), "this alias refers to a value that contains it");
      attach(make(mark, Data::Kind::Null));
      return;
    }
    nValues_ += countValues(*it->second);
    if (nValues_ > maximumValues) {
      mistakes_.add(place(mark), "aliases expand to more than " + std::to_string(maximumValues) + " values");
      mistakes_.report();
    }
    attach(it->second->deepCopy());
  }

  void OnSequenceStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value) override {
    open(make(mark, Data::Kind::Sequence), anchor);
  }
  void OnMapStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value) override {
    open(make(mark, Data::Kind::Map), anchor);
  }
  void OnSequenceEnd() override { close(); }
  void OnMapEnd() override { close(); }

 private:
  struct Open {
    std::shared_ptr<Data> node;
    YAML::anchor_t anchor = YAML::NullAnchor;
    bool hasKey = false;  ///< of a map: the key is read, its value comes next
    bool keepsValue = true;
    std::string key;
    int keyLine = 0, keyColumn = 0;
  };

  std::string place(const YAML::Mark& mark) const {
    return hasLines_ ? *source_ + ":" + std::to_string(mark.line + 1) + ":" + std::to_string(mark.column + 1)
                     : *source_;
  }

  std::shared_ptr<Data> make(const YAML::Mark& mark, Data::Kind kind) {
    auto node = std::make_shared<Data>();
    node->kind = kind;
    node->source = source_;
    if (hasLines_) {
      node->line = node->keyLine = mark.line + 1;
      node->column = node->keyColumn = mark.column + 1;
    }
    ++nValues_;
    return node;
  }

  void finish(const std::shared_ptr<Data>& node, YAML::anchor_t anchor) {
    attach(node);
    if (anchor != YAML::NullAnchor) anchors_[anchor] = node;
  }
  void open(const std::shared_ptr<Data>& node, YAML::anchor_t anchor) {
    attach(node);
    Open level;
    level.node = node;
    level.anchor = anchor;
    open_.push_back(std::move(level));
  }
  void close() {
    if (open_.back().anchor != YAML::NullAnchor) anchors_[open_.back().anchor] = open_.back().node;
    open_.pop_back();
  }

  void attach(const std::shared_ptr<Data>& node) {
    if (open_.empty()) {
      root_ = node;
    } else if (Open& level = open_.back(); level.node->kind == Data::Kind::Sequence) {
      level.node->items.push_back(node);
    } else if (!level.hasKey) {
      attachKey(level, *node);
    } else {
      level.hasKey = false;
      if (!level.keepsValue) return;
      node->keyLine = level.keyLine;
      node->keyColumn = level.keyColumn;
      if (node->kind == Data::Kind::Null) {  // yaml-cpp places it at whatever comes next
        node->line = level.keyLine;
        node->column = level.keyColumn;
      }
      level.node->entries.emplace_back(level.key, node);
    }
  }

  void attachKey(Open& level, const Data& node) {
    level.hasKey = level.keepsValue = true;
    level.key = node.scalar;
    level.keyLine = node.line;
    level.keyColumn = node.column;
    const std::string keyPlace = node.placeOf(node.line, node.column);
    if (node.kind != Data::Kind::Scalar || node.scalar.empty()) {
      mistakes_.add(keyPlace, "a key must be a name, not a list or nothing");
      level.keepsValue = false;
    } else if (const Data* earlier = level.node->entry(node.scalar)) {
      mistakes_.add(keyPlace, "key \"" + node.scalar + "\" is given twice in the same section" +
                                  (hasLines_ ? " (first in line " + std::to_string(earlier->keyLine) + ")" : "") +
                                  "; remove one of them");
      level.keepsValue = false;
    }
  }

  std::shared_ptr<const std::string> source_;
  bool hasLines_;
  Mistakes mistakes_;
  std::shared_ptr<Data> root_;
  std::vector<Open> open_;
  std::map<YAML::anchor_t, std::shared_ptr<Data>> anchors_;
  int nValues_ = 0;
};

/// Decks of Peridigm write the braces of a function as \\{ and \\} within double quotes, which YAML forbids. A blank in
/// place of the backslash keeps all columns.
std::string withoutEscapedBraces(std::string text) {
  for (std::size_t i = 0; i + 1 < text.size(); ++i) {
    if (text[i] != '\\') continue;
    if (text[i + 1] == '{' || text[i + 1] == '}')
      text[i] = ' ';
    else
      ++i;  // another escaped character, which may itself be a backslash
  }
  return text;
}

/// What a syntax error in this line (from 0) is likely to come from.
std::string syntaxHint(const std::string& text, int line) {
  std::istringstream lines(text);
  std::string content;
  for (int i = 0; i <= line && std::getline(lines, content); ++i) {
  }
  if (content.find('\t') != std::string::npos) return "; the line contains a tab: indent with blanks";
  return "; look at the indentation, colons, quotes and brackets here and just above";
}

}  // namespace

std::shared_ptr<Data> readYaml(const std::string& text, const std::string& source, bool hasLines) {
  TreeBuilder builder(source, hasLines);
  try {
    std::istringstream stream(withoutEscapedBraces(text));
    YAML::Parser parser(stream);
    parser.HandleNextDocument(builder);
    TreeBuilder second(source, hasLines);
    if (parser.HandleNextDocument(second) && second.root() && second.root()->kind != Data::Kind::Null)
      builder.mistakes().add(second.root()->placeOf(second.root()->line, second.root()->column),
                             "a second YAML document starts here; a deck is one document (remove the \"---\")");
  } catch (const YAML::Exception& error) {
    const std::string at = hasLines && !error.mark.is_null()
                               ? ":" + std::to_string(error.mark.line + 1) + ":" + std::to_string(error.mark.column + 1)
                               : "";
    builder.mistakes().add(source + at, "YAML syntax: " + error.msg + syntaxHint(text, error.mark.line));
  }
  builder.mistakes().report();
  return builder.root();
}

}  // namespace pd
