#include "deck_parameters.hpp"

#include <Teuchos_Array.hpp>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <sstream>

#include "deck_data.hpp"
#include "function.hpp"
#include "names.hpp"
#include "quantity.hpp"

namespace pd {

namespace {

/// Reads the entries of one section that are declared.
class SectionReader {
 public:
  SectionReader(Mistakes& mistakes, Teuchos::ParameterList& list) : mistakes_(mistakes), list_(list) {}

  void read(const DeckNode& value, const Parameter& parameter) {
    try {
      convert(value, parameter);
    } catch (const DeckError& error) {
      // The typed readers know what they found, the declaration knows what is wanted.
      addAll(mistakes_, error);
    }
  }

 private:
  void convert(const DeckNode& value, const Parameter& parameter) {
    const std::string& name = parameter.name;
    switch (parameter.type) {
      case ParameterType::Real:
        if (!isWritten(value, parameter, [](const std::string& text) { return parseReal(text).has_value(); })) return;
        if (isAllowed(value, parameter, value.real())) list_.set(name, value.real());
        return;
      case ParameterType::Integer:
        if (!isWritten(value, parameter, [](const std::string& text) { return parseInteger(text).has_value(); }))
          return;
        if (isAllowed(value, parameter, value.integer())) list_.set(name, value.integer());
        return;
      case ParameterType::Flag:
        if (isWritten(value, parameter, [](const std::string& text) { return parseFlag(text).has_value(); }))
          list_.set(name, value.flag());
        return;
      case ParameterType::Text:
        if (!isWritten(
                value, parameter, [](const std::string& text) { return !text.empty(); }, true))
          return;
        if (isAllowed(value, parameter, value.text())) list_.set(name, value.text());
        return;
      case ParameterType::Function:
        function(value, parameter);
        return;
      case ParameterType::Reals:
        reals(value, parameter);
        return;
      case ParameterType::Texts:
        texts(value, parameter);
        return;
      case ParameterType::Functions:
        functions(value, parameter);
        return;
    }
  }

  /// Whether the value is a scalar of the right form; else a mistake that says what the declaration wants.
  template <class Predicate>
  bool isWritten(const DeckNode& value, const Parameter& parameter, Predicate hasForm, bool mayBeQuoted = false) {
    std::string found = "nothing";
    if (value.isSequence()) found = "a list";
    if (value.isMap() && !value.entries().empty()) found = "a section";
    if (!value.xmlType().empty()) return hasXmlType(value, parameter);
    if (value.isScalar()) {
      const std::string text = value.text();
      std::string complaint;
      const std::optional<std::string> number = plainNumber(value, parameter, complaint);
      if ((number || hasForm(text)) && (mayBeQuoted || !value.isQuoted())) {
        if (number) value.becomes(*number);
        return true;
      }
      found = "\"" + shortened(text) + "\"";
      if (number || hasForm(text)) found += " in quotes";
      if (!complaint.empty()) found += ": " + complaint;
      if (parameter.type == ParameterType::Integer && !value.isQuoted() && parseReal(text))
        found += text.find_first_of(".eE") == std::string::npos ? " (too large)" : " (write it without a point)";
    }
    mistakes_.add(value.place(), value.path() + " must be " + parameter.expectation() + ", not " + found);
    return false;
  }

  /// The number that "3 GPa" or "2*3600" stands for, as text; nothing for plain numbers and what is none. `complaint`
  /// as of readQuantity().
  static std::optional<std::string> plainNumber(const DeckNode& value, const Parameter& parameter,
                                                std::string& complaint) {
    const bool isInteger = parameter.type == ParameterType::Integer;
    if (!(isInteger || parameter.type == ParameterType::Real) || parseReal(value.text())) return std::nullopt;
    const std::optional<double> number = readQuantity(value.text(), parameter.unit, minusSignOf(value), complaint);
    if (!number || !isInteger) return number ? std::optional(realText(*number)) : std::nullopt;
    if (*number == std::trunc(*number) && std::abs(*number) <= std::numeric_limits<int>::max())
      return std::to_string(static_cast<int>(*number));
    complaint = "it is " + realText(*number);
    return std::nullopt;
  }

  /// XML says the type of each value; the reader has seen that the value is of it.
  bool hasXmlType(const DeckNode& value, const Parameter& parameter) {
    const std::string type = value.xmlType();
    const std::string wanted = parameter.type == ParameterType::Real      ? "double"
                               : parameter.type == ParameterType::Integer ? "int"
                               : parameter.type == ParameterType::Flag    ? "bool"
                                                                          : "string";
    if (type == wanted || (type == "int" && wanted == "double")) {
      if (!value.text().empty()) return true;
      mistakes_.add(value.place(), value.path() + " must be " + parameter.expectation() + ", not empty");
      return false;
    }
    mistakes_.add(value.place(), value.path() + " must be " + parameter.expectation() + ", not the " + type + " \"" +
                                     value.text() + "\"; write type=\"" + wanted + "\"");
    return false;
  }

