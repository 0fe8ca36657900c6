#include "function.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "deck_data.hpp"
#include "parameters.hpp"

namespace pd {

/// One of: a program, a table, a constant (none of the two).
struct Function::Implementation {
  std::string place, text;  ///< for messages
  std::unique_ptr<FunctionProgram> program;
  std::vector<double> times, values;
  double constant = 0.0;
  bool dependsOnTime = false, dependsOnPlace = false;
  // A table is asked for many points at one time; the last answer is kept.
  mutable double lastTime = std::numeric_limits<double>::quiet_NaN(), lastValue = 0.0;

  double interpolate(double t) const {
    const auto next = std::upper_bound(times.begin(), times.end(), t) - times.begin();
    if (next == 0) return values.front();
    const auto i = static_cast<std::size_t>(next);
    if (i == times.size()) return values.back();
    const double weight = (t - times[i - 1]) / (times[i] - times[i - 1]);
    return values[i - 1] + weight * (values[i] - values[i - 1]);
  }
};

namespace {

MinusSign minusSignOf(bool isPeridigms) { return isPeridigms ? MinusSign::BeforePower : MinusSign::AfterPower; }

FunctionProgram compiled(const std::string& text, const std::string& place, const std::vector<std::string>& variables,
                         MinusSign minusSign) {
  try {
    return {text, variables, minusSign};
  } catch (const std::invalid_argument& error) {
    throw DeckError(place + ": " + error.what());
  }
}

}  // namespace

Function::Function(const std::string& text, const std::string& place, bool isPeridigms) {
  auto implementation = std::make_shared<Implementation>();
  implementation->place = place;
  implementation->text = text;
  if (const auto number = parseReal(text)) {
    implementation->constant = *number;
  } else {
    auto program =
        std::make_unique<FunctionProgram>(compiled(text, place, {"x", "y", "z", "t"}, minusSignOf(isPeridigms)));
    implementation->dependsOnPlace = program->uses(0) || program->uses(1) || program->uses(2);
    implementation->dependsOnTime = program->uses(3);
    if (implementation->dependsOnPlace || implementation->dependsOnTime) {
      implementation->program = std::move(program);
    } else {
      const double origin[4] = {0.0, 0.0, 0.0, 0.0};
      implementation->constant = program->evaluate(origin);
      if (!std::isfinite(implementation->constant))
        throw DeckError(place + ": the value of \"" + text + "\" is not a finite number");
    }
  }
  implementation_ = implementation;
}

Function Function::constant(double value) {
  auto implementation = std::make_shared<Implementation>();
  implementation->constant = value;
  Function result;
  result.implementation_ = implementation;
  return result;
}

Function Function::table(std::vector<double> times, std::vector<double> values, const std::string& place) {
  if (times.empty() || times.size() != values.size())
    throw std::invalid_argument("a table needs as many times as values, and at least one");
  if (!std::is_sorted(times.begin(), times.end()))
    throw std::invalid_argument("the times of a table must not decrease");
  if (times.size() == 1) return constant(values.front());
  auto implementation = std::make_shared<Implementation>();
  implementation->place = place;
  implementation->times = std::move(times);
  implementation->values = std::move(values);
  implementation->dependsOnTime = true;
  Function result;
  result.implementation_ = implementation;
  return result;
}

namespace {

Function tableFromDeck(const DeckNode& node) {
  Mistakes mistakes;
  for (const auto& [key, value] : node.entries())
    if (key != "Table")
      mistakes.add(value.keyPlace(), "unknown key \"" + key + "\" in " + node.path() + " (known here: \"Table\")");
  const DeckNode rows = node["Table"];
  const std::string form = " must be a list of [time, value] pairs, as in {Table: [[0.0, 0.0], [10.0, 1.0e-3]]}";
  if (!rows.isSequence() || rows.items().empty()) {
    mistakes.add(rows ? rows.place() : node.place(), (rows ? rows.path() : node.path()) + form);
    mistakes.report();
  }
  std::vector<double> times, values;
  for (const DeckNode& row : rows.items()) {
    const auto pair = row.items();
    if (pair.size() != 2) {
      mistakes.add(row.place(), row.path() + " must be a [time, value] pair");
      continue;
    }
    try {
      const double time = pair[0].real(), value = pair[1].real();
      if (!times.empty() && time < times.back())
        mistakes.add(pair[0].place(), pair[0].path() + " is earlier than the time before it; sort the table by time");
      times.push_back(time);
      values.push_back(value);
    } catch (const DeckError& error) {
      mistakes.add("", error.what());
    }
  }
  mistakes.report();
  return Function::table(std::move(times), std::move(values), node.place());
}

}  // namespace

Function Function::fromDeck(const DeckNode& node) {
  if (node.isScalar()) return Function(node.text(), node.place(), node.isPeridigms());
  if (node.isMap()) return tableFromDeck(node);
  throw DeckError(node.place() + ": " + node.path() +
                  " must be a number, a function of x, y, z, t or {Table: [[time, value], ...]}");
}

double Function::operator()(double x, double y, double z, double t) const {
  const Implementation& f = *implementation_;
  if (f.program) {
    const double values[4] = {x, y, z, t};
    return f.program->evaluate(values);
  }
  if (f.times.empty()) return f.constant;
  if (t != f.lastTime) {
    f.lastValue = f.interpolate(t);
    f.lastTime = t;
  }
  return f.lastValue;
}

namespace {

std::string whatIsWrongWith(double value) {
  if (std::isnan(value)) return "not a number";
  return std::isinf(value) ? "infinite" : fmt::format("{:g}, too large to be meant,", value);
}

}  // namespace

double Function::at(const double* x, double t, int id) const {
  const double value = (*this)(x[0], x[1], x[2], t);
  if (std::abs(value) <= largestMeant) return value;
  const Implementation& f = *implementation_;
  // Unlike the branches of "? :", both are evaluated.
  const bool hasBothSides = f.text.find("&&") != std::string::npos || f.text.find("||") != std::string::npos;
  throw DeckError(fmt::format(
      "{}{} is {} at point {}, ({:.9g}, {:.9g}, {:.9g}) m{}{}", f.place.empty() ? "" : f.place + ": ",
      f.text.empty() ? "the value" : "the value of \"" + shortened(f.text) + "\"", whatIsWrongWith(value), id + 1, x[0],
      x[1], x[2], f.dependsOnTime ? fmt::format(", at t = {:.9g} s", t) : "",
      std::isnan(value) && hasBothSides ? "; both sides of && and || must have a value: a ? b : 0 in place of a && b"
                                        : ""));
}

bool Function::isConstant() const { return !implementation_->program && implementation_->times.empty(); }
bool Function::dependsOnTime() const { return implementation_->dependsOnTime; }

bool Function::dependsOnPlace() const { return implementation_->dependsOnPlace; }

MinusSign minusSignOf(const DeckNode& node) { return minusSignOf(node.isPeridigms()); }

void checkFunction(const std::string& text, const std::string& place, const std::vector<std::string>& variables) {
  compiled(text, place, variables, MinusSign::AfterPower);
}

std::function<double(double, double)> influenceFunction(const std::string& text, const std::string& place,
                                                        bool isPeridigms) {
  auto program =
      std::make_shared<FunctionProgram>(compiled(text, place, {"zeta", "horizon"}, minusSignOf(isPeridigms)));
  return [program, text, place](double zeta, double horizon) {
    const double values[2] = {zeta, horizon};
    const double weight = program->evaluate(values);
    if (!std::isfinite(weight))
      throw DeckError(fmt::format("{}: the influence function \"{}\" is {} at zeta = {:.6g} m, horizon = {:.6g} m",
                                  place, shortened(text), std::isnan(weight) ? "not a number" : "infinite", zeta,
                                  horizon));
    return weight;
  };
}

}  // namespace pd
