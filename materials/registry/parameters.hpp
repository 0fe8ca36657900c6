// Declaration of a plug-in's parameters. One declaration feeds deck checking, `pdrun --explain` and the reference
// pages, and fills the defaults of the parameter list that the plug-in reads.
#ifndef PD_PARAMETERS_HPP
#define PD_PARAMETERS_HPP

#include <Teuchos_ParameterList.hpp>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace pd {

/// Larger values, and smaller ones than its inverse that have a unit, are slips: products of a few given ones with
/// powers of lengths would overflow.
constexpr double largestMeant = 1e100;

enum class ParameterType {
  Real,      ///< double; an integer is accepted
  Integer,   ///< int
  Flag,      ///< bool
  Text,      ///< std::string, limited to `choices` where those are given
  Function,  ///< number or text of a function of `variables`; handed over as std::string
  Reals,     ///< list of numbers; handed over as Teuchos::Array<double>
  Texts,     ///< list of different strings (where mayBeOne: or one); handed over as Teuchos::Array<std::string>
  Functions  ///< list of what a Function is; handed over as Teuchos::Array<std::string>
};

struct Parameter {
  using Value = std::variant<std::monostate, double, int, bool, std::string>;

  std::string name;
  ParameterType type = ParameterType::Real;
  std::string unit;     ///< "Pa", "m", ...; "1" for a pure number; empty for text and flags
  std::string meaning;  ///< one sentence
  std::string source;   ///< where the formula or the value comes from; may be empty
  Value defaultValue;   ///< monostate: none (optional or required)
  bool isRequired = false;
  double lowest = -std::numeric_limits<double>::infinity();
  double highest = std::numeric_limits<double>::infinity();
  bool lowestExcluded = false, highestExcluded = false;
  bool mayBeOne = false;  ///< of Texts: a text alone is a list of it
  std::vector<std::string> choices;
  std::vector<std::string> variables{"x", "y", "z", "t"};  ///< of functions
  std::string field;  ///< label of a field of which it says more, without which it does nothing; may be empty

  // Chained, as in declare.real("Density", "kg/m3", "Mass density.").positive().required();
  Parameter& required();
  Parameter& defaultTo(double value);
  Parameter& defaultTo(int value);
  Parameter& defaultTo(bool value);
  Parameter& defaultTo(const char* value);
  Parameter& positive();
  Parameter& atLeast(double value);
  Parameter& atMost(double value);
  Parameter& between(double low, double high);          ///< both included
  Parameter& strictlyBetween(double low, double high);  ///< both excluded
  Parameter& oneOf(std::vector<std::string> names);
  Parameter& orOne();
  Parameter& of(std::vector<std::string> names);  ///< the variables of a function
  Parameter& from(const char* sourceText);
  Parameter& ofField(const std::string& label);

  /// Whether its functions are of place and time, as conditions have them.
  bool isOfPlaceAndTime() const { return variables == Parameter().variables; }
  /// "> 0 Pa", "in [0, 1]", "one of A, B"; empty where anything goes.
  std::string allowedText() const;
  /// Default as text; empty where there is none.
  std::string defaultText() const;
  /// "a number > 0 Pa", "true or false", "a list of names": what a user may write.
  std::string expectation() const;
  /// Message where `value` is out of range (without name and place), else empty.
  std::string complaint(double value) const;
  /// Message where `value` is none of `choices` (if there are any), else empty.
  std::string complaint(const std::string& value) const;
  /// Sets the default, if there is one, in `list`.
  void setDefault(Teuchos::ParameterList& list) const;
};

/// The parameters of one plug-in (or deck section), and its named sub-lists.
class ParameterDeclarations {
 public:
  Parameter& real(const std::string& name, const std::string& unit, const std::string& meaning);
  Parameter& integer(const std::string& name, const std::string& meaning);
  Parameter& flag(const std::string& name, const std::string& meaning);
  Parameter& text(const std::string& name, const std::string& meaning);
  Parameter& function(const std::string& name, const std::string& unit, const std::string& meaning);
  Parameter& reals(const std::string& name, const std::string& unit, const std::string& meaning);
  Parameter& texts(const std::string& name, const std::string& meaning);
  Parameter& functions(const std::string& name, const std::string& unit, const std::string& meaning);

