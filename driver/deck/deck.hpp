// A deck: a tree of values from YAML or XML that know their place in the file, checked against the declarations of the
// plug-ins.
#ifndef PD_DECK_HPP
#define PD_DECK_HPP

#include <Teuchos_ParameterList.hpp>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "../../materials/registry/parameters.hpp"

namespace pd {

/// One value of a deck. A light handle; copies refer to the same tree.
class DeckNode {
 public:
  DeckNode() = default;
  bool exists() const { return data_ != nullptr; }
  explicit operator bool() const { return exists(); }

  bool isMap() const;  ///< a key without a value counts as an empty map
  bool isSequence() const;
  bool isScalar() const;
  bool isQuoted() const;  ///< a scalar in quotes, or a block of text; in XML a string
  /// The type that XML gives a scalar: "int", "double", "bool" or "string"; empty in YAML.
  std::string xmlType() const;

  bool isPeridigms() const;  ///< of a deck of Peridigm

  /// The entry of a map; a node that does not exist where there is none.
  DeckNode operator[](const std::string& key) const;
  /// Entries of a map in the order of the file: (key, value).
  std::vector<std::pair<std::string, DeckNode>> entries() const;
  std::vector<DeckNode> items() const;
  /// The items of a list, or the value itself; those that are scalars.
  std::vector<DeckNode> each() const;

  /// "plate.yaml:12:5" of the value ("plate.xml:12" in XML); keyPlace() of its key.
  std::string place() const;
  std::string keyPlace() const;
  /// "Blocks/My Block/Horizon".
  std::string path() const;
  /// From now on this entry is not there for anybody.
  void ignore() const;
  /// From now on this scalar is the number, for everybody: "3 GPa" was written for it.
  void becomes(const std::string& number) const;

  // Typed values; throw DeckError naming place, path and what was expected.
  double real() const;  ///< accepts an integer
  int integer() const;
  bool flag() const;
  std::string text() const;
  double real(const std::string& key, double fallback) const;
  int integer(const std::string& key, int fallback) const;
  bool flag(const std::string& key, bool fallback) const;
  std::string text(const std::string& key, const std::string& fallback) const;

  /// The map as a Teuchos list (int, double, bool, string, arrays, sub-lists), types converted to what `declarations`
  /// asks for, defaults filled in. Functions are handed over as text; one that is given as a table is left out (read
  /// it by Function::fromDeck). The keys that name a plug-in pass, and the horizon that the driver adds to a material
  /// is not missed. Mistakes throw DeckError with all of them.
  Teuchos::ParameterList parameters(const ParameterDeclarations& declarations) const;

  struct Data;
  explicit DeckNode(std::shared_ptr<const Data> data) : data_(std::move(data)) {}

 private:
  std::shared_ptr<const Data> data_;
};

/// What a user did wrong. what(): one "place: message" a line. pdrun exits with code 2.
class DeckError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The entry `key` of a section. Throws DeckError where there is none.
DeckNode required(const DeckNode& section, const std::string& key);

/// Mistakes found so far; thrown together.
class Mistakes {
 public:
  void add(const std::string& place, const std::string& message);
  bool empty() const { return lines_.empty(); }
  const std::vector<std::string>& lines() const { return lines_; }
  /// Throws DeckError with all lines, if there are any.
  void report() const;
  /// Puts the lines that name a place in `fileName` in the order of the file, before all others.
  void sort(const std::string& fileName);

 private:
  std::vector<std::string> lines_;
};

/// What a key is that neither we nor Peridigm know, in a deck of Peridigm. In decks of our own it is a mistake.
enum class UnknownKeys { AreMistakes, AreWarnings };

class Deck {
 public:
  /// Reads the file, XML where its name ends in ".xml" and YAML else, applies overrides of the form
  /// "Solver/Final Time=1.0" (value in YAML), and removes one root key "Peridigm" where there is one. A deck of
  /// Peridigm is brought into our own form (driver/deck/peridigm_deck.hpp), with its mistakes and warnings. Throws
  /// DeckError on a file that cannot be read.
  static Deck read(const std::string& fileName, const std::vector<std::string>& overrides = {},
                   UnknownKeys unknownKeys = UnknownKeys::AreMistakes);

  DeckNode root() const { return root_; }
  DeckNode operator[](const std::string& section) const { return root_[section]; }
  std::string fileName() const { return fileName_; }
  /// Folder of the deck; relative file names in it start here. Those in a deck of Peridigm, which takes them from the
  /// working folder, start there where the deck's folder has no such file.
  std::string directory() const;
  std::string resolvePath(const std::string& fileName) const;
  /// Whether the deck is in XML or has the root key `Peridigm`: then Peridigm's defaults hold
  /// (driver/deck/sections.hpp).
  bool isPeridigmDeck() const { return isPeridigmDeck_; }
  Mistakes& mistakes() const { return *mistakes_; }
  /// Whether unknown keys are reported by warnings() and ignored.
  bool isLenient() const { return isLenient_; }
  /// What a run puts up with but its user should know.
  Mistakes& warnings() const { return *warnings_; }

 private:
  DeckNode root_;
  std::string fileName_;
  bool isPeridigmDeck_ = false, isLenient_ = false;
  std::shared_ptr<Mistakes> mistakes_ = std::make_shared<Mistakes>();
  std::shared_ptr<Mistakes> warnings_ = std::make_shared<Mistakes>();
};

}  // namespace pd

#endif
