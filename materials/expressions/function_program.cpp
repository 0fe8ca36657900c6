#include "function_program.hpp"

#include <muParser.h>

#include <algorithm>
#include <cctype>
#include <cfenv>
#include <cmath>
#include <deque>
#include <limits>
#include <map>
#include <stdexcept>

#include "parameters.hpp"

namespace pd {

namespace {

using Names = std::map<std::string, double*>;

constexpr std::size_t maximumLength = 10000;  // characters of a function
constexpr int maximumNesting = 40;            // of nested statements

double besselI0(double x) { return std::cyl_bessel_i(0.0, std::fabs(x) < 700.0 ? std::fabs(x) : 700.0); }

mu::Parser makeParser(MinusSign minusSign) {
  mu::Parser parser;
  if (minusSign == MinusSign::BeforePower)
    parser.DefineInfixOprt(
        "-", [](double a) { return -a; }, mu::prPOW + 1);
  const auto one = [&](const char* name, double (*function)(double)) { parser.DefineFun(name, function); };
  const auto two = [&](const char* name, double (*function)(double, double)) { parser.DefineFun(name, function); };
  one("fabs", [](double a) { return std::fabs(a); });
  one("erf", [](double a) { return std::erf(a); });
  one("erfc", [](double a) { return std::erfc(a); });
  one("gamma", [](double a) { return std::tgamma(a); });
  one("j0", [](double a) { return ::j0(a); });
  one("i0", besselI0);
  one("floor", [](double a) { return std::floor(a); });
  one("ceil", [](double a) { return std::ceil(a); });
  two("pow", [](double a, double b) { return std::pow(a, b); });
  two("fmod", [](double a, double b) { return std::fmod(a, b); });
  parser.DefineOprt(
      "%", [](double a, double b) { return std::fmod(a, b); }, mu::prMUL_DIV);
  parser.DefineConst("pi", 3.14159265358979323846);
  parser.DefineConst("_pi", 3.14159265358979323846);  // muParser's own has 13 digits
  parser.DefineInfixOprt("!", [](double a) { return a == 0.0 ? 1.0 : 0.0; });
  return parser;
}

const mu::Parser& prototype(MinusSign minusSign = MinusSign::AfterPower) {
  static const mu::Parser ours = makeParser(MinusSign::AfterPower), peridigms = makeParser(MinusSign::BeforePower);
  return minusSign == MinusSign::AfterPower ? ours : peridigms;
}

bool isNameStart(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_'; }
bool isNamePart(char c) { return isNameStart(c) || std::isdigit(static_cast<unsigned char>(c)) != 0; }

std::string trimmed(const std::string& text) {
  const char* blanks = " \t\r\n";
  const std::size_t first = text.find_first_not_of(blanks);
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

/// A "=" that is not part of "==", "<=", ">=" or "!=".
std::size_t findAssignment(const std::string& text) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '=') continue;
    if (i + 1 < text.size() && text[i + 1] == '=')
      ++i;
    else if (i == 0 || std::string("<>!").find(text[i - 1]) == std::string::npos)
      return i;
  }
  return std::string::npos;
}

/// Comments and escaped braces become blanks.
std::string cleaned(std::string text) {
  for (std::size_t i = 0; i + 1 < text.size(); ++i) {
    if (text[i] == '\\' && (text[i + 1] == '{' || text[i + 1] == '}')) text[i] = ' ';
    const bool isBlock = text.compare(i, 2, "/*") == 0;
    if (!isBlock && text.compare(i, 2, "//") != 0) continue;
    const std::size_t end = isBlock ? text.find("*/", i + 2) : text.find('\n', i);
    const std::size_t stop = end == std::string::npos ? text.size() : end + (isBlock ? 2 : 0);
    for (; i < stop; ++i) text[i] = ' ';
    --i;
  }
  return text;
}

std::string unknownName(const std::string& token, const Names& names) {
  const std::string word(token.begin(), std::find_if_not(token.begin(), token.end(), isNamePart));
  std::vector<std::string> known{"pi"};
  std::string variables, functions;
  for (const auto& entry : names) {
    known.push_back(entry.first);
    variables += (variables.empty() ? "" : ", ") + entry.first;
  }
  for (const auto& entry : prototype().GetFunDef()) {
    known.push_back(entry.first);
    functions += (functions.empty() ? "" : ", ") + entry.first;
  }
  return "unknown name \"" + word + "\"" + didYouMean(word, known) + "; variables: " + variables +
         "; constant: pi; functions: " + functions + "; no units, values are SI: 1.0e-3*t, not 1 mm*t";
}

}  // namespace

struct FunctionProgram::Statement {
  std::unique_ptr<mu::Parser> expression;  ///< of an assignment, or the condition of an if
  double* target = nullptr;                ///< of an assignment
  bool isInteger = false;
  std::vector<Statement> body, otherwise;

  void run() const {
    if (target != nullptr) {
      const double result = expression->Eval();
      *target = isInteger ? std::trunc(result) : result;
      return;
    }
    for (const Statement& statement : expression == nullptr || expression->Eval() != 0.0 ? body : otherwise)
      statement.run();
  }
};

