#include "parameters.hpp"

#include <Teuchos_Array.hpp>
#include <algorithm>
#include <cctype>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace pd {

namespace {

std::string numberText(double value) {
  std::ostringstream out;
  out.precision(10);
  out << value;
  return out.str();
}

/// Letters to add, drop, replace or swap with their neighbour, to come from `a` to `b`; case ignored.
std::size_t editDistance(const std::string& a, const std::string& b) {
  const auto isSame = [](char x, char y) {
    return std::tolower(static_cast<unsigned char>(x)) == std::tolower(static_cast<unsigned char>(y));
  };
  std::vector<std::size_t> beforeLast, last(b.size() + 1), row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) last[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = last[j - 1] + (isSame(a[i - 1], b[j - 1]) ? 0 : 1);
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, replaced});
      if (i > 1 && j > 1 && isSame(a[i - 1], b[j - 2]) && isSame(a[i - 2], b[j - 1]))
        row[j] = std::min(row[j], beforeLast[j - 2] + 1);
    }
    beforeLast = last;
    last = row;
  }
  return last[b.size()];
}

std::string ruleComplaint(const ParameterDeclarations::Rule& rule,
                          const std::function<bool(const std::string&)>& isGiven) {
  if (rule.kind == ParameterDeclarations::Rule::Needs) {
    if (!isGiven(rule.names[0])) return "";
    std::vector<std::string> missing;
    for (std::size_t i = 1; i < rule.names.size(); ++i)
      if (!isGiven(rule.names[i])) missing.push_back(rule.names[i]);
    return missing.empty() ? "" : "\"" + rule.names[0] + "\" needs " + quotedList(missing) + " beside it";
  }
  const auto count = std::count_if(rule.names.begin(), rule.names.end(), isGiven);
  const bool tooMany = count > 1 && rule.kind != ParameterDeclarations::Rule::AtLeastOne;
  const bool tooFew = count == 0 && rule.kind != ParameterDeclarations::Rule::AtMostOne;
  if (tooMany) return "give only one of " + quotedList(rule.names);
  if (tooFew)
    return (rule.kind == ParameterDeclarations::Rule::AtLeastOne ? "give at least one of " : "give one of ") +
           quotedList(rule.names);
  return "";
}

template <class Value>
std::string firstComplaint(const Parameter& parameter, const Teuchos::Array<Value>& values) {
  for (const Value& value : values) {
    const std::string message = parameter.complaint(value);
    if (!message.empty()) return message;
  }
  return "";
}

/// A name twice is a slip: all that takes a list of them means different ones.
std::string complaintOfNames(const Parameter& parameter, const Teuchos::Array<std::string>& names) {
  const std::string message = firstComplaint(parameter, names);
  if (!message.empty()) return message;
  for (auto name = names.begin(); name != names.end(); ++name)
    if (std::find(names.begin(), name, *name) != name) return "has \"" + *name + "\" twice";
  return "";
}

/// The mistake of one given entry, or empty.
std::string entryComplaint(const Parameter& parameter, const Teuchos::ParameterList& given) {
  const std::string& name = parameter.name;
  switch (parameter.type) {
    case ParameterType::Real:
      if (given.isType<int>(name)) return parameter.complaint(given.get<int>(name));
      if (!given.isType<double>(name)) return "must be a number";
      return parameter.complaint(given.get<double>(name));
    case ParameterType::Integer:
      if (!given.isType<int>(name)) return "must be an integer";
      return parameter.complaint(given.get<int>(name));
    case ParameterType::Flag:
      return given.isType<bool>(name) ? "" : "must be true or false";
    case ParameterType::Function:
      return given.isType<std::string>(name) || given.isType<double>(name) || given.isType<int>(name)
                 ? ""
                 : "must be " + parameter.expectation();
    case ParameterType::Text: {
      if (!given.isType<std::string>(name)) return "must be text";
      return parameter.complaint(given.get<std::string>(name));
    }
    case ParameterType::Reals:
      if (given.isType<Teuchos::Array<int>>(name))
        return firstComplaint(parameter, given.get<Teuchos::Array<int>>(name));
      if (!given.isType<Teuchos::Array<double>>(name)) return "must be a list of numbers";
      return firstComplaint(parameter, given.get<Teuchos::Array<double>>(name));
    case ParameterType::Texts:
      if (parameter.mayBeOne && given.isType<std::string>(name))
        return parameter.complaint(given.get<std::string>(name));
      if (!given.isType<Teuchos::Array<std::string>>(name)) return "must be " + parameter.expectation();
      return complaintOfNames(parameter, given.get<Teuchos::Array<std::string>>(name));
    case ParameterType::Functions:
      return given.isType<Teuchos::Array<std::string>>(name) ? "" : "must be " + parameter.expectation();
  }
  return "";
}

