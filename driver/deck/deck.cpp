#include "deck.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>

#include "deck_data.hpp"
#include "peridigm_deck.hpp"

namespace pd {

using NodeKind = DeckNode::Data::Kind;

// ---- values ----

std::optional<double> parseReal(const std::string& text) {
  const bool hasPlus = !text.empty() && text[0] == '+';
  const char* begin = text.data() + (hasPlus ? 1 : 0);
  const char* end = text.data() + text.size();
  if (hasPlus && begin != end && *begin == '-') return std::nullopt;
  double value = 0.0;
  const auto [last, error] = std::from_chars(begin, end, value);
  if (error == std::errc::result_out_of_range && last == end) {
    // Too small is zero to a double; too large is no number.
    value = std::strtod(text.c_str(), nullptr);
  } else if (error != std::errc() || last != end) {
    return std::nullopt;
  }
  if (!std::isfinite(value)) return std::nullopt;
  return value;
}

std::string realText(double value) {
  std::string text = fmt::format("{}", value);
  if (text.find_first_of(".e") == std::string::npos) text += ".0";
  return text;
}

std::optional<int> parseInteger(const std::string& text) {
  const std::size_t skip = text.size() > 1 && text[0] == '+' && text[1] != '-' ? 1 : 0;
  int value = 0;
  const auto [last, error] = std::from_chars(text.data() + skip, text.data() + text.size(), value);
  if (error != std::errc() || last != text.data() + text.size()) return std::nullopt;
  return value;
}

std::string shortened(const std::string& text) { return text.size() > 60 ? text.substr(0, 57) + "..." : text; }

std::optional<bool> parseFlag(const std::string& text) {
  for (const char* word : {"true", "True", "TRUE", "yes", "Yes", "on", "On"})
    if (text == word) return true;
  for (const char* word : {"false", "False", "FALSE", "no", "No", "off", "Off"})
    if (text == word) return false;
  return std::nullopt;
}

// ---- tree ----

std::string DeckNode::Data::placeOf(int atLine, int atColumn) const {
  if (atLine == 0) return *source;
  return *source + ":" + std::to_string(atLine) + (atColumn == 0 ? "" : ":" + std::to_string(atColumn));
}

DeckNode::Data* DeckNode::Data::entry(const std::string& key) const {
  for (const auto& [name, value] : entries)
    if (name == key) return value.get();
  return nullptr;
}

std::shared_ptr<DeckNode::Data> DeckNode::Data::deepCopy() const {
  auto copy = std::make_shared<Data>(*this);
  for (auto& child : copy->entries) child.second = child.second->deepCopy();
  for (auto& item : copy->items) item = item->deepCopy();
  return copy;
}

void DeckNode::Data::setPath(const std::string& newPath) {
  path = newPath;
  for (auto& [name, value] : entries) value->setPath(path.empty() ? name : path + "/" + name);
  for (std::size_t i = 0; i < items.size(); ++i) items[i]->setPath(path + "[" + std::to_string(i + 1) + "]");
}

void DeckNode::Data::setPeridigms() {
  isPeridigms = true;
  for (auto& entry : entries) entry.second->setPeridigms();
  for (auto& item : items) item->setPeridigms();
}

namespace {

/// `"abc"`, "a list", ... as a user would call the value in a message.
std::string shown(const DeckNode::Data& node) {
  switch (node.kind) {
    case NodeKind::Null:
      return "nothing";
    case NodeKind::Sequence:
      return "a list";
    case NodeKind::Map:
      return "a section";
    case NodeKind::Scalar:
      break;
  }
  return (node.xmlType.empty() ? "" : "the " + node.xmlType + " ") + "\"" + shortened(node.scalar) + "\"";
}

[[noreturn]] void refuse(const DeckNode::Data& node, const std::string& expected) {
  throw DeckError(node.placeOf(node.line, node.column) + ": " + node.path + " must be " + expected + ", not " +
                  shown(node));
}

const DeckNode::Data& checked(const std::shared_ptr<const DeckNode::Data>& data) {
  if (!data) throw std::logic_error("a deck value was read that does not exist");
  return *data;
}

}  // namespace

DeckNode required(const DeckNode& section, const std::string& key) {
  const DeckNode value = section[key];
  if (!value) throw DeckError(section.place() + ": " + section.path() + " needs " + key);
  return value;
}

bool DeckNode::isMap() const { return data_ && (data_->kind == NodeKind::Map || data_->kind == NodeKind::Null); }
bool DeckNode::isSequence() const { return data_ && data_->kind == NodeKind::Sequence; }
bool DeckNode::isScalar() const { return data_ && data_->kind == NodeKind::Scalar; }
bool DeckNode::isQuoted() const { return data_ && data_->isQuoted; }
bool DeckNode::isPeridigms() const { return data_ && data_->isPeridigms; }
std::string DeckNode::xmlType() const { return data_ ? data_->xmlType : ""; }

DeckNode DeckNode::operator[](const std::string& key) const {
  if (!data_) return {};
  for (const auto& [name, value] : data_->entries)
    if (name == key && !value->isIgnored) return DeckNode(value);
  return {};
}

std::vector<std::pair<std::string, DeckNode>> DeckNode::entries() const {
  std::vector<std::pair<std::string, DeckNode>> result;
  if (data_)
    for (const auto& [name, value] : data_->entries)
      if (!value->isIgnored) result.emplace_back(name, DeckNode(value));
  return result;
}

std::vector<DeckNode> DeckNode::items() const {
  std::vector<DeckNode> result;
  if (data_)
    for (const auto& item : data_->items) result.emplace_back(item);
  return result;
}

std::vector<DeckNode> DeckNode::each() const {
  std::vector<DeckNode> result = isScalar() ? std::vector<DeckNode>{*this} : items();
  result.erase(std::remove_if(result.begin(), result.end(), [](const DeckNode& item) { return !item.isScalar(); }),
               result.end());
  return result;
}

std::string DeckNode::place() const { return data_ ? data_->placeOf(data_->line, data_->column) : ""; }
std::string DeckNode::keyPlace() const { return data_ ? data_->placeOf(data_->keyLine, data_->keyColumn) : ""; }
std::string DeckNode::path() const { return data_ ? data_->path : ""; }
void DeckNode::ignore() const { checked(data_).isIgnored = true; }
void DeckNode::becomes(const std::string& number) const {
  checked(data_).scalar = number;
  data_->isQuoted = false;
}

double DeckNode::real() const {
  const Data& node = checked(data_);
  const auto value = node.kind == NodeKind::Scalar && !node.isQuoted ? parseReal(node.scalar) : std::nullopt;
  if (!value) refuse(node, "a finite number");
  return *value;
}

int DeckNode::integer() const {
  const Data& node = checked(data_);
  const auto value = node.kind == NodeKind::Scalar && !node.isQuoted ? parseInteger(node.scalar) : std::nullopt;
  if (!value) refuse(node, "an integer");
  return *value;
}

bool DeckNode::flag() const {
  const Data& node = checked(data_);
  const auto value = node.kind == NodeKind::Scalar && !node.isQuoted ? parseFlag(node.scalar) : std::nullopt;
  if (!value) refuse(node, "true or false");
  return *value;
}

std::string DeckNode::text() const {
  const Data& node = checked(data_);
  if (node.kind != NodeKind::Scalar) refuse(node, "text");
  return node.scalar;
}

double DeckNode::real(const std::string& key, double fallback) const {
  const DeckNode value = (*this)[key];
  return value ? value.real() : fallback;
}
int DeckNode::integer(const std::string& key, int fallback) const {
  const DeckNode value = (*this)[key];
  return value ? value.integer() : fallback;
}
bool DeckNode::flag(const std::string& key, bool fallback) const {
  const DeckNode value = (*this)[key];
  return value ? value.flag() : fallback;
}
std::string DeckNode::text(const std::string& key, const std::string& fallback) const {
  const DeckNode value = (*this)[key];
  return value ? value.text() : fallback;
}

// ---- mistakes ----

void Mistakes::add(const std::string& place, const std::string& message) {
  std::string line = place.empty() ? message : place + ": " + message;
  constexpr std::size_t longestLine = 5000;  // what the deck is quoted with may be of any length
  if (line.size() > longestLine && line.find('\n') == std::string::npos) line = line.substr(0, longestLine) + "...";
  if (std::find(lines_.begin(), lines_.end(), line) == lines_.end()) lines_.push_back(line);
}

void Mistakes::report() const {
  if (lines_.empty()) return;
  std::string all;
  for (const std::string& line : lines_) all += (all.empty() ? "" : "\n") + line;
  throw DeckError(all);
}

void Mistakes::sort(const std::string& fileName) {
  const auto lineOf = [&](const std::string& text) {
    int line = std::numeric_limits<int>::max(), column = line;
    if (text.compare(0, fileName.size() + 1, fileName + ":") == 0)
      if (std::sscanf(text.c_str() + fileName.size() + 1, "%d:%d", &line, &column) == 0)
        line = column = std::numeric_limits<int>::max();
    return std::make_pair(line, column);
  };
  std::stable_sort(lines_.begin(), lines_.end(),
                   [&](const std::string& a, const std::string& b) { return lineOf(a) < lineOf(b); });
}

// ---- deck ----

namespace {

std::string readFile(const std::string& fileName) {
  std::error_code error;
  if (std::filesystem::is_directory(fileName, error))
    throw DeckError(fileName + ": is a folder; name the deck file in it");
  errno = 0;
  std::ifstream file(fileName, std::ios::binary);
  if (!file)
    throw DeckError(fileName + ": cannot be read (" +
                    (errno == 0 ? std::string("unknown reason") : std::strerror(errno)) + ")");
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

std::vector<std::string> splitPath(const std::string& path) {
  std::vector<std::string> parts;
  std::istringstream stream(path);
  for (std::string part; std::getline(stream, part, '/');) parts.push_back(part);
  return parts;
}

/// The entry `name` of `parent`. Where there is none: DeckError with the nearest name.
DeckNode::Data* requireEntry(const DeckNode::Data& parent, const std::string& name, const std::string& source) {
  if (DeckNode::Data* child = parent.entry(name)) return child;
  std::vector<std::string> known;
  std::string list;
  for (const auto& entry : parent.entries) {
    known.push_back(entry.first);
    list += (list.empty() ? "\"" : ", \"") + entry.first + "\"";
  }
  const std::string nearest = nearestWord(name, known);
  throw DeckError(source + ": the deck has no \"" + name + "\" in " +
                  (parent.path.empty() ? "its top level" : parent.path) +
                  (nearest.empty() ? " (it has: " + list + ")" : " (did you mean \"" + nearest + "\"?)"));
}

void applyOverride(DeckNode::Data& root, const std::string& text) {
  const std::string source = "--set \"" + text + "\"";
  const std::size_t equals = text.find('=');
  std::vector<std::string> parts = splitPath(text.substr(0, equals));
  const bool hasEmptyPart = std::find(parts.begin(), parts.end(), "") != parts.end();
  if (equals == std::string::npos || parts.empty() || hasEmptyPart)
    throw DeckError(source + ": write it as path=value, as in --set \"Solver/Final Time=1.0\"");
  auto value = readYaml(text.substr(equals + 1), source, false);
  if (!value || value->kind == NodeKind::Null) throw DeckError(source + ": there is no value after \"=\"");

  if (parts.size() > 1 && parts.front() == "Peridigm") parts.erase(parts.begin());
  DeckNode::Data* parent = &root;
  for (std::size_t i = 0; i + 1 < parts.size(); ++i) parent = requireEntry(*parent, parts[i], source);
  if (parent->kind == NodeKind::Scalar || parent->kind == NodeKind::Sequence)
    throw DeckError(source + ": " + parent->path + " is a value, not a section; set it itself");
  parent->kind = NodeKind::Map;
  for (auto& entry : parent->entries)
    if (entry.first == parts.back()) {
      entry.second = value;
      return;
    }
  parent->entries.emplace_back(parts.back(), value);
}

}  // namespace

Deck Deck::read(const std::string& fileName, const std::vector<std::string>& overrides, UnknownKeys unknownKeys) {
  const bool isXml = std::filesystem::path(fileName).extension() == ".xml";
  const std::string text = readFile(fileName);
  std::shared_ptr<DeckNode::Data> root = isXml ? readXml(text, fileName) : readYaml(text, fileName, true);
  if (!root || root->kind == NodeKind::Null) throw DeckError(fileName + ": is empty");
  if (root->kind != NodeKind::Map)
    throw DeckError(root->placeOf(root->line, root->column) +
                    ": a deck is a list of sections, as in \"Solver:\" with its keys indented below it");
  Deck deck;
  deck.fileName_ = fileName;
  deck.isPeridigmDeck_ = isXml;
  if (root->entries.size() == 1 && root->entries.front().first == "Peridigm") {
    deck.isPeridigmDeck_ = true;
    root = root->entries.front().second;
    if (root->kind != NodeKind::Map)
      throw DeckError(root->placeOf(root->line, root->column) + ": Peridigm must hold the sections of the deck");
  }
  root->setPath("");
  Mistakes mistakes;
  for (const std::string& change : overrides) try {
      applyOverride(*root, change);
      root->setPath("");
    } catch (const DeckError& error) {
      mistakes.add("", error.what());
    }
  mistakes.report();
  if (deck.isPeridigmDeck_) {
    deck.isLenient_ = unknownKeys == UnknownKeys::AreWarnings;
    translatePeridigmDeck(*root, *deck.mistakes_, *deck.warnings_);
  }
  deck.root_ = DeckNode(root);
  return deck;
}

std::string Deck::directory() const {
  const std::string folder = std::filesystem::path(fileName_).parent_path().string();
  return folder.empty() ? "." : folder;
}

std::string Deck::resolvePath(const std::string& fileName) const {
  const std::filesystem::path path(fileName);
  if (path.is_absolute()) return fileName;
  const std::string here = (std::filesystem::path(directory()) / path).lexically_normal().string();
  std::error_code error;
  const bool isInWorkingFolder =
      isPeridigmDeck_ && !std::filesystem::exists(here, error) && std::filesystem::exists(path, error);
  return isInWorkingFolder ? path.lexically_normal().string() : here;
}

}  // namespace pd
