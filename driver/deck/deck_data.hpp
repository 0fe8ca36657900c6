// The tree behind DeckNode. Private to this folder.
#ifndef PD_DECK_DATA_HPP
#define PD_DECK_DATA_HPP

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "deck.hpp"

namespace pd {

struct DeckNode::Data {
  enum class Kind { Null, Scalar, Sequence, Map };

  Kind kind = Kind::Null;
  mutable std::string scalar;  ///< a number with a unit becomes one in the unit of its key
  mutable bool isQuoted = false;
  std::string xmlType;                        ///< "int", "double", "bool" or "string" in XML; empty in YAML
  std::shared_ptr<const std::string> source;  ///< file name, or the text of the override
  int line = 0, column = 0;                   ///< from 1; 0 where they are not known (overrides; columns in XML)
  int keyLine = 0, keyColumn = 0;
  std::string path;
  bool isPeridigms = false;        ///< of a deck of Peridigm
  mutable bool isIgnored = false;  ///< an unknown key that its user was warned of; DeckNode does not show it
  std::vector<std::pair<std::string, std::shared_ptr<Data>>> entries;
  std::vector<std::shared_ptr<Data>> items;

  std::string placeOf(int atLine, int atColumn) const;
  Data* entry(const std::string& key) const;
  std::shared_ptr<Data> deepCopy() const;
  /// Sets the paths of this value and of everything below it.
  void setPath(const std::string& newPath);
  /// Marks this value and everything below it as Peridigm's.
  void setPeridigms();
};

/// The tree of a YAML text. `source` names it in messages; with `hasLines` they add line and column. Throws DeckError
/// with all duplicate keys and the syntax error, if there is one.
std::shared_ptr<DeckNode::Data> readYaml(const std::string& text, const std::string& source, bool hasLines);

/// The tree of an XML text: a Teuchos parameter list, `int`, `double`, `bool` and `string` checked against the values.
/// Nothing for a text without elements. Throws DeckError with all mistakes, by line.
std::shared_ptr<DeckNode::Data> readXml(const std::string& text, const std::string& source);

/// At most 60 characters of a text, for a message.
std::string shortened(const std::string& text);

/// A finite decimal number written as in C, or nothing.
std::optional<double> parseReal(const std::string& text);
/// The shortest text, with a point or an exponent, that parseReal() reads as this finite number.
std::string realText(double value);
std::optional<int> parseInteger(const std::string& text);
std::optional<bool> parseFlag(const std::string& text);

}  // namespace pd

#endif