struct FunctionProgram::Implementation {
  double evaluate() {
    if (expression) return expression->Eval();
    value = 0.0;
    for (const Statement& statement : statements) statement.run();
    return value;
  }

  std::deque<double> inputs;
  std::deque<double> locals;
  double value = 0.0;
  bool hasValue = true;  ///< false where a constant part, such as sqrt(-1), has none
  std::vector<char> isUsed;
  std::unique_ptr<mu::Parser> expression;  ///< of a text that is one expression
  std::vector<Statement> statements;       ///< of a body
};

namespace {

using Statement = FunctionProgram::Statement;

/// Reads the body of a function by recursive descent; expressions go to muParser.
class BodyReader {
 public:
  BodyReader(FunctionProgram::Implementation& program, std::string text, const std::vector<std::string>& variables,
             MinusSign minusSign)
      : program_(program), text_(std::move(text)), minusSign_(minusSign) {
    scopes_.emplace_back();
    for (std::size_t i = 0; i < variables.size(); ++i) scopes_.back()[variables[i]] = &program_.inputs[i];
  }

  std::unique_ptr<mu::Parser> expression(const std::string& rawText) {
    const std::string text = trimmed(rawText);
    if (text.empty()) refuse("an expression is missing");
    if (findAssignment(text) != std::string::npos) refuse("\"=\" in \"" + text + "\": compare with \"==\"");
    if (text.find('"') != std::string::npos) refuse("quotes in \"" + text + "\"");
    const Names names = visibleNames();
    auto parser = std::make_unique<mu::Parser>(prototype(minusSign_));
    try {
      for (const auto& [name, address] : names) parser->DefineVar(name, address);
      parser->SetExpr(text);
      int nResults = 0;
      std::feclearexcept(FE_INVALID);
      parser->Eval(nResults);
      if (std::fetestexcept(FE_INVALID) != 0) {
        // The first time it works constant parts out for good.
        std::feclearexcept(FE_INVALID);
        parser->Eval(nResults);
        program_.hasValue = program_.hasValue && std::fetestexcept(FE_INVALID) != 0;
      }
      if (nResults != 1) refuse("\"" + text + "\" has several values; write decimals with a point");
      for (const auto& used : parser->GetUsedVar())
        for (std::size_t i = 0; i < program_.inputs.size(); ++i)
          if (used.second == &program_.inputs[i]) program_.isUsed[i] = 1;
    } catch (const mu::Parser::exception_type& error) {
      const bool isUnknown = error.GetCode() == mu::ecUNASSIGNABLE_TOKEN && isNameStart((error.GetToken() + " ")[0]);
      refuse(isUnknown ? unknownName(error.GetToken(), names) : error.GetMsg());
    } catch (const std::invalid_argument&) {
      throw;
    } catch (const std::exception& error) {
      refuse(error.what());
    }
    return parser;
  }

  std::vector<Statement> body() {
    scopes_.emplace_back();
    scopes_.back()["value"] = &program_.value;
    std::vector<Statement> result;
    while (!atEnd()) statement(result, 0);
    if (!assignsValue_) refuse("it never assigns \"value\"");
    return result;
  }

 private:
  [[noreturn]] void refuse(const std::string& why) const {
    const std::string shown = trimmed(text_);
    throw std::invalid_argument("cannot understand the function \"" +
                                (shown.size() > 80 ? shown.substr(0, 77) + "..." : shown) + "\": " + why);
  }

  Names visibleNames() const {
    Names names;
    for (const Names& scope : scopes_)
      for (const auto& [name, address] : scope) names[name] = address;
    return names;
  }