  template <class Value>
  bool isAllowed(const DeckNode& value, const Parameter& parameter, const Value& given) {
    const std::string complaint = parameter.complaint(given);
    if (!complaint.empty()) mistakes_.add(value.place(), value.path() + " " + complaint);
    return complaint.empty();
  }

  void function(const DeckNode& value, const Parameter& parameter) {
    if (value.isMap() && value.entries().empty()) {
      isWritten(value, parameter, [](const std::string&) { return false; });
      return;
    }
    const auto rows = value["Table"].items();
    if (!std::all_of(rows.begin(), rows.end(), [&](const DeckNode& row) { return tableRow(row, parameter); })) return;
    if (isFunction(value, parameter) && value.isScalar()) list_.set(parameter.name, value.text());
  }

  void refuse(const DeckNode& value, const Parameter& parameter, const std::string& why) {
    mistakes_.add(value.place(), value.path() + " must be " + parameter.expectation() + ", not \"" +
                                     shortened(value.text()) + "\": " + why);
  }

  /// [time, value], each with a unit or without: false after a mistake of these. Others are left to Function.
  bool tableRow(const DeckNode& row, const Parameter& parameter) {
    Parameter one = parameter;
    one.type = ParameterType::Real;
    const auto items = row.items();
    for (std::size_t i = 0; i < items.size() && i < 2; ++i) {
      one.unit = i == 0 ? "s" : parameter.unit;
      std::string complaint;
      if (!items[i].isScalar() || items[i].isQuoted()) continue;
      const std::optional<std::string> number = plainNumber(items[i], one, complaint);
      if (number) items[i].becomes(*number);
      if (complaint.empty()) continue;
      refuse(items[i], one, complaint);
      return false;
    }
    return true;
  }

  /// Whether it can be understood, and is allowed where it is constant: then it becomes a plain number. Throws
  /// DeckError.
  bool isFunction(const DeckNode& value, const Parameter& parameter) {
    std::optional<double> constant;
    try {
      constant = constantOf(value, parameter);
    } catch (const DeckError&) {
      // A function comes first: "2/t" is one, and no number in 1/t.
      if (!value.isScalar() || !hasUnit(value.text())) throw;
      std::string complaint;
      constant = readQuantity(value.text(), parameter.unit, minusSignOf(value), complaint);
      if (!constant) refuse(value, parameter, complaint);
      if (!constant) return false;
    }
    if (!constant) return true;
    if (value.isScalar() && !parseReal(value.text())) value.becomes(realText(*constant));
    return isAllowed(value, parameter, *constant);
  }

  /// The value of a function of nothing.
  static std::optional<double> constantOf(const DeckNode& value, const Parameter& parameter) {
    if (parameter.isOfPlaceAndTime()) {
      const Function function = Function::fromDeck(value);
      return function.isConstant() ? std::optional(function(0.0, 0.0, 0.0, 0.0)) : std::nullopt;
    }
    if (!value.isScalar()) throw DeckError(value.place() + ": " + value.path() + " must be " + parameter.expectation());
    checkFunction(value.text(), value.place(), parameter.variables);
    return parseReal(value.text());
  }

  /// Whether the value is a list; else a mistake.
  bool isList(const DeckNode& value, const Parameter& parameter) {
    return value.isSequence() || isWritten(value, parameter, [](const std::string&) { return false; });
  }

  void reals(const DeckNode& value, const Parameter& parameter) {
    if (!isList(value, parameter)) return;
    Parameter one = parameter;
    one.type = ParameterType::Real;
    Teuchos::Array<double> numbers;
    const auto items = value.items();
    for (const DeckNode& item : items) {
      const auto isReal = [](const std::string& text) { return parseReal(text).has_value(); };
      if (isWritten(item, one, isReal) && isAllowed(item, one, item.real())) numbers.push_back(item.real());
    }
    if (static_cast<std::size_t>(numbers.size()) == items.size()) list_.set(parameter.name, numbers);
  }

  void functions(const DeckNode& value, const Parameter& parameter) {
    if (!isList(value, parameter)) return;
    Teuchos::Array<std::string> texts;
    for (const DeckNode& item : value.items())
      if (isFunction(item, parameter)) texts.push_back(item.text());
    if (static_cast<std::size_t>(texts.size()) == value.items().size()) list_.set(parameter.name, texts);
  }

  bool isNew(const DeckNode& item, const Teuchos::Array<std::string>& names) {
    const bool isTwice = std::find(names.begin(), names.end(), item.text()) != names.end();
    if (isTwice) mistakes_.add(item.place(), item.path() + ": \"" + item.text() + "\" is in the list already");
    return !isTwice;
  }