void normalise(Teuchos::ParameterList& list, const Parameter& parameter) {
  const std::string& name = parameter.name;
  if (!list.isParameter(name)) return;
  if (parameter.type == ParameterType::Real && list.isType<int>(name))
    list.set(name, static_cast<double>(list.get<int>(name)));
  if (parameter.type == ParameterType::Reals && list.isType<Teuchos::Array<int>>(name)) {
    const auto given = list.get<Teuchos::Array<int>>(name);
    list.set(name, Teuchos::Array<double>(given.begin(), given.end()));
  }
  if (parameter.mayBeOne && list.isType<std::string>(name))
    list.set(name, Teuchos::Array<std::string>(1, list.get<std::string>(name)));
  if (parameter.type != ParameterType::Function) return;
  if (list.isType<double>(name)) {
    std::ostringstream out;
    out.precision(17);
    out << list.get<double>(name);
    list.set(name, out.str());
  } else if (list.isType<int>(name)) {
    list.set(name, std::to_string(list.get<int>(name)));
  }
}

}  // namespace

Parameter& Parameter::required() {
  isRequired = true;
  return *this;
}
Parameter& Parameter::defaultTo(double value) {
  defaultValue = value;
  return *this;
}
Parameter& Parameter::defaultTo(int value) {
  if (type == ParameterType::Real)
    defaultValue = static_cast<double>(value);
  else
    defaultValue = value;
  return *this;
}
Parameter& Parameter::defaultTo(bool value) {
  defaultValue = value;
  return *this;
}
Parameter& Parameter::defaultTo(const char* value) {
  defaultValue = std::string(value);
  return *this;
}
Parameter& Parameter::positive() {
  lowest = 0.0;
  lowestExcluded = true;
  return *this;
}
Parameter& Parameter::atLeast(double value) {
  lowest = value;
  return *this;
}
Parameter& Parameter::atMost(double value) {
  highest = value;
  return *this;
}
Parameter& Parameter::between(double low, double high) { return atLeast(low).atMost(high); }
Parameter& Parameter::strictlyBetween(double low, double high) {
  lowestExcluded = highestExcluded = true;
  return between(low, high);
}
Parameter& Parameter::oneOf(std::vector<std::string> names) {
  choices = std::move(names);
  return *this;
}
Parameter& Parameter::orOne() {
  mayBeOne = true;
  return *this;
}
Parameter& Parameter::of(std::vector<std::string> names) {
  variables = std::move(names);
  return *this;
}
Parameter& Parameter::from(const char* sourceText) {
  source = sourceText;
  return *this;
}
Parameter& Parameter::ofField(const std::string& label) {
  field = label;
  return *this;
}