  bool atEnd() {
    while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_])) != 0) ++at_;
    return at_ == text_.size();
  }
  bool accept(char c) {
    if (atEnd() || text_[at_] != c) return false;
    ++at_;
    return true;
  }
  void expect(char c, const char* where) {
    if (!accept(c)) refuse(std::string("\"") + c + "\" is missing " + where);
  }
  std::string peekWord() {
    if (atEnd() || !isNameStart(text_[at_])) return "";
    std::size_t end = at_;
    while (end < text_.size() && isNamePart(text_[end])) ++end;
    return text_.substr(at_, end - at_);
  }
  std::string takeWord() {
    const std::string word = peekWord();
    at_ += word.size();
    return word;
  }

  /// Text up to one of `stops` outside parentheses, which is not taken.
  std::string upTo(const std::string& stops) {
    const std::size_t start = at_;
    int depth = 0;
    for (; at_ < text_.size(); ++at_) {
      const char c = text_[at_];
      if (depth == 0 && stops.find(c) != std::string::npos) break;
      if (c == '(') ++depth;
      if (c == ')') --depth;
    }
    return text_.substr(start, at_ - start);
  }

  void endStatement() {
    // The last semicolon of a body or block may be left out, as in an expression.
    if (!accept(';') && !atEnd() && text_[at_] != '}')
      refuse("\";\" is missing before \"" + text_.substr(at_, 20) + "\"");
  }

  void statement(std::vector<Statement>& into, int depth) {
    if (depth > maximumNesting) refuse("it is nested too deeply");
    if (accept(';')) return;
    if (accept('{')) {
      into.push_back(block(depth));
      return;
    }
    const std::string word = takeWord();
    if (word == "if") {
      into.push_back(ifElse(depth));
    } else if (word == "while" || word == "for" || word == "do") {
      refuse("\"" + word + "\" loops are not allowed, since they may never end; write the sum or the condition out");
    } else if (word == "double" || word == "float" || word == "int") {
      declaration(into, word == "int");
    } else if (word.empty()) {
      refuse("an assignment such as \"value = x;\" is expected at \"" + text_.substr(at_, 20) + "\"");
    } else {
      assignment(into, word);
    }
  }

  Statement block(int depth) {
    Statement result;
    scopes_.emplace_back();
    while (!accept('}')) {
      if (atEnd()) refuse("\"}\" is missing");
      statement(result.body, depth + 1);
    }
    scopes_.pop_back();
    return result;
  }

  Statement ifElse(int depth) {
    Statement result;
    expect('(', "after \"if\"");
    result.expression = expression(upTo(")"));
    expect(')', "after the condition of \"if\"");
    if (atEnd()) refuse("a statement is missing after \"if\"");
    statement(result.body, depth + 1);
    if (peekWord() == "else") {
      takeWord();
      if (atEnd()) refuse("a statement is missing after \"else\"");
      statement(result.otherwise, depth + 1);
    }
    return result;
  }

  void declaration(std::vector<Statement>& into, bool isInteger) {
    do {
      const std::string name = takeWord();
      if (name.empty()) refuse("a name is missing in a declaration");
      if (visibleNames().count(name) != 0) refuse("\"" + name + "\" is declared already");
      // An undefined initial value would be a trap; it is 0.
      const std::string initial = accept('=') ? upTo(",;}") : "0";
      Statement result;
      result.expression = expression(initial);
      result.isInteger = isInteger;
      program_.locals.push_back(0.0);
      result.target = &program_.locals.back();
      scopes_.back()[name] = result.target;
      if (isInteger) integers_[result.target] = true;
      into.push_back(std::move(result));
    } while (accept(','));
    endStatement();
  }

  void assignment(std::vector<Statement>& into, const std::string& name) {
    const Names names = visibleNames();
    const auto it = names.find(name);
    if (it == names.end()) refuse("\"" + name + "\" is not declared (write \"double " + name + " = ...;\")");
    if (scopes_.front().count(name) != 0) refuse("\"" + name + "\" is an input and cannot be assigned");
    if (!accept('=')) refuse("\"=\" is missing after \"" + name + "\"");
    Statement result;
    result.target = it->second;
    result.isInteger = integers_.count(it->second) != 0;
    result.expression = expression(upTo(";}"));
    if (result.target == &program_.value) assignsValue_ = true;
    into.push_back(std::move(result));
    endStatement();
  }

  FunctionProgram::Implementation& program_;
  std::string text_;
  MinusSign minusSign_;
  std::size_t at_ = 0;
  std::vector<Names> scopes_;  ///< the inputs, then the body, then its blocks
  std::map<double*, bool> integers_;
  bool assignsValue_ = false;
};

}  // namespace

FunctionProgram::FunctionProgram(const std::string& rawText, const std::vector<std::string>& variables,
                                 MinusSign minusSign)
    : implementation_(std::make_unique<Implementation>()) {
  if (rawText.size() > maximumLength)
    throw std::invalid_argument("a function may have at most " + std::to_string(maximumLength) + " characters");
  if (rawText.find('\0') != std::string::npos) throw std::invalid_argument("a function contains a zero byte");
  const std::string text = cleaned(rawText);
  implementation_->inputs.resize(variables.size(), 0.0);
  implementation_->isUsed.resize(variables.size(), 0);
  BodyReader reader(*implementation_, text, variables, minusSign);
  const bool isBody = findAssignment(text) != std::string::npos || text.find_first_of(";{}") != std::string::npos;
  if (isBody)
    implementation_->statements = reader.body();
  else
    implementation_->expression = reader.expression(text);
}

FunctionProgram::~FunctionProgram() = default;
FunctionProgram::FunctionProgram(FunctionProgram&&) noexcept = default;

double FunctionProgram::evaluate(const double* values) const {
  Implementation& program = *implementation_;
  for (std::size_t i = 0; i < program.inputs.size(); ++i) program.inputs[i] = values[i];
  const double result = program.hasValue ? program.evaluate() : std::numeric_limits<double>::quiet_NaN();
  // The processor remembers operations without a value, and comparisons with what they left; others may have caused
  // them. To ask is quick, to have it forget is not.
  if (std::fetestexcept(FE_INVALID) == 0) return result;
  std::feclearexcept(FE_INVALID);
  program.evaluate();
  return std::fetestexcept(FE_INVALID) == 0 ? result : std::numeric_limits<double>::quiet_NaN();
}

bool FunctionProgram::uses(std::size_t variable) const { return implementation_->isUsed[variable] != 0; }

}  // namespace pd