  /// A list of names, or Peridigm's map {name: true}.
  void texts(const DeckNode& value, const Parameter& parameter) {
    Parameter one = parameter;
    one.type = ParameterType::Text;
    Teuchos::Array<std::string> names;
    if (value.isMap() && !value.entries().empty() && !parameter.mayBeOne) {
      for (const auto& [name, isWanted] : value.entries())
        if (isWanted.flag() && isAllowed(isWanted, one, name)) names.push_back(name);
    } else if (parameter.mayBeOne && value.isScalar()) {
      if (!isWritten(
              value, parameter, [](const std::string& text) { return !text.empty(); }, true))
        return;
      if (isAllowed(value, parameter, value.text())) names.push_back(value.text());
    } else if (isList(value, parameter)) {
      const auto isName = [](const std::string& text) { return !text.empty(); };
      for (const DeckNode& item : value.items())
        if (isWritten(item, one, isName, true) && isAllowed(item, one, item.text()) && isNew(item, names))
          names.push_back(item.text());
    } else {
      return;
    }
    list_.set(parameter.name, names);
  }

  Mistakes& mistakes_;
  Teuchos::ParameterList& list_;
};

void checkCompleteness(const DeckNode& section, const ParameterDeclarations& declarations, Mistakes& mistakes,
                       const HostKeys& hostKeys) {
  // A misspelt key is one mistake, not two.
  std::vector<std::string> meant = hostKeys.injected;
  for (const auto& entry : section.entries())
    if (declarations.find(entry.first) == nullptr) meant.push_back(nearestWord(entry.first, declarations.names()));
  for (const Parameter& parameter : declarations.parameters()) {
    if (!parameter.isRequired || section[parameter.name] || contains(meant, parameter.name)) continue;
    mistakes.add(section.keyPlace(), section.path() + " lacks \"" + parameter.name + "\" (" + parameter.expectation() +
                                         "): " + parameter.meaning);
  }
  // A flag that is false says no more than one left out.
  const auto isFalse = [&](const std::string& name) {
    const Parameter* parameter = declarations.find(name);
    return parameter != nullptr && parameter->type == ParameterType::Flag && section[name].isScalar() &&
           parseFlag(section[name].text()) == false;
  };
  const auto isGiven = [&](const std::string& name) {
    return (section[name].exists() && !isFalse(name)) || contains(meant, name);
  };
  for (const std::string& message : declarations.brokenRules(isGiven))
    mistakes.add(section.keyPlace(), section.path() + ": " + message);
}

}  // namespace

std::string inSection(const DeckNode& section) {
  return section.path().empty() ? " at the top level" : " in " + section.path();
}

void addAll(Mistakes& mistakes, const DeckError& error) {
  std::istringstream lines(error.what());
  for (std::string line; std::getline(lines, line);) mistakes.add("", line);
}

Teuchos::ParameterList readParameters(const DeckNode& section, const ParameterDeclarations& declarations,
                                      Mistakes& mistakes, const HostKeys& hostKeys, Mistakes* ignoredKeys) {
  Teuchos::ParameterList list;
  if (!section.isMap()) {
    mistakes.add(section.place(), section.path() + " must be a section with keys of its own");
    return list;
  }
  SectionReader reader(mistakes, list);
  for (const auto& [key, value] : section.entries()) {
    if (const Parameter* parameter = declarations.find(key)) {
      reader.read(value, *parameter);
    } else if (const auto* sublist = declarations.findSublist(key)) {
      list.sublist(key) = readParameters(value, sublist->declarations.front(), mistakes, {}, ignoredKeys);
    } else if (contains(hostKeys.known, key)) {
      if (value.isScalar()) list.set(key, value.text());
    } else {
      std::vector<std::string> known = declarations.names();
      known.insert(known.begin(), hostKeys.known.begin(), hostKeys.known.end());
      const std::string message = "unknown key \"" + key + "\"" + inSection(section) + didYouMean(key, known) +
                                  (known.empty() ? "; it takes no keys" : "; known here: " + quotedList(known));
      if (ignoredKeys == nullptr) {
        mistakes.add(value.keyPlace(), message);
      } else {
        ignoredKeys->add(value.keyPlace(), message);
        value.ignore();
      }
    }
  }
  checkCompleteness(section, declarations, mistakes, hostKeys);
  for (const Parameter& parameter : declarations.parameters())
    if (!section[parameter.name]) parameter.setDefault(list);
  return list;
}

Teuchos::ParameterList DeckNode::parameters(const ParameterDeclarations& declarations) const {
  Mistakes mistakes;
  HostKeys hostKeys;
  for (const char* key : {"Material Model", "Damage Model", "Compute Class", "Type"})
    if ((*this)[key]) hostKeys.known.emplace_back(key);
  if ((*this)["Material Model"]) hostKeys.injected.emplace_back("Horizon");
  Teuchos::ParameterList list = readParameters(*this, declarations, mistakes, hostKeys);
  mistakes.report();
  return list;
}

}  // namespace pd