std::string Parameter::allowedText() const {
  if (!choices.empty()) return "one of " + quotedList(choices);
  const std::string unitText = unit.empty() || unit == "1" ? "" : " " + unit;
  const bool hasLow = std::isfinite(lowest), hasHigh = std::isfinite(highest);
  if (hasLow && hasHigh)
    return std::string("in ") + (lowestExcluded ? "(" : "[") + numberText(lowest) + ", " + numberText(highest) +
           (highestExcluded ? ")" : "]") + unitText;
  if (hasLow) return (lowestExcluded ? "> " : ">= ") + numberText(lowest) + unitText;
  if (hasHigh) return (highestExcluded ? "< " : "<= ") + numberText(highest) + unitText;
  return "";
}

std::string Parameter::defaultText() const {
  if (std::holds_alternative<double>(defaultValue)) return numberText(std::get<double>(defaultValue));
  if (std::holds_alternative<int>(defaultValue)) return std::to_string(std::get<int>(defaultValue));
  if (std::holds_alternative<bool>(defaultValue)) return std::get<bool>(defaultValue) ? "true" : "false";
  if (std::holds_alternative<std::string>(defaultValue)) return std::get<std::string>(defaultValue);
  return "";
}

std::string Parameter::complaint(double value) const {
  if (std::isnan(value)) return "is not a number";
  const bool low = lowestExcluded ? !(value > lowest) : value < lowest;
  const bool high = highestExcluded ? !(value < highest) : value > highest;
  if ((low && std::isfinite(lowest)) || (high && std::isfinite(highest)))
    return "is " + numberText(value) + ", must be " + allowedText();
  const bool isSmall = value != 0.0 && std::abs(value) < 1.0 / largestMeant && !unit.empty() && unit != "1";
  if (std::abs(value) > largestMeant || isSmall)
    return "is " + numberText(value) + ", too " + (isSmall ? "small" : "large") + " to be meant";
  return "";
}

std::string Parameter::complaint(const std::string& value) const {
  if (choices.empty() || std::find(choices.begin(), choices.end(), value) != choices.end()) return "";
  const std::string nearest = nearestWord(value, choices);
  return "\"" + value + "\" is not allowed here (" + allowedText() + ")" +
         (nearest.empty() ? "" : "; did you mean \"" + nearest + "\"?");
}

std::string Parameter::expectation() const {
  const std::string allowed = allowedText();
  const std::string unitText = unit.empty() || unit == "1" ? "" : " in " + unit;
  const std::string range = allowed.empty() ? unitText : " " + allowed;
  switch (type) {
    case ParameterType::Real:
      return "a number" + range;
    case ParameterType::Integer:
      return "an integer" + range;
    case ParameterType::Flag:
      return "true or false";
    case ParameterType::Text:
      return choices.empty() ? "text" : allowed;
    case ParameterType::Function:
      return "a number or a function of " + commaList(variables) + unitText;
    case ParameterType::Reals:
      return "a list of numbers" + range;
    case ParameterType::Texts:
      return std::string(mayBeOne ? "a name or a list of names" : "a list of names") +
             (choices.empty() ? "" : ", each " + allowed);
    case ParameterType::Functions:
      return "a list of numbers or functions of " + commaList(variables) + unitText;
  }
  return "";
}

void Parameter::setDefault(Teuchos::ParameterList& list) const {
  if (std::holds_alternative<double>(defaultValue)) list.set(name, std::get<double>(defaultValue));
  if (std::holds_alternative<int>(defaultValue)) list.set(name, std::get<int>(defaultValue));
  if (std::holds_alternative<bool>(defaultValue)) list.set(name, std::get<bool>(defaultValue));
  if (std::holds_alternative<std::string>(defaultValue)) list.set(name, std::get<std::string>(defaultValue));
  normalise(list, *this);
}

Parameter& ParameterDeclarations::add(const std::string& name, ParameterType type, const std::string& unit,
                                      const std::string& meaning) {
  Parameter parameter;
  parameter.name = name;
  parameter.type = type;
  parameter.unit = unit;
  parameter.meaning = meaning;
  parameters_.push_back(std::move(parameter));
  return parameters_.back();
}

