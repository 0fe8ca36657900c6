// Functions of place and time in decks.
#include "driver/deck/function.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <random>

#include "deck_from_text.hpp"

namespace pd {
namespace {

constexpr double pi = 3.14159265358979323846;

Function make(const std::string& text) { return Function(text, "deck.yaml:1:1"); }
double valueOf(const std::string& text, double x = 0.3, double y = 0.7, double z = -1.2, double t = 2.0) {
  return make(text)(x, y, z, t);
}
std::string refusal(const std::string& text) {
  return complaintOf([&] { make(text); });
}

TEST(Function, EvaluatesExpressions) {
  EXPECT_DOUBLE_EQ(valueOf("1.5e-3"), 1.5e-3);
  EXPECT_DOUBLE_EQ(valueOf("x + 2*y - z/t"), 0.3 + 1.4 + 0.6);
  EXPECT_DOUBLE_EQ(valueOf("2^3^2"), 512.0);
  EXPECT_DOUBLE_EQ(valueOf("-x^2"), -0.09);
  EXPECT_DOUBLE_EQ(valueOf("0.02e-3*min(t/1000, 1)"), 4.0e-8);
  EXPECT_DOUBLE_EQ(valueOf("t > 1 && x < 0.5 ? 3 : 4"), 3.0);
  EXPECT_DOUBLE_EQ(valueOf("!(x < 0.5) || y == 0.7"), 1.0);
  EXPECT_DOUBLE_EQ(valueOf("-0.1 * 0.5*(cos(3.14159265359 + t*3.14159265359/1.0e-2) + 1.0)", 0, 0, 0, 0.01),
                   -0.1 * 0.5 * (std::cos(2 * 3.14159265359) + 1.0));
}

TEST(Function, KnowsTheFunctionsOfPeridigmAndMore) {
  EXPECT_DOUBLE_EQ(valueOf("sin(x) + cos(y) + tan(x)"), std::sin(0.3) + std::cos(0.7) + std::tan(0.3));
  EXPECT_DOUBLE_EQ(valueOf("asin(x) + acos(x)"), pi / 2);
  EXPECT_DOUBLE_EQ(valueOf("atan(x) + atan2(y, z)"), std::atan(0.3) + std::atan2(0.7, -1.2));
  EXPECT_DOUBLE_EQ(valueOf("sinh(x)+cosh(x)+tanh(x)"), std::sinh(0.3) + std::cosh(0.3) + std::tanh(0.3));
  EXPECT_DOUBLE_EQ(valueOf("exp(x) + log(y) + log10(y) + sqrt(y)"),
                   std::exp(0.3) + std::log(0.7) + std::log10(0.7) + std::sqrt(0.7));
  EXPECT_DOUBLE_EQ(valueOf("pow(y, 3) + fabs(z) + abs(z)"), 0.343 + 2.4);
  EXPECT_DOUBLE_EQ(valueOf("min(x, y) + max(x, y)"), 1.0);
  EXPECT_DOUBLE_EQ(valueOf("erf(x) + erfc(x)"), 1.0);
  EXPECT_DOUBLE_EQ(valueOf("j0(2.404825557695773) + 1"), 1.0);  // its first zero (Abramowitz & Stegun table 9.5)
  EXPECT_NEAR(valueOf("i0(1.0)"), 1.2660658777520084, 1e-14);   // Abramowitz & Stegun table 9.8
  EXPECT_DOUBLE_EQ(valueOf("gamma(5.0)"), 24.0);
  EXPECT_DOUBLE_EQ(valueOf("floor(2.7) + ceil(2.2) + fmod(7, 4)"), 8.0);
  EXPECT_DOUBLE_EQ(valueOf("sin(pi/2)"), 1.0);
}

TEST(Function, UnderstandsTheBodiesOfPeridigm) {
  const std::string turn = "if(t <= 0.2)\\{ value = -x*sin(1.5*t); \\} else\\{ value = -x*sin(1.5*0.2); \\} ";
  EXPECT_DOUBLE_EQ(valueOf(turn, 2.0, 0, 0, 0.1), -2.0 * std::sin(0.15));
  EXPECT_DOUBLE_EQ(valueOf(turn, 2.0, 0, 0, 5.0), -2.0 * std::sin(0.3));
  EXPECT_DOUBLE_EQ(valueOf("value = 2*x"), 0.6);
  EXPECT_DOUBLE_EQ(valueOf("value = 1.0; value = value + t;"), 3.0);
  EXPECT_DOUBLE_EQ(valueOf("double a = 2.0, b = a*x; value = a + b;"), 2.6);
  EXPECT_DOUBLE_EQ(valueOf("int n = 3.7; value = n;"), 3.0);
  EXPECT_DOUBLE_EQ(valueOf("if (x > 1) value = 5;"), 0.0);
  EXPECT_DOUBLE_EQ(valueOf("if (x > 1) value = 5; else if (y > 0.5) value = 6; else value = 7;"), 6.0);
  EXPECT_DOUBLE_EQ(
      valueOf("/* note */ double r = sqrt(x^2 + y^2); // radius\n if (r > 0.5) { double s = r; value = s; }"),
      std::sqrt(0.09 + 0.49));
  EXPECT_DOUBLE_EQ(valueOf("if ((x < 1) && (y <= 0.7)) { if (z != 0) { value = 1; } else { value = 2; } }"), 1.0);
}

TEST(Function, HasNoValueWhereAPartHasNone) {
  // Each compares what is no number, or chooses by it; in C all of them are numbers.
  for (const char* text :
       {"sqrt(x - 1) < 2", "!(log(x - 1) > 0)", "min(2, sqrt(x - 1))", "max(sqrt(x - 1), 0)", "sqrt(x - 1) < 2 ? 3 : 4",
        "(y - 0.7)/(x - 0.3) == 0", "x > 1 && sqrt(x - 1) < 2", "asin(t) >= 0 || x > 0",
        "value = 1; if (sqrt(x - 1) < 2) value = 2;", "double a = pow(x - 1, 0.5); value = 1;"}) {
    const Function function = make(text);
    EXPECT_TRUE(std::isnan(function(0.3, 0.7, -1.2, 2.0))) << text;
    EXPECT_TRUE(std::isnan(function(0.3, 0.7, -1.2, 2.0))) << text << ": the second time";
    EXPECT_TRUE(std::isfinite(function(1.5, 0.2, -1.2, 0.5))) << text;
    const double place[3] = {0.3, 0.7, -1.2};
    EXPECT_THAT(complaintOf([&] { function.at(place, 2.0, 6); }), testing::HasSubstr("is not a number at point 7"));
  }
  EXPECT_TRUE(std::isnan(make("x < 1 && sqrt(-1) < 2")(0.3, 0.7, -1.2, 2.0)));
  EXPECT_NE(refusal("sqrt(-1) < 2"), "");
  // What is not evaluated has no need of a value; infinity is one.
  EXPECT_EQ(valueOf("x > 1 ? sqrt(x - 1) : 0"), 0.0);
  EXPECT_EQ(valueOf("if (x > 1) value = sqrt(x - 1); else value = 5;"), 5.0);
  EXPECT_EQ(valueOf("1/(x - 0.3) > 2"), 1.0);
  const double place[3] = {0.3, 0.7, -1.2};
  EXPECT_THAT(complaintOf([&] { make("x > 1 && sqrt(x - 1) < 2").at(place, 0.0, 6); }),
              testing::HasSubstr("both sides of && and || must have a value: a ? b : 0 in place of a && b"));
}

TEST(Function, OperationsOfOthersDoNotMatter) {
  volatile double zero = 0.0;
  const volatile double none = zero / zero;
  EXPECT_TRUE(std::isnan(none));
  EXPECT_DOUBLE_EQ(valueOf("x + 2*y < 3"), 1.0);
}

TEST(Function, KnowsWhatItDependsOn) {
  EXPECT_TRUE(make("3*pi").isConstant());
  EXPECT_DOUBLE_EQ(valueOf("3*pi"), 3 * pi);
  EXPECT_FALSE(make("x").isConstant());
  EXPECT_FALSE(make("x + y*z").dependsOnTime());
  EXPECT_TRUE(make("x*t").dependsOnTime());
  EXPECT_TRUE(make("if (t > 1) value = x; else value = 0;").dependsOnTime());
  EXPECT_FALSE(make("double a = x; value = a;").dependsOnTime());
  EXPECT_TRUE(make("value = 4;").isConstant());
  EXPECT_TRUE(Function::constant(2.0).isConstant());
}

TEST(Function, InterpolatesTables) {
  const Function table = Function::table({0.0, 1.0, 1.0, 3.0}, {0.0, 2.0, 5.0, 1.0});
  EXPECT_DOUBLE_EQ(table(0, 0, 0, -1.0), 0.0);
  EXPECT_DOUBLE_EQ(table(0, 0, 0, 0.25), 0.5);
  EXPECT_DOUBLE_EQ(table(0, 0, 0, 0.25), 0.5);
  EXPECT_DOUBLE_EQ(table(0, 0, 0, 1.0), 5.0);  // a jump: the later value holds
  EXPECT_DOUBLE_EQ(table(0, 0, 0, 2.0), 3.0);
  EXPECT_DOUBLE_EQ(table(0, 0, 0, 9.0), 1.0);
  EXPECT_TRUE(table.dependsOnTime());
  EXPECT_FALSE(Function::table({1.0}, {4.0}).dependsOnTime());
  EXPECT_THROW(Function::table({}, {}), std::invalid_argument);
  EXPECT_THROW(Function::table({1.0, 0.0}, {1.0, 2.0}), std::invalid_argument);
}

TEST(Function, ComesFromADeckInAllForms) {
  const Deck deck = deckFromText(
      "A: 3\nB: \"2*t\"\nC: {Table: [[0, 0], [10, 5]]}\nD: {Table: [[0, 0], [10]]}\nE: {Table: [[1, 0], [0, 0]]}\n"
      "F: {Tabel: []}\nG: [1, 2]\nH: {Table: [[0, a]]}\n");
  EXPECT_DOUBLE_EQ(Function::fromDeck(deck["A"])(0, 0, 0, 0), 3.0);
  EXPECT_DOUBLE_EQ(Function::fromDeck(deck["B"])(0, 0, 0, 4.0), 8.0);
  EXPECT_DOUBLE_EQ(Function::fromDeck(deck["C"])(0, 0, 0, 4.0), 2.0);
  const auto refused = [&](const char* key) { return complaintOf([&] { Function::fromDeck(deck[key]); }); };
  EXPECT_EQ(refused("D"), "deck:4:21: D/Table[2] must be a [time, value] pair");
  EXPECT_EQ(refused("E"), "deck:5:22: E/Table[2][1] is earlier than the time before it; sort the table by time");
  EXPECT_NE(refused("F").find("deck:6:5: unknown key \"Tabel\" in F"), std::string::npos);
  EXPECT_NE(refused("G").find("deck:7:4: G must be a number, a function of x, y, z, t"), std::string::npos);
  EXPECT_NE(refused("H").find("deck:8:17: H/Table[1][2] must be a finite number"), std::string::npos);
}

TEST(Function, SaysWhatItDoesNotUnderstand) {
  EXPECT_NE(
      refusal("2*foo(x)").find("deck.yaml:1:1: cannot understand the function \"2*foo(x)\": unknown name \"foo\""),
      std::string::npos);
  EXPECT_NE(refusal("aatan2(x, y)").find("(did you mean \"atan2\"?)"), std::string::npos);
  EXPECT_NE(refusal("while(1) { value = 1; }").find("\"while\" loops are not allowed"), std::string::npos);
  EXPECT_NE(refusal("for(;;) value = 1;").find("\"for\" loops are not allowed"), std::string::npos);
  EXPECT_NE(refusal("value = q;").find("unknown name \"q\""), std::string::npos);
  EXPECT_NE(refusal("a = 1; value = a;").find("\"a\" is not declared (write \"double a = ...;\")"), std::string::npos);
  EXPECT_NE(refusal("x = 1; value = x;").find("\"x\" is an input"), std::string::npos);
  EXPECT_NE(refusal("double a = 1;").find("never assigns \"value\""), std::string::npos);
  EXPECT_NE(refusal("if (x = 1) value = 1;").find("compare with \"==\""), std::string::npos);
  EXPECT_NE(refusal("if (x > 1) { value = 1;").find("\"}\" is missing"), std::string::npos);
  EXPECT_NE(refusal("1, 2").find("several values"), std::string::npos);
  EXPECT_NE(refusal("log(-1)").find("not a finite number"), std::string::npos);
  for (const char* text :
       {"",          "   ",   "(", "x +", "x y",   "\"x\"", "1..2",      "value",  "if",
        "value = ;", "{",     "}", ";",   "x ? 1", "sin()", "sin(x, y)", "pow(x)", "value = 1 value = 2",
        "int",       "rand()"})
    EXPECT_NE(refusal(text), "") << text;
}

TEST(Function, NeverCrashesOnAnyText) {
  const std::vector<std::string> pieces{"x",  "t",  "value", "=",  ";",  "{",    "}",     "(",    ")",  "if", "else",
                                        "+",  "-",  "*",     "/",  "^",  "1.5",  "sin",   ",",    "?",  ":",  "double ",
                                        "a",  "<",  "==",    "&&", "||", "!",    "\\{",   "\"",   "//", "/*", "min",
                                        "pi", "\n", "e",     "1e", ".",  "\x80", "while", "int ", "[",  "]",  "%"};
  std::mt19937 random(1);
  int understood = 0;
  for (int i = 0; i < 20000; ++i) {
    std::string text;
    for (std::size_t k = random() % 14; k > 0; --k) text += pieces[random() % pieces.size()];
    try {
      const double value = make(text)(0.1, 0.2, 0.3, 0.4);
      understood += std::isnan(value) ? 0 : 1;
    } catch (const DeckError&) {
    }
  }
  EXPECT_GT(understood, 100);  // else the pieces would not reach the evaluation
  EXPECT_NE(refusal(std::string(100000, '(')), "");
  EXPECT_NE(refusal(std::string(5000, '(')), "");
  EXPECT_NE(refusal(std::string(5000, '{')), "");
  std::string ifs;
  for (int i = 0; i < 1000; ++i) ifs += "if(1)";
  EXPECT_NE(refusal(ifs + "value=1;"), "");
}

TEST(Function, SaysAtWhichPointAValueIsNotFinite) {
  const double points[2][3] = {{0.25, 0.5, -1.0}, {0.0, 0.5, 0.0}};
  EXPECT_DOUBLE_EQ(make("sqrt(x)").at(points[0], 0.0, 0), 0.5);
  EXPECT_EQ(complaintOf([&] { make("1/x").at(points[1], 3.0, 6); }),
            "deck.yaml:1:1: the value of \"1/x\" is infinite at point 7, (0, 0.5, 0) m");
  EXPECT_EQ(complaintOf([&] { make("sqrt(z - t)").at(points[0], 3.0, 6); }),
            "deck.yaml:1:1: the value of \"sqrt(z - t)\" is not a number at point 7, (0.25, 0.5, -1) m, at t = 3 s");
  const Function table = Function::table({0.0, 1.0}, {1.0e308, -1.0e308}, "deck.yaml:2:3");
  EXPECT_EQ(complaintOf([&] { table.at(points[0], 0.5, 0); }),
            "deck.yaml:2:3: the value is infinite at point 1, (0.25, 0.5, -1) m, at t = 0.5 s");
}

TEST(Function, InfluenceFunctionsTakeZetaAndHorizon) {
  EXPECT_DOUBLE_EQ(influenceFunction("1.0/zeta", "deck.yaml:1:1")(0.5, 3.0), 2.0);
  EXPECT_DOUBLE_EQ(influenceFunction("exp(-zeta^2/(0.4*horizon)^2)", "deck.yaml:1:1")(0.4, 1.0), std::exp(-1.0));
  EXPECT_EQ(complaintOf([] { influenceFunction("log(zeta - 1)", "deck.yaml:1:1")(0.5, 3.0); }),
            "deck.yaml:1:1: the influence function \"log(zeta - 1)\" is not a number at zeta = 0.5 m, horizon = 3 m");
  EXPECT_NE(complaintOf([] { influenceFunction("x", "deck.yaml:1:1"); }).find("variables: horizon, zeta"),
            std::string::npos);
}

/// Seen in Peridigm's own runs: a sign binds tighter than a power.
TEST(Function, APeridigmMinusComesBeforePowers) {
  const auto both = [](const std::string& text) {
    return std::make_pair(Function(text, "deck", false)(3.0, 0.0, 0.0, 1.0),
                          Function(text, "deck", true)(3.0, 0.0, 0.0, 1.0));
  };
  EXPECT_EQ(both("-x^2"), std::make_pair(-9.0, 9.0));
  EXPECT_EQ(both("2*-x^2"), std::make_pair(-18.0, 18.0));
  EXPECT_EQ(both("1 - -x^2"), std::make_pair(10.0, -8.0));
  EXPECT_EQ(both("value = -sqrt(x + 1)^2;"), std::make_pair(-4.0, 4.0));
  // With a number or a value on its left the sign is a difference, and alike.
  for (const char* text : {"0 - x^2", "-t - x^2", "-1.0*x^2", "-x", "2^3^2", "7 - 4 - 2", "x % 2"})
    EXPECT_DOUBLE_EQ(both(text).first, both(text).second) << text;
  EXPECT_DOUBLE_EQ(both("8 % x").first, 2.0);
  EXPECT_DOUBLE_EQ(influenceFunction("-zeta^2", "deck", true)(3.0, 1.0), 9.0);
}

}  // namespace
}  // namespace pd
