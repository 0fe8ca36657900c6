// Declarations of parameters and what they make of a parameter list.
#include "materials/registry/parameters.hpp"

#include <gtest/gtest.h>

#include <Teuchos_Array.hpp>
#include <stdexcept>

#include "materials/registry/registry.hpp"

namespace pd {
namespace {

ParameterDeclarations example() {
  ParameterDeclarations declare;
  declare.real("Density", "kg/m3", "Mass density.").positive().required();
  declare.real("Ratio", "1", "Ratio.").strictlyBetween(-1.0, 0.5);
  declare.real("Share", "1", "Share.").between(0.0, 1.0).defaultTo(1);
  declare.integer("Steps", "Steps.").atLeast(1).atMost(9).defaultTo(3);
  declare.flag("On", "Switch.").defaultTo(true);
  declare.text("Law", "Law.").oneOf({"Linear", "Quadratic"}).defaultTo("Linear");
  declare.function("Load", "N", "Load.").defaultTo(2.5);
  declare.reals("Times", "s", "Times.").atLeast(0.0);
  declare.texts("Names", "Names.").oneOf({"a", "b"});
  declare.sublist("Inner", "More.").real("Radius", "m", "Radius.").defaultTo(0.5);
  return declare;
}

std::string complaintOf(const ParameterDeclarations& declarations, const Teuchos::ParameterList& list) {
  try {
    declarations.complete(list, "owner");
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(Parameters, FillDefaultsAndConvert) {
  Teuchos::ParameterList list;
  list.set("Density", 7850);
  list.set("Load", 3);
  list.set("Times", Teuchos::Array<int>(Teuchos::tuple(1, 2)));
  list.sublist("Inner");
  const Teuchos::ParameterList complete = example().complete(list, "owner");
  EXPECT_DOUBLE_EQ(complete.get<double>("Density"), 7850.0);
  EXPECT_DOUBLE_EQ(complete.get<double>("Share"), 1.0);
  EXPECT_EQ(complete.get<int>("Steps"), 3);
  EXPECT_TRUE(complete.get<bool>("On"));
  EXPECT_EQ(complete.get<std::string>("Law"), "Linear");
  EXPECT_EQ(complete.get<std::string>("Load"), "3");
  EXPECT_EQ(complete.get<Teuchos::Array<double>>("Times").toVector(), (std::vector<double>{1.0, 2.0}));
  EXPECT_DOUBLE_EQ(complete.sublist("Inner").get<double>("Radius"), 0.5);
  EXPECT_FALSE(complete.isParameter("Ratio"));
  EXPECT_FALSE(complete.isParameter("Names"));
}

TEST(Parameters, DefaultsOfFunctionsAreText) {
  Teuchos::ParameterList list;
  list.set("Density", 1.0);
  EXPECT_EQ(example().complete(list, "owner").get<std::string>("Load"), "2.5");
}

TEST(Parameters, NamesOfAListAreDifferent) {
  Teuchos::ParameterList list;
  list.set("Density", 1.0);
  list.set("Names", Teuchos::Array<std::string>(Teuchos::tuple<std::string>("a", "b", "a")));
  EXPECT_EQ(complaintOf(example(), list), "owner: \"Names\" has \"a\" twice");
}

TEST(Parameters, ReportEveryMistake) {
  Teuchos::ParameterList list;
  list.set("Ratio", 0.5);
  list.set("Share", 1.5);
  list.set("Steps", 10);
  list.set("On", "yes");
  list.set("Law", "Quadradic");
  list.set("Times", Teuchos::Array<double>(Teuchos::tuple(1.0, -2.0)));
  list.set("Names", Teuchos::Array<std::string>(Teuchos::tuple<std::string>("a", "c")));
  list.set("Desity", 1.0);
  list.set("Inner", 3);
  const std::string message = complaintOf(example(), list);
  for (const char* expected :
       {"owner: \"Ratio\" is 0.5, must be in (-1, 0.5)", "owner: \"Share\" is 1.5, must be in [0, 1]",
        "owner: \"Steps\" is 10, must be in [1, 9]", "owner: \"On\" must be true or false",
        "owner: \"Law\" \"Quadradic\" is not allowed here (one of \"Linear\", \"Quadratic\"); did you mean "
        "\"Quadratic\"?",
        "owner: \"Times\" is -2, must be >= 0 s", "owner: \"Names\" \"c\" is not allowed here (one of \"a\", \"b\")",
        "owner: \"Desity\" unknown key; did you mean \"Density\"?", "owner: \"Density\" is required: Mass density.",
        "owner: \"Inner\" must be a list of its own"})
    EXPECT_NE(message.find(expected), std::string::npos) << expected << "\n--- is not in ---\n" << message;
}

TEST(Parameters, NotANumberIsRefused) {
  Teuchos::ParameterList list;
  list.set("Density", std::numeric_limits<double>::quiet_NaN());
  EXPECT_NE(complaintOf(example(), list).find("\"Density\" is not a number"), std::string::npos);
}

TEST(Parameters, LetKeysOfTheHostPass) {
  Teuchos::ParameterList list;
  list.set("Density", 1.0);
  list.set("Material Model", "Example");
  list.set("Horizon", 0.1);
  EXPECT_EQ(complaintOf(example(), list), "");
}

ParameterDeclarations withRules() {
  ParameterDeclarations declare;
  for (const char* name : {"A", "B", "C", "D", "E"}) declare.real(name, "1", "A number.");
  declare.flag("F", "A switch.").defaultTo(false);
  declare.flag("G", "A switch.").defaultTo(false);
  declare.exactlyOneOf({"A", "B"});
  declare.atMostOneOf({"C", "D"});
  declare.atMostOneOf({"F", "G"});
  declare.needs("E", {"C"});
  return declare;
}

TEST(Parameters, RulesHold) {
  Teuchos::ParameterList list;
  EXPECT_EQ(complaintOf(withRules(), list), "owner: give one of \"A\", \"B\"");
  list.set("A", 1.0);
  EXPECT_EQ(complaintOf(withRules(), list), "");
  list.set("B", 1.0);
  list.set("C", 1.0);
  list.set("D", 1.0);
  EXPECT_EQ(complaintOf(withRules(), list),
            "owner: give only one of \"A\", \"B\"\nowner: give only one of \"C\", \"D\"");
  list.remove("B");
  list.remove("C");
  list.set("E", 1.0);
  EXPECT_EQ(complaintOf(withRules(), list), "owner: \"E\" needs \"C\" beside it");
}

TEST(Parameters, WhatAHostFillsInBreaksNoRule) {
  Teuchos::ParameterList list;
  list.set("A", 1.0);
  list.set("F", true);
  const ParameterDeclarations declarations = withRules();
  EXPECT_EQ(complaintOf(declarations, declarations.complete(list, "owner")), "");
  list.set("G", true);
  EXPECT_EQ(complaintOf(declarations, list), "owner: give only one of \"F\", \"G\"");
}

TEST(Parameters, AtLeastOneOf) {
  ParameterDeclarations declare;
  declare.real("A", "1", "A number.");
  declare.real("B", "1", "A number.");
  declare.atLeastOneOf({"A", "B"});
  EXPECT_EQ(complaintOf(declare, Teuchos::ParameterList()), "owner: give at least one of \"A\", \"B\"");
}

TEST(Parameters, SayWhatTheyExpect) {
  const ParameterDeclarations declarations = example();
  EXPECT_EQ(declarations.find("Density")->expectation(), "a number > 0 kg/m3");
  EXPECT_EQ(declarations.find("Ratio")->expectation(), "a number in (-1, 0.5)");
  EXPECT_EQ(declarations.find("Steps")->expectation(), "an integer in [1, 9]");
  EXPECT_EQ(declarations.find("Law")->expectation(), "one of \"Linear\", \"Quadratic\"");
  EXPECT_EQ(declarations.find("Load")->expectation(), "a number or a function of x, y, z, t in N");
  EXPECT_EQ(declarations.find("Times")->expectation(), "a list of numbers >= 0 s");
  EXPECT_EQ(declarations.find("Share")->defaultText(), "1");
  EXPECT_EQ(declarations.find("On")->defaultText(), "true");
  EXPECT_EQ(declarations.find("Ratio")->defaultText(), "");
}

TEST(Parameters, ReferencesToSublistsStayGood) {
  ParameterDeclarations declare;
  ParameterDeclarations& first = declare.sublist("First", "One.");
  for (int i = 0; i < 50; ++i) declare.sublist("More " + std::to_string(i), "Others.");
  first.real("Radius", "m", "Radius.");
  EXPECT_NE(declare.findSublist("First")->declarations.front().find("Radius"), nullptr);
}

TEST(NearestWord, FindsSlipsOfThePenOnly) {
  const std::vector<std::string> known{"Horizon", "Material", "Damage Model", "dt"};
  EXPECT_EQ(nearestWord("Horizn", known), "Horizon");
  EXPECT_EQ(nearestWord("horizon", known), "Horizon");
  EXPECT_EQ(nearestWord("Damge Modell", known), "Damage Model");
  EXPECT_EQ(nearestWord("dts", known), "dt");
  EXPECT_EQ(nearestWord("PDEH", {"PDHE"}), "PDHE");
  EXPECT_EQ(nearestWord("d", known), "");
  EXPECT_EQ(nearestWord("xy", known), "");
  EXPECT_EQ(nearestWord("Viscosity", known), "");
  EXPECT_EQ(nearestWord("", known), "");
}

struct Shape {
  virtual ~Shape() = default;
  virtual double area() const = 0;
};
struct Square : Shape {
  explicit Square(double side) : side_(side) {}
  double area() const override { return side_ * side_; }
  static void declareParameters(ParameterDeclarations& declare) { declare.real("Side", "m", "Side."); }
  double side_;
};
using ShapeRegistry = PluginRegistry<Shape, double>;
PD_REGISTER(ShapeRegistry, Square, "Square", "Four equal sides.")

TEST(Registry, MakesPluginsByName) {
  EXPECT_EQ(ShapeRegistry::self().names(), std::vector<std::string>{"Square"});
  EXPECT_DOUBLE_EQ(ShapeRegistry::self().create("Square", 3.0)->area(), 9.0);
  EXPECT_NE(ShapeRegistry::self().find("Square")->declare().find("Side"), nullptr);
  EXPECT_THROW(ShapeRegistry::self().create("Circle", 1.0), std::invalid_argument);
  EXPECT_THROW(ShapeRegistry::self().add({"Square", "", {}, {}, {}, {}}), std::logic_error);
}

}  // namespace
}  // namespace pd