Parameter& ParameterDeclarations::real(const std::string& name, const std::string& unit, const std::string& meaning) {
  return add(name, ParameterType::Real, unit, meaning);
}
Parameter& ParameterDeclarations::integer(const std::string& name, const std::string& meaning) {
  return add(name, ParameterType::Integer, "", meaning);
}
Parameter& ParameterDeclarations::flag(const std::string& name, const std::string& meaning) {
  return add(name, ParameterType::Flag, "", meaning);
}
Parameter& ParameterDeclarations::text(const std::string& name, const std::string& meaning) {
  return add(name, ParameterType::Text, "", meaning);
}
Parameter& ParameterDeclarations::function(const std::string& name, const std::string& unit,
                                           const std::string& meaning) {
  return add(name, ParameterType::Function, unit, meaning);
}
Parameter& ParameterDeclarations::reals(const std::string& name, const std::string& unit, const std::string& meaning) {
  return add(name, ParameterType::Reals, unit, meaning);
}
Parameter& ParameterDeclarations::texts(const std::string& name, const std::string& meaning) {
  return add(name, ParameterType::Texts, "", meaning);
}
Parameter& ParameterDeclarations::functions(const std::string& name, const std::string& unit,
                                            const std::string& meaning) {
  return add(name, ParameterType::Functions, unit, meaning);
}

ParameterDeclarations& ParameterDeclarations::sublist(const std::string& name, const std::string& meaning) {
  sublists_.push_back({name, meaning, {ParameterDeclarations()}});
  return sublists_.back().declarations.front();
}

void ParameterDeclarations::exactlyOneOf(std::vector<std::string> names) {
  rules_.push_back({Rule::ExactlyOne, std::move(names)});
}
void ParameterDeclarations::atMostOneOf(std::vector<std::string> names) {
  rules_.push_back({Rule::AtMostOne, std::move(names)});
}
void ParameterDeclarations::atLeastOneOf(std::vector<std::string> names) {
  rules_.push_back({Rule::AtLeastOne, std::move(names)});
}
void ParameterDeclarations::needs(const std::string& name, std::vector<std::string> others) {
  others.insert(others.begin(), name);
  rules_.push_back({Rule::Needs, std::move(others)});
}

const Parameter* ParameterDeclarations::find(const std::string& name) const {
  for (const Parameter& parameter : parameters_)
    if (parameter.name == name) return &parameter;
  return nullptr;
}

const ParameterDeclarations::Sublist* ParameterDeclarations::findSublist(const std::string& name) const {
  const Sublist* ofAnyName = nullptr;
  for (const Sublist& sublist : sublists_) {
    if (sublist.name == name) return &sublist;
    if (sublist.name == "*") ofAnyName = &sublist;
  }
  return find(name) == nullptr ? ofAnyName : nullptr;
}

std::vector<std::pair<std::string, std::string>> ParameterDeclarations::mistakes(
    const Teuchos::ParameterList& given) const {
  std::vector<std::pair<std::string, std::string>> result;
  const std::vector<std::string> known = names();

  for (auto it = given.begin(); it != given.end(); ++it) {
    const std::string& name = given.name(it);
    if (const Sublist* sublist = findSublist(name)) {
      if (!given.isSublist(name)) {
        result.emplace_back(name, "must be a list of its own");
        continue;
      }
      for (auto& [inner, message] : sublist->declarations.front().mistakes(given.sublist(name)))
        result.emplace_back(name + (inner.empty() ? "" : "/" + inner), message);
    } else if (const Parameter* parameter = find(name)) {
      const std::string message = entryComplaint(*parameter, given);
      if (!message.empty()) result.emplace_back(name, message);
    } else if (!isHostKey(name)) {
      const std::string nearest = nearestWord(name, known);
      result.emplace_back(name, "unknown key" + (nearest.empty() ? " (known here: " + quotedList(known) + ")"
                                                                 : "; did you mean \"" + nearest + "\"?"));
    }
  }
  for (const Parameter& parameter : parameters_)
    if (parameter.isRequired && !given.isParameter(parameter.name))
      result.emplace_back(parameter.name, "is required: " + parameter.meaning);
  // A flag that is false says no more than one left out; hosts fill it in.
  const auto isGiven = [&](const std::string& name) {
    if (given.isSublist(name)) return true;
    if (!given.isParameter(name) || (given.isType<bool>(name) && !given.get<bool>(name))) return false;
    // A host may have filled in the default.
    const Parameter* parameter = find(name);
    Teuchos::ParameterList defaults;
    if (parameter != nullptr) parameter->setDefault(defaults);
    return !defaults.isParameter(name) || defaults.getEntry(name).getAny() != given.getEntry(name).getAny();
  };
  for (const std::string& message : brokenRules(isGiven)) result.emplace_back("", message);
  return result;
}