  /// A named sub-list with parameters of its own ("Adaptive Dynamic Relaxation" in "Staggered"). "*" stands for all
  /// names that are not declared: lists of entries that the user names ("Solvers" in "Staggered").
  ParameterDeclarations& sublist(const std::string& name, const std::string& meaning);

  /// Of these parameters (or sub-lists) exactly / at most / at least one must be given. A flag that is false, or a
  /// value that is the default, counts as not given.
  void exactlyOneOf(std::vector<std::string> names);
  void atMostOneOf(std::vector<std::string> names);
  void atLeastOneOf(std::vector<std::string> names);
  /// Where the first is given, the others must be too.
  void needs(const std::string& name, std::vector<std::string> others);

  struct Sublist {
    std::string name, meaning;
    std::vector<ParameterDeclarations> declarations;  ///< exactly one; a vector since the type is incomplete here
  };
  struct Rule {
    enum Kind { ExactlyOne, AtMostOne, AtLeastOne, Needs } kind;
    std::vector<std::string> names;
  };
  const std::vector<Parameter>& parameters() const { return parameters_; }
  const std::vector<Sublist>& sublists() const { return sublists_; }
  const std::vector<Rule>& rules() const { return rules_; }
  const Parameter* find(const std::string& name) const;
  const Sublist* findSublist(const std::string& name) const;

  /// Checks `given` against the declarations and returns it with the defaults filled in. Keys that a host injects
  /// (isHostKey) pass unchecked. Throws std::invalid_argument that lists every mistake, each naming `owner`.
  /// A plug-in calls this in its constructor, so that it is safe under a host that checks nothing.
  Teuchos::ParameterList complete(const Teuchos::ParameterList& given, const std::string& owner) const;

  /// All mistakes of `given` as (parameter name, message) pairs; the name is empty for a broken rule.
  std::vector<std::pair<std::string, std::string>> mistakes(const Teuchos::ParameterList& given) const;

  /// A message for each rule that is broken where `isGiven` says which parameters and sub-lists are there.
  std::vector<std::string> brokenRules(const std::function<bool(const std::string&)>& isGiven) const;
  /// Names of all parameters and sub-lists.
  std::vector<std::string> names() const;

 private:
  Parameter& add(const std::string& name, ParameterType type, const std::string& unit, const std::string& meaning);
  std::vector<Parameter> parameters_;
  std::vector<Sublist> sublists_;
  std::vector<Rule> rules_;
};

/// The parameters of a plug-in of class Class with their defaults: ParameterDeclarations::complete with what
/// Class::declareParameters declares.
template <class Class>
Teuchos::ParameterList completed(const Teuchos::ParameterList& given, const std::string& owner) {
  ParameterDeclarations declarations;
  Class::declareParameters(declarations);
  return declarations.complete(given, owner);
}

/// The defaults alone, required parameters missing: what a class of plug-ins is described by.
template <class Class>
Teuchos::ParameterList defaultsOf() {
  ParameterDeclarations declarations;
  Class::declareParameters(declarations);
  Teuchos::ParameterList list;
  for (const Parameter& parameter : declarations.parameters()) parameter.setDefault(list);
  return list;
}

/// Keys that a host puts into the list of a plug-in, declared or not: those that name it, and the horizon of its block.
bool isHostKey(const std::string& name);

/// `"A", "B"`.
std::string quotedList(const std::vector<std::string>& names);

/// The word of `known` nearest to `word` (edit distance with swaps, case ignored) if it is near enough to be a slip of
/// the pen; empty otherwise, and where `word` is longer than any name.
std::string nearestWord(const std::string& word, const std::vector<std::string>& known);
/// ` (did you mean "A"?)` or empty.
std::string didYouMean(const std::string& word, const std::vector<std::string>& known);

/// "C, pH".
std::string commaList(const std::vector<std::string>& names);

}  // namespace pd

#endif