std::vector<std::string> ParameterDeclarations::brokenRules(
    const std::function<bool(const std::string&)>& isGiven) const {
  std::vector<std::string> result;
  for (const Rule& rule : rules_) {
    const std::string message = ruleComplaint(rule, isGiven);
    if (!message.empty()) result.push_back(message);
  }
  return result;
}

std::vector<std::string> ParameterDeclarations::names() const {
  std::vector<std::string> result;
  for (const Parameter& parameter : parameters_) result.push_back(parameter.name);
  for (const Sublist& sublist : sublists_) result.push_back(sublist.name);
  return result;
}

Teuchos::ParameterList ParameterDeclarations::complete(const Teuchos::ParameterList& given,
                                                       const std::string& owner) const {
  const auto found = mistakes(given);
  if (!found.empty()) {
    std::string message;
    for (const auto& [name, text] : found)
      message += (message.empty() ? "" : "\n") + owner + ": " + (name.empty() ? "" : "\"" + name + "\" ") + text;
    throw std::invalid_argument(message);
  }
  Teuchos::ParameterList result(given);
  for (const Parameter& parameter : parameters_) {
    if (result.isParameter(parameter.name))
      normalise(result, parameter);
    else
      parameter.setDefault(result);
  }
  for (auto it = result.begin(); it != result.end(); ++it) {
    const std::string& name = result.name(it);
    const Sublist* sublist = findSublist(name);
    if (sublist == nullptr || !result.isSublist(name)) continue;
    Teuchos::ParameterList& inner = result.sublist(name);
    inner = sublist->declarations.front().complete(inner, owner + "/" + name);
  }
  return result;
}

bool isHostKey(const std::string& name) {
  return name == "Material Model" || name == "Damage Model" || name == "Compute Class" || name == "Horizon";
}

std::string quotedList(const std::vector<std::string>& names) {
  std::string result;
  for (const std::string& name : names) result += (result.empty() ? "\"" : ", \"") + name + "\"";
  return result;
}

std::string nearestWord(const std::string& word, const std::vector<std::string>& known) {
  constexpr std::size_t longestName = 100;  // the effort grows with the product of the lengths
  if (word.size() < 2 || word.size() > longestName) return "";
  std::string best;
  std::size_t bestDistance = (word.size() < 5 ? 1 : std::max<std::size_t>(2, word.size() / 3)) + 1;
  for (const std::string& candidate : known) {
    if (candidate.size() > word.size() + bestDistance) continue;
    const std::size_t distance = editDistance(word, candidate);
    if (distance < bestDistance) {
      bestDistance = distance;
      best = candidate;
    }
  }
  return best;
}

std::string didYouMean(const std::string& word, const std::vector<std::string>& known) {
  const std::string nearest = nearestWord(word, known);
  return nearest.empty() ? "" : " (did you mean \"" + nearest + "\"?)";
}

std::string commaList(const std::vector<std::string>& names) {
  std::string result;
  for (const std::string& name : names) result += (result.empty() ? "" : ", ") + name;
  return result;
}

}  // namespace pd
